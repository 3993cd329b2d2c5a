// For tests of windows without a view: settings of their own, and answers to questions.
#pragma once

#include <QTest>

#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"
#include "ui/base/message_bar.h"
#include "ui/bench/workbench.h"
#include "ui/files/document_files.h"
#include "ui/settings/settings.h"
#include "ui/window/main_window.h"
#include "ui/window/windows.h"

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>

namespace fff::ui {

/// One square section, `side` mm, as a step of the history when it is committed.
inline Document squareDocument(double side = 40.0)
{
    NewSection section;
    section.name = "Plate";
    section.shape =
        *Shape::make(*Contour::fromPolygon({{0, 0}, {side, 0}, {side, side}, {0, side}}));
    return *addSection(newDocument(), section);
}

/// Presses the button of this text in the next question; counts the questions.
inline void answer(const QString &button, int *asked)
{
    auto *timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, button, asked] {
        auto *question = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
        if (!question)
            return;
        timer->deleteLater();
        ++*asked;
        for (QAbstractButton *b : question->buttons()) {
            if (b->text().remove(u'&') == button)
                QTest::mouseClick(b, Qt::LeftButton);
        }
    });
    timer->start(20);
}

/// Runs once a modal dialog of this name is shown.
template <class Dialog, class Act>
void whenShown(const char *name, Act act)
{
    auto *timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, name, act] {
        auto *dialog = qobject_cast<Dialog *>(QApplication::activeModalWidget());
        if (!dialog || dialog->objectName() != QLatin1String(name))
            return;
        timer->deleteLater();
        act(dialog);
        dialog->close();
    });
    timer->start(20);
}

inline QAction *actionOf(MainWindow &window, const char *id)
{
    return window.findChild<QAction *>(QLatin1String(id));
}

inline MessageBar *messagesOf(MainWindow &window)
{
    return window.findChild<MessageBar *>(QStringLiteral("messageBar"));
}

inline void closeEverything()
{
    for (MainWindow *window : mainWindows())
        window->closeUnasked();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

} // namespace fff::ui
