// What the docks say of a selected weight, and its key, in a window without its view.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/interaction/load_marks.h"
#include "core/model/load_edits.h"
#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/field_style.h"
#include "ui/properties/number_edit.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTreeWidget>
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
    void thePageHasItsNumbers();
    void aGlassHoldsWater();
    void aPushHasADirection();
    void theOutlineListsThem();

private:
    Session &session() { return m_window->bench().session(); }
    LoadId hang(const char *name);
    void type(const char *field, const QString &text);
    void choose(const char *box, int index);
    bool isShown(const char *name) const;
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

LoadId TestWeightDocks::hang(const char *name)
{
    const Document square = squareDocument();
    Load weight{{}, square.sections.front()->ref(), Vec2(10, 20), 0.35, name};
    session().commit(QStringLiteral("Hang"), *addLoad(square, weight));
    return session().committed().document.loads.front().id;
}

// Wrong: it says that nothing is selected, while keys do something to the weight.
void TestWeightDocks::theHeaderSaysWhatIsSelected()
{
    m_window->bench().selectLoad(hang(""));
    QCOMPARE(text("propertiesTitle"), QStringLiteral("Weight"));
    QCOMPARE(text("propertiesKind"), QStringLiteral("350\u202Fg on Plate"));
    m_window->bench().selectLoad(hang("Cup"));
    QCOMPARE(text("propertiesTitle"), QStringLiteral("Cup"));
    QCOMPARE(text("propertiesKind"), QStringLiteral("350\u202Fg on Plate"));
    m_window->bench().select({});
    QCOMPARE(text("propertiesTitle"), QStringLiteral("Model"));
}

// Wrong: the command is grey, or takes the section away.
void TestWeightDocks::delRemovesIt()
{
    m_window->bench().selectLoad(hang("Cup"));
    const Document before = session().committed().document;
    auto *action = m_window->findChild<QAction *>(QStringLiteral("edit.delete"));
    QVERIFY(action && action->isEnabled());
    action->trigger();
    QVERIFY(session().committed().document.loads.empty());
    QCOMPARE(session().committed().sectionCount(), std::size_t(1));
    session().history()->undo();
    QVERIFY(session().committed().document.isSame(before));
    QVERIFY(m_window->bench().interaction().selectedLoad().isValid());
}

/// As one types it.
void TestWeightDocks::type(const char *field, const QString &text)
{
    auto *edit = m_window->findChild<NumberEdit *>(QLatin1String(field));
    QVERIFY2(edit && edit->isVisibleTo(m_window.get()), field);
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
}

void TestWeightDocks::choose(const char *box, int index)
{
    auto *choice = m_window->findChild<QComboBox *>(QLatin1String(box));
    QVERIFY2(choice && choice->isVisibleTo(m_window.get()), box);
    choice->setCurrentIndex(index);
    Q_EMIT choice->activated(index);
}

bool TestWeightDocks::isShown(const char *name) const
{
    const auto *widget = m_window->findChild<QWidget *>(QLatin1String(name));
    return widget && widget->isVisibleTo(m_window.get());
}

// Wrong: a number is another one's, or becomes no step of the history.
void TestWeightDocks::thePageHasItsNumbers()
{
    const LoadId id = hang("");
    m_window->bench().selectLoad(id);
    const auto load = [&] { return *session().committed().document.find(id); };
    QVERIFY(isShown("loadMass") && !isShown("loadForce") && !isShown("loadWidth"));
    QVERIFY(!isShown("loadRepeated")); // nothing copies its section
    type("loadMass", QStringLiteral("2 lb"));
    QVERIFY(std::abs(load().mass - 0.90718474) < 1e-9);
    type("loadX", QStringLiteral("3*4"));
    QCOMPARE(load().position.x(), 12.0);
    type("loadX", QStringLiteral("9000")); // beside its section: said, and not done
    QCOMPARE(load().position.x(), 12.0);
    choose("loadSpread", 1);
    QCOMPARE(load().spread, Spread::Patch);
    QVERIFY(isShown("loadWidth"));
    type("loadWidth", QStringLiteral("35"));
    QCOMPARE(load().width, 35.0);
    auto *name = m_window->findChild<QLineEdit *>(QStringLiteral("propertiesName"));
    QVERIFY(name && name->isVisibleTo(m_window.get()));
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("Jar"));
    QTest::keyClick(name, Qt::Key_Return);
    QCOMPARE(load().name, std::string("Jar"));
    const int steps = session().history()->count();
    QCOMPARE(steps, 6); // with that of hanging it
    m_window->findChild<QPushButton *>(QStringLiteral("loadRemove"))->click();
    QVERIFY(session().committed().document.loads.empty());
    QVERIFY(!isShown("loadMass"));
}

