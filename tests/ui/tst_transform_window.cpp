// Moving, copying and pasting in a real window, by hand, by numbers and through the clipboard.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/tool.h"
#include "core/io/fff_format.h"
#include "core/model/edit_words.h"
#include "core/session/copy_commands.h"
#include "tests/test_program.h"
#include "tests/told.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"

#include <QClipboard>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QMimeData>
#include <QToolButton>
#include <QTreeWidget>

using namespace fff;
using namespace fff::ui;

class TestTransformWindow : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        openWindow();
        drawFirst();
        drawSecond();
        m_view->setFocus();
        key(Qt::Key_0);
        QTRY_VERIFY(!interaction().isAnimating());
        key(Qt::Key_Home);
        QTRY_VERIFY(!interaction().isAnimating());
    }
    void cleanup() { closeWindow(); }

    void draggedByAnArrow();
    void typedIntoTheBar();
    void escLeavesTheBarThenTheTool();
    void theBarOffersTheSource();
    void fieldsOfProperties();
    void copiedToAnotherWindowAndBack();
    void pastedTextThatIsNoModel();
    void lockedInTheOutline();

private:
    template <class Widget>
    Widget *find(const char *name)
    {
        return m_window->findChild<Widget *>(QLatin1String(name));
    }
    const Section &section(std::size_t index) const
    {
        return *session().committed().section(index);
    }
    void hold(std::size_t index)
    {
        bench().select({section(index).ref()});
        m_view->setFocus();
        key(Qt::Key_T);
        QTRY_VERIFY(interaction().overlay().find<GizmoMarks>());
    }
    QPoint tip(int axis) const
    {
        const GizmoLook look(interaction().overlay().find<GizmoMarks>()->gizmo,
                             interaction().camera(), Vec2(m_view->width(), m_view->height()));
        return {static_cast<int>(look.tip(axis).x()), static_cast<int>(look.tip(axis).y())};
    }
    void type(const char *field, const QString &text)
    {
        auto *edit = find<QDoubleSpinBox>(field);
        QVERIFY2(edit && edit->isVisible(), field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
};

// Wrong: the handles would be drawn, but not held where they are.
void TestTransformWindow::draggedByAnArrow()
{
    hold(0);
    const int before = steps();
    const Vec3 at = section(0).frame.origin, on = section(1).frame.origin;
    const QPoint from = tip(1);
    drag({from, from + QPoint(0, -20), from + QPoint(0, -45)});
    QCOMPARE(steps(), before + 1);
    const Vec3 way = section(0).frame.origin - at;
    QVERIFY(way.y() > 1.0);
    QVERIFY(std::abs(way.x()) + std::abs(way.z()) < 1e-9);
    QVERIFY((section(1).frame.origin - on - way).norm() < 1e-9);
    const QPoint again = tip(0);
    press(again);
    move(again + QPoint(30, 0));
    QTRY_VERIFY(session().hasPreview());
    key(Qt::Key_Escape);
    QTRY_VERIFY(!session().hasPreview());
    release(again + QPoint(30, 0));
    QCOMPARE(steps(), before + 1);
    key(Qt::Key_T);
    QVERIFY(!interaction().tool());
}

// Wrong: a digit over the view would do nothing, or look from the right.
void TestTransformWindow::typedIntoTheBar()
{
    hold(0);
    const Camera camera = interaction().camera();
    const double x = section(0).frame.origin.x();
    key(Qt::Key_2);
    auto *field = find<QDoubleSpinBox>("canvasMoveRight");
    QTRY_VERIFY(field->hasFocus());
    QTRY_VERIFY(session().hasPreview());
    QTest::keyClicks(field, QStringLiteral("5/2"));
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_VERIFY(m_view->hasFocus());
    QVERIFY(!session().hasPreview());
    QCOMPARE(std::abs(section(0).frame.origin.x() - x), 12.5);
    QCOMPARE(interaction().camera(), camera);
    QVERIFY(interaction().tool());
    QCOMPARE(field->value(), 0.0);             // from here on
    type("canvasCopies", QStringLiteral("2")); // of nothing that is moved: nothing is done
    QCOMPARE(count(), std::size_t(2));
}

// Wrong: numbers that were typed and left would stay, and nobody would know of them.
void TestTransformWindow::escLeavesTheBarThenTheTool()
{
    hold(0);
    const int before = steps();
    key(Qt::Key_7);
    QTRY_VERIFY(session().hasPreview());
    QTest::keyClick(find<QDoubleSpinBox>("canvasMoveRight"), Qt::Key_Escape);
    QTRY_VERIFY(!session().hasPreview());
    QVERIFY(interaction().tool());
    QCOMPARE(steps(), before);
    key(Qt::Key_Escape);
    QTRY_VERIFY(!interaction().tool());
    QVERIFY(!find<QWidget>("canvasBar")->isVisible());
}

// Wrong: a person with a generated section in hand would be told what is not possible only.
void TestTransformWindow::theBarOffersTheSource()
{
    bench().run(QStringLiteral("operation.linear"),
                {{"section", section(1).name}, {"along", section(0).name}, {"count", "4"}});
    QVERIFY(count() > 2);
    const SectionRef made = section(2).ref();
    QVERIFY(made.operation.isValid());
    bench().select({made});
    m_view->setFocus();
    key(Qt::Key_T);
    auto *source = find<QToolButton>("canvas.operation.editSource");
    QTRY_VERIFY(source && source->isVisible());
    QTest::mouseClick(source, Qt::LeftButton);
    QTRY_VERIFY(interaction().overlay().find<GizmoMarks>());
    QCOMPARE(interaction().selection(), std::vector<SectionRef>{section(1).ref()});
    QTRY_VERIFY(find<QToolButton>("canvas.transform.inSpace"));
    QTest::mouseClick(find<QToolButton>("canvas.transform.inSpace"), Qt::LeftButton);
    QTRY_VERIFY(interaction().overlay().find<GizmoMarks>()->gizmo.isInSpace);
    QVERIFY(find<QDoubleSpinBox>("canvasMoveX")->isVisible());
}

// Wrong: what the fields say would not be what is done.
void TestTransformWindow::fieldsOfProperties()
{
    bench().select({section(1).ref()});
    type("sectionAngle", QStringLiteral("60"));
    QVERIFY(std::abs(std::abs(section(1).frame.normal().dot(section(0).frame.normal())) - 0.5) <
            1e-9);
    QCOMPARE(session().history()->undoText(), QStringLiteral("Turn Section 2"));
    bench().run(QStringLiteral("section.makeOrthogonal"));
    QTRY_COMPARE(find<QDoubleSpinBox>("sectionAngle")->value(), 90.0);
    bench().select({section(0).ref()});
    type("normalX", QStringLiteral("0.6"));
    QVERIFY(std::abs(section(0).frame.normal().x() - 0.6) < 1e-12);
    QVERIFY(std::abs(section(0).frame.normal().y()) < 1e-12);
    bench().run(QStringLiteral("section.snapNormal"));
    QCOMPARE(std::abs(section(0).frame.normal().z()), 1.0);
    type("positionX", QStringLiteral("100"));
    QVERIFY(std::abs(section(0).frame.toWorld(section(0).shape->bounds().center()).x() - 100.0) <
            1e-9);
}

// Wrong: what is copied here could not be pasted there.
void TestTransformWindow::copiedToAnotherWindowAndBack()
{
    bench().run(QStringLiteral("edit.selectAll"));
    m_view->setFocus();
    key(Qt::Key_C, Qt::ControlModifier);
    const QMimeData *data = QGuiApplication::clipboard()->mimeData();
    QVERIFY(data->hasFormat(QStringLiteral("application/x-flatfitfab+json")));
    const auto text = io::readFff(data->text().toStdString());
    QVERIFY(text && text->document.sections.size() == 2);
    const Document copied = session().committed().document;
    key(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(count(), std::size_t(4));
    QCOMPARE(section(2).parent.has_value(), false);
    QCOMPARE(section(3).parent->section, section(2).ref());
    QVERIFY(!(section(2).frame == section(0).frame)); // beside what is there
    QCOMPARE(interaction().selection().size(), std::size_t(2));
    session().history()->undo();
    QVERIFY(session().committed().document.isSame(copied));
    closeWindow();
    openWindow();
    key(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(count(), std::size_t(2));
    QVERIFY(section(0).frame == copied.sections[0]->frame); // where it was
    QVERIFY(*section(1).shape == *copied.sections[1]->shape);
    key(Qt::Key_X, Qt::ControlModifier);
    QCOMPARE(count(), std::size_t(0));
    key(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(count(), std::size_t(2));
    key(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(count(), std::size_t(4));
}

// Wrong: a text from elsewhere would be pasted as rubbish, or without a word.
void TestTransformWindow::pastedTextThatIsNoModel()
{
    for (const char *text :
         {"", "hello", "{\"format\": \"FlatFitFab\", \"version\": 3}", "[1, 2"}) {
        QGuiApplication::clipboard()->setText(QLatin1String(text));
        const int before = steps();
        m_view->setFocus();
        key(Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(steps(), before);
        QCOMPARE(interaction().hint().words.text, hints::kNothingToPaste);
        QVERIFY(interaction().hint().isRefusal);
    }
}

// Wrong: what is locked could never be unlocked where the sentence says so.
void TestTransformWindow::lockedInTheOutline()
{
    bench().select({section(0).ref()});
    bench().run(QStringLiteral("section.lock"));
    QVERIFY(section(0).isLocked);
    m_view->setFocus();
    key(Qt::Key_Right);
    QCOMPARE(interaction().hint().words.text, hints::kLocked);
    auto *tree = find<QTreeWidget>("outlineTree");
    QTreeWidgetItem *row = tree->topLevelItem(0);
    constexpr int kLock = 3;
    QVERIFY(!row->icon(kLock).isNull());
    const QRect place = tree->visualItemRect(row);
    const QPoint on(tree->columnViewportPosition(kLock) + tree->columnWidth(kLock) / 2,
                    place.center().y());
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, on);
    QVERIFY(!section(0).isLocked);
    m_view->setFocus();
    key(Qt::Key_Right);
    QCOMPARE(session().history()->undoText(), QStringLiteral("Move Section 1"));
}

FFF_TEST_WITH(TestTransformWindow, runInWindowProgram<TestTransformWindow>)
#include "tst_transform_window.moc"
