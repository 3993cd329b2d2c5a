// Operations in Properties and Outline as a person uses them, in a window without its view.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/tool.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"
#include "ui/base/field_style.h"
#include "ui/base/message_bar.h"
#include "ui/base/translations.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestOperationsDocks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_window.reset(); }

    void thePanelHasWhatTheKindAsksFor();
    void aSliderIsLiveAndOneStep();
    void escapeGivesADragUp();
    void choicesAndSwitches();
    void whatFollowsCanBeSetAndSetFree();
    void rowsComeAndGo();
    void oneIsLeftOutAndShownAgain();
    void oneIsDetached();
    void aStockOfItsOwn();
    void inputsAreNamedAndChosen();
    void aListLosesOneAndChangesItsOrder();
    void offAndOn();
    void theTreeFollows();
    void theTreeSelectsAndRenames();
    void theOrderChanges();
    void theEyeHidesThem();
    void aLostInputIsSaid();
    void actionsSayWhyNot();
    void theBarFolds();
    void whatNeedsASectionWaitsForIt();
    void everyKindHasAnIcon();

private:
    void makeRibs();
    Workbench &bench() { return m_window->bench(); }
    Session &session() { return bench().session(); }
    const Operation &ribs() { return *session().committed().document.operations.front(); }
    std::size_t count() { return session().committed().sectionCount(); }
    int steps() { return session().history()->count(); }
    QString lastStep() { return session().history()->undoText(); }
    template <class Widget>
    Widget *field(const char *name)
    {
        for (Widget *widget : m_window->findChildren<Widget *>(QLatin1String(name)))
            if (widget->isVisible())
                return widget;
        return nullptr;
    }
    template <class Widget>
    Widget *in(const char *row)
    {
        QWidget *box = field<QWidget>(row);
        return box ? box->findChild<Widget *>() : nullptr;
    }
    QAbstractButton *segment(const char *row, const QString &text)
    {
        for (QAbstractButton *button : field<QWidget>(row)->findChildren<QAbstractButton *>())
            if (button->text() == text)
                return button;
        return nullptr;
    }
    QAction *actionOf(const char *id) { return m_window->findChild<QAction *>(QLatin1String(id)); }
    QTreeWidget *tree()
    {
        return m_window->findChild<QTreeWidget *>(QStringLiteral("operationTree"));
    }
    double number(const char *key) { return std::get<double>(ribs().parameters.at(key)); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    FishBones m_bones;
};

void TestOperationsDocks::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1440, 900);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    QApplication::setActiveWindow(m_window.get());
    m_bones = FishBones();
    session().reset(m_bones.document);
}

void TestOperationsDocks::makeRibs()
{
    bench().run(QStringLiteral("operation.linear"),
                {{"section", "Rib"}, {"along", "Spine"}, {"side", "both"}, {"name", "Ribs"}});
    QCOMPARE(count(), 2U + 7U);
}

// Wrong: an operation that is made could not be changed.
void TestOperationsDocks::thePanelHasWhatTheKindAsksFor()
{
    makeRibs();
    QCOMPARE(field<QLineEdit>("propertiesName")->text(), QStringLiteral("Ribs"));
    QCOMPARE(field<QLabel>("propertiesKind")->text(),
             QStringLiteral("Linear · 7 sections · up to date"));
    for (const ParameterSpec &spec : operationKind("linear")->parameters)
        QCOMPARE(field<QWidget>(spec.key) != nullptr,
                 counts(spec, ribs()) || std::string(spec.key) == "spacing");
    // What the count decides is said, but not asked for.
    QVERIFY(!field<QWidget>("spacing")->isEnabled());
    QVERIFY(in<QDoubleSpinBox>("spacing")->value() > 1.0);
    QCOMPARE(field<QAbstractButton>("section")->text(), QStringLiteral("Rib"));
    QCOMPARE(field<QAbstractButton>("along")->text(), QStringLiteral("Spine"));
    // The panel is no wider than the dock.
    auto *area = field<QWidget>("operationBake");
    QVERIFY(area->mapTo(m_window.get(), QPoint(0, 0)).x() > 0);
    auto *dock = field<QWidget>("propertiesDock");
    QVERIFY2(dock->findChild<QWidget *>(QStringLiteral("operationDelete"))
                         ->mapTo(dock, QPoint(0, 0))
                         .x() +
                     field<QWidget>("operationDelete")->width() <=
                 dock->width(),
             "nothing is cut off at the right");
}

