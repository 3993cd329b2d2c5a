// FlatFab's models. If this fails, someone's old model opens wrongly, or a broken file does harm.
// First: moc cannot read <numbers> before another header of the standard library.
#include <QtTest/QtTest>

#include "core/base/tolerances.h"
#include "core/io/error_text.h"
#include "core/io/flatfab_format.h"
#include "tests/core/io/io_samples.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using fff::test::flatfabSquares;
using fff::test::replaced;
using io::readFlatfab;

class TestFlatfabFormat : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void squaresAreRead();
    void tolerated_data();
    void tolerated();
    void unitScalesEverything();
    void worldPointsStay_data();
    void worldPointsStay();
    void warnings_data();
    void warnings();
    void overlappingHoles_data();
    void overlappingHoles();
    void malformed_data();
    void malformed();
    void truncationIsAnError();
    void flippedBytesNeverCrash();
};

namespace {

constexpr double kSamePoint = 1e-9; // mm

/// A file of one section with these four axis lines, contour and further curves.
std::string oneSection(const std::string &axes, const std::vector<std::string> &curves)
{
    std::string text = "HeaderParameters 1\nFlatFab 1\n" + axes + "BoundaryCurves " +
                       std::to_string(curves.size()) + "\n";
    for (const std::string &curve : curves)
        text += "SketchPoints 0\nBezierPoints " +
                std::to_string(std::count(curve.begin(), curve.end(), '\n')) + "\n" + curve;
    return text;
}

const std::string kUprightAxes = "P 0 0 0\nT 1 0 0\nN 0 0 1\nB 0 1 0\n";

/// Control points of straight edges between corners, closed, units of the file.
std::string polygonCurve(const Polygon &corners)
{
    std::vector<Vec2> points = Contour::fromPolygon(corners).value().points();
    points.push_back(points.front());
    std::string text;
    for (const Vec2 &p : points)
        text += std::to_string(p.x()) + " " + std::to_string(p.y()) + "\n";
    return text;
}

std::string square(double half, double x = 0.0)
{
    return polygonCurve({{x - half, -half}, {x + half, -half}, {x + half, half}, {x - half, half}});
}

} // namespace

void TestFlatfabFormat::squaresAreRead()
{
    const auto loaded = readFlatfab(flatfabSquares(2), "squares.txt");
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    QVERIFY(loaded->warnings.empty());
    const Document &document = loaded->document;
    QCOMPARE(document.sections.size(), std::size_t(2));
    QCOMPARE(document.stocks.size(), std::size_t(1));
    QCOMPARE(document.stocks.front()->thickness, 3.175);
    QCOMPARE(document.currentStock, document.stocks.front()->id);
    const Section &first = *document.sections.front();
    QCOMPARE(first.name, std::string("Section 1"));
    const auto german = readFlatfab(flatfabSquares(2), {}, {.naming = {"Scheibe %1"}});
    QCOMPARE(german->document.sections.back()->name, std::string("Scheibe 2"));
    QVERIFY(!first.parent);
    QCOMPARE(first.stock, document.currentStock);
    QCOMPARE(first.frame.origin, Vec3(0, 3 * 25.4, 0));
    QCOMPARE(first.shape->holes().size(), std::size_t(1));
    QCOMPARE(first.shape->contour().points().front(), Vec2(-25.4, -25.4));
    const Section &second = *document.sections.back();
    QVERIFY(std::abs(second.shape->area() - 4 * 25.4 * 25.4) < 1e-9);
    QVERIFY(document.nextId > second.id.value);
}

void TestFlatfabFormat::tolerated_data()
{
    QTest::addColumn<std::string>("text");
    const std::string text = flatfabSquares(2);
    QTest::newRow("the newer header word") << flatfabSquares(2, "FlatFab");
    QTest::newRow("CR LF") << replaced(text, "\n", "\r\n");
    QTest::newRow("doubled blanks") << replaced(text, " ", "  ");
    QTest::newRow("leading and trailing blanks") << replaced(text, "\n", " \n ");
    QTest::newRow("tabs") << replaced(text, " ", "\t");
    QTest::newRow("blank lines") << replaced(text, "\n", "\n\n");
    QTest::newRow("no line end at the end") << text.substr(0, text.size() - 1);
    QTest::newRow("no BoundaryCurves before a lone curve")
        << replaced(text, "BoundaryCurves 1\n", "");
    QTest::newRow("plus signs") << replaced(text, "\n0.5 1\n", "\n+0.5 +1\n");
    QTest::newRow("exponents") << replaced(text, "0.5 1\n", "5e-1 1.0E+0\n");
    QTest::newRow("too small for a double") << replaced(text, "T 1 0 0", "T 1 1e-400 -1e-999");
    QTest::newRow("a byte-order mark") << "\xEF\xBB\xBF" + text;
    QTest::newRow("no samples") << replaced(text, "SketchPoints 2\n0 0\n0.5 0.25\n",
                                            "SketchPoints 0\n");
}

