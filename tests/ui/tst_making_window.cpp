// Shapes by numbers, marks, lengths and named numbers in a real window.
#include <QTest> // first: moc cannot read some of the standard library before it

#include <QApplication>

#include "core/interaction/tool.h"
#include "core/io/document_file.h"
#include "core/io/svg_reader.h"
#include "core/model/figures.h"
#include "core/model/named_numbers.h"
#include "core/model/symmetric_section.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"
#include "tests/ui/work_folder.h"
#include "ui/base/panes.h"
#include "ui/cards/model_card.h"
#include "ui/docks/library_dock.h"

#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>

using namespace fff;
using namespace fff::ui;

class TestMakingWindow : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void aShapeIsDraggedThenTyped();
    void theBarSaysWhichShape();
    void wordsAreSetAndWritten();
    void engravingBeginsFromTheOutline();
    void symmetryIsSwitchedOff();
    void marksAreChangedInTheirGroup();
    void aLengthIsTypedInTheBar();
    void aDimensionIsKeptAndTyped();
    void namesAreTakenInFields();
    void namesThatFollow();
    void laterRowsHaveTheColours();
    void aPartOfTheLibrary();
    void theLibraryComesToTheFront();
    void theViewSaysWhatIsSelected();
    void everythingHasAName();
    void escLeadsBackToTheView_data();
    void escLeadsBackToTheView();
    void byKeysAlone();

private:
    template <class Widget>
    Widget *find(const char *name)
    {
        for (Widget *widget : m_window->findChildren<Widget *>(QLatin1String(name)))
            if (widget->isVisible())
                return widget;
        return nullptr;
    }
    void type(const char *field, const QString &text)
    {
        QTRY_VERIFY2(find<QDoubleSpinBox>(field), field);
        auto *edit = find<QDoubleSpinBox>(field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    void addPlate()
    {
        bench().run(QStringLiteral("section.addRectangle"),
                    {{"width", "200"}, {"height", "120"}, {"corner", "0"}});
        m_view->setFocus();
        key(Qt::Key_Home);
        QTRY_VERIFY(!interaction().isAnimating());
    }
    Vec2 size() const { return first().shape->bounds().size(); }
};

// Wrong: a shape would be as large as the hand was steady.
void TestMakingWindow::aShapeIsDraggedThenTyped()
{
    m_view->setFocus();
    key(Qt::Key_A, Qt::ShiftModifier);
    QTRY_VERIFY(interaction().tool());
    drag({middle(), middle() + QPoint(60, -40), middle() + QPoint(90, -60)});
    QCOMPARE(count(), std::size_t(1));
    QCOMPARE(figureOf(first(), 0)->kind, std::string("rectangle"));
    type("figure0.width", QStringLiteral("84"));
    QVERIFY(std::abs(size().x() - 84.0) < 1e-6);
    type("figure0.height", QStringLiteral("2*t + 1in"));
    QVERIFY(std::abs(size().y() - 31.4) < 1e-6);
}

void TestMakingWindow::theBarSaysWhichShape()
{
    m_view->setFocus();
    key(Qt::Key_A, Qt::ShiftModifier);
    auto *star = find<QToolButton>("canvas.section.addStar");
    QVERIFY(star);
    QTest::mouseClick(star, Qt::LeftButton);
    QCOMPARE(count(), std::size_t(0));
    drag({middle(), middle() + QPoint(60, -40), middle() + QPoint(90, -60)});
    QCOMPARE(figureOf(first(), 0)->kind, std::string("star"));
}

// Wrong: after the click one would have to look for the field of the words.
void TestMakingWindow::wordsAreSetAndWritten()
{
    addPlate();
    key(Qt::Key_E);
    QTRY_VERIFY(interaction().tool() && !interaction().isAnimating());
    const int before = steps();
    click(onScreen(first().frame.toWorld(first().shape->bounds().center())));
    QCOMPARE(first().marks.size(), std::size_t(1));
    QTRY_VERIFY(qobject_cast<QPlainTextEdit *>(QApplication::focusWidget()));
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("Kim"));
    QCOMPARE(first().marks.front()->lettering->text, std::string("Kim"));
    QCOMPARE(steps(), before + 2); // set, written
    QVERIFY(interaction().tool());
}

