#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/figure.h"
#include "core/geometry/mapped_contour.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>

using namespace fff;

namespace {

Figure figure(const char *kind, std::vector<double> numbers, const Vec2 &centre = Vec2::Zero(),
              double turn = 0.0)
{
    return {kind, std::move(numbers), centre, turn};
}

Box2 boxOf(const Contour &contour)
{
    Box2 box;
    for (const Vec2 &p : contour.flatten(1e-4).points)
        box.extend(p);
    return box;
}

} // namespace

class TestFigure : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areasAndSizes_data();
    void areasAndSizes();
    void circlesAreRound();
    void roundCornersAtMost();
    void numbersAreChecked_data();
    void numbersAreChecked();
    void isKnownAgain();
    void editedByHandItIsNone();
    void mapsAlike_data();
    void mapsAlike();
    void mapsThatAreNoFigure();
    void asLargeAsABox();
};

void TestFigure::areasAndSizes_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QVector<double>>("numbers");
    QTest::addColumn<double>("area");
    QTest::addColumn<QPointF>("size");
    constexpr double pi = std::numbers::pi;
    QTest::newRow("circle") << "circle" << QVector<double>{40} << pi * 400 << QPointF(40, 40);
    QTest::newRow("ellipse") << "ellipse" << QVector<double>{60, 40} << pi * 600 << QPointF(60, 40);
    QTest::newRow("rectangle") << "rectangle" << QVector<double>{60, 40, 0} << 2400.0
                               << QPointF(60, 40);
    QTest::newRow("round corners")
        << "rectangle" << QVector<double>{60, 40, 5} << 2400.0 - (4 - pi) * 25 << QPointF(60, 40);
    QTest::newRow("hexagon") << "polygon" << QVector<double>{50, 6} << 1.5 * std::sqrt(3.0) * 625.0
                             << QPointF(50 * std::sqrt(0.75), 50);
    QTest::newRow("slot") << "slot" << QVector<double>{40, 10} << 300.0 + pi * 25
                          << QPointF(40, 10);
    QTest::newRow("square star") << "star" << QVector<double>{60, 60 * std::sqrt(0.5), 4} << 1800.0
                                 << QPointF(60, 60);
}

// Wrong: what was typed would not be what is cut.
void TestFigure::areasAndSizes()
{
    QFETCH(QString, kind);
    QFETCH(QVector<double>, numbers);
    QFETCH(double, area);
    QFETCH(QPointF, size);
    const Vec2 centre(12, -7);
    const Figure of = figure(kind.toStdString().c_str(), {numbers.begin(), numbers.end()}, centre);
    const Contour contour = contourOf(of).value();
    QVERIFY2(std::abs(contour.signedArea() - area) <= 1e-4 * area,
             qPrintable(QString::number(contour.signedArea())));
    const Box2 box = boxOf(contour);
    QVERIFY((box.size() - Vec2(size.x(), size.y())).norm() < 1e-3);
    QVERIFY((box.center() - centre).norm() < 1e-3);
    // Turned it is the same.
    Figure turned = of;
    turned.turn = 0.7;
    QVERIFY(std::abs(contourOf(turned)->signedArea() - contour.signedArea()) < 1e-9 * area);
}

// Wrong: a wheel of 200 mm would be off by more than a saw's kerf wanders.
void TestFigure::circlesAreRound()
{
    const Contour circle = contourOf(figure("circle", {200})).value();
    for (const Vec2 &p : circle.flatten(1e-3).points)
        QVERIFY(std::abs(p.norm() - 100.0) < 1e-3);
}

// Wrong: corners would cross each other.
void TestFigure::roundCornersAtMost()
{
    const Contour pill = contourOf(figure("rectangle", {60, 40, 500})).value();
    QVERIFY(std::abs(pill.signedArea() - (800.0 + std::numbers::pi * 400)) < 0.1);
    QCOMPARE(contourOf(figure("slot", {4, 10}))->segmentCount(), 8); // a circle
    QVERIFY(std::abs(contourOf(figure("slot", {4, 10}))->signedArea() - std::numbers::pi * 25) <
            0.01);
}

void TestFigure::numbersAreChecked_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QVector<double>>("numbers");
    QTest::addColumn<QString>("place");
    QTest::newRow("too small") << "circle" << QVector<double>{0.1} << "diameter";
    QTest::newRow("negative") << "rectangle" << QVector<double>{10, -4, 0} << "height";
    QTest::newRow("missing") << "ellipse" << QVector<double>{10} << "height";
    QTest::newRow("no number") << "circle" << QVector<double>{std::nan("")} << "diameter";
    QTest::newRow("two sides") << "polygon" << QVector<double>{10, 2} << "sides";
    QTest::newRow("half a side") << "polygon" << QVector<double>{10, 3.5} << "sides";
    QTest::newRow("unknown") << "heart" << QVector<double>{10} << "kind";
}

