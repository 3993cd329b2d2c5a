// The tabs of docks, in a window without its view: all of them can be told apart and reached.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/panes.h"

#include <QDockWidget>
#include <QLocale>
#include <QTabBar>
#include <QTranslator>

#include <memory>

using namespace fff;
using namespace fff::ui;

class TestDockTabs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void allOfThemCanBeRead_data();
    void allOfThemCanBeRead();
    void fewOfThemHaveTheirNames();
    void theOneInFrontHasItsName();
    void belowTabsNoTitleSaysItAgain();

private:
    void open(const QString &language, const QSize &size);
    void show(const char *dock);
    QList<QTabBar *> bars() const;
    QString fault() const;

    std::unique_ptr<QTemporaryDir> m_folder;
    QTranslator m_translator;
    MainWindow *m_window = nullptr;
};

void TestDockTabs::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
}

void TestDockTabs::cleanup()
{
    closeEverything();
    QCoreApplication::removeTranslator(&m_translator);
}

void TestDockTabs::open(const QString &language, const QSize &size)
{
    if (language == QStringLiteral("de")) {
        QVERIFY(m_translator.load(QStringLiteral(":/i18n/flatfitfab_de")));
        QCoreApplication::installTranslator(&m_translator);
    }
    m_window = openWindow();
    m_window->resize(size);
    m_window->resetLayout();
    QTest::qWait(20);
}

/// As from the menu.
void TestDockTabs::show(const char *dock)
{
    auto *found = m_window->findChild<QDockWidget *>(QLatin1String(dock));
    if (found->isHidden())
        found->toggleViewAction()->trigger();
}

QList<QTabBar *> TestDockTabs::bars() const
{
    QList<QTabBar *> seen;
    for (QTabBar *bar : m_window->findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly))
        if (bar->isVisible())
            seen += bar;
    return seen;
}

/// What cannot be read, told apart or reached; empty: nothing.
QString TestDockTabs::fault() const
{
    for (const QTabBar *bar : bars()) {
        int end = 0;
        for (int i = 0; i < bar->count(); ++i) {
            const QRect place = bar->tabRect(i);
            const int icon = bar->tabIcon(i).isNull() ? 0 : bar->iconSize().width();
            const int words = bar->fontMetrics().horizontalAdvance(bar->tabText(i));
            const bool isRead = place.width() >= words + icon;
            if (!isRead && (icon == 0 || i == bar->currentIndex() || place.width() < icon))
                return bar->tabText(i);
            if (!isRead && bar->tabToolTip(i) != bar->tabText(i))
                return bar->tabText(i) + QStringLiteral(" has no tip");
            end = std::max(end, place.right() + 1);
        }
        if (end > bar->width() || bar->usesScrollButtons())
            return QStringLiteral("they scroll");
    }
    return {};
}

void TestDockTabs::allOfThemCanBeRead_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    for (const char *language : {"en", "de"})
        for (const QSize &size : {QSize(1024, 640), QSize(1440, 900)})
            QTest::newRow(
                qPrintable(QStringLiteral("%1 %2").arg(QLatin1String(language)).arg(size.width())))
                << QString::fromLatin1(language) << size;
}

// Wrong: "Eige…", "Gl…", "Pr…", and two arrows to scroll them.
void TestDockTabs::allOfThemCanBeRead()
{
    QFETCH(QString, language);
    QFETCH(QSize, size);
    open(language, size);
    for (const char *dock : {"templatesDock", "libraryDock", "sheetsDock"}) {
        show(dock);
        QTRY_VERIFY2(fault().isEmpty(), qPrintable(fault()));
    }
    for (QTabBar *bar : bars())
        for (int i = 0; i < bar->count(); ++i) {
            QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(i).center());
            QCOMPARE(bar->currentIndex(), i);
            QTRY_VERIFY2(fault().isEmpty(), qPrintable(fault()));
        }
    // So that the view keeps its room.
    const auto *properties = m_window->findChild<QDockWidget *>(QStringLiteral("propertiesDock"));
    QVERIFY2(properties->width() <= 366, qPrintable(QString::number(properties->width())));
}

// Wrong: pictures to be learned where there is room for words.
void TestDockTabs::fewOfThemHaveTheirNames()
{
    open(QStringLiteral("en"), {1024, 640});
    QTRY_VERIFY(!bars().isEmpty());
    const auto haveIcons = [this] {
        for (const QTabBar *bar : bars())
            for (int i = 0; i < bar->count(); ++i)
                if (!bar->tabIcon(i).isNull())
                    return true;
        return false;
    };
    QTRY_VERIFY(!haveIcons());
    show("templatesDock");
    show("libraryDock");
    QTRY_VERIFY(haveIcons());
    for (const char *dock : {"templatesDock", "libraryDock"})
        m_window->findChild<QDockWidget *>(QLatin1String(dock))->close();
    QTRY_VERIFY(!haveIcons());
}

void TestDockTabs::theOneInFrontHasItsName()
{
    open(QStringLiteral("de"), {1024, 640});
    show("templatesDock");
    show("libraryDock");
    QTRY_VERIFY(!bars().isEmpty());
    QTabBar *bar = bars().front();
    for (int i = 0; i < bar->count(); ++i) {
        bar->setCurrentIndex(i);
        QTRY_VERIFY(bar->tabRect(i).width() >=
                    bar->fontMetrics().horizontalAdvance(bar->tabText(i)) +
                        bar->iconSize().width());
    }
}

// Wrong: "Properties" in the tab and "Properties" below it; or a dock that nothing names.
void TestDockTabs::belowTabsNoTitleSaysItAgain()
{
    open(QStringLiteral("en"), {1024, 640});
    auto *checks = m_window->findChild<QDockWidget *>(QStringLiteral("checksDock"));
    const auto isTitled = [](const QDockWidget *dock) {
        return dock->findChild<QWidget *>(QStringLiteral("dockTitle"))->isVisible();
    };
    // In front, as nothing that is behind shows a title anyway.
    const auto bringToFront = [&] {
        for (QTabBar *bar : bars())
            for (int i = 0; i < bar->count(); ++i)
                if (bar->tabText(i) == checks->windowTitle())
                    bar->setCurrentIndex(i);
        return isSeen(checks);
    };
    QTRY_VERIFY(bringToFront());
    QTRY_VERIFY(!isTitled(checks));
    // One that comes by itself stays behind it, as ever.
    auto *physics = m_window->findChild<QDockWidget *>(QStringLiteral("physicsDock"));
    QVERIFY(!isSeen(physics));
    checks->setFloating(true);
    QTRY_VERIFY(isTitled(checks));
    checks->setFloating(false);
    QTRY_VERIFY(bringToFront());
    QTRY_VERIFY(!isTitled(checks));

    m_window->resize(1440, 900); // two columns; tabs are at the bottom
    m_window->resetLayout();
    QTRY_VERIFY(isTitled(checks));
}

FFF_TEST_WITH(TestDockTabs, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    TestDockTabs test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_dock_tabs.moc"
