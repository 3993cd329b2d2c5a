// A hand at the Export panel: opens it as a person does, acts while it is there, and says where the
// file goes.
#pragma once

#include "tests/ui/window_fixture.h"
#include "ui/dialogs/export_dialog.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>

#include <functional>

namespace fff::ui {

/// The panel's sheets and its checks are those of the model.
inline void awaitSheets(QDialog *dialog)
{
    QTRY_VERIFY_WITH_TIMEOUT(!dialog->findChild<QLabel *>(QStringLiteral("exportState"))
                                  ->text()
                                  .startsWith(QStringLiteral("Working")),
                             30000);
}

/// The command is run; `act` is done in the panel. How the panel is left is for `act`: what is
/// still open then is cancelled.
inline void inExportPanel(MainWindow &window, const std::function<void(QDialog *)> &act)
{
    bool isSeen = false;
    whenShown<QDialog>("exportDialog", [&](QDialog *dialog) {
        isSeen = true;
        awaitSheets(dialog);
        act(dialog);
    });
    actionOf(window, "file.export")->trigger();
    QVERIFY(isSeen);
}

/// Answers the file box that comes next, whoever opens it.
inline void nameTheFile(const QString &path)
{
    auto *timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, path] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        if (!dialog || !dialog->isVisible())
            return;
        timer->deleteLater();
        dialog->selectFile(path); // what was suggested is no more
        dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))
            ->setText(QFileInfo(path).fileName());
        QMetaObject::invokeMethod(dialog, "accept");
    });
    timer->start(20);
}

inline QAbstractButton *exportButton(QDialog *dialog)
{
    return dialog->findChild<QAbstractButton *>(QStringLiteral("exportNow"));
}

/// Chooses where it goes: in the file box that the link opens.
inline void chooseFile(QDialog *dialog, const QString &path)
{
    nameTheFile(path);
    auto *change = dialog->findChild<QWidget *>(QStringLiteral("exportChangePlace"));
    QTest::mouseClick(change->findChild<QAbstractButton *>(), Qt::LeftButton);
}

inline void exportTo(QDialog *dialog, const QString &path)
{
    chooseFile(dialog, path);
    QTest::mouseClick(exportButton(dialog), Qt::LeftButton);
}

/// As a person types it, with Enter.
inline void typeInto(QDialog *dialog, const char *field, const QString &text)
{
    auto *box = dialog->findChild<QDoubleSpinBox *>(QLatin1String(field));
    QVERIFY2(box, field);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
}

/// As a person who goes through the rows, to the first that begins so.
inline void chooseRow(QDialog *dialog, const char *name, const QString &begin)
{
    auto *box = dialog->findChild<QComboBox *>(QLatin1String(name));
    QVERIFY2(box && box->isVisible(), name);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < box->count() && !box->currentText().startsWith(begin); ++i)
        QTest::keyClick(box, Qt::Key_Down);
    QVERIFY2(box->currentText().startsWith(begin), qPrintable(box->currentText()));
}

inline QString textOf(QDialog *dialog, const char *label)
{
    return dialog->findChild<QLabel *>(QLatin1String(label))->text();
}

} // namespace fff::ui
