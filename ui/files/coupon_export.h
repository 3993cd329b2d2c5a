// A fit coupon as a file, for the stocks that the model is cut from: asks where to, writes it, and
// says what is done with it.
#pragma once

#include <QString>

class QWidget;

namespace fff::ui {

class MessageBar;
class StatusLine;
class Workbench;

struct CouponExport
{
    Workbench &bench;
    MessageBar &messages;
    StatusLine &status;
    QWidget &window;

    /// For the machine, and in the format, that Export has now where that is one of cutting files.
    /// suggestion  path of the model without a suffix. False when nothing was written.
    bool ask(const QString &suggestion) const;
    /// In the format that the suffix names, else as a drawing.
    bool write(const QString &path) const;
};

} // namespace fff::ui