// Wrong: after a click in the Outline the key looks for a name that begins with it.
void TestMakingWindow::engravingBeginsFromTheOutline()
{
    addPlate();
    bench().run(QStringLiteral("view.right")); // on edge
    QTRY_VERIFY(!interaction().isAnimating());
    bench().select({});
    auto *tree = find<QTreeWidget>("outlineTree");
    QVERIFY(tree);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                      tree->visualItemRect(tree->topLevelItem(0)).center());
    QCOMPARE(interaction().selection(), std::vector<SectionRef>{first().id});
    QVERIFY(tree->hasFocus());
    QTest::keyClick(tree, Qt::Key_E);
    QVERIFY(interaction().tool());
    QCOMPARE(interaction().tool()->command(), std::string_view("section.mark"));
    QVERIFY(m_view->hasFocus());
    QTRY_VERIFY(!interaction().isAnimating());
    QVERIFY(first().frame.normal().dot(interaction().camera().backward()) > 0.999);
    click(onScreen(first().frame.toWorld(first().shape->bounds().center())));
    QCOMPARE(first().marks.size(), std::size_t(1));
}

// Wrong: nobody could let the halves of a section differ.
void TestMakingWindow::symmetryIsSwitchedOff()
{
    addPlate();
    auto *box = find<QCheckBox>("sectionSymmetric");
    QVERIFY(box && box->isEnabled() && !box->isChecked());
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(6, box->height() / 2));
    QVERIFY(symmetryOf(first()));
    QVERIFY(box->isChecked());
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(6, box->height() / 2));
    QVERIFY(!symmetryOf(first()));
}

void TestMakingWindow::marksAreChangedInTheirGroup()
{
    addPlate();
    bench().run(QStringLiteral("mark.addText"), {{"text", "Kim"}});
    type("mark0.height", QStringLiteral("20"));
    QCOMPARE(first().marks.front()->lettering->height, 20.0);
    type("mark0.turn", QStringLiteral("90"));
    QVERIFY(std::abs(first().marks.front()->lettering->turn - radians(90.0)) < 1e-9);
    auto *kind = find<QComboBox>("mark0.kind");
    QVERIFY(kind);
    kind->setFocus();
    QTest::keyClick(kind, Qt::Key_Down);
    QTRY_COMPARE(first().marks.front()->kind, Mark::Kind::Scored);
    auto *remove = find<QToolButton>("mark0.delete");
    QVERIFY(remove);
    QTest::mouseClick(remove, Qt::LeftButton);
    QVERIFY(first().marks.empty());
}

void TestMakingWindow::aLengthIsTypedInTheBar()
{
    addPlate();
    key(Qt::Key_D);
    QTRY_VERIFY(interaction().tool());
    const Box2 box = first().shape->bounds();
    const auto at = [&](const Vec2 &p) { return onScreen(first().frame.toWorld(p)); };
    drag({at(box.min), at(box.center()), at(Vec2(box.max.x(), box.min.y()))});
    QVERIFY(find<QDoubleSpinBox>("canvasWanted"));
    for (const Qt::Key digit : {Qt::Key_1, Qt::Key_0, Qt::Key_0})
        QTest::keyClick(QApplication::focusWidget(), digit);
    QTRY_VERIFY(std::abs(session().model().section(0)->shape->bounds().size().x() - 100.0) < 1e-6);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTRY_VERIFY(std::abs(size().x() - 100.0) < 1e-6);
    QVERIFY(std::abs(size().y() - 60.0) < 1e-6);
}

