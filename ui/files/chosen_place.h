// The place of an export (ui/dialogs/export_place.h): where the model went before, else beside it,
// until a person chooses another.
#pragma once

#include "ui/dialogs/export_place.h"
#include "ui/files/export_targets.h"

#include <functional>
#include <optional>

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
    /// isOurs      whether what is at a path was written by this model's exports
    ChosenPlace(const QString &suggestion, std::optional<ExportTarget> before,
                std::function<bool(const QString &)> isOurs);

    QString pathOf(const ExportFile &file) const override;
    bool change(QWidget *dialog, const ExportFile &file) override;
    bool mayWrite(QWidget *dialog, const ExportFile &file) override;

    /// With the name that is typed for several numbered files: "chair.svg" for "chair-1.svg".
    ExportTarget target(const ExportFile &file) const;

private:
    QString m_base; // path without a suffix
    std::optional<ExportTarget> m_before, m_chosen;
    const std::function<bool(const QString &)> m_isOurs;
};

} // namespace fff::ui
