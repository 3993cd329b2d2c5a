#include "ui/dialogs/key_recorder.h"

#include <QKeyEvent>

namespace fff::ui {

KeyRecorder::KeyRecorder(QWidget *parent) : QLineEdit(parent)
{
    setReadOnly(true);
    setPlaceholderText(tr("Press the keys"));
    setContextMenuPolicy(Qt::NoContextMenu);
}

void KeyRecorder::setKeys(const QKeySequence &keys)
{
    setText(keys.toString(QKeySequence::NativeText));
}

bool KeyRecorder::event(QEvent *event)
{
    // Before the keys reach the shortcuts that have them now.
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::KeyPress && take(*static_cast<QKeyEvent *>(event)))
        return true;
    return QLineEdit::event(event);
}

bool KeyRecorder::take(const QKeyEvent &event)
{
    switch (event.key()) {
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Escape:
        return false;
    case Qt::Key_Control:
    case Qt::Key_Shift:
    case Qt::Key_Alt:
    case Qt::Key_AltGr:
    case Qt::Key_Meta:
    case Qt::Key_unknown:
    case 0:
        return true; // more is to come
    default:
        break;
    }
    Qt::KeyboardModifiers held = event.modifiers() & ~Qt::KeypadModifier;
    // The key of "+" is that whether it takes Shift to type it or not.
    const bool isLetter = event.key() >= Qt::Key_A && event.key() <= Qt::Key_Z;
    const bool isSign = event.key() > Qt::Key_Space && event.key() < Qt::Key_Escape;
    if (isSign && !isLetter)
        held &= ~Qt::ShiftModifier;
    const QKeySequence keys(QKeyCombination(held, static_cast<Qt::Key>(event.key())));
    setKeys(keys);
    Q_EMIT recorded(keys);
    return true;
}

} // namespace fff::ui
