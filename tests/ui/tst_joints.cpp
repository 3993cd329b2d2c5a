// Joints in a real window: with mouse, keys and the Properties dock.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/joint_state.h"
#include "core/session/session_commands.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "tests/told.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_program.h"
#include "ui/docks/joint_page.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QEnterEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>

#include <cmath>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestJoints : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { closeWindow(); }

    void aMarkIsClickedAndDragged();
    void theListMarksThem();
    void rowsAndLinksGoThereAndBack();
    void keysAreEnough();
    void kindsThatCannotBeHadSayWhy();
    void oneThatCollidesIsTrimmed();
    void theSliderIsOneStep();
    void escapeEndsTheSlidersDrag();
    void directionsAreWords();
    void menusFlipAndReset();
    void delDeletesNothing();
    void placesHaveARowEach();
    void whatIsNotSettledIsOfTheJointBefore();
    void theTabKeyGoesDownThePage();
    void theTabKeyGoesDownTheList();
    void slidersAndFieldsAreReadOut();
    void anAmpersandIsPartOfAName();

private:
    /// Two sections that share two places, and a third one that shares one with the first.
    void openTwoPlaces();
    JointRef joint(std::size_t a, std::size_t b) const
    {
        return {session().committed().ref(a), session().committed().ref(b)};
    }
    QLabel *labelOf(const char *editor) const;
    template <class Widget>
    Widget *field(const char *name)
    {
        return m_window->findChild<Widget *>(QLatin1String(name));
    }
    QPoint at(double height) const { return onScreen({0, height, 0}); }
    JointRef joint() const { return joint(0, 1); }
    JointState state() const { return *jointState(session().committed(), joint()); }
    /// Of the slit of Head.
    double percent() const { return 100.0 * (1.0 - *state().shares[0]); }
    double shown() { return field<QWidget>("jointShare1")->findChild<QDoubleSpinBox *>()->value(); }
    QAbstractButton *row() { return field<QWidget>("jointList")->findChild<QAbstractButton *>(); }
};

/// Two plates, Body and Head, that stand across each other; Body is selected.
void TestJoints::init()
{
    openWindow();
    const ShapePointer plate = polygonShape(rectangle(-50, 0, 50, 60));
    Document document = withSection(withSection(newDocument(), plate, front()), plate, side());
    document = *renameSection(document, document.sections[0]->id, "Body");
    document = *renameSection(document, document.sections[1]->id, "Head");
    session().reset(document);
    bench().showAll("iso1");
    bench().select({session().committed().ref(0)});
    m_view->setFocus();
    QTRY_VERIFY(m_view->hasFocus());
}

// Wrong: the numbers are those of before the drag, or a drag selects.
void TestJoints::aMarkIsClickedAndDragged()
{
    click(at(30));
    QTRY_VERIFY(interaction().selectedJoint() == joint());
    QCOMPARE(field<QLabel>("propertiesTitle")->text(), QStringLiteral("Body · Head"));
    QCOMPARE(field<QLabel>("propertiesKind")->text(), QStringLiteral("Cross lap · automatic"));
    QVERIFY(!field<QPushButton>("jointReset")->isEnabled());
    QVERIFY(std::abs(shown() - 50.0) < 1e-9);
    move(at(30));
    press(at(30));
    for (int i = 1; i <= 10; ++i)
        move(at(30) + (at(45) - at(30)) * i / 10);
    QTRY_VERIFY(session().hasPreview());
    QTRY_VERIFY(shown() > 70.0);
    QCOMPARE(steps(), 0);
    const double seen = shown();
    release(at(45));
    QTRY_COMPARE(steps(), 1);
    QVERIFY(std::abs(percent() - seen) < 1e-9);
    QVERIFY(std::abs(percent() - 75.0) <= 1.0);
    QCOMPARE(field<QLabel>("propertiesKind")->text(), QStringLiteral("Cross lap · set by hand"));
    QVERIFY(field<QPushButton>("jointReset")->isEnabled());
    QTest::mouseClick(field<QPushButton>("jointReset"), Qt::LeftButton);
    QVERIFY(session().committed().document.jointOverrides.empty());
    QCOMPARE(session().history()->undoText(),
             QStringLiteral("Body · Head: restore automatic settings"));
    // Wrong: the focus goes on to another dock.
    QCOMPARE(QApplication::focusWidget(), field<QComboBox>("jointKind"));
}

