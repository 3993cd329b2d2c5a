// Words with marks in them (<b>, links) for Qt's labels.
#pragma once

#include <QString>

namespace fff::ui {

/// The same, in which the narrow spaces between numbers and their units stay what they are: Qt
/// makes plain ones of them otherwise, where a line may break.
QString keepingUnits(const QString &html);

} // namespace fff::ui
