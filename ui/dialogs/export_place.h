// Where an exported file goes: shown in the Export panel before it is written, changed from there.
#pragma once

#include <QString>

class QWidget;

namespace fff::ui {

struct ExportFile;

class ExportPlace
{
public:
    virtual ~ExportPlace() = default;

    /// Of that file, or of that folder; of several numbered ones the first.
    virtual QString pathOf(const ExportFile &file) const = 0;
    /// Asks for another one. False: it stays.
    virtual bool change(QWidget *dialog, const ExportFile &file) = 0;
    /// Asks whether to replace what is there, unless that was asked, or this model wrote it.
    virtual bool mayWrite(QWidget *dialog, const ExportFile &file) = 0;
};

} // namespace fff::ui