void TestFlatfabFormat::tolerated()
{
    QFETCH(std::string, text);
    const auto loaded = readFlatfab(text, "squares.txt");
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    QVERIFY(loaded->document == readFlatfab(flatfabSquares(2)).value().document);
    QVERIFY(loaded->warnings.empty());
}

void TestFlatfabFormat::unitScalesEverything()
{
    const Document inch = readFlatfab(flatfabSquares(3)).value().document;
    const Document tenth = readFlatfab(flatfabSquares(3), {}, {.unitMm = 2.54}).value().document;
    for (std::size_t i = 0; i < inch.sections.size(); ++i) {
        QVERIFY((inch.sections[i]->frame.origin - 10 * tenth.sections[i]->frame.origin).norm() <
                kSamePoint);
        QVERIFY(std::abs(inch.sections[i]->shape->area() - 100 * tenth.sections[i]->shape->area()) <
                1e-6);
    }
}

void TestFlatfabFormat::worldPointsStay_data()
{
    QTest::addColumn<Vec3>("t");
    QTest::addColumn<Vec3>("b");
    QTest::addColumn<bool>("warns");
    QTest::newRow("upright") << Vec3(1, 0, 0) << Vec3(0, 1, 0) << false;
    QTest::newRow("six digits") << Vec3(0.707107, 0, 0.707107) << Vec3(0, 1, 0) << false;
    QTest::newRow("skew") << Vec3(1, 0, 0) << Vec3(0.6, 0.8, 0) << true;
    QTest::newRow("long and short") << Vec3(0, 3, 0) << Vec3(0, 0, 0.01) << true;
    QTest::newRow("skew and long") << Vec3(2, -1, 0.5) << Vec3(1, 2, 0.7) << true;
    QTest::newRow("nearly parallel") << Vec3(1, 0, 0) << Vec3(1, 0.01, 0) << true;
}

void TestFlatfabFormat::worldPointsStay()
{
    QFETCH(Vec3, t);
    QFETCH(Vec3, b);
    QFETCH(bool, warns);
    const auto line = [](const char *word, const Vec3 &v) {
        return std::string(word) + " " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
               std::to_string(v.z()) + "\n";
    };
    const Vec3 n(t.y() * b.z() - t.z() * b.y(), t.z() * b.x() - t.x() * b.z(),
                 t.x() * b.y() - t.y() * b.x());
    const std::string axes = "P 1 2 3\n" + line("T", t) + line("N", n) + line("B", b);
    const auto loaded =
        readFlatfab(oneSection(axes, {polygonCurve({{0, 0}, {6, 0}, {6, 3}})}), "a.txt").value();
    QCOMPARE(loaded.warnings.size(), std::size_t(warns ? 1 : 0));
    const Section &section = *loaded.document.sections.front();
    QVERIFY(std::abs(section.frame.x.dot(section.frame.y)) < 1e-15);
    QVERIFY(section.frame.normal().dot(n) > 0.0);
    const auto &points = section.shape->contour().points();
    for (const Vec2 &uv : {Vec2(0, 0), Vec2(6, 0), Vec2(6, 3)}) {
        const Vec3 world = 25.4 * (Vec3(1, 2, 3) + uv.x() * t + uv.y() * b);
        const bool isThere = std::any_of(points.begin(), points.end(), [&](const Vec2 &p) {
            return (section.frame.toWorld(p) - world).norm() < kSamePoint;
        });
        QVERIFY(isThere);
    }
}

