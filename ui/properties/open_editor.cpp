#include "ui/properties/open_editor.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QLineEdit>
#include <QPointer>

namespace fff::ui {

void commitOpenEditor()
{
    const QPointer<QWidget> editor = QApplication::focusWidget();
    if (!qobject_cast<QLineEdit *>(editor) && !qobject_cast<QAbstractSpinBox *>(editor) &&
        !qobject_cast<QAbstractSlider *>(editor))
        return;
    editor->clearFocus();
    // The outline renames in a call of its own, once its editor has gone.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
    for (QWidget *at = editor; at && !QApplication::focusWidget(); at = at->parentWidget()) {
        if (at->isVisible() && at->focusPolicy() != Qt::NoFocus)
            at->setFocus();
    }
}

} // namespace fff::ui