void TestMakingWindow::aDimensionIsKeptAndTyped()
{
    addPlate();
    key(Qt::Key_M);
    QTRY_VERIFY(interaction().tool());
    const Box2 box = first().shape->bounds();
    const auto at = [&](const Vec2 &p) { return onScreen(first().frame.toWorld(p)); };
    drag({at(box.min), at(box.center()), at(Vec2(box.max.x(), box.min.y()))});
    auto *keep = find<QToolButton>("canvas.measure.keep");
    QVERIFY(keep);
    QTRY_VERIFY(keep->isEnabled());
    QTest::mouseClick(keep, Qt::LeftButton);
    QCOMPARE(session().committed().document.dimensions.size(), std::size_t(1));
    m_view->setFocus();
    for (int i = 0; i < 3; ++i)
        key(Qt::Key_Escape);
    QTRY_VERIFY(find<QDoubleSpinBox>("dimension0"));
    const double height = size().y();
    type("dimension0", QStringLiteral("50"));
    QVERIFY(std::abs(size().x() - 50.0) < 1e-6);
    QCOMPARE(size().y(), height); // the plate is stretched, the model is not scaled
    QTest::mouseClick(find<QToolButton>("dimension0.delete"), Qt::LeftButton);
    QVERIFY(session().committed().document.dimensions.empty());
}

// Wrong: what is the same everywhere had to be typed everywhere.
void TestMakingWindow::namesAreTakenInFields()
{
    bench().run(QStringLiteral("value.add"), {{"name", "gap"}, {"expression", "12.5 mm"}});
    QCOMPARE(session().committed().document.values.list.size(), std::size_t(1));
    addPlate();
    type("figure0.width", QStringLiteral("4*gap"));
    QVERIFY(std::abs(size().x() - 50.0) < 1e-6);
    type("figure0.height", QStringLiteral("GAP + t"));
    QVERIFY(std::abs(size().y() - 15.5) < 1e-6);
    bench().run(QStringLiteral("value.set"), {{"name", "gap"}, {"expression", "20 mm"}});
    QVERIFY(std::abs(size().x() - 80.0) < 1e-6);
    QVERIFY(std::abs(size().y() - 23.0) < 1e-6);
}

// Wrong: a number of an older file that is made of another one would keep what that was.
void TestMakingWindow::namesThatFollow()
{
    Document older = session().committed().document;
    for (const auto &[name, typed] :
         {std::pair("gap", "10 mm"), std::pair("twice", "2*gap"), std::pair("count", "3")})
        older = setExpression(older, name, typed, Commas::Groups).value();
    QVERIFY(!find<QLineEdit>("number.gap"));
    bench().commit(QStringLiteral("Older"), older);
    QTRY_VERIFY(find<QLineEdit>("number.gap"));
    const auto value = [this](std::size_t i) {
        return session().committed().document.numbers.at(i).value;
    };
    QCOMPARE(value(1), 20.0);
    auto *gap = find<QLineEdit>("number.gap");
    QVERIFY(gap);
    gap->setFocus();
    gap->selectAll();
    QTest::keyClicks(gap, QStringLiteral("15 mm"));
    QTest::keyClick(gap, Qt::Key_Return);
    QTRY_COMPARE(value(1), 30.0);
    session().history()->undo();
    QCOMPARE(value(1), 20.0);
}

// Wrong: in a dark window fields that come later would be white.
void TestMakingWindow::laterRowsHaveTheColours()
{
    settings().setColourScheme(ColourScheme::Dark);
    addPlate();
    QCoreApplication::processEvents();
    const QColor ground = m_window->palette().color(QPalette::Base);
    QVERIFY(ground.lightness() < 100);
    auto *width = find<QDoubleSpinBox>("figure0.width");
    QVERIFY(width);
    QCOMPARE(width->palette().color(QPalette::Base), ground);
}

// Wrong: what was made for one model had to be made again for the next.
void TestMakingWindow::aPartOfTheLibrary()
{
    auto *library = m_window->findChild<LibraryDock *>(QStringLiteral("libraryDock"));
    QVERIFY(library && !library->isVisible()); // until it is asked for
    library->setFolder(m_folder->filePath(QStringLiteral("parts")));
    library->show();
    addPlate();
    QTest::mouseClick(find<QPushButton>("libraryAdd"), Qt::LeftButton);
    QTRY_VERIFY(find<ModelCard>("libraryCard"));
    QTest::mouseClick(find<QPushButton>("libraryAdd"), Qt::LeftButton);
    QTRY_COMPARE(library->findChildren<ModelCard *>().size(), 2); // under another name
    const int before = steps();
    QTest::mouseClick(find<ModelCard>("libraryCard"), Qt::LeftButton);
    QTRY_COMPARE(count(), std::size_t(2));
    QCOMPARE(steps(), before + 1);
    QVERIFY(session().committed().section(1)->shape->bounds().size().isApprox(size()));
}