void TestFlatfabFormat::warnings_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<std::vector<WarningCode>>("codes");
    QTest::addColumn<QString>("place");
    QTest::addColumn<int>("holes");
    using enum WarningCode;
    using Codes = std::vector<WarningCode>;
    const auto holes = [](const std::string &hole) {
        return oneSection(kUprightAxes, {square(2), hole});
    };
    QTest::newRow("clockwise contour and hole of any winding are fine")
        << oneSection(kUprightAxes, {polygonCurve({{0, 0}, {0, 4}, {4, 4}, {4, 0}}),
                                     polygonCurve({{1, 1}, {2, 1}, {2, 2}})})
        << Codes{} << QString() << 1;
    QTest::newRow("normal that is not T x B")
        << replaced(holes(square(1)), "N 0 0 1", "N 0.6 0 0.8") << Codes{SkewFrame}
        << QStringLiteral("a.txt:3") << 1;
    QTest::newRow("left-handed axes") << replaced(holes(square(1)), "N 0 0 1", "N 0 0 -1")
                                      << Codes{SkewFrame} << QStringLiteral("a.txt:3") << 1;
    QTest::newRow("figure of eight")
        << oneSection(kUprightAxes, {polygonCurve({{0, 0}, {4, 4}, {4, 0}, {0, 3}})})
        << Codes{SelfCrossingContour} << QStringLiteral("a.txt:9") << 0;
    QTest::newRow("hole that crosses itself")
        << holes(polygonCurve({{0, 0}, {1, 1}, {1, 0}, {0, 0.7}})) << Codes{SelfCrossingContour}
        << QStringLiteral("a.txt:24") << 1;
    QTest::newRow("hole beside the contour")
        << holes(square(1, 5)) << Codes{HoleOutside} << QStringLiteral("a.txt:24") << 0;
    QTest::newRow("hole across the contour")
        << holes(square(1, 2)) << Codes{NotchedContour} << QStringLiteral("a.txt:24") << 0;
    QTest::newRow("hole that cuts the contour in two")
        << holes(polygonCurve({{-1, -3}, {1, -3}, {1, 3}, {-1, 3}})) << Codes{HoleOutside}
        << QStringLiteral("a.txt:24") << 0;
    QTest::newRow("hole round the contour")
        << holes(square(3)) << Codes{HoleOutside} << QStringLiteral("a.txt:24") << 0;
    QTest::newRow("hole that touches the contour")
        << holes(square(1, 1)) << Codes{} << QString() << 1;
    QTest::newRow("hole on a line") << holes(polygonCurve({{0, 0}, {1, 0}}))
                                    << Codes{DegenerateHole} << QStringLiteral("a.txt:24") << 0;
    QTest::newRow("hole in a point") << holes(polygonCurve({{0, 0}, {0, 0}}))
                                     << Codes{DegenerateHole} << QStringLiteral("a.txt:24") << 0;
    QTest::newRow("text after the last section")
        << holes(square(1)) + "\nP 0 0 0\nT 1 0 0\n"
        << Codes{TrailingLines} << QStringLiteral("a.txt:39") << 1;
    QTest::newRow("blank lines after the last section") << holes(square(1)) + "\n \r\n"
                                                        << Codes{} << QString() << 1;
}

void TestFlatfabFormat::warnings()
{
    QFETCH(std::string, text);
    QFETCH(std::vector<WarningCode>, codes);
    QFETCH(QString, place);
    QFETCH(int, holes);
    const auto loaded = readFlatfab(text, "a.txt");
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    std::vector<WarningCode> found;
    for (const Warning &warning : loaded->warnings) {
        found.push_back(warning.code);
        QCOMPARE(QString::fromStdString(warning.place), place);
        QVERIFY(io::warningText(warning).startsWith(place + QStringLiteral(": ")));
    }
    QVERIFY(found == codes);
    QCOMPARE(static_cast<int>(loaded->document.sections.front()->shape->holes().size()), holes);
}

