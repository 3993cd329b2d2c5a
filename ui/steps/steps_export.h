// Export of the steps: asks for a file, makes it without a window that hangs, and says what was
// done.
#pragma once

#include "core/analysis/cutting.h"
#include "core/interaction/camera.h"
#include "core/session/assembly_steps.h"
#include "ui/view/steps_files.h"

#include <QObject>
#include <QString>

class QWidget;

namespace fff {
struct Error;
}

namespace fff::ui {

class MessageBar;
class StatusLine;

class StepsExport : public QObject
{
    Q_OBJECT
public:
    StepsExport(MessageBar &messages, StatusLine &status, QWidget &window);

    struct Subject
    {
        AssemblyStepsPointer steps;
        Camera looking;              // pictures are seen from the same direction
        QString title;               // the model's name
        CuttingOptions cutting = {}; // with which its sheets are counted
    };
    /// suggestion  path without a suffix
    bool ask(const Subject &subject, const QString &suggestion);
    /// A PDF, or for .html a web page, which replaces another one, or for .png a picture of each
    /// step, OUT-01.png, OUT-02.png, …, where it asks before it replaces some. False when nothing
    /// was written.
    bool write(const Subject &subject, const QString &path);
    /// How it writes: lengths and names as they are in the window.
    StepsFiles::Options optionsFor(const Subject &subject, const QString &path) const;

private:
    bool tellFailure(const Subject &subject, const QString &path, const Error &error);

    MessageBar &m_messages;
    StatusLine &m_status;
    QWidget &m_window;
};

} // namespace fff::ui
