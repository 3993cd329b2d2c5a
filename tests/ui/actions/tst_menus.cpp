// What stands in the menus: few enough to be read, and nothing that can be done is lost with it.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/actions/action_finder.h"
#include "ui/actions/action_set.h"
#include "ui/actions/menu_table.h"
#include "ui/actions/search_words.h"

#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QToolBar>

#include <algorithm>

using namespace fff;
using namespace fff::ui;

namespace {

constexpr int kMostEntries = 80, kMostRows = 16, kMostRowsOfClick = 12;

QList<QAction *> rowsOf(const QMenu &menu)
{
    QList<QAction *> rows;
    for (QAction *action : menu.actions())
        if (!action->isSeparator())
            rows += action;
    return rows;
}

/// Also what opens beside it, but for files that were opened before.
int entriesOf(const QMenu &menu)
{
    int count = 0;
    for (const QAction *row : rowsOf(menu))
        count += 1 + (row->menu() && row->menu()->objectName() != QStringLiteral("recentMenu")
                          ? entriesOf(*row->menu())
                          : 0);
    return count;
}

QList<QMenu *> seenMenus(const QMenuBar &bar)
{
    QList<QMenu *> menus;
    for (const QAction *action : bar.actions())
        if (action->isVisible())
            menus += action->menu();
    return menus;
}

} // namespace

class TestMenus : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
        m_window = openWindow();
    }
    void cleanup() { closeEverything(); }

    void theyCanBeRead();
    void aRightClickIsShort();
    void everyCommandIsFound();
    void nothingIsListedTwice();
    void whatPeopleTypeIsFound_data();
    void whatPeopleTypeIsFound();
    void otherWordsAreOfCommands();
    void keysWorkOutsideTheMenus();
    void buttonsForASectionComeWithIt();
    void nothingIsRepeatedOfNothing();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

// Wrong: menus grow by a row with each thing that the program learns, until nobody reads them.
void TestMenus::theyCanBeRead()
{
    int entries = 0;
    for (const QMenu *menu : seenMenus(*m_window->menuBar())) {
        const int rows = static_cast<int>(rowsOf(*menu).size());
        qInfo("%s: %d rows, %d entries", qPrintable(menu->title()), rows, entriesOf(*menu));
        entries += entriesOf(*menu);
        QVERIFY2(rows <= kMostRows, qPrintable(menu->title()));
        for (const QMenu *beside : menu->findChildren<QMenu *>())
            QVERIFY2(rowsOf(*beside).size() <= kMostRows, qPrintable(beside->title()));
    }
    QVERIFY2(entries <= kMostEntries, qPrintable(QString::number(entries)));
}

// Wrong: a right click covers half of the model.
void TestMenus::aRightClickIsShort()
{
    for (const MenuRow &row : menuTable()) {
        if (!row.key || !QLatin1String(row.key).startsWith(QLatin1String("context.")))
            continue;
        const QStringList ids = QString::fromLatin1(row.ids).split(u' ', Qt::SkipEmptyParts);
        const auto rows = ids.size() - ids.count(QStringLiteral("|"));
        qInfo("%s: %d rows", row.key, static_cast<int>(rows));
        QVERIFY2(rows <= kMostRowsOfClick, row.key);
    }
}

// Wrong: what is in no menu any more can be neither found nor given a key.
void TestMenus::everyCommandIsFound()
{
    QSet<QString> found;
    for (const ListedAction &listed : listedActions(*m_window->menuBar())) {
        if (listed.id.isEmpty())
            continue;
        QVERIFY2(!found.contains(listed.id), qPrintable(listed.id)); // once, under one menu
        found += listed.id;
        QVERIFY2(!listed.menuPath.isEmpty(), qPrintable(listed.id));
    }
    for (const CommandWords *words : m_window->bench().commands().offered())
        QVERIFY2(found.contains(QLatin1String(words->id)), words->id);
}

// Wrong: the search has two rows of one name that do the same, from a panel and its command.
void TestMenus::nothingIsListedTwice()
{
    QSet<QString> names;
    for (const ListedAction &listed : listedActions(*m_window->menuBar())) {
        QVERIFY2(!names.contains(listed.name), qPrintable(listed.name));
        names += listed.name;
    }
}

