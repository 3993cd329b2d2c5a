// Control points in a real window: with mouse, keys and the fields of the Properties dock.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/ui/window_fixture.h"
#include "ui/field_style.h"
#include "ui/properties/choice_box.h"
#include "ui/translations.h"
#include "ui/viewport.h"

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSurfaceFormat>

#include <cmath>

using namespace fff;
using namespace fff::ui;

class TestPointEditing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_window.reset(); }

    void aPointIsDraggedAndTakenBack();
    void aDoubleClickAddsAndDelTakesOut();
    void arrowKeysMoveAndMerge();
    void numbersAreTyped();
    void kindsAreChosen();
    void severalPointsShowWhatTheyShare();
    void aDragIsShownInTheNumbers();

private:
    QPoint at(double x, double y) const;
    void press(const QPoint &inView, Qt::KeyboardModifiers keys = {});
    void move(const QPoint &inView);
    void release(const QPoint &inView, Qt::KeyboardModifiers keys = {});
    void click(const QPoint &inView, Qt::KeyboardModifiers keys = {});
    void keys(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(m_window->windowHandle(), key, modifiers);
    }
    void type(const char *field, const QString &text);
    template <class Widget>
    Widget *field(const char *name)
    {
        return m_window->findChild<Widget *>(QLatin1String(name));
    }
    Session &session() { return m_window->bench().session(); }
    const Section &plate() const
    {
        return *m_window->bench().session().committed().document.sections.front();
    }
    Vec2 corner(int index) const { return position(*plate().shape, {0, index}); }
    int steps() { return session().history()->count(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    Viewport *m_view = nullptr;
};

/// A square of 100 mm that stands 20 mm above the ground, seen from the front and selected.
void TestPointEditing::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1440, 900);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    QApplication::setActiveWindow(m_window.get());
    m_view = m_window->findChild<Viewport *>(QStringLiteral("viewport"));
    QTRY_VERIFY(m_view->isValid());
    Document document = squareDocument(100.0);
    Frame frame;
    frame.origin = Vec3(-50, 20, 0);
    session().reset(*moveSection(document, document.sections.front()->id, frame));
    m_window->bench().showAll("front");
    m_window->bench().select({session().committed().ref(0)});
    m_view->setFocus();
    QTRY_VERIFY(m_view->hasFocus());
}

QPoint TestPointEditing::at(double x, double y) const
{
    const Vec2 p = m_window->bench().interaction().camera().toScreen(
        plate().frame.toWorld({x, y}), Vec2(m_view->width(), m_view->height()));
    return {static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))};
}

void TestPointEditing::press(const QPoint &inView, Qt::KeyboardModifiers keys)
{
    QTest::mousePress(m_window->windowHandle(), Qt::LeftButton, keys,
                      m_view->mapTo(m_window.get(), inView), 5);
}

void TestPointEditing::move(const QPoint &inView)
{
    QTest::mouseMove(m_window->windowHandle(), m_view->mapTo(m_window.get(), inView), 5);
}

void TestPointEditing::release(const QPoint &inView, Qt::KeyboardModifiers keys)
{
    QTest::mouseRelease(m_window->windowHandle(), Qt::LeftButton, keys,
                        m_view->mapTo(m_window.get(), inView), 5);
}

void TestPointEditing::click(const QPoint &inView, Qt::KeyboardModifiers keys)
{
    move(inView);
    press(inView, keys);
    release(inView, keys);
    QTest::qWait(1);
}

void TestPointEditing::type(const char *name, const QString &text)
{
    auto *edit = field<QAbstractSpinBox>(name);
    QVERIFY(edit && edit->isVisible());
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
}