// Wrong: one reads of joints and does not see where they are; or all of them are seen all the time.
void TestJoints::theListMarksThem()
{
    move({5, 5}); // on no section
    const auto marked = [this] { return interaction().overlay().find<sign::Joints>() != nullptr; };
    auto *dock = field<QDockWidget>("propertiesDock");
    auto *list = field<QWidget>("jointList");
    QTRY_VERIFY(list->isVisible());
    for (QWidget *above = list; above; above = above->parentWidget())
        if (auto *area = qobject_cast<QScrollArea *>(above))
            area->ensureWidgetVisible(list);
    QTRY_VERIFY(marked());
    dock->hide();
    QTRY_VERIFY(!marked());
    move(onScreen({30, 10, 0})); // on Body, whose joint it is
    QTRY_VERIFY(marked());
    dock->show();
}

void TestJoints::rowsAndLinksGoThereAndBack()
{
    QTRY_VERIFY(row() && row()->isVisible());
    // The other section is outlined while the cursor is on its row.
    const std::vector head{session().committed().ref(1)};
    QEnterEvent enter({5, 5}, {5, 5}, {5, 5});
    QApplication::sendEvent(row(), &enter);
    QCOMPARE(bench().outlined(), head);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(row(), &leave);
    QVERIFY(bench().outlined().empty());
    QApplication::sendEvent(row(), &enter);
    QTest::mouseClick(row(), Qt::LeftButton);
    QVERIFY(bench().outlined().empty()); // the row is gone
    QVERIFY(interaction().selectedJoint() == joint());
    auto *links = field<QLabel>("jointSections");
    QVERIFY(links->isVisible() && links->text().contains(QStringLiteral("Head")));
    // The section that a link names is outlined while the cursor is on the link.
    Q_EMIT links->linkHovered(QStringLiteral("b"));
    QCOMPARE(bench().outlined(), head);
    QApplication::sendEvent(links, &leave);
    QVERIFY(bench().outlined().empty());
    bench().setOutlined(head); // by another dock
    QApplication::sendEvent(links, &leave);
    QCOMPARE(bench().outlined(), head);
    Q_EMIT links->linkHovered(QStringLiteral("b"));
    Q_EMIT links->linkActivated(QStringLiteral("b"));
    QVERIFY(bench().outlined().empty()); // the link is gone
    QCOMPARE(interaction().selection(), std::vector{session().committed().ref(1)});
    QVERIFY(!interaction().selectedJoint());
    QTRY_COMPARE(row()->accessibleName().left(4), QStringLiteral("Body"));
}

// Wrong: the focus is lost with the row that was chosen.
void TestJoints::keysAreEnough()
{
    QTRY_VERIFY(row() && row()->isVisible());
    row()->setFocus();
    QTest::keyClick(row(), Qt::Key_Return);
    QVERIFY(interaction().selectedJoint() == joint());
    QCOMPARE(QApplication::focusWidget(), field<QLabel>("jointSections"));
    key(Qt::Key_Tab);
    key(Qt::Key_Return);
    QTRY_VERIFY(!interaction().selectedJoint());
    QTRY_COMPARE(QApplication::focusWidget(), row());
}

void TestJoints::kindsThatCannotBeHadSayWhy()
{
    bench().selectJoint(joint());
    auto *kinds = field<QComboBox>("jointKind");
    QCOMPARE(kinds->currentText(), QStringLiteral("Cross lap"));
    QVERIFY(kinds->model()->flags(kinds->model()->index(0, 0)).testFlag(Qt::ItemIsEnabled));
    QVERIFY(!kinds->model()->flags(kinds->model()->index(1, 0)).testFlag(Qt::ItemIsEnabled));
    QCOMPARE(kinds->itemData(1, Qt::ToolTipRole).toString(),
             QStringLiteral("Neither section reaches beyond the other"));
    kinds->setFocus();
    QTest::keyClick(kinds, Qt::Key_End);
    QTRY_COMPARE(state().kind, JointKind::None);
    QCOMPARE(session().history()->undoText(), QStringLiteral("Body · Head: kind → none"));
    QVERIFY(!field<QWidget>("jointShare1")->isVisible());
    QVERIFY(!field<QWidget>("jointOpens")->isVisible());
    auto *problem = field<QLabel>("jointProblem");
    QVERIFY(problem->isVisible());
    QVERIFY(problem->text().startsWith(QStringLiteral("Body and Head overlap.<br>"))); // wanted so
    QTest::keyClick(kinds, Qt::Key_Home);
    QTRY_COMPARE(state().kind, JointKind::CrossLap);
    QVERIFY(session().committed().document.jointOverrides.empty());
    QVERIFY(!problem->isVisible());
}