void TestMenus::whatPeopleTypeIsFound_data()
{
    QTest::addColumn<QString>("id");
    const auto row = [](const char *typed, const char *id) {
        QTest::newRow(typed) << QString::fromLatin1(id);
    };
    row("keyboard", "file.shortcuts");
    row("shortcuts", "file.shortcuts");
    row("hotkey", "file.shortcuts");
    row("customizer", "value.handOn");
    row("hand on", "value.handOn");
    row("share", "value.handOn");
    row("print", "file.export");
    row("laser", "file.export");
    row("dxf", "file.export");
    row("undo", "edit.undo");
    row("grid", "operation.grid");
    row("mirror", "edit.mirror");
    row("flip", "edit.mirror");
    row("dark", "file.settings");
    row("language", "file.settings");
    row("preferences", "file.settings");
    row("zoom", "view.fitAll");
    row("transparent", "view.xray");
    row("rotate", "section.transform");
    row("text", "section.mark");
    row("circle", "section.addShape");
    row("waffle", "operation.grid");
    row("loft", "operation.blend");
    row("photo", "template.addMesh");
    row("stl", "template.addMesh");
    row("material", "fabricate.stocks");
    row("nesting", "fabricate.sheets");
    row("test piece", "fabricate.coupon");
    row("instructions", "check.showAssembly");
    row("fem", "check.stress");
    row("tutorial", "help.firstSteps");
}

// Wrong: who does not know how the program calls it does not find it.
void TestMenus::whatPeopleTypeIsFound()
{
    QFETCH(QString, id);
    const QString typed = QString::fromLatin1(QTest::currentDataTag());
    const QList<ListedAction> found = foundActions(typed, listedActions(*m_window->menuBar()));
    QStringList first; // what is seen at a glance
    for (const ListedAction &one : found.mid(0, 4))
        first += one.id;
    QVERIFY2(first.contains(id), qPrintable(first.join(u' ')));
}

// Wrong: words of a command that was renamed find nothing, and nobody sees it.
void TestMenus::otherWordsAreOfCommands()
{
    const auto &offered = m_window->bench().commands().offered();
    QSet<QString> ids;
    for (const SearchWords &row : searchWords()) {
        QVERIFY2(std::any_of(offered.begin(), offered.end(),
                             [&](const CommandWords *words) {
                                 return QLatin1String(words->id) == QLatin1String(row.id);
                             }),
                 row.id);
        QVERIFY2(!ids.contains(QLatin1String(row.id)), row.id);
        ids += QLatin1String(row.id);
    }
}

// Wrong: F6 is dead, since Qt passes over the keys of what is in hidden menus alone.
void TestMenus::keysWorkOutsideTheMenus()
{
    auto *pane = m_window->findChild<QAction *>(QStringLiteral("view.nextPane"));
    int runs = 0;
    connect(pane, &QAction::triggered, this, [&runs] { ++runs; });
    QApplication::setActiveWindow(m_window);
    QTest::keyClick(m_window, Qt::Key_F6);
    QCOMPARE(runs, 1);
}

// Wrong: the bar is full of what cannot be done yet.
void TestMenus::buttonsForASectionComeWithIt()
{
    auto *bar = m_window->findChild<QToolBar *>(QStringLiteral("mainToolBar"));
    const auto has = [&](const char *id) {
        return bar->actions().contains(m_window->findChild<QAction *>(QLatin1String(id)));
    };
    Workbench &bench = m_window->bench();
    bench.session().commit(QStringLiteral("draw"), squareDocument());
    QVERIFY(!has("section.redraw") && !has("section.addHole"));
    QVERIFY(has("section.addShape") && has("measure.ruler"));
    bench.select({bench.session().committed().section(0)->ref()});
    QVERIFY(has("section.redraw") && has("section.addHole"));
    bench.select({});
    QVERIFY(!has("section.redraw") && !has("section.addHole"));
}

// Wrong: buttons that are grey and leave one to guess why; or a tool that asks for a section to be
// clicked where there is none.
void TestMenus::nothingIsRepeatedOfNothing()
{
    const Interaction &interaction = m_window->bench().interaction();
    const char *const ids[] = {"operation.linear", "operation.revolve", "operation.grid",
                               "operation.radial", "operation.mirror",  "edit.mirror"};
    for (const char *id : ids) {
        QVERIFY2(actionOf(*m_window, id)->isEnabled(), id);
        actionOf(*m_window, id)->trigger();
        QVERIFY2(!interaction.tool(), id);
        QVERIFY2(interaction.hint().isRefusal, id);
        QVERIFY(m_window->bench().session().committed().document.operations.empty());
    }
    m_window->bench().session().commit(QStringLiteral("draw"), squareDocument());
    for (const char *id : ids)
        QVERIFY2(actionOf(*m_window, id)->isEnabled(), id);
    actionOf(*m_window, "operation.linear")->trigger();
    QVERIFY(interaction.tool());
}

FFF_TEST_WITH(TestMenus, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    TestMenus test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_menus.moc"