// Wrong: one would not see what a number does until it is set, or Undo would go back notch by
// notch.
void TestOperationsDocks::aSliderIsLiveAndOneStep()
{
    makeRibs();
    const int before = steps();
    auto *slider = in<QSlider>("count");
    slider->setSliderDown(true);
    slider->setValue(12);
    QVERIFY(session().hasPreview());
    QCOMPARE(session().model().sectionCount(), 2U + 11U);
    QCOMPARE(count(), 2U + 7U);
    slider->setValue(15);
    QCOMPARE(session().model().sectionCount(), 2U + 14U);
    slider->setSliderDown(false);
    QVERIFY(!session().hasPreview());
    QCOMPARE(count(), 2U + 14U);
    QCOMPARE(steps(), before + 1);
    QCOMPARE(lastStep(), QStringLiteral("Ribs: Count 8 → 15"));
    session().history()->undo();
    QCOMPARE(slider->value(), 8);
    // Typed.
    auto *edit = in<QDoubleSpinBox>("to");
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QStringLiteral("75"));
    QTest::keyClick(edit, Qt::Key_Return);
    QCOMPARE(number("to"), 0.75);
    QCOMPARE(lastStep(), QStringLiteral("Ribs: To 100\u202f% → 75\u202f%"));
}

// Wrong: a drag that one thinks better of would stay.
void TestOperationsDocks::escapeGivesADragUp()
{
    makeRibs();
    const int before = steps();
    auto *slider = in<QSlider>("count");
    slider->setFocus();
    slider->setSliderDown(true);
    slider->setValue(20);
    QVERIFY(session().hasPreview());
    QTest::keyClick(slider, Qt::Key_Escape);
    QVERIFY(!session().hasPreview());
    QCOMPARE(steps(), before);
    QCOMPARE(count(), 2U + 7U);
}

// Wrong: a button would show what was clicked, not what is so.
void TestOperationsDocks::choicesAndSwitches()
{
    makeRibs();
    QTest::mouseClick(segment("repeatBy", QStringLiteral("Spacing")), Qt::LeftButton);
    QCOMPARE(std::get<std::string>(ribs().parameters.at("repeatBy")), std::string("spacing"));
    QVERIFY(segment("repeatBy", QStringLiteral("Spacing"))->isChecked());
    QVERIFY(field<QWidget>("spacing")->isEnabled());
    session().history()->undo();
    QVERIFY(segment("repeatBy", QStringLiteral("Count"))->isChecked());
    auto *equal = field<QCheckBox>("equalDepth");
    QVERIFY(equal->isChecked());
    QTest::mouseClick(equal, Qt::LeftButton, {}, QPoint(8, equal->height() / 2));
    QCOMPARE(std::get<bool>(ribs().parameters.at("equalDepth")), false);
    QCOMPARE(lastStep(), QStringLiteral("Ribs: Equal depth inside on → off"));
}

// Wrong: an angle that was set once would stay when the source turns.
void TestOperationsDocks::whatFollowsCanBeSetAndSetFree()
{
    bench().run(QStringLiteral("operation.revolve"),
                {{"section", "Rib"}, {"along", "Spine"}, {"name", "Ribs"}});
    QVERIFY(!ribs().parameters.contains("angle"));
    const double own = in<QDoubleSpinBox>("angle")->value();
    auto *free = field<QToolButton>("parameterFree");
    QVERIFY(!free);
    auto *slider = in<QSlider>("angle");
    slider->setSliderDown(true);
    slider->setValue(slider->value() + 20);
    slider->setSliderDown(false);
    QVERIFY(ribs().parameters.contains("angle"));
    free = field<QToolButton>("parameterFree");
    QVERIFY(free);
    QTest::mouseClick(free, Qt::LeftButton);
    QVERIFY(!ribs().parameters.contains("angle"));
    QCOMPARE(in<QDoubleSpinBox>("angle")->value(), own);
}

