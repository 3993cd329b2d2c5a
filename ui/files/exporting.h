// Export: asks for a file, writes the parts for a cutter or the solids for another program, and
// says what to look out for. The window stays alive meanwhile.
#pragma once

#include <QObject>
#include <QStringList>

class QWidget;

namespace fff::io {
struct CuttingFile;
}

namespace fff {
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
    Exporting(Workbench &bench, MessageBar &messages, StatusLine &status, QWidget &window);

    /// suggestion  path without a suffix
    bool ask(const QString &suggestion);
    /// In the format that the suffix names, else as a drawing. False when nothing was written.
    bool write(const QString &path);
    /// A drawing for each sheet: OUT-1.svg, OUT-2.svg, … for OUT.svg. Asks before it replaces
    /// files.
    bool writeSheets(const QString &path);

Q_SIGNALS:
    /// To change what cannot be cut as it is.
    void stocksWanted();

private:
    bool prepare(const QString &path);
    bool writeDrawing(const QString &path, bool isFilePerSheet);
    void tellDone(const io::CuttingFile &file, const QString &name);
    bool writeSolids(const QString &path);
    bool finishAnalysis(const QString &path);
    bool tellFailure(const QString &path, const fff::Error &error);
    static QStringList warningsOf(const io::CuttingFile &file);
    /// What an earlier export with more sheets has left, in a sentence; empty: nothing.
    static QStringList olderSheets(const QString &path, std::size_t count, const QString &suffix);

    Workbench &m_bench;
    MessageBar &m_messages;
    StatusLine &m_status;
    QWidget &m_window;
    QString m_refusal; // said last
};

} // namespace fff::ui
