// Whoever works with keys alone sees where they are, and gets on from everywhere.
#include <QTest>

#include "core/model/edits.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "tests/ui/contrast.h"
#include "ui/base/field_style.h"
#include "ui/base/focus_frame.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/settings/settings.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QListWidget>
#include <QTemporaryDir>

#include <memory>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

/// Pixels that differ by a contrast of at least so much.
int changedPixels(const QImage &a, const QImage &b, double least)
{
    int changed = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            if (contrast(a.pixelColor(x, y), b.pixelColor(x, y)) >= least)
                ++changed;
        }
    }
    return changed;
}

QImage pictureOf(QWidget *widget)
{
    QWidget *window = widget->window();
    const QRect place(widget->mapTo(window, QPoint(0, 0)), widget->size());
    return window->grab(place.adjusted(-3, -3, 3, 3)).toImage();
}

QString nameOf(const QWidget *widget)
{
    return QStringLiteral("%1 \"%2\" in %3")
        .arg(QLatin1String(widget->metaObject()->className()), widget->objectName(),
             widget->parentWidget() ? widget->parentWidget()->objectName() : QString());
}

} // namespace

class TestFocus : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QApplication::setCursorFlashTime(0); }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    }

    void cleanup() { m_window.reset(); }

    void theFocusIsSeen_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<int>("scheme");
        for (const char *what : {"window", "settings", "stocks"}) {
            for (const auto scheme :
                 {ColourScheme::Light, ColourScheme::Dark, ColourScheme::HighContrast})
                QTest::newRow(qPrintable(QStringLiteral("%1, colours %2")
                                             .arg(QLatin1String(what))
                                             .arg(static_cast<int>(scheme))))
                    << QString::fromLatin1(what) << static_cast<int>(scheme);
        }
    }

    /// Tab that goes somewhere unseen, or does not come out again.
    void theFocusIsSeen()
    {
        QFETCH(QString, what);
        QFETCH(int, scheme);
        settings().setColourScheme(static_cast<ColourScheme>(scheme));
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1400, 900);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        Session &session = m_window->bench().session();
        session.reset(twoSections(polygonShape(rectangle(-50, 0, 50, 60)), front(),
                                  polygonShape(rectangle(-50, 0, 50, 60)), side())
                          .document);
        session.currentAnalysis();
        m_window->bench().select({session.model().ref(0)});

        if (what == QStringLiteral("window")) {
            check(m_window.get(), 15);
        } else if (what == QStringLiteral("stocks")) {
            m_window->findChild<QAction *>(QStringLiteral("fabricate.stocks"))->trigger();
            auto *dialog = m_window->findChild<QDialog *>(QStringLiteral("stockEditor"));
            QVERIFY(dialog);
            QTRY_VERIFY(dialog->isVisible());
            check(dialog, 10);
        } else {
            SettingsDialog dialog({}, m_window.get());
            dialog.show();
            QVERIFY(QTest::qWaitForWindowExposed(&dialog));
            auto *groups = dialog.findChild<QListWidget *>(QStringLiteral("settingsGroups"));
            for (int page = 0; page < groups->count(); ++page) {
                groups->setCurrentRow(page);
                check(&dialog, 2);
            }
        }
    }

private:
    void check(QWidget *window, int least)
    {
        QApplication::setActiveWindow(window);
        window->setFocus();
        QTRY_COMPARE(QApplication::activeWindow(), window);
        QTest::qWait(50);
        // Three to one is what WCAG 2.2 wants of a sign of the focus.
        const double contrast = theme().isHighContrast ? 3.0 : 2.0;
        QList<QWidget *> visited;
        QStringList unseen;
        for (int i = 0; i < 200; ++i) {
            // To who has the keys, as the system does: what scrolls brings the next one into view.
            QWidget *before = window->focusWidget();
            QTest::keyClick(before ? before : window, Qt::Key_Tab);
            QWidget *focus = window->focusWidget();
            if (!focus || visited.contains(focus))
                break;
            visited += focus;
            const QImage with = pictureOf(focus);
            focus->clearFocus();
            const QImage without = pictureOf(focus);
            QCOMPARE(focus->window(), window);
            focus->setFocus(Qt::TabFocusReason);
            // A line of one pixel along the shorter side, at least.
            const int wanted = std::min(20, std::min(focus->width(), focus->height()));
            if (changedPixels(with, without, contrast) < wanted) {
                unseen += nameOf(focus);
            }
        }
        QVERIFY2(visited.size() >= least, qPrintable(QString::number(visited.size())));
        QVERIFY2(unseen.isEmpty(), qPrintable(unseen.join(QStringLiteral("\n"))));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

FFF_TEST_WITH(TestFocus, [](int argc, char *argv[]) {
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    new FocusFrame(application);
    TestFocus test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_focus.moc"