// Wrong: two sections that collide are left to the person who drew them.
void TestJoints::oneThatCollidesIsTrimmed()
{
    bench().selectJoint(joint());
    auto *kinds = field<QComboBox>("jointKind");
    kinds->setFocus();
    QTest::keyClick(kinds, Qt::Key_End);
    QTRY_COMPARE(state().kind, JointKind::None);
    const Document before = session().committed().document;
    auto *problem = field<QLabel>("jointProblem");
    QTRY_VERIFY(problem->isVisible());
    problem->setFocus();
    QTest::keyClick(problem, Qt::Key_Tab); // to its first link
    QTest::keyClick(problem, Qt::Key_Return);
    QTRY_COMPARE(session().history()->undoText(), QStringLiteral("Trim Body to Head"));
    QVERIFY(session().committed().document.sections[0]->shape->area() <
            before.sections[0]->shape->area());
    QTRY_VERIFY(!interaction().selectedJoint()); // there is none any more
    session().history()->undo();
    QVERIFY(session().committed().document == before);
}

// Wrong: a hundred steps of the history for one drag, or slits that follow only at its end.
void TestJoints::theSliderIsOneStep()
{
    bench().selectJoint(joint());
    auto *slider = field<QWidget>("jointShare1")->findChild<QSlider *>();
    QTRY_VERIFY(slider->isVisible());
    const int y = slider->height() / 2, middle = slider->width() / 2;
    QTest::mousePress(slider, Qt::LeftButton, {}, {middle, y});
    for (int x = middle; x <= middle + 20; x += 2)
        QTest::mouseMove(slider, {x, y});
    QTRY_VERIFY(session().hasPreview());
    QCOMPARE(steps(), 0);
    const auto now = jointState(session().model(), joint());
    QVERIFY(std::abs(100.0 * (1.0 - *now->shares[0]) - shown()) < 1e-9);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {middle + 20, y});
    QTRY_COMPARE(steps(), 1);
    QVERIFY(!session().hasPreview());
    QVERIFY(percent() > 55.0);
    QVERIFY(std::abs(percent() - shown()) < 1e-9);
    session().history()->undo();
    QVERIFY(std::abs(shown() - 50.0) < 1e-9);
    // A number that is typed is one step, too, and is read back as it was typed.
    auto *edit = field<QWidget>("jointShare1")->findChild<QDoubleSpinBox *>();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QStringLiteral("37"));
    QTest::keyClick(edit, Qt::Key_Return);
    QCOMPARE(steps(), 1);
    QVERIFY(std::abs(percent() - 37.0) < 1e-9);
    QVERIFY(shown() == 37.0);
}

void TestJoints::escapeEndsTheSlidersDrag()
{
    bench().selectJoint(joint());
    auto *slider = field<QWidget>("jointShare1")->findChild<QSlider *>();
    QTRY_VERIFY(slider->isVisible());
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(session().hasPreview());
    QTest::keyClick(slider, Qt::Key_Escape);
    QVERIFY(!session().hasPreview());
    QCOMPARE(steps(), 0);
    QVERIFY(std::abs(shown() - 50.0) < 1e-9);
}

void TestJoints::directionsAreWords()
{
    bench().selectJoint(joint());
    auto *opens = field<QComboBox>("jointOpens");
    QCOMPARE(opens->currentText(), QStringLiteral("Down"));
    QCOMPARE(opens->accessibleName(), QStringLiteral("Head opens"));
    opens->setFocus();
    QTest::keyClick(opens, Qt::Key_Home);
    QTRY_COMPARE(opens->currentText(), QStringLiteral("Up"));
    QVERIFY(state().openingOfB().y() > 0.99);
    QCOMPARE(steps(), 1);
    QVERIFY(!opens->accessibleDescription().isEmpty()); // set by hand
    session().history()->undo();
    QCOMPARE(opens->currentText(), QStringLiteral("Down"));
}