// Wrong: numbers that do nothing would ask to be set.
void TestOperationsDocks::rowsComeAndGo()
{
    makeRibs();
    QVERIFY(!field<QWidget>("strength"));
    bench().run(QStringLiteral("operation.change"), {{"scale", "thickness"}});
    QVERIFY(field<QWidget>("strength"));
    bench().run(QStringLiteral("operation.mirror"), {{"name", "Both sides"}});
    QVERIFY(!field<QWidget>("strength"));
    QVERIFY(field<QWidget>("join"));
    QVERIFY2(!field<QWidget>("across"), "only a section's plane asks for a section");
    const auto hasInputs = [this] {
        for (QPushButton *title :
             m_window->findChildren<QPushButton *>(QStringLiteral("groupTitle")))
            if (title->isVisible() && title->text() == QStringLiteral("Inputs"))
                return true;
        return false;
    };
    QVERIFY2(!hasInputs(), "a heading over nothing");
    bench().run(QStringLiteral("operation.change"), {{"plane", "section"}});
    QVERIFY(field<QWidget>("across"));
    QVERIFY(hasInputs());
}

// Wrong: what was left out could not be had back.
void TestOperationsDocks::oneIsLeftOutAndShownAgain()
{
    makeRibs();
    const SectionRef third = session().committed().ref(4);
    const QString name = QString::fromStdString(session().committed().nameOf(third));
    bench().select({third});
    QCOMPARE(field<QLabel>("propertiesTitle")->text(), name);
    // What it is made of is a click away.
    QCOMPARE(in<QAbstractButton>("instanceSource")->text(), QStringLiteral("Rib"));
    auto *leaveOut = field<QCheckBox>("instanceLeaveOut");
    QTest::mouseClick(leaveOut, Qt::LeftButton, {}, QPoint(8, leaveOut->height() / 2));
    QCOMPARE(count(), 2U + 6U);
    QCOMPARE(bench().interaction().selectedOperation(), ribs().id);
    auto *show = field<QWidget>("exceptionShow");
    QVERIFY(show);
    QVERIFY(show->parentWidget()->findChild<QLabel *>()->text().startsWith(name));
    QTest::mouseClick(show->findChild<QAbstractButton *>(), Qt::LeftButton);
    QCOMPARE(count(), 2U + 7U);
    QVERIFY(!field<QWidget>("exceptionShow"));
}

// Wrong: one rib that is to be other than all could not be drawn anew.
void TestOperationsDocks::oneIsDetached()
{
    makeRibs();
    bench().select({session().committed().ref(4)});
    QTest::mouseClick(field<QPushButton>("instanceDetach"), Qt::LeftButton);
    QCOMPARE(session().committed().document.sections.size(), 3U);
    QCOMPARE(count(), 2U + 7U);
    QCOMPARE(bench().interaction().selection(),
             std::vector{SectionRef(session().committed().document.sections[2]->id)});
    QVERIFY(!field<QPushButton>("instanceDetach"));
}

// Wrong: one part of thicker wood would need an operation of its own.
void TestOperationsDocks::aStockOfItsOwn()
{
    makeRibs();
    Stock thick = *session().committed().document.stocks.front();
    thick.name = "Thick";
    thick.thickness = 6.0;
    bench().commit(QStringLiteral("Stock"), addStock(session().committed().document, thick));
    const SectionRef third = session().committed().ref(4);
    bench().select({third});
    auto *box = field<QComboBox>("sectionStock");
    for (int i = 0; i < box->count(); ++i)
        if (box->itemText(i).startsWith(QStringLiteral("Thick"))) {
            box->setCurrentIndex(i);
            Q_EMIT box->activated(i);
            break;
        }
    QCOMPARE(session().committed().stockOf(4).thickness, 6.0);
    QCOMPARE(session().committed().stockOf(3).thickness, 3.0);
    QCOMPARE(ribs().exceptions.size(), 1U);
}