// Wrong: who opens it would see a new tab, and what was in front before.
void TestMakingWindow::theLibraryComesToTheFront()
{
    auto *dock = m_window->findChild<LibraryDock *>();
    QVERIFY(dock);
    QVERIFY(!isSeen(dock));
    dock->toggleViewAction()->trigger();
    QTRY_VERIFY(isSeen(dock));
}

// Wrong: who does not see the view would not know what is selected in it.
void TestMakingWindow::theViewSaysWhatIsSelected()
{
    const QString ofTheView = m_view->accessibleDescription();
    QVERIFY(!ofTheView.isEmpty());
    addPlate();
    QTRY_VERIFY(m_view->accessibleDescription().startsWith(QStringLiteral("Section 1, section, ")));
    bench().run(QStringLiteral("edit.duplicate"));
    bench().run(QStringLiteral("edit.selectAll"));
    QTRY_COMPARE(m_view->accessibleDescription(), QStringLiteral("2 sections selected"));
    m_view->setFocus();
    key(Qt::Key_PageDown);
    QTRY_VERIFY(m_view->accessibleDescription().startsWith(QStringLiteral("Section 1")));
    key(Qt::Key_PageDown);
    QTRY_VERIFY(m_view->accessibleDescription().startsWith(
        QString::fromStdString(session().committed().section(1)->name)));
    key(Qt::Key_PageUp);
    QTRY_VERIFY(m_view->accessibleDescription().startsWith(QStringLiteral("Section 1")));
    key(Qt::Key_Return);
    QTRY_VERIFY(QApplication::focusWidget() != m_view);
    bench().select({});
    QCOMPARE(m_view->accessibleDescription(), ofTheView);
}

// Wrong: a screen reader would say "spin box" and nothing else.
void TestMakingWindow::everythingHasAName()
{
    addPlate();
    bench().run(QStringLiteral("mark.addText"), {{"text", "Kim"}});
    bench().run(QStringLiteral("numbers.set"), {{"name", "gap"}, {"value", "1"}});
    bench().run(QStringLiteral("section.transform"));
    QCoreApplication::processEvents();
    for (const QWidget *widget : m_window->findChildren<QWidget *>()) {
        // Parts of a field speak as that.
        if (widget->objectName().startsWith(QStringLiteral("qt_")))
            continue;
        if (!widget->isVisible() || (widget->focusPolicy() & Qt::TabFocus) != Qt::TabFocus)
            continue;
        QAccessibleInterface *interface =
            QAccessible::queryAccessibleInterface(const_cast<QWidget *>(widget));
        QVERIFY(interface);
        const QString name = interface->text(QAccessible::Name);
        QVERIFY2(!name.isEmpty(),
                 qPrintable(QStringLiteral("%1 %2 in %3")
                                .arg(QLatin1String(widget->metaObject()->className()),
                                     widget->objectName(), widget->parentWidget()->objectName())));
    }
}

// New, a first section by typed points, a second one across it, moved by numbers: no mouse.
void TestMakingWindow::escLeadsBackToTheView_data()
{
    QTest::addColumn<QString>("field");
    QTest::newRow("a number") << QStringLiteral("sectionThickness");
    QTest::newRow("the name") << QStringLiteral("propertiesName");
}

// Wrong: keys of tools would be typed into a field until one clicks elsewhere, or what was typed
// and given up would be entered.
void TestMakingWindow::escLeadsBackToTheView()
{
    QFETCH(QString, field);
    addPlate();
    bench().select({session().committed().section(0)->ref()});
    auto *edit = m_window->findChild<QWidget *>(field);
    QVERIFY(edit);
    edit->setFocus();
    QTRY_VERIFY(edit->hasFocus());
    const int before = steps();
    QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(edit, QStringLiteral("7"));
    QTest::keyClick(edit, Qt::Key_Escape);
    QTRY_VERIFY(m_view->hasFocus());
    QCOMPARE(steps(), before);
}