void TestJoints::menusFlipAndReset()
{
    QVERIFY(!actionOf(*m_window, "joint.flip")->isEnabled());
    QVERIFY(actionOf(*m_window, "joint.flip")->toolTip().contains(QStringLiteral("No joint")));
    bench().selectJoint(joint());
    QVERIFY(actionOf(*m_window, "joint.flip")->isEnabled());
    QVERIFY(!actionOf(*m_window, "joint.reset")->isEnabled());
    actionOf(*m_window, "joint.flip")->trigger();
    QVERIFY(state().openingOfB().y() > 0.99);
    QTRY_VERIFY(actionOf(*m_window, "joint.reset")->isEnabled());
    actionOf(*m_window, "joint.reset")->trigger();
    QVERIFY(session().committed().document.jointOverrides.empty());
}

void TestJoints::delDeletesNothing()
{
    bench().selectJoint(joint());
    m_view->setFocus();
    key(Qt::Key_Delete);
    QTRY_COMPARE(interaction().hint().words.text, hints::kJointNotDeleted);
    QCOMPARE(count(), std::size_t(2));
    QCOMPARE(steps(), 0);
}

void TestJoints::openTwoPlaces()
{
    Document document = newDocument();
    document = withSection(
        document,
        polygonShape(
            {{-50, 0}, {50, 0}, {50, 80}, {30, 80}, {30, 20}, {-30, 20}, {-30, 80}, {-50, 80}}),
        front());
    document = withSection(document, polygonShape(rectangle(-60, -30, 60, 30)),
                           {{0, 50, 0}, Vec3::UnitX(), -Vec3::UnitZ()});
    document = withSection(document, polygonShape(rectangle(-30, 0, 30, 15)), side());
    session().reset(document);
}

// Wrong: of a joint with two places only one can be set.
void TestJoints::placesHaveARowEach()
{
    openTwoPlaces();
    bench().selectJoint(joint());
    QTRY_VERIFY(field<QWidget>("jointShare2") && field<QWidget>("jointShare2")->isVisible());
    auto *edit = field<QWidget>("jointShare2")->findChild<QDoubleSpinBox *>();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QStringLiteral("80"));
    QTest::keyClick(edit, Qt::Key_Return);
    QVERIFY(std::abs(*state().shares[1] - 0.2) < 1e-9);
    QVERIFY(std::abs(*state().shares[0] - 0.5) < 1e-9);
    // One with a single place has one row again.
    bench().selectJoint(joint(0, 2));
    QTRY_VERIFY(!field<QWidget>("jointShare2")->isVisible());
    QVERIFY(field<QWidget>("jointShare1")->isVisible());
    QCOMPARE(labelOf("jointShare1")->text(), QStringLiteral("Meeting point"));
}

// Wrong: it is lost, or given to another joint, whose rows are made while it is settled.
void TestJoints::whatIsNotSettledIsOfTheJointBefore()
{
    openTwoPlaces();
    bench().selectJoint(joint(0, 2));
    auto *slider = field<QWidget>("jointShare1")->findChild<QSlider *>();
    QTRY_VERIFY(slider->isVisible());
    QVERIFY(!field<QWidget>("jointShare2"));
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(steps(), 0);
    bench().selectJoint(joint());
    QCOMPARE(steps(), 1);
    QTRY_VERIFY(field<QWidget>("jointShare2") && field<QWidget>("jointShare2")->isVisible());
    QVERIFY(std::abs(*jointState(session().committed(), joint(0, 2))->shares[0] - 0.49) < 1e-9);
    QVERIFY(std::abs(*state().shares[0] - 0.5) < 1e-9);
    QCOMPARE(shown(), 50.0);
}

/// In the order of the Tab key, of those inside `page`.
QStringList inTabOrder(QWidget *page)
{
    QStringList names;
    QWidget *widget = page;
    while ((widget = widget->nextInFocusChain()) != page) {
        if (!page->isAncestorOf(widget) || widget->focusProxy() ||
            !(widget->focusPolicy() & Qt::TabFocus))
            continue;
        if (auto *button = qobject_cast<QPushButton *>(widget))
            names += button->text();
        else if (widget->objectName().isEmpty() || qobject_cast<QSlider *>(widget) ||
                 qobject_cast<QDoubleSpinBox *>(widget))
            names += widget->parentWidget()->objectName();
        else
            names += widget->objectName();
    }
    return names;
}

