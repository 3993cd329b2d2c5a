// The place of an export (ui/dialogs/export_place.h): where the model went before, else beside it,
// until a person chooses another.
#pragma once

#include "ui/dialogs/export_place.h"
#include "ui/files/export_targets.h"

#include <QStringList>

namespace fff::ui {

struct ExportKind;

/// Asks for the path of such a file, or of the folder for a workshop; empty: none was chosen.
/// suggestion  path without a suffix
QString askForExport(QWidget *parent, const ExportKind &kind, const QString &suggestion);

/// What names of files for that target begin with: its path without a suffix.
/// suggestion  the same where it is a folder, which has a name of its own
QString baseOf(const ExportTarget &target, const QString &suggestion);

class ChosenPlace : public ExportPlace
{
public:
    /// suggestion  path without a suffix, where the model was not exported yet
    ChosenPlace(const QString &suggestion, std::optional<ExportTarget> before);

    QString pathOf(const ExportFile &file) const override;
    bool change(QWidget *dialog, const ExportFile &file) override;
    bool mayWrite(QWidget *dialog, const ExportFile &file) override;

    /// With the name that is typed for several numbered files: "chair.svg" for "chair-1.svg".
    ExportTarget target(const ExportFile &file) const;
    /// It may replace what is there without a word.
    bool isSettled(const ExportFile &file) const;

private:
    QString m_base; // path without a suffix
    std::optional<ExportTarget> m_before, m_chosen;
};

} // namespace fff::ui