/// In a square of 8 by 8 units about the origin.
void TestFlatfabFormat::overlappingHoles_data()
{
    QTest::addColumn<std::vector<std::string>>("curves");
    QTest::addColumn<double>("area"); // squares of the file's unit
    QTest::addColumn<int>("holes");
    QTest::addColumn<int>("merged");
    QTest::addColumn<int>("notches");
    using Curves = std::vector<std::string>;
    const std::string clockwise = polygonCurve({{0, -1}, {0, 1}, {2, 1}, {2, -1}});
    const auto row = [](const char *name, Curves curves, double area, int holes, int merged,
                        int notches) {
        curves.insert(curves.begin(), square(4));
        QTest::newRow(name) << curves << area << holes << merged << notches;
    };
    row("apart", {square(1, -2), square(1, 2)}, 64 - 8, 2, 0, 0);
    row("side by side", {square(1, -1), square(1, 1)}, 64 - 8, 2, 0, 0);
    row("half on each other", {square(1), square(1, 1)}, 64 - 6, 1, 1, 0);
    row("of either winding", {square(1), clockwise}, 64 - 6, 1, 1, 0);
    row("the same twice", {square(1), square(1)}, 64 - 4, 1, 1, 0);
    row("one in the other", {square(1), square(2)}, 64 - 16, 1, 1, 0);
    row("a chain of three", {square(1, -1.5), square(1, 1.5), square(1)}, 64 - 10, 1, 2, 0);
    row("one apart from two", {square(0.5), square(0.5, 3), square(0.5, 0.5)}, 64 - 2.5, 2, 1, 0);
    row("across the contour", {square(1, 4)}, 64 - 2, 0, 0, 1);
    row("across the contour and apart", {square(1), square(1, 4)}, 64 - 6, 1, 0, 1);
    row("across the contour and on each other", {square(1, 2.5), square(1, 4)}, 64 - 5, 0, 1, 1);
}

void TestFlatfabFormat::overlappingHoles()
{
    QFETCH(std::vector<std::string>, curves);
    QFETCH(double, area);
    QFETCH(int, holes);
    QFETCH(int, merged);
    QFETCH(int, notches);
    const auto loaded = readFlatfab(oneSection(kUprightAxes, curves), "a.txt");
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    const Shape &shape = *loaded->document.sections.front()->shape;
    QCOMPARE(shape.area() / (25.4 * 25.4), area);
    QVERIFY(std::abs(fff::area(shape.region()) - shape.area()) < 1e-6);
    QCOMPARE(static_cast<int>(shape.holes().size()), holes);
    const auto count = [&](WarningCode code) {
        return static_cast<int>(std::count_if(loaded->warnings.begin(), loaded->warnings.end(),
                                              [&](const Warning &w) { return w.code == code; }));
    };
    QCOMPARE(count(WarningCode::MergedHoles), merged);
    QCOMPARE(count(WarningCode::NotchedContour), notches);
    QCOMPARE(static_cast<int>(loaded->warnings.size()), merged + notches);
}

