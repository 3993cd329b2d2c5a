// Export: shows what will be cut and where to (ui/export_dialog.h), writes the parts for a
// cutter or the solids for another program, and says what to look out for. The window stays alive
// meanwhile.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/analysis/finding.h"
#include "ui/files/export_targets.h"
#include "ui/files/format_filters.h"
#include "ui/files/written_files.h"

#include <QStringList>

class QWidget;

namespace fff::io {
struct CuttingFile;
}

namespace fff {
class CheckList;
struct Error;
} // namespace fff

namespace fff::ui {

class MessageBar;
class StatusLine;
class Workbench;

class Exporting : public QObject
{
    Q_OBJECT
public:
    Exporting(Workbench &bench, const CheckList &checks, MessageBar &messages, StatusLine &status,
              QWidget &window);

    /// The panel. suggestion  path without a suffix, where the model was not exported yet; model
    /// its file's path, or empty
    bool ask(const QString &suggestion, const QString &model);
    /// What was exported last, over it and without a question.
    bool again(const QString &model);
    bool canAgain(const QString &model) const { return target(model).has_value(); }

    /// In the format that the suffix names, else as a drawing. False when nothing was written.
    bool write(const QString &path);
    /// A drawing for each sheet: OUT-1.svg, OUT-2.svg, … for OUT.svg. Asks before it replaces
    /// files.
    bool writeSheets(const QString &path);

Q_SIGNALS:
    /// To change what cannot be cut as it is.
    void stocksWanted();
    /// Somebody wants to see it in the model.
    void problemWanted(const fff::Finding &problem);
    void sectionsWanted(const std::vector<fff::SectionRef> &sections);
    void exported();

private:
    /// Whether a single file may replace what is there was asked already.
    enum class Replaces { Asking, Asked };

    std::optional<ExportTarget> target(const QString &model) const;
    bool writeTo(const ExportTarget &target, const QString &model, Replaces replaces);
    bool prepare(const QString &path);
    bool mayReplaceThose(const ExportKind &kind, const std::vector<io::NamedBytes> &files);
    /// Writes them; path: what they are called together.
    bool put(const QString &path, const ExportKind &kind, const QString &doing,
             const std::vector<io::NamedBytes> &files);
    bool writeDrawing(const QString &path, const ExportKind &kind);
    void tellDone(const io::CuttingFile &file, const QString &name);
    bool writeSolids(const QString &path, const ExportKind &kind);
    bool writeSkin(const QString &path, const ExportKind &kind);
    bool finishAnalysis(const QString &path);
    bool tellFailure(const QString &path, const ExportKind &kind, const fff::Error &error);
    static QStringList warningsOf(const io::CuttingFile &file);
    /// What an earlier export with more sheets has left, in a sentence; empty: nothing.
    static QStringList olderSheets(const QString &path, std::size_t count, const QString &suffix);

    Workbench &m_bench;
    const CheckList &m_checks;
    MessageBar &m_messages;
    StatusLine &m_status;
    QWidget &m_window;
    QString m_refusal;                  // said last
    QString m_model;                    // that is exported, its file; may be empty
    std::optional<ExportTarget> m_last; // of this document
    WrittenFiles m_written;
    Replaces m_replaces = Replaces::Asking;
};

} // namespace fff::ui
