// A person finds an action by what they would call it.
#include <QApplication>
#include <QTest>

#include "tests/test_program.h"
#include "ui/actions/action_finder.h"

#include <QMenu>
#include <QMenuBar>

using namespace fff::ui;

class TestActionFinder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void menusAreListedInTheirOrder();
    void wordsFindActions_data();
    void wordsFindActions();
    void othersAreNotFound_data();
    void othersAreNotFound();
    void theNameCountsMoreThanTheMenu();
    void guessesGiveWayToWords();

private:
    static QList<ListedAction> some();
};

QList<ListedAction> TestActionFinder::some()
{
    const auto listed = [](const char *name, const char *menu, const char *id,
                           const char *does = "", const char *also = "") {
        return ListedAction{nullptr,           QString::fromUtf8(name), QString::fromUtf8(menu),
                            QLatin1String(id), QString::fromUtf8(does), QString::fromUtf8(also)};
    };
    return {listed("New", "File", "file.new"),
            listed("Open…", "File", "file.open"),
            listed("Export cutting files…", "File", "file.export", "", "print laser"),
            listed("Front", "View", "view.front"),
            listed("Fit everything", "View", "view.fitAll", "Show the whole model"),
            listed("Fit selection", "View", "view.fitSelection"),
            listed("Rückgängig", "Bearbeiten", "edit.undo")};
}

void TestActionFinder::menusAreListedInTheirOrder()
{
    QMenuBar bar;
    QMenu *file = bar.addMenu(QStringLiteral("&File"));
    file->addAction(QStringLiteral("&New"))->setObjectName(QStringLiteral("file.new"));
    file->addSeparator();
    QMenu *recent = file->addMenu(QStringLiteral("Open &recent"));
    recent->addAction(QStringLiteral("Salt && pepper.fff"));
    file->addAction(QStringLiteral("Hidden"))->setVisible(false);
    bar.addMenu(QStringLiteral("&View"))->addAction(QStringLiteral("F&ull screen"));
    const QList<ListedAction> all = listedActions(bar);
    QCOMPARE(all.size(), 3);
    QCOMPARE(all[0].name, QStringLiteral("New"));
    QCOMPARE(all[0].menuPath, QStringLiteral("File"));
    QCOMPARE(all[0].id, QStringLiteral("file.new"));
    QCOMPARE(all[1].name, QStringLiteral("Salt & pepper.fff"));
    QCOMPARE(all[1].menuPath, QStringLiteral("File › Open recent"));
    QCOMPARE(all[2].name, QStringLiteral("Full screen"));
}

void TestActionFinder::wordsFindActions_data()
{
    QTest::addColumn<QString>("query");
    QTest::addColumn<QString>("first");
    QTest::newRow("the name") << QStringLiteral("front") << QStringLiteral("view.front");
    QTest::newRow("its beginning") << QStringLiteral("exp") << QStringLiteral("file.export");
    QTest::newRow("words in any order")
        << QStringLiteral("all fit") << QStringLiteral("view.fitAll");
    QTest::newRow("a word of the middle")
        << QStringLiteral("cutting") << QStringLiteral("file.export");
    QTest::newRow("the id") << QStringLiteral("view.fitSel") << QStringLiteral("view.fitSelection");
    QTest::newRow("English in another language")
        << QStringLiteral("undo") << QStringLiteral("edit.undo");
    QTest::newRow("without its accents") << QStringLiteral("ruckg") << QStringLiteral("edit.undo");
    QTest::newRow("upper case") << QStringLiteral("FRONT") << QStringLiteral("view.front");
    QTest::newRow("menu and name") << QStringLiteral("file new") << QStringLiteral("file.new");
    QTest::newRow("letters left out") << QStringLiteral("evrthng") << QStringLiteral("view.fitAll");
    QTest::newRow("what it does") << QStringLiteral("whole") << QStringLiteral("view.fitAll");
    QTest::newRow("another word for it")
        << QStringLiteral("laser") << QStringLiteral("file.export");
    QTest::newRow("its beginning, too") << QStringLiteral("pri") << QStringLiteral("file.export");
    QTest::newRow("nothing typed yet") << QString() << QStringLiteral("file.new");
}

void TestActionFinder::wordsFindActions()
{
    QFETCH(QString, query);
    QFETCH(QString, first);
    const QList<ListedAction> found = foundActions(query, some());
    QVERIFY(!found.isEmpty());
    QCOMPARE(found.front().id, first);
}

void TestActionFinder::othersAreNotFound_data()
{
    QTest::addColumn<QString>("query");
    QTest::newRow("another word") << QStringLiteral("saxophone");
    QTest::newRow("one of two words") << QStringLiteral("front saxophone");
    QTest::newRow("the middle of another word") << QStringLiteral("rint");
    QTest::newRow("letters in the wrong order") << QStringLiteral("tnorf");
}

void TestActionFinder::othersAreNotFound()
{
    QFETCH(QString, query);
    QVERIFY(foundActions(query, some()).isEmpty());
}

void TestActionFinder::theNameCountsMoreThanTheMenu()
{
    const QList<ListedAction> actions = {
        {nullptr, QStringLiteral("Outline"), QStringLiteral("Fit"), QStringLiteral("a.b")},
        {nullptr, QStringLiteral("Profit"), QStringLiteral("View"), QStringLiteral("a.c")},
        {nullptr, QStringLiteral("Fit"), QStringLiteral("View"), QStringLiteral("a.d")}};
    const QList<ListedAction> found = foundActions(QStringLiteral("fit"), actions);
    QCOMPARE(found.size(), 3);
    QCOMPARE(found[0].id, QStringLiteral("a.d"));
    QCOMPARE(found[1].id, QStringLiteral("a.c"));
}

void TestActionFinder::guessesGiveWayToWords()
{
    const QList<ListedAction> actions = {
        {nullptr, QStringLiteral("Find a command"), QStringLiteral("Help"), QStringLiteral("a.b")},
        {nullptr, QStringLiteral("Fit everything"), QStringLiteral("View"), QStringLiteral("a.c")}};
    QCOMPARE(foundActions(QStringLiteral("fit"), actions).size(), 1);
    QCOMPARE(foundActions(QStringLiteral("fdn"), actions).size(), 1);
}

FFF_TEST_WITH(TestActionFinder, fff::testing::runWithin<TestActionFinder, QApplication>)
#include "tst_action_finder.moc"
