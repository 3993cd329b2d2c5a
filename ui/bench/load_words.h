// What weights and pushes are called, and how much they are.
#pragma once

#include "core/model/load.h"

#include <QLocale>
#include <QString>

namespace fff::ui {

/// Its own name, else what it is.
QString loadName(const Load &load);
/// Its own name, else the section that it is on, by which those of a list are told apart.
QString loadTitle(const Load &load, const QString &section);
/// "350 g", "5 N"
QString loadAmount(const Load &load, const QLocale &locale);
QString forceText(double newtons, const QLocale &locale);

} // namespace fff::ui