void TestFlatfabFormat::malformed_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<ErrorCode>("code");
    QTest::addColumn<QString>("place");
    const std::string text = flatfabSquares(2);
    const auto row = [](const char *name, std::string broken, ErrorCode code, const char *place) {
        QTest::newRow(name) << std::move(broken) << code << QString::fromLatin1(place);
    };
    const auto edit = [&](const char *from, const char *to) {
        return test::replacedOnce(text, from, to);
    };
    using enum ErrorCode;
    row("no bytes", "", Truncated, "a.txt:1");
    row("blank lines", "\n\n\r\n", Truncated, "a.txt:3");
    row("some other text", "Hello, world\n", NotAModel, "a.txt");
    row("header word in small letters", "headerparameters 1\n", NotAModel, "a.txt");
    row("sections without header", "PlaneSketch 1\n" + kUprightAxes, NotAModel, "a.txt");
    row("header without a number", edit("HeaderParameters 1", "HeaderParameters"), BadSyntax,
        "a.txt:1");
    row("header only", "HeaderParameters 1\n", Truncated, "a.txt:1");
    row("unknown program", edit("PlaneSketch", "RoundFab"), BadSyntax, "a.txt:2");
    row("no number of sections", edit("PlaneSketch 2", "PlaneSketch"), BadSyntax, "a.txt:2");
    row("two numbers of sections", edit("PlaneSketch 2", "PlaneSketch 2 2"), BadSyntax, "a.txt:2");
    row("number of sections in words", edit("PlaneSketch 2", "PlaneSketch two"), BadValue,
        "a.txt:2");
    row("half a section", edit("PlaneSketch 2", "PlaneSketch 2.5"), BadValue, "a.txt:2");
    row("negative number of sections", edit("PlaneSketch 2", "PlaneSketch -2"), BadValue,
        "a.txt:2");
    row("two billion sections", edit("PlaneSketch 2", "PlaneSketch 2000000000"), BadCount,
        "a.txt:2");
    row("more sections than 64 bits count",
        edit("PlaneSketch 2", "PlaneSketch 99999999999999999999"), BadCount, "a.txt:2");
    row("fewer than 64 bits count", edit("PlaneSketch 2", "PlaneSketch -99999999999999999999"),
        BadValue, "a.txt:2");
    row("more sections than there are", edit("PlaneSketch 2", "PlaneSketch 3"), Truncated,
        "a.txt:58");
    row("a hundred thousand sections", edit("PlaneSketch 2", "PlaneSketch 100000"), Truncated,
        "a.txt:58");
    row("T before P", edit("P 0 3 0\nT 1 0 0", "T 1 0 0\nP 0 3 0"), BadSyntax, "a.txt:3");
    row("an origin of two numbers", edit("P 0 3 0", "P 0 3"), BadSyntax, "a.txt:3");
    row("an origin of four numbers", edit("P 0 3 0", "P 0 3 0 0"), BadSyntax, "a.txt:3");
    row("an origin in words", edit("P 0 3 0", "P 0 three 0"), BadValue, "a.txt:3");
    row("a decimal comma", edit("P 0 3 0", "P 0 3,5 0"), BadValue, "a.txt:3");
    row("nan in the origin", edit("P 0 3 0", "P 0 nan 0"), NonFinite, "a.txt:3");
    row("infinity in an axis", edit("T 1 0 0", "T inf 0 0"), NonFinite, "a.txt:4");
    row("minus infinity in the normal", edit("N 0 0 1", "N 0 0 -inf"), NonFinite, "a.txt:5");
    row("NaN in B", edit("B 0 1 0", "B 0 -NaN 0"), NonFinite, "a.txt:6");
    row("a number no double holds", edit("P 0 3 0", "P 0 1e999 0"), NonFinite, "a.txt:3");
    row("an origin of 1e308", edit("P 0 3 0", "P 0 1e308 0"), BadValue, "a.txt:3");
    row("an origin too far away", edit("P 0 3 0", "P 0 1e6 0"), BadValue, "a.txt:3");
    row("an axis of 1e308", edit("T 1 0 0", "T 1e308 1e308 0"), BadValue, "a.txt:11");
    row("an axis without length", edit("T 1 0 0", "T 0 0 0"), DegenerateFrame, "a.txt:3");
    row("parallel axes", edit("B 0 1 0", "B 1 0 0"), DegenerateFrame, "a.txt:3");
    row("no curves", edit("BoundaryCurves 2", "BoundaryCurves 0"), BadValue, "a.txt:7");
    row("negative number of curves", edit("BoundaryCurves 2", "BoundaryCurves -1"), BadValue,
        "a.txt:7");
    row("a billion curves", edit("BoundaryCurves 2", "BoundaryCurves 1000000000"), BadCount,
        "a.txt:7");
    row("more curves than there are", edit("BoundaryCurves 2", "BoundaryCurves 3"), BadSyntax,
        "a.txt:37");
    row("fewer curves than there are", edit("BoundaryCurves 2", "BoundaryCurves 1"), BadSyntax,
        "a.txt:25");
    row("a keyword that is none", edit("BoundaryCurves", "BoundaryCurve"), BadSyntax, "a.txt:7");
    row("fewer samples than there are", edit("SketchPoints 2", "SketchPoints 1"), BadSyntax,
        "a.txt:10");
    row("more samples than there are", edit("SketchPoints 2", "SketchPoints 3"), BadValue,
        "a.txt:11");
    row("absurdly many samples", edit("SketchPoints 2", "SketchPoints 4000000000"), BadCount,
        "a.txt:8");
    row("nan in a sample", edit("0.5 0.25", "0.5 nan"), NonFinite, "a.txt:10");
    row("no control points", edit("BezierPoints 13", "BezierPoints 0"), BadContour, "a.txt:11");
    row("one segment", edit("BezierPoints 13", "BezierPoints 4"), BadContour, "a.txt:11");
    row("twelve control points", edit("BezierPoints 13", "BezierPoints 12"), BadContour,
        "a.txt:11");
    row("more control points than there are", edit("BezierPoints 13", "BezierPoints 16"), BadValue,
        "a.txt:25");
    row("fewer control points than there are", edit("BezierPoints 13", "BezierPoints 10"),
        BadSyntax, "a.txt:22");
    row("absurdly many control points", edit("BezierPoints 13", "BezierPoints 3000001"), BadCount,
        "a.txt:11");
    row("a point of one number", edit("1 -0.5\n", "1\n"), BadSyntax, "a.txt:16");
    row("a point of three numbers", edit("1 -0.5\n", "1 -0.5 0\n"), BadSyntax, "a.txt:16");
    row("a point of words", edit("1 -0.5\n", "one -0.5\n"), BadValue, "a.txt:16");
    row("inf in a point", edit("1 -0.5\n", "1 inf\n"), NonFinite, "a.txt:16");
    row("a point of 1e308", edit("1 -0.5\n", "1 1e308\n"), BadValue, "a.txt:11");
    row("a point too far away", edit("1 -0.5\n", "1 50000\n"), BadValue, "a.txt:11");
    row("a contour that does not close", edit("-1 -0.5\n-1 -1\n", "-1 -0.5\n-1 -0.9\n"), BadContour,
        "a.txt:11");
    row("a contour without area", oneSection(kUprightAxes, {polygonCurve({{0, 0}, {1, 0}})}),
        EmptyContour, "a.txt:9");
    row("a hole that does not close", edit("0.1 0.1\n0 0\n", "0.1 0.1\n0 1\n"), BadContour,
        "a.txt:26");
    row("a hole that leaves nothing", oneSection(kUprightAxes, {square(2), square(2)}),
        EmptyContour, "a.txt:9");
    row("steering characters in a line",
        edit("PlaneSketch 2", "Plane\xC2\x9E\x1b[31m\xE2\x80\xA8 2"), BadSyntax, "a.txt:2");
    row("bytes that are no text", edit("PlaneSketch 2", "\xFF\xFE\x80\x81"), BadSyntax, "a.txt:2");
    row("a line of a million letters",
        test::replacedOnce(text, "PlaneSketch 2", "PlaneSketch " + std::string(1'000'000, 'x')),
        BadValue, "a.txt:2");
    row("an error behind CR LF", test::replaced(edit("T 1 0 0", "T inf 0 0"), "\n", "\r\n"),
        NonFinite, "a.txt:4");
    row("old Mac line ends", test::replaced(text, "\n", "\r"), BadSyntax, "a.txt:1");
    row("a byte-order mark alone", "\xEF\xBB\xBF", Truncated, "a.txt:1");
    row("hexadecimal numbers", edit("P 0 3 0", "P 0x10 3 0"), BadValue, "a.txt:3");
    row("two signs", edit("P 0 3 0", "P +-3 3 0"), BadValue, "a.txt:3");
    row("zero bytes", std::string("HeaderParameters 1\nFlatFab 1\n\0\0\0\0", 33), BadSyntax,
        "a.txt:3");
}