// Wrong: a source could not be exchanged.
void TestOperationsDocks::inputsAreNamedAndChosen()
{
    makeRibs();
    auto *along = field<QAbstractButton>("along");
    QTest::mouseClick(along, Qt::LeftButton);
    const Tool *tool = bench().interaction().tool();
    QVERIFY(tool);
    QCOMPARE(tool->asksFor().role, std::string("along"));
    QVERIFY2(along->isChecked(), "as long as the view asks");
    QTest::mouseClick(along, Qt::LeftButton);
    QVERIFY2(!bench().interaction().tool(), "a second click lets it be");
    QVERIFY(!along->isChecked());
    // A section that is renamed is called so here, too.
    bench().commit(QStringLiteral("Rename"),
                   renameSection(session().committed().document, m_bones.spine, "Back"));
    QCOMPARE(along->text(), QStringLiteral("Back"));
}

// Wrong: the order of a blend's sections could not be mended.
void TestOperationsDocks::aListLosesOneAndChangesItsOrder()
{
    makeRibs();
    bench().run(QStringLiteral("operation.blend"),
                {{"sections", "Rib\nRib 2\nRib 3"}, {"along", "Spine"}, {"name", "Between"}});
    const auto inputs = [this] {
        std::vector<std::string> names;
        for (const OperationInput &input :
             session().committed().document.operations[1]->inputs.at("sections"))
            names.push_back(input.name);
        return names;
    };
    auto *list = field<QListWidget>("sections");
    QCOMPARE(list->count(), 3);
    QVERIFY(list->model()->moveRow(QModelIndex(), 2, QModelIndex(), 0));
    QCoreApplication::processEvents();
    QCOMPARE(inputs(), (std::vector<std::string>{"Rib 3", "Rib", "Rib 2"}));
    list->setCurrentRow(1);
    QTest::keyClick(list, Qt::Key_Delete);
    QCOMPARE(inputs(), (std::vector<std::string>{"Rib 3", "Rib 2"}));
    QCOMPARE(list->count(), 2);
}

// Wrong: to look at a model without its ribs one would have to delete them.
void TestOperationsDocks::offAndOn()
{
    makeRibs();
    auto *on = field<QCheckBox>("operationOn");
    QTest::mouseClick(on, Qt::LeftButton, {}, QPoint(8, on->height() / 2));
    QCOMPARE(count(), 2U);
    QCOMPARE(field<QLabel>("propertiesKind")->text(), QStringLiteral("Linear · switched off"));
    QCOMPARE(tree()->topLevelItem(0)->text(1), QStringLiteral("off"));
    QTest::mouseClick(on, Qt::LeftButton, {}, QPoint(8, on->height() / 2));
    QCOMPARE(count(), 2U + 7U);
}

// Wrong: the list would say other than what is there; or sections that are made would stand with
// the drawn ones.
void TestOperationsDocks::theTreeFollows()
{
    QVERIFY2(!tree()->isVisible(), "without operations there is no list of them");
    makeRibs();
    QVERIFY(tree()->isVisible());
    QCOMPARE(tree()->topLevelItemCount(), 1);
    QTreeWidgetItem *item = tree()->topLevelItem(0);
    QCOMPARE(item->text(1), QStringLiteral("7"));
    item->setExpanded(true);
    QCOMPARE(item->childCount(), 7);
    QVERIFY(item->child(0)->font(0).italic());
    bench().run(QStringLiteral("operation.change"), {{"count", "5"}});
    QCOMPARE(item->childCount(), 4);
    auto *drawn = m_window->findChild<QTreeWidget *>(QStringLiteral("outlineTree"));
    QCOMPARE(
        drawn->findItems(QStringLiteral("Rib"), Qt::MatchStartsWith | Qt::MatchRecursive).size(),
        1);
    session().history()->undo();
    session().history()->undo();
    QCOMPARE(tree()->topLevelItemCount(), 0);
}

