// A tool that is added is in the menu, greyed with its reason, held and found, with nothing else
// that knows it.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "tests/ui/push_tool.h"
#include "ui/actions/action_finder.h"
#include "ui/actions/action_set.h"
#include "ui/bench/hint_text.h"
#include "ui/bench/workbench.h"
#include "ui/dialogs/shortcut_keys.h"

#include <QApplication>
#include <QMenuBar>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestOwnTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        // Its line; the program's own are in registerSessionCommands(), which is given this.
        registerPushTool(m_bench.commands(), m_bench.session(),
                         const_cast<Interaction &>(m_bench.interaction()));
        m_actions = std::make_unique<ActionSet>(m_bench);
        m_actions->fill(&m_menus, [](const QString &, QMenu *) {});
        connect(m_actions.get(), &ActionSet::triggered, &m_bench,
                [this](const QString &id) { m_bench.run(id); });
    }

    void everyCommandOfAMenuHasWords();
    void itStandsInItsMenu();
    void itIsGreyedWithItsReason();
    void itIsCheckedWhileItIsHeld();
    void itsKeysAreItsOwn();

private:
    QAction *push() { return m_actions->action("test.push"); }

    Workbench m_bench;
    QMenuBar m_menus;
    std::unique_ptr<ActionSet> m_actions;
};

// Wrong: an action that no command is behind does nothing when it is pressed.
void TestOwnTool::everyCommandOfAMenuHasWords()
{
    for (const CommandWords *words : m_bench.commands().offered()) {
        QVERIFY2(m_bench.commands().contains(words->id), words->id);
        QVERIFY2(m_actions->action(words->id), words->id);
    }
}

void TestOwnTool::itStandsInItsMenu()
{
    const QList<ListedAction> found = foundActions(QStringLiteral("push"), listedActions(m_menus));
    QVERIFY(!found.isEmpty());
    QCOMPARE(found.front().action.data(), push());
    QCOMPARE(found.front().menuPath, QStringLiteral("Checks"));
}

void TestOwnTool::itIsGreyedWithItsReason()
{
    QVERIFY(!push()->isEnabled());
    QCOMPARE(ActionSet::sentence(push()), QStringLiteral("There is no section yet"));
    m_bench.session().reset(
        withSection(newDocument(), polygonShape(rectangle(-60, 20, 60, 120)), front()));
    QVERIFY(push()->isEnabled());
    QCOMPARE(ActionSet::sentence(push()), QStringLiteral("Push the model at a place"));
}

void TestOwnTool::itIsCheckedWhileItIsHeld()
{
    QVERIFY(push()->isCheckable() && !push()->isChecked());
    push()->trigger();
    QVERIFY(m_bench.interaction().tool());
    QTRY_VERIFY(push()->isChecked());
    QCOMPARE(hintSentence(m_bench.interaction().hint(), {}),
             QStringLiteral("Click where it is pushed."));
    push()->trigger();
    QVERIFY(!m_bench.interaction().tool());
    QTRY_VERIFY(!push()->isChecked());
}

void TestOwnTool::itsKeysAreItsOwn()
{
    const ShortcutKeys keys(listedActions(m_menus));
    const QKeySequence own(QStringLiteral("Ctrl+Alt+P"));
    QCOMPARE(keys.of(QStringLiteral("test.push")), QList<QKeySequence>{own});
    QCOMPARE(keys.ownerOf(own, {}), QStringLiteral("test.push"));
    QVERIFY(!keys.isChanged(QStringLiteral("test.push")));
}

FFF_TEST_WITH(TestOwnTool, fff::testing::runWithin<TestOwnTool, QApplication>)
#include "tst_own_tool.moc"