void TestMakingWindow::byKeysAlone()
{
    const auto send = [](Qt::Key which, Qt::KeyboardModifiers keys = {}) {
        QTest::keyClick(QApplication::focusWidget(), which, keys, 5);
    };
    // The first letter may take the focus elsewhere.
    const auto type = [](const char *text) {
        for (; *text; ++text)
            QTest::keyClick(QApplication::focusWidget(), *text, Qt::NoModifier, 5);
    };
    const auto point = [&](const char *x, const char *y) {
        type(x);
        send(Qt::Key_Tab);
        type(y);
        send(Qt::Key_Return);
        QTRY_VERIFY(m_view->hasFocus());
    };
    m_view->setFocus();
    send(Qt::Key_P);
    QTRY_VERIFY(interaction().tool());
    point("0", "0");
    point("80", "0");
    point("80", "60");
    point("0", "60");
    send(Qt::Key_Return); // closes
    QCOMPARE(count(), std::size_t(1));
    QVERIFY(std::abs(size().x() - 80.0) < 1e-6);
    QVERIFY(interaction().tool()); // the pen stays
    // Across it, on the plane of the side: by the search for actions.
    send(Qt::Key_K, Qt::ControlModifier);
    QTRY_VERIFY(qobject_cast<QLineEdit *>(QApplication::focusWidget()));
    type("side plane");
    QTest::keyPress(QApplication::focusWidget(), Qt::Key_Return); // it closes: nobody is released
    QTRY_VERIFY(m_view->hasFocus() && !interaction().isAnimating());
    point("-30", "0");
    point("30", "0");
    point("30", "40");
    point("-30", "40");
    send(Qt::Key_Return);
    QCOMPARE(count(), std::size_t(2));
    while (interaction().tool())
        send(Qt::Key_Escape);
    // The second one is selected by keys and moved into the middle of the first.
    send(Qt::Key_PageUp);
    QCOMPARE(interaction().selection().front(), session().committed().section(1)->ref());
    send(Qt::Key_T);
    QTRY_VERIFY(interaction().tool());
    const Vec3 before = session().committed().section(1)->frame.origin;
    type("40");
    send(Qt::Key_Return);
    QTRY_VERIFY(m_view->hasFocus());
    QVERIFY(std::abs((session().committed().section(1)->frame.origin - before).norm() - 40.0) <
            1e-6);
    // The cutting file, where the dialog says.
    const QTemporaryDir folder;
    workIn(folder.path());
    const QString path = folder.filePath(QStringLiteral("untitled.svg"));
    QTimer dialogs;
    bool isAsked = false;
    connect(&dialogs, &QTimer::timeout, &dialogs, [&] {
        QWidget *dialog = QApplication::activeModalWidget();
        if (dialog && dialog->objectName() == QStringLiteral("exportDialog") && !isAsked) {
            const auto *now = dialog->findChild<QPushButton *>(QStringLiteral("exportNow"));
            isAsked = now && now->isEnabled(); // when the sheets are there
            if (isAsked)                       // not from here: this timer waits for what it begins
                QTimer::singleShot(0, dialog,
                                   [dialog] { QTest::keyPress(dialog, Qt::Key_Return); });
        }
    });
    dialogs.start(20);
    send(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(QFile::exists(path));
    const Result<std::string> file = io::readFile(path);
    QVERIFY(file);
    const Result<io::SvgDrawing> drawing = io::readSvg(*file);
    QVERIFY(drawing && drawing->isCuttingFile);
    const auto isCut = [](const io::SvgDrawing::Line &line) { return line.stroke == "#ff0000"; };
    QCOMPARE(std::count_if(drawing->lines.begin(), drawing->lines.end(), isCut), 2); // the parts
}

FFF_TEST_WITH(TestMakingWindow, fff::testing::runWithin<TestMakingWindow, QApplication>)
#include "tst_making_window.moc"