// Wrong: the Tab key jumps over the page, and comes to rows that were made later at the very end.
void TestJoints::theTabKeyGoesDownThePage()
{
    openTwoPlaces();
    bench().selectJoint(joint());
    QTRY_VERIFY(field<QWidget>("jointShare2") && field<QWidget>("jointShare2")->isVisible());
    const QStringList expected{QStringLiteral("jointProblem"), // when there is one
                               QStringLiteral("Joint"),
                               QStringLiteral("jointSections"),
                               QStringLiteral("jointKind"),
                               QStringLiteral("jointOpens"),
                               QStringLiteral("jointFlip"),
                               QStringLiteral("jointShare1"),
                               QStringLiteral("jointShare1"),
                               QStringLiteral("jointShare2"),
                               QStringLiteral("jointShare2"),
                               QStringLiteral("Slits"),
                               QStringLiteral("Restore automatic settings")};
    QCOMPARE(inTabOrder(m_window->findChild<JointPage *>()), expected);
}

// The same of the rows of a section's joints.
void TestJoints::theTabKeyGoesDownTheList()
{
    QTRY_VERIFY(row() && row()->isVisible());
    openTwoPlaces();
    bench().select({session().committed().ref(0)});
    const auto rows = [this] {
        return field<QWidget>("jointList")->findChildren<QAbstractButton *>();
    };
    QTRY_COMPARE(rows().size(), 2);
    QWidget *widget = field<QWidget>("jointList");
    for (QAbstractButton *expected : rows()) {
        do
            widget = widget->nextInFocusChain();
        while (!(widget->focusPolicy() & Qt::TabFocus));
        QCOMPARE(widget, expected);
    }
}

// Wrong: a screen reader says "slider", and not of what.
void TestJoints::slidersAndFieldsAreReadOut()
{
    openTwoPlaces();
    bench().selectJoint(joint());
    QTRY_VERIFY(field<QWidget>("jointShare2") && field<QWidget>("jointShare2")->isVisible());
    auto *slider = field<QWidget>("jointShare2")->findChild<QSlider *>();
    auto *edit = field<QWidget>("jointShare2")->findChild<QDoubleSpinBox *>();
    QCOMPARE(slider->accessibleName(), QStringLiteral("Meeting point 2"));
    QCOMPARE(edit->accessibleName(), slider->accessibleName());
    QVERIFY(slider->accessibleDescription().isEmpty());
    bench().editJoint(moveMeetingPoint(session().committed(), joint(), 1, 0.3));
    QTRY_VERIFY(slider->accessibleDescription().startsWith(QStringLiteral("Set by hand")));
    QCOMPARE(edit->accessibleDescription(), slider->accessibleDescription());
    bench().selectJoint(joint(0, 2));
    slider = field<QWidget>("jointShare1")->findChild<QSlider *>();
    QTRY_COMPARE(slider->accessibleName(), QStringLiteral("Meeting point"));
}

QLabel *TestJoints::labelOf(const char *editor) const
{
    for (QLabel *label : m_window->findChildren<QLabel *>()) {
        if (label->buddy() && label->buddy()->objectName() == QLatin1String(editor))
            return label;
    }
    return nullptr;
}

// Wrong: "A&B" is shown as "AB" with a line under the B, which is then a key of a shortcut.
void TestJoints::anAmpersandIsPartOfAName()
{
    Document document = session().committed().document;
    document = *renameSection(document, document.sections[0]->id, "A&B");
    document = *renameSection(document, document.sections[1]->id, "<b>C</b>");
    session().reset(document);
    bench().selectJoint(joint());
    QTRY_COMPARE(labelOf("jointSlitsA")->text(), QStringLiteral("In A&&B"));
    QCOMPARE(field<QLabel>("jointSlitsA")->accessibleName(), QStringLiteral("In A&B"));
    QCOMPARE(labelOf("jointSlitsB")->textFormat(), Qt::PlainText);
}

FFF_TEST_WITH(TestJoints, runInWindowProgram<TestJoints>)
#include "tst_joints.moc"