void TestWeightDocks::aGlassHoldsWater()
{
    const LoadId id = hang("");
    m_window->bench().selectLoad(id);
    const auto load = [&] { return *session().committed().document.find(id); };
    QVERIFY(!isShown("loadWater.field"));
    choose("loadPreset", 1);
    QCOMPARE(load().preset, std::string("glass"));
    QCOMPARE(load().name, std::string("Glass of water"));
    QVERIFY(std::abs(load().mass - 0.35) < 1e-12);
    QVERIFY(isShown("loadWater.field"));
    // Wrong: a field beyond the dock's edge, as wide as the largest number that it takes.
    const auto *field = m_window->findChild<QWidget *>(QStringLiteral("loadWater.field"));
    const auto *dock = m_window->findChild<QWidget *>(QStringLiteral("propertiesDock"));
    QCoreApplication::processEvents();
    QVERIFY(field->mapTo(dock, QPoint(field->width(), 0)).x() <= dock->width());
    type("loadWater.field", QStringLiteral("350"));
    QVERIFY(std::abs(load().mass - 0.625) < 1e-12);
    QVERIFY(std::abs(load().filled - 0.35) < 1e-12);
    // Wrong: a slider that ends before the vessel is full, or goes on beyond that.
    const auto *slider = m_window->findChild<QSlider *>(QStringLiteral("loadWaterSlider"));
    QCOMPARE(slider->value(), slider->maximum());
    choose("loadPreset", 6);
    QCOMPARE(load().preset, std::string("pot"));
    type("loadWater.field", QStringLiteral("300"));
    QCOMPARE(slider->value(), slider->maximum());
    type("loadWater.field", QStringLiteral("150"));
    QCOMPARE(2 * slider->value(), slider->maximum());
    choose("loadPreset", 5);
    QCOMPARE(load().name, std::string("Book"));
    QCOMPARE(load().filled, 0.0);
    choose("loadPreset", 0);
    QVERIFY(load().preset.empty() && load().name == "Book");
}

void TestWeightDocks::aPushHasADirection()
{
    Document square = squareDocument();
    Load push{{}, square.sections.front()->ref(), Vec2(10, 20)};
    push.kind = LoadKind::Push;
    push.push = Vec3(0.0, 0.0, -4.0);
    session().commit(QStringLiteral("Push"), *addLoad(square, push));
    const LoadId id = session().committed().document.loads.front().id;
    m_window->bench().selectLoad(id);
    const auto load = [&] { return *session().committed().document.find(id); };
    QCOMPARE(text("propertiesTitle"), QStringLiteral("Push"));
    QVERIFY(!isShown("loadMass") && isShown("loadForce"));
    type("loadForce", QStringLiteral("12.5"));
    QVERIFY((load().push - Vec3(0.0, 0.0, -12.5)).norm() < 1e-9);
    const Frame &frame = session().committed().document.sections.front()->frame;
    const Vec3 before = pushInWorld(load().push, frame).normalized();
    const int axis = std::abs(before.y()) > 0.5 ? 0 : 1;
    type(axis == 0 ? "loadDirectionX" : "loadDirectionY", QStringLiteral("1"));
    Vec3 wanted = before;
    wanted[axis] = 1.0;
    QVERIFY((pushInWorld(load().push, frame) - 12.5 * wanted.normalized()).norm() < 1e-9);
}

// Wrong: a heading over nothing, or a row that is another one's.
void TestWeightDocks::theOutlineListsThem()
{
    QVERIFY(!isShown("loadTree") && !isShown("loadsTitle"));
    hang("Cup");
    auto *tree = m_window->findChild<QTreeWidget *>(QStringLiteral("loadTree"));
    QVERIFY(isShown("loadTree"));
    QCOMPARE(text("loadsTitle"), QStringLiteral("Weights"));
    QCOMPARE(tree->topLevelItemCount(), 1);
    QCOMPARE(tree->topLevelItem(0)->text(0), QStringLiteral("Cup"));
    QCOMPARE(tree->topLevelItem(0)->text(1).trimmed(), QStringLiteral("350\u202Fg"));
    tree->setCurrentItem(tree->topLevelItem(0));
    QCOMPARE(m_window->bench().interaction().selectedLoad(),
             session().committed().document.loads.front().id);
    tree->topLevelItem(0)->setText(0, QStringLiteral("Mug"));
    QCoreApplication::processEvents();
    QCOMPARE(session().committed().document.loads.front().name, std::string("Mug"));
    session().history()->undo();
    QCOMPARE(tree->topLevelItem(0)->text(0), QStringLiteral("Cup"));
    session().history()->undo();
    QVERIFY(!isShown("loadTree"));
    // Two without names of their own are told apart by where they hang.
    hang("");
    QCOMPARE(tree->topLevelItem(0)->text(0), QStringLiteral("Plate"));
    const Document &now = session().committed().document;
    session().commit(QStringLiteral("Rename"),
                     *renameSection(now, now.sections.front()->id, "Body"));
    QCOMPARE(tree->topLevelItem(0)->text(0), QStringLiteral("Body"));
}

FFF_TEST_WITH(TestWeightDocks, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    TestWeightDocks test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_weight_docks.moc"