void TestFlatfabFormat::malformed()
{
    QFETCH(std::string, text);
    QFETCH(ErrorCode, code);
    QFETCH(QString, place);
    const auto loaded = readFlatfab(text, "a.txt");
    QVERIFY(!loaded);
    const QByteArray sentence = io::errorText(loaded.error()).toUtf8();
    QVERIFY2(loaded.error().code == code, sentence);
    QCOMPARE(QString::fromStdString(loaded.error().place), place);
    QCOMPARE(test::unclear(loaded.error()), QString());
}

void TestFlatfabFormat::truncationIsAnError()
{
    const std::string text = flatfabSquares(2);
    for (std::size_t length = 0; length < text.size(); ++length) {
        const auto loaded = readFlatfab(std::string_view(text).substr(0, length), "a.txt");
        if (loaded) // the last number without its line end
            QCOMPARE(loaded->document.sections.size(), std::size_t(2));
        else
            QVERIFY(loaded.error().code != ErrorCode::NotAModel || length < 16);
        QVERIFY2(!loaded || length + 2 >= text.size(), std::to_string(length).c_str());
    }
}

void TestFlatfabFormat::flippedBytesNeverCrash()
{
    const unsigned seed = 5;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const std::string text = flatfabSquares(2);
    int errors = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string broken = text;
        for (int j = 0; j < 2; ++j)
            broken[random() % broken.size()] = "0123456789-+.e \nPTNBinaf"[random() % 24];
        const auto loaded = readFlatfab(broken, "a.txt");
        if (loaded)
            QVERIFY(loaded->document.sections.size() <= 2);
        else
            ++errors;
    }
    QVERIFY(errors > 300);
}

FFF_TEST(TestFlatfabFormat)
#include "tst_flatfab_format.moc"