// Wrong: what is dragged is not what is committed, or Ctrl+Z does not take it back.
void TestPointEditing::aPointIsDraggedAndTakenBack()
{
    const QPoint from = at(100, 100), to = from + QPoint(40, -30);
    move(from);
    press(from);
    for (int i = 1; i <= 8; ++i)
        move(from + (to - from) * i / 8);
    QTRY_VERIFY(session().hasPreview());
    release(to);
    QTRY_COMPARE(steps(), 1);
    const double scale = m_window->bench().interaction().camera().millimetresPerPixel;
    QVERIFY((corner(2) - Vec2(100 + 40 * scale, 100 + 30 * scale)).norm() < 1e-6);
    QCOMPARE(session().history()->undoText(), QStringLiteral("Move point of Plate"));
    keys(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(corner(2) == Vec2(100, 100));
    keys(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(corner(2).x() > 105.0);
}

void TestPointEditing::aDoubleClickAddsAndDelTakesOut()
{
    const QPoint middle = at(50, 100);
    move(middle);
    press(middle);
    release(middle);
    QTest::mouseDClick(m_window->windowHandle(), Qt::LeftButton, {},
                       m_view->mapTo(m_window.get(), middle), 5);
    QTRY_COMPARE(plate().shape->contour().segmentCount(), 5);
    QCOMPARE(steps(), 1);
    QCOMPARE(m_window->bench().interaction().points().points().size(), std::size_t(1));
    keys(Qt::Key_Delete);
    QCOMPARE(plate().shape->contour().segmentCount(), 4);
    QCOMPARE(steps(), 2);
    QCOMPARE(m_window->bench().interaction().selection().size(), std::size_t(1));
}

void TestPointEditing::arrowKeysMoveAndMerge()
{
    click(at(100, 100));
    for (int i = 0; i < 3; ++i)
        keys(Qt::Key_Right);
    keys(Qt::Key_Up, Qt::ShiftModifier);
    keys(Qt::Key_Left, Qt::ControlModifier);
    QVERIFY((corner(2) - Vec2(102.9, 110)).norm() < 1e-9);
    QCOMPARE(steps(), 1);
    keys(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(corner(2) == Vec2(100, 100));
}

// Wrong: a number that is typed lands beside itself, or takes several steps.
void TestPointEditing::numbersAreTyped()
{
    click(at(100, 100));
    type("pointX", QStringLiteral("112.7"));
    QVERIFY(corner(2) == Vec2(112.7, 100));
    type("pointY", QStringLiteral("90+1.5"));
    QVERIFY(corner(2) == Vec2(112.7, 91.5));
    QCOMPARE(steps(), 2);
    type("handleOutLength", QStringLiteral("20"));
    type("handleOutAngle", QStringLiteral("135"));
    const Vec2 arm = handle(plate().shape->contour(), 2, HandleSide::Out) - corner(2);
    QVERIFY((arm - 20.0 * Vec2(-std::sqrt(0.5), std::sqrt(0.5))).norm() < 1e-9);
    QCOMPARE(steps(), 4);
    m_view->setFocus();
    keys(Qt::Key_Z, Qt::ControlModifier);
    keys(Qt::Key_Z, Qt::ControlModifier);
    keys(Qt::Key_Z, Qt::ControlModifier);
    keys(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(corner(2) == Vec2(100, 100));
}

void TestPointEditing::kindsAreChosen()
{
    click(at(100, 100));
    auto *kind = field<ChoiceBox>("pointKind");
    QVERIFY(kind && kind->isVisible());
    for (const PointKind wanted : {PointKind::Smooth, PointKind::Symmetric, PointKind::Corner}) {
        kind->setCurrentIndex(static_cast<int>(wanted));
        Q_EMIT kind->activated(static_cast<int>(wanted));
        QCOMPARE(kindOf(plate().shape->contour(), 2), wanted);
        QCOMPARE(kind->currentIndex(), static_cast<int>(wanted));
    }
    m_view->setFocus();
    keys(Qt::Key_1, Qt::ControlModifier);
    QCOMPARE(kindOf(plate().shape->contour(), 2), PointKind::Smooth);
    keys(Qt::Key_2, Qt::ControlModifier);
    QCOMPARE(kindOf(plate().shape->contour(), 2), PointKind::Corner);
    QCOMPARE(steps(), 5);
}

void TestPointEditing::severalPointsShowWhatTheyShare()
{
    click(at(100, 0));
    click(at(100, 100), Qt::ControlModifier);
    auto *x = field<QAbstractSpinBox>("pointX"), *y = field<QAbstractSpinBox>("pointY");
    QVERIFY(x && x->isVisible());
    QVERIFY2(x->text().startsWith(QStringLiteral("100")), qPrintable(x->text()));
    QVERIFY(y->text().isEmpty());
    QCOMPARE(y->findChild<QLineEdit *>()->placeholderText(), QStringLiteral("mixed"));
    type("pointX", QStringLiteral("120"));
    QVERIFY(corner(1) == Vec2(120, 0) && corner(2) == Vec2(120, 100));
    QCOMPARE(steps(), 1);
    keys(Qt::Key_Escape);
    m_view->setFocus();
    keys(Qt::Key_Escape);
    QTRY_VERIFY(!x->isVisible());
}

void TestPointEditing::aDragIsShownInTheNumbers()
{
    const QPoint from = at(100, 100);
    move(from);
    press(from);
    for (int i = 1; i <= 8; ++i)
        move(from + QPoint(5 * i, 0));
    auto *x = field<QDoubleSpinBox>("pointX");
    QTRY_VERIFY(x && x->isVisible() && x->value() > 105.0);
    QCOMPARE(steps(), 0);
    release(from + QPoint(40, 0));
    QTRY_COMPARE(steps(), 1);
}

int main(int argc, char *argv[])
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    QSurfaceFormat::setDefaultFormat(format);
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    installTranslations(application);
    TestPointEditing test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_point_editing.moc"
