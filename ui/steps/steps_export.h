// Export of the steps: asks for a file, makes it without a window that hangs, and says what was
// done.
#pragma once

#include "core/interaction/camera.h"
#include "core/session/assembly_steps.h"

#include <QObject>

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

    /// suggestion  path without a suffix
    /// looking     pictures are seen from the same direction
    bool ask(const AssemblyStepsPointer &steps, const Camera &looking, const QString &suggestion);
    /// A PDF, or for .png a picture of each step, OUT-01.png, OUT-02.png, …, where it asks before
    /// it replaces some. False when nothing was written.
    bool write(const AssemblyStepsPointer &steps, const Camera &looking, const QString &path);

private:
    bool tellFailure(const AssemblyStepsPointer &steps, const Camera &looking, const QString &path,
                     const Error &error);

    MessageBar &m_messages;
    StatusLine &m_status;
    QWidget &m_window;
};

} // namespace fff::ui