// Wrong: list and view would show two things as selected.
void TestOperationsDocks::theTreeSelectsAndRenames()
{
    makeRibs();
    QTreeWidgetItem *item = tree()->topLevelItem(0);
    QVERIFY2(item->isSelected(), "what was made is selected");
    item->setExpanded(true);
    bench().select({session().committed().ref(3)});
    QVERIFY(!item->isSelected());
    QCOMPARE(tree()->selectedItems().size(), 1);
    QCOMPARE(tree()->selectedItems().front()->text(0),
             QString::fromStdString(session().committed().section(3)->name));
    tree()->clearSelection();
    tree()->setCurrentItem(item);
    QCOMPARE(bench().interaction().selectedOperation(), ribs().id);
    item->setText(0, QStringLiteral("Bones"));
    QCoreApplication::processEvents();
    QCOMPARE(ribs().name, std::string("Bones"));
    QCOMPARE(field<QLineEdit>("propertiesName")->text(), QStringLiteral("Bones"));
    item->setText(0, QStringLiteral("  "));
    QCoreApplication::processEvents();
    QCOMPARE(item->text(0), QStringLiteral("Bones"));
    // In the panel.
    auto *name = field<QLineEdit>("propertiesName");
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("Fish bones"));
    QTest::keyClick(name, Qt::Key_Return);
    QCOMPARE(ribs().name, std::string("Fish bones"));
    QCOMPARE(item->text(0), QStringLiteral("Fish bones"));
}