// Wrong: a file or a script could make a contour of nothing.
void TestFigure::numbersAreChecked()
{
    QFETCH(QString, kind);
    QFETCH(QVector<double>, numbers);
    QFETCH(QString, place);
    const auto made =
        contourOf(figure(kind.toStdString().c_str(), {numbers.begin(), numbers.end()}));
    QVERIFY(!made);
    QCOMPARE(made.error().code, ErrorCode::BadValue);
    QCOMPARE(QString::fromStdString(made.error().place), place);
}

// Wrong: the panel would have no numbers of what was made by numbers.
void TestFigure::isKnownAgain()
{
    for (const FigureKind &kind : figureKinds()) {
        Figure of = newFigure(kind);
        of.centre = {3, 4};
        of.turn = 0.3;
        const Contour contour = contourOf(of).value();
        QVERIFY(isOf(contour, of));
        QVERIFY(isOf(contour.reversed(), of)); // as a hole
        Figure other = of;
        other.numbers[0] += 0.01;
        QVERIFY(!isOf(contour, other));
    }
}

// Wrong: the next number would throw away what was drawn by hand.
void TestFigure::editedByHandItIsNone()
{
    const Figure of = newFigure(*figureKind("circle"));
    std::vector<Vec2> points = contourOf(of)->points();
    points[3].x() += 0.5;
    QVERIFY(!isOf(Contour::fromPoints(points).value(), of));
}

void TestFigure::mapsAlike_data()
{
    QTest::addColumn<QString>("kind");
    for (const FigureKind &kind : figureKinds())
        QTest::newRow(kind.key) << QString::fromLatin1(kind.key);
}

// Wrong: after a move or a new size the figure would be forgotten.
void TestFigure::mapsAlike()
{
    QFETCH(QString, kind);
    Figure of = newFigure(*figureKind(kind.toStdString()));
    of.centre = {3, 4};
    of.turn = 0.3;
    const Eigen::Matrix2d matrix = 1.7 * Eigen::Rotation2Dd(-1.1).toRotationMatrix();
    const Vec2 about(-20, 5);
    const std::optional<Figure> next = mapped(of, matrix, about);
    QVERIFY(next);
    QVERIFY(isOf(fff::mapped(contourOf(of).value(), matrix, about).value(), *next));
    const std::optional<Figure> back = mapped(*next, matrix.inverse(), about);
    QVERIFY(isOf(contourOf(of).value(), *back));
}

// Wrong: an oval would be called a circle, a leaning box a rectangle.
void TestFigure::mapsThatAreNoFigure()
{
    Eigen::Matrix2d wide;
    wide << 2.0, 0.0, 0.0, 1.0;
    const Figure circle = figure("circle", {40}, {3, 4});
    const std::optional<Figure> oval = mapped(circle, wide, Vec2::Zero());
    QCOMPARE(oval->kind, std::string("ellipse"));
    QVERIFY(isOf(fff::mapped(contourOf(circle).value(), wide, Vec2::Zero()).value(), *oval));
    const Figure box = figure("rectangle", {60, 40, 0}, {1, 2});
    QVERIFY(isOf(fff::mapped(contourOf(box).value(), wide, Vec2::Zero()).value(),
                 *mapped(box, wide, Vec2::Zero())));
    QVERIFY(!mapped(figure("rectangle", {60, 40, 0}, {1, 2}, 0.4), wide, Vec2::Zero()));
    QVERIFY(!mapped(figure("rectangle", {60, 40, 5}), wide, Vec2::Zero()));
    QVERIFY(!mapped(newFigure(*figureKind("star")), wide, Vec2::Zero()));
    Eigen::Matrix2d mirror;
    mirror << -1.0, 0.0, 0.0, 1.0;
    QVERIFY(!mapped(circle, mirror, Vec2::Zero()));
    QVERIFY(!mapped(circle, Eigen::Matrix2d::Zero(), Vec2::Zero()));
}

// Wrong: a drag would not make it as large as it is drawn.
void TestFigure::asLargeAsABox()
{
    QCOMPARE(sized(newFigure(*figureKind("rectangle")), {80, 30}).numbers,
             (std::vector<double>{80, 30, 0}));
    QCOMPARE(sized(newFigure(*figureKind("circle")), {80, 30}).numbers, std::vector<double>{80});
    QCOMPARE(sized(figure("star", {60, 30, 5}), {120, 10}).numbers,
             (std::vector<double>{120, 60, 5}));
    QVERIFY(contourOf(sized(newFigure(*figureKind("ellipse")), {0, 0})).has_value());
}

FFF_TEST(TestFigure)
#include "tst_figure.moc"
