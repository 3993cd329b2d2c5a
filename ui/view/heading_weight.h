// How heavy headings are.
#pragma once

#include <QFont>

namespace fff::ui {

/// Semi-bold, and bold in Chinese and Japanese: a font for these often has but one weight, as the
/// small one of Debian, and Qt makes up a heavier one only of what is asked for as bold.
QFont::Weight headingWeight();

} // namespace fff::ui