// Wrong: an operation that is to work on what another one makes could not be put below it.
void TestOperationsDocks::theOrderChanges()
{
    makeRibs();
    bench().run(QStringLiteral("operation.mirror"), {{"name", "Both sides"}});
    const auto names = [this] {
        QStringList all;
        for (int i = 0; i < tree()->topLevelItemCount(); ++i)
            all += tree()->topLevelItem(i)->text(0);
        return all;
    };
    QCOMPARE(names(), (QStringList{QStringLiteral("Ribs"), QStringLiteral("Both sides")}));
    tree()->setCurrentItem(tree()->topLevelItem(1));
    QTest::keyClick(tree(), Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(names(), (QStringList{QStringLiteral("Both sides"), QStringLiteral("Ribs")}));
    QCOMPARE(ribs().name, std::string("Both sides"));
    actionOf("operation.moveDown")->trigger();
    QCOMPARE(ribs().name, std::string("Ribs"));
    QTest::keyClick(tree(), Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(ribs().name, std::string("Ribs"));
}

// Wrong: forty ribs would have to be hidden one by one.
void TestOperationsDocks::theEyeHidesThem()
{
    makeRibs();
    tree()->setCurrentItem(tree()->topLevelItem(0));
    QTest::keyClick(tree(), Qt::Key_Space);
    for (std::size_t i = 2; i < count(); ++i)
        QVERIFY(bench().isHidden(session().committed().ref(i)));
    QVERIFY(!bench().isHidden(session().committed().ref(1)));
    QTest::keyClick(tree(), Qt::Key_Space);
    QVERIFY(!bench().isHidden(session().committed().ref(3)));
}

// Wrong: the ribs would be gone, and nobody said why.
void TestOperationsDocks::aLostInputIsSaid()
{
    makeRibs();
    bench().select({SectionRef(m_bones.rib)});
    bench().run(QStringLiteral("edit.delete"));
    QCOMPARE(count(), 1U);
    auto *messages = m_window->findChild<MessageBar *>(QStringLiteral("messageBar"));
    QVERIFY(messages->isVisible());
    QVERIFY(messages->text().contains(QStringLiteral("Ribs has lost its section “Rib”")));
    bench().selectOperation(ribs().id);
    QVERIFY(field<QLabel>("operationProblem")->text().contains(QStringLiteral("Rib")));
    QCOMPARE(field<QLabel>("propertiesKind")->text(), QStringLiteral("Linear · makes nothing"));
    QCOMPARE(field<QAbstractButton>("section")->text(), QStringLiteral("Rib (deleted)"));
    QVERIFY(!tree()->topLevelItem(0)->icon(2).isNull());
    session().history()->undo();
    QCOMPARE(count(), 2U + 7U);
    QVERIFY(!field<QLabel>("operationProblem"));
}

// Wrong: a greyed entry that does not say what it waits for; or an operation that is greyed.
void TestOperationsDocks::actionsSayWhyNot()
{
    // Those that need a mesh wait for one, the others ask for what they need.
    for (const OperationKind *kind : operationKinds())
        QCOMPARE(actionOf((std::string("operation.") + kind->key).c_str())->isEnabled(),
                 !kind->isOfTemplate);
    QVERIFY(!actionOf("operation.bake")->isEnabled());
    QVERIFY(!actionOf("operation.bake")->toolTip().isEmpty());
    makeRibs();
    QVERIFY(actionOf("operation.bake")->isEnabled());
    QVERIFY(!actionOf("operation.moveUp")->isEnabled());
    actionOf("operation.bake")->trigger();
    QCOMPARE(session().committed().document.sections.size(), 9U);
    session().history()->undo();
    actionOf("edit.delete")->trigger();
    QVERIFY(session().committed().document.operations.empty());
    // Without what it needs, it asks.
    bench().select({});
    actionOf("operation.linear")->trigger();
    QVERIFY(bench().interaction().tool());
    QVERIFY(actionOf("operation.linear")->isChecked());
    actionOf("operation.linear")->trigger();
    QVERIFY(!bench().interaction().tool());
    QVERIFY(!actionOf("operation.linear")->isChecked());
}

// Wrong: in a small window operations could not be had.
void TestOperationsDocks::theBarFolds()
{
    auto *bar = m_window->findChild<QToolBar *>(QStringLiteral("mainToolBar"));
    const auto hasButton = [&](const char *id) { return bar->widgetForAction(actionOf(id)); };
    QVERIFY(hasButton("operation.revolve"));
    QVERIFY(!field<QToolButton>("repeatButton"));
    m_window->resize(1100, 800);
    QCoreApplication::processEvents();
    QVERIFY(!hasButton("operation.revolve"));
    auto *repeat = field<QToolButton>("repeatButton");
    QVERIFY(repeat);
    QCOMPARE(repeat->menu()->actions().size(), 8);
    // A word that is too long for the bar is left out, not cut in its middle.
    QCOMPARE(repeat->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    const QString word = repeat->text();
    repeat->setText(word.repeated(20));
    m_window->resize(1099, 800);
    QCoreApplication::processEvents();
    QCOMPARE(repeat->toolButtonStyle(), Qt::ToolButtonIconOnly);
    repeat->setText(word);
    m_window->resize(1100, 800);
    QCoreApplication::processEvents();
    QCOMPARE(repeat->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    m_window->resize(1440, 900);
    QCoreApplication::processEvents();
    QVERIFY(hasButton("operation.revolve"));
    QVERIFY(!field<QToolButton>("repeatButton"));
}

/// Wrong: a person is asked to click on another section, and there is none.
void TestOperationsDocks::whatNeedsASectionWaitsForIt()
{
    const Document both = session().committed().document;
    QVERIFY(both.sections.size() > 1);
    for (const std::size_t count : {std::size_t(0), std::size_t(1), both.sections.size()}) {
        Document some = both;
        some.operations.clear(); // their images are sections too
        some.sections.resize(count);
        session().reset(some);
        if (count > 0)
            m_window->bench().select({session().committed().ref(0)});
        QCoreApplication::processEvents();
        for (const char *id : {"check.nextProblem", "check.previousProblem"})
            QCOMPARE(actionOf(id)->isEnabled(), count > 0);
        for (const char *id : {"section.putOn", "edit.mirrorCopySection"}) {
            QCOMPARE(m_window->findChildren<QAction *>(QLatin1String(id)).size(), 1);
            QCOMPARE(actionOf(id)->isEnabled(), count > 1);
        }
    }
}

// Wrong: a new kind would stand in the list without a picture.
void TestOperationsDocks::everyKindHasAnIcon()
{
    for (const OperationKind *kind : operationKinds())
        QVERIFY2(QFile::exists(QStringLiteral(":/icons/%1.png").arg(QLatin1String(kind->key))),
                 kind->key);
}

FFF_TEST_WITH(TestOperationsDocks, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    installTranslations(application);
    TestOperationsDocks test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_operations_docks.moc"
