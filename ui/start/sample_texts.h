// What is written in the samples, in the language of the window.
#pragma once

#include "core/model/document.h"

#include <QStringList>

namespace fff::ui {

Document inThisLanguage(const Document &sample);
/// In English: all that can be told in another language.
QStringList sampleTexts();

} // namespace fff::ui
