// A fit coupon as a file, for the stocks that the model is cut from: asks where to, writes it, and
// says what came of it.
#pragma once

#include "ui/dialogs/export_choices.h"

#include <QString>

#include <optional>

class QWidget;

namespace fff::ui {

class Workbench;

struct CouponOutcome
{
    bool isWritten = false;
    QString sentence, details; // these of a failure
};

struct CouponExport
{
    Workbench &bench;
    QWidget &window;
    ExportChoices choices = rememberedChoices(); // its machine, and its format where it has one

    /// suggestion  path of the model without a suffix. None where nobody wanted it after all.
    std::optional<CouponOutcome> ask(const QString &suggestion) const;
    /// In the format that the suffix names, else as a drawing.
    CouponOutcome write(const QString &path) const;
};

} // namespace fff::ui
