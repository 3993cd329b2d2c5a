// What the docks say of a selected weight, and its key, in a window without its view.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/field_style.h"

#include <QAction>
#include <QLabel>
#include <QUndoStack>

#include <memory>

using namespace fff;
using namespace fff::ui;

class TestWeightDocks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_window.reset(); }
    void theHeaderSaysWhatIsSelected();
    void delRemovesIt();

private:
    Session &session() { return m_window->bench().session(); }
    WeightId hang(const char *name);
    QString text(const char *label)
    {
        return m_window->findChild<QLabel *>(QLatin1String(label))->text();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestWeightDocks::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1400, 900);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    QApplication::setActiveWindow(m_window.get());
}

WeightId TestWeightDocks::hang(const char *name)
{
    const Document square = squareDocument();
    Weight weight{{}, square.sections.front()->ref(), Vec2(10, 20), 0.35, name};
    session().commit(QStringLiteral("Hang"), *addWeight(square, weight));
    return session().committed().document.weights.front().id;
}

// Wrong: it says that nothing is selected, while keys do something to the weight.
void TestWeightDocks::theHeaderSaysWhatIsSelected()
{
    m_window->bench().selectWeight(hang(""));
    QCOMPARE(text("propertiesTitle"), QStringLiteral("Weight"));
    QCOMPARE(text("propertiesKind"), QStringLiteral("350\u202Fg on Plate"));
    m_window->bench().selectWeight(hang("Cup"));
    QCOMPARE(text("propertiesTitle"), QStringLiteral("Cup"));
    m_window->bench().select({});
    QCOMPARE(text("propertiesTitle"), QStringLiteral("Model"));
}

// Wrong: the command is grey, or takes the section away.
void TestWeightDocks::delRemovesIt()
{
    m_window->bench().selectWeight(hang("Cup"));
    const Document before = session().committed().document;
    auto *action = m_window->findChild<QAction *>(QStringLiteral("edit.delete"));
    QVERIFY(action && action->isEnabled());
    action->trigger();
    QVERIFY(session().committed().document.weights.empty());
    QCOMPARE(session().committed().sectionCount(), std::size_t(1));
    session().history()->undo();
    QVERIFY(session().committed().document.isSame(before));
    QVERIFY(m_window->bench().interaction().selectedWeight().isValid());
}

FFF_TEST_WITH(TestWeightDocks, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    TestWeightDocks test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_weight_docks.moc"
