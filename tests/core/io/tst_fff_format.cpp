// The native format. If this fails, a saved model does not come back, or a broken file does harm.
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/io/error_text.h"
#include "core/io/fff_format.h"
#include "core/operations/operation_kind.h"
#include "tests/core/io/io_samples.h"
#include "tests/test_program.h"

#include <QtCore/QFile>
#include <QtTest/QtTest>
#include <numbers>
#include <random>

using namespace fff;
using fff::test::twoSections;

class TestFffFormat : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void writeThenReadIsEqual_data();
    void writeThenReadIsEqual();
    void randomDocumentsReadBack();
    void sharedShapesComeBackShared();
    void goldenFileIsWritten();
    void goldenFileIsRead();
    void howSlitsAreCutComesBack();
    void malformed_data();
    void malformed();
    void shapesAreMended_data();
    void shapesAreMended();
    void mendingComesToAnEnd_data();
    void mendingComesToAnEnd();
    void mendingOfHolesComesToAnEnd();
    void frames_data();
    void frames();
    void danglingOperationIsKept();
    void unknownKeysArePassedOver();
    void operationsAreNotLost();
    void deepNestingIsAnError();
    void truncationIsAnError();
    void flippedBytesNeverCrash();
};

namespace {

std::string goldenPath()
{
    return FFF_TEST_DATA "/fff/two_sections.fff";
}

std::string golden()
{
    QFile file(QString::fromStdString(goldenPath()));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

/// The golden file with the first `from` replaced.
std::string edited(const std::string &from, const std::string &to)
{
    return test::replacedOnce(golden(), from, to);
}

/// Where the text stands first in the golden file, from 1.
std::ptrdiff_t lineOf(const std::string &text)
{
    const std::string whole = golden();
    const auto end = whole.begin() + static_cast<std::ptrdiff_t>(whole.find(text));
    return 1 + std::count(whole.begin(), end, '\n');
}

/// With an operation of this in place of what a whole one has.
std::string withOperation(const std::string &from, const std::string &to)
{
    const std::string whole = R"({"id": 9, "kind": "linear", "version": 1, "name": "Ribs",
        "inputs": {"section": [{"section": 4, "name": "Rib"}], "along": []},
        "parameters": {"count": 8, "side": "both", "equalDepth": true},
        "exceptions": [{"instance": "1", "state": "hidden"}]})";
    const std::string text = from.empty() ? whole : test::replacedOnce(whole, from, to);
    return test::replacedOnce(edited("\"operations\": []", "\"operations\": [" + text + "]"),
                              "\"nextId\": 6", "\"nextId\": 20");
}

Document withFrame(const Frame &frame)
{
    Document document = twoSections();
    return moveSection(document, document.sections.front()->id, frame).value();
}

/// Control points once round the origin: hardly ever crossing, so that little is mended.
ShapePointer randomShape(std::mt19937_64 &random)
{
    std::uniform_real_distribution<double> radius(20.0, 60.0);
    for (;;) {
        std::vector<Vec2> points(3 * (2 + random() % 6));
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) /
                                 static_cast<double>(points.size());
            const double r = radius(random);
            points[i] = {r * std::cos(angle), random() % 10 == 0 ? -0.0 : r * std::sin(angle)};
        }
        const auto contour = resolveCrossings(Contour::fromPoints(points).value());
        if (!contour)
            continue;
        if (const auto shape = Shape::make(contour->contour))
            return *shape;
    }
}

Document randomDocument(std::mt19937_64 &random)
{
    std::normal_distribution<double> length(0.0, 100.0);
    const auto vector = [&] { return Vec3(length(random), length(random), length(random)); };
    Document document = newDocument();
    std::vector<ShapePointer> shapes = {randomShape(random), randomShape(random)};
    const int count = static_cast<int>(random() % 8);
    for (int i = 0; i < count; ++i) {
        NewSection section;
        section.shape = random() % 2 == 0 ? randomShape(random) : shapes[random() % 2];
        section.frame = makeFrame(vector(), vector(), vector()).value();
        if (i > 0)
            section.parent = Parent{document.sections[random() % document.sections.size()]->id,
                                    {length(random), 0.0},
                                    {length(random), 1e-12}};
        document = addSection(document, section).value();
    }
    return document;
}

} // namespace

void TestFffFormat::writeThenReadIsEqual_data()
{
    QTest::addColumn<Document>("document");
    QTest::newRow("two sections") << twoSections();
    QTest::newRow("new document") << newDocument();
    Document gaps = twoSections();
    gaps = removeSections(gaps, std::vector{gaps.sections.front()->id}).value();
    gaps.nextId = 4'000'000'000'000;
    QTest::newRow("ids with gaps") << gaps;
    Document reversed = twoSections();
    std::swap(reversed.sections[0], reversed.sections[1]);
    QTest::newRow("parent below its child") << reversed;
    Document odd = twoSections();
    odd = renameSection(odd, odd.sections[0]->id, std::string("\"\\\n\t\x01\0 🐟", 11)).value();
    odd = renameSection(odd, odd.sections[1]->id, "").value();
    QTest::newRow("odd names") << odd;
    Document named = twoSections();
    named.loads.front().name = "Cup \"of\" tea – 茶";
    QTest::newRow("a weight with a name") << named;
    Document wanted = twoSections();
    JointOverride joint;
    joint.a = wanted.sections[0]->id;
    joint.b = wanted.sections[1]->id;
    joint.kind = JointKind::Mortise;
    wanted = setJointOverride(wanted, joint).value();
    QTest::newRow("a joint of a kind") << wanted;
    joint.kind.reset();
    joint.opens = Vec2(0.6, -0.8);
    joint.shares = {{{0.1 + 0.2, -5e-7}, 0.05}, {{7.0, 8.0}, 1.0 / 3.0}};
    wanted = setJointOverride(wanted, joint).value();
    joint = {};
    joint.a = wanted.sections[0]->id;
    joint.b = SectionRef(OperationId{3}, "rib/7");
    joint.kind = JointKind::None;
    QTest::newRow("joints, one dormant") << setJointOverride(wanted, joint).value();
}

void TestFffFormat::writeThenReadIsEqual()
{
    QFETCH(Document, document);
    const std::string bytes = io::writeFff(document).value();
    const auto loaded = io::readFff(bytes);
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    QVERIFY(loaded->document == document);
    QVERIFY(loaded->warnings.empty());
    QCOMPARE(io::writeFff(loaded->document).value(), bytes);
}

void TestFffFormat::randomDocumentsReadBack()
{
    const unsigned seed = 7;
    qInfo("seed %u", seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 200; ++i) {
        const Document document = randomDocument(random);
        const std::string bytes = io::writeFff(document).value();
        const auto loaded = io::readFff(bytes);
        QVERIFY2(loaded, bytes.c_str());
        QVERIFY2(loaded->document == document, bytes.c_str());
        QCOMPARE(io::writeFff(loaded->document).value(), bytes);
    }
}

void TestFffFormat::sharedShapesComeBackShared()
{
    Document document = newDocument();
    NewSection section;
    for (const ShapePointer &shape : {test::rib(), test::rib(), test::plateWithHole()}) {
        section.shape = shape;
        for (int i = 0; i < 3; ++i)
            document = addSection(document, section).value();
    }
    const std::string bytes = io::writeFff(document).value();
    const Document again = io::readFff(bytes).value().document;
    for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t j = 0; j < 9; ++j)
            QCOMPARE(again.sections[i]->shape == again.sections[j]->shape,
                     document.sections[i]->shape == document.sections[j]->shape);
    }
}

void TestFffFormat::goldenFileIsWritten()
{
    const std::string bytes = io::writeFff(twoSections()).value();
    if (bytes != golden()) {
        QFile actual(QStringLiteral("two_sections.actual.fff"));
        QVERIFY(actual.open(QIODevice::WriteOnly));
        actual.write(bytes.data(), static_cast<qint64>(bytes.size()));
        QFAIL(qPrintable(QStringLiteral("differs from the golden file; written instead: ") +
                         actual.fileName()));
    }
}

// Wrong: a model that is milled elsewhere than where it was set up has square slits again.
void TestFffFormat::howSlitsAreCutComesBack()
{
    for (const SlitEnd end : {SlitEnd::Square, SlitEnd::Round, SlitEnd::Dogbone, SlitEnd::TBone}) {
        Document document = twoSections();
        Stock stock = *document.stocks.front();
        stock.slitEnd = end;
        stock.toolDiameter = 0.1 + 0.2;
        stock.leadIn = 1.5;
        stock.bumps = 0.15;
        stock.isDuctile = true;
        stock.lastingShare = 0.25;
        document = setStock(document, stock).value();
        const auto bytes = io::writeFff(document);
        QVERIFY(bytes);
        const auto loaded = io::readFff(*bytes);
        QVERIFY(loaded);
        QVERIFY(*loaded->document.stocks.front() == stock);
        QVERIFY(loaded->document == document);
    }
    // Plain slits are what they always were, and not worth a word.
    QVERIFY(golden().find("slitEnd") == std::string::npos);
}

void TestFffFormat::goldenFileIsRead()
{
    const auto loaded = io::readFff(golden(), "two.fff");
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    const Document &document = loaded->document;
    QCOMPARE(document.sections.size(), std::size_t(2));
    QCOMPARE(document.sections[0]->name, std::string("Rückwand"));
    QCOMPARE(document.sections[0]->shape->holes().size(), std::size_t(1));
    QCOMPARE(document.sections[1]->parent->section.drawn, document.sections[0]->id);
    QCOMPARE(document.loads.size(), std::size_t(1));
    QVERIFY(document == twoSections());
}

void TestFffFormat::malformed_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<ErrorCode>("code");
    QTest::addColumn<std::string>("place");
    const auto row = [](const char *name, std::string text, ErrorCode code, std::string place) {
        QTest::newRow(name) << std::move(text) << code << std::move(place);
    };
    using enum ErrorCode;
    row("no bytes", "", Truncated, "a.fff:1");
    row("a list", "[1]", NotAModel, "a.fff");
    row("another JSON", "{\"format\": \"gltf\"}", NotAModel, "a.fff");
    row("empty object", "{}", NotAModel, "a.fff");
    row("NaN", edited("83.82", "NaN"), NonFinite, "a.fff:64");
    row("nan", edited("83.82", "nan"), NonFinite, "a.fff:64");
    row("minus infinity", edited("83.82", "-Infinity"), NonFinite, "a.fff:64");
    row("a number no double holds", edited("83.82", "1e999"), NonFinite, "a.fff:64");
    row("a missing comma", edited("\"version\": 3,", "\"version\": 3"), BadSyntax, "a.fff:4");
    row("a comma too many", edited("0.35\n", "0.35,\n"), BadSyntax, "a.fff:89");
    row("a second document", golden() + "{}", BadSyntax, "a.fff:93");
    row("broken UTF-8",
        edited("Rückwand", "R\xFC"
                           "ckwand"),
        BadSyntax, "a.fff:60");
    row("a version from the future", edited("\"version\": 3", "\"version\": 7"), NewerVersion,
        "a.fff:$.version");
    row("version zero", edited("\"version\": 3", "\"version\": 0"), BadValue, "a.fff:$.version");
    row("version in words", edited("\"version\": 3", "\"version\": \"1\""), BadValue,
        "a.fff:$.version");
    row("no nextId", edited("\"nextId\"", "\"next\""), BadValue, "a.fff:$.nextId");
    row("nextId that was used", edited("\"nextId\": 6", "\"nextId\": 5"), BadValue,
        "a.fff:$.weights[0].id");
    row("nextId beyond whole numbers", edited("\"nextId\": 6", "\"nextId\": 1e19"), BadValue,
        "a.fff:$.nextId");
    row("an id of 2.5", edited("\"id\": 2", "\"id\": 2.5"), BadValue, "a.fff:$.sections[0].id");
    row("an id of 0", edited("\"id\": 2", "\"id\": 0"), BadValue, "a.fff:$.sections[0].id");
    row("a negative id", edited("\"id\": 1", "\"id\": -1"), BadValue, "a.fff:$.stocks[0].id");
    row("two sections with one id", edited("\"id\": 4", "\"id\": 2"), DuplicateId,
        "a.fff:$.sections[1].id");
    row("a section with a stock's id", edited("\"id\": 4", "\"id\": 1"), DuplicateId,
        "a.fff:$.sections[1].id");
    row("a weight with a section's id", edited("\"id\": 5", "\"id\": 4"), DuplicateId,
        "a.fff:$.weights[0].id");
    row("an unknown current stock", edited("\"currentStock\": 3", "\"currentStock\": 2"),
        UnknownReference, "a.fff:$.currentStock");
    row("no stocks", edited("\"stocks\"", "\"stacks\""), BadValue, "a.fff:$.stocks");
    row("an empty list of stocks", io::writeFff(Document{}).value(), BadValue, "a.fff:$.stocks");
    row("an empty list of stocks that is used", edited("\"stocks\": [", "\"stocks\": [], \"x\": ["),
        BadValue, "a.fff:$.stocks");
    row("stocks as an object", edited("\"stocks\": [", "\"stocks\": {}, \"x\": ["), BadValue,
        "a.fff:$.stocks");
    row("a stock that is a number", edited("\"stocks\": [", "\"stocks\": [3, "), BadValue,
        "a.fff:$.stocks[0]");
    row("a thickness of 0", edited("\"thickness\": 3", "\"thickness\": 0"), BadValue,
        "a.fff:$.stocks[0].thickness");
    row("a density below 0", edited("660", "-660"), BadValue, "a.fff:$.stocks[0].density");
    row("a strength in words", edited("\"tensileStrength\": 25", "\"tensileStrength\": \"25\""),
        BadValue, "a.fff:$.stocks[0].tensileStrength");
    row("a kerf below 0", edited("\"kerf\": 0.2", "\"kerf\": -0.2"), BadValue,
        "a.fff:$.stocks[0].kerf");
    row("a sheet without height", edited("[600, 400]", "[600, 0]"), BadValue,
        "a.fff:$.stocks[0].sheet");
    row("a sheet of one number", edited("[600, 400]", "[600]"), BadValue,
        "a.fff:$.stocks[0].sheet");
    row("a name that is a number", edited("\"Rückwand\"", "7"), BadValue,
        "a.fff:$.sections[0].name");
    row("an unknown stock", edited("\"stock\": 1", "\"stock\": 9"), UnknownReference,
        "a.fff:$.sections[0].stock");
    row("an unknown shape", edited("\"shape\": 1", "\"shape\": 2"), UnknownReference,
        "a.fff:$.sections[1].shape");
    row("a negative shape", edited("\"shape\": 1", "\"shape\": -1"), BadValue,
        "a.fff:$.sections[1].shape");
    row("a contour of 11 points", edited("[0, 0], ", ""), BadContour, "a.fff:$.shapes[0].contour");
    row("a point of three numbers", edited("[80, 0]", "[80, 0, 0]"), BadValue,
        "a.fff:$.shapes[0].contour[3]");
    row("a point of words", edited("[80, 0]", "[80, \"0\"]"), BadValue,
        "a.fff:$.shapes[0].contour[3][1]");
    row("a point that is null", edited("[80, 0]", "null"), BadValue,
        "a.fff:$.shapes[0].contour[3]");
    row("a coordinate of 1e308", edited("[80, 0]", "[1e308, 0]"), BadValue,
        "a.fff:$.shapes[0].contour[3][0]");
    row("no contour", edited("\"contour\"", "\"outline\""), BadValue, "a.fff:$.shapes[0].contour");
    row("an empty contour", edited("\"contour\": [", "\"contour\": [], \"x\": ["), BadContour,
        "a.fff:$.shapes[0].contour");
    row("a contour without area",
        edited("\"contour\": [", "\"contour\": [[0,0],[1,0],[2,0],[3,0],[2,0],[1,0]], \"x\": ["),
        EmptyContour, "a.fff:$.shapes[0]");
    row("a hole that is a number", edited("\"holes\": [", "\"holes\": [4, "), BadValue,
        "a.fff:$.shapes[0].holes[0]");
    row("no frame", edited("\"frame\"", "\"place\""), BadValue, "a.fff:$.sections[0].frame");
    row("an axis without length", edited("\"x\": [1, 0, 0]", "\"x\": [0, 0, 0]"), DegenerateFrame,
        "a.fff:$.sections[0].frame");
    row("parallel axes", edited("\"y\": [0, 1, 0]", "\"y\": [1, 0, 0]"), DegenerateFrame,
        "a.fff:$.sections[0].frame");
    row("an axis of length 2", edited("\"x\": [1, 0, 0]", "\"x\": [2, 0, 0]"), DegenerateFrame,
        "a.fff:$.sections[0].frame");
    row("an origin too far away", edited("83.82", "1e7"), BadValue,
        "a.fff:$.sections[0].frame.origin[1]");
    row("an unknown parent", edited("{\"section\": 2", "{\"section\": 3"), UnknownReference,
        "a.fff:$.sections[1].parent.section");
    row("a section that is its own parent", edited("{\"section\": 2", "{\"section\": 4"), BadValue,
        "a.fff:$.sections[1].parent");
    row("a parent without a slit", edited("slitTo", "slitTwo"), BadValue,
        "a.fff:$.sections[1].parent.slitTo");
    row("an unknown operation", withOperation("linear", "spiral"), Unsupported,
        "a.fff:$.operations[0]");
    row("an operation of a later version", withOperation("\"version\": 1", "\"version\": 2"),
        Unsupported, "a.fff:$.operations[0]");
    row("an operation with a section's id", withOperation("\"id\": 9", "\"id\": 4"), DuplicateId,
        "a.fff:$.operations[0].id");
    row("an operation with 1 replica", withOperation("8", "1"), BadValue,
        "a.fff:$.operations[0].parameters.count");
    row("an operation with half a replica", withOperation("8", "8.5"), BadValue,
        "a.fff:$.operations[0].parameters.count");
    row("an operation with an unknown side", withOperation("both", "up"), BadValue,
        "a.fff:$.operations[0].parameters.side");
    row("a switch that is a number", withOperation("true", "1"), BadValue,
        "a.fff:$.operations[0].parameters.equalDepth");
    row("an input that never was", withOperation("\"section\": 4", "\"section\": 21"),
        UnknownReference, "a.fff:$.operations[0].inputs.section[0].section");
    row("inputs as a list", withOperation("\"along\": []", "\"along\": 4"), BadValue,
        "a.fff:$.operations[0].inputs.along");
    row("an exception that is none", withOperation(", \"state\": \"hidden\"", ""), BadValue,
        "a.fff:$.operations[0].exceptions[0]");
    row("an exception of an unknown kind", withOperation("hidden", "blue"), BadValue,
        "a.fff:$.operations[0].exceptions[0].state");
    row("an exception of no stock", withOperation("\"state\": \"hidden\"", "\"stock\": 4"),
        UnknownReference, "a.fff:$.operations[0].exceptions[0].stock");
    row("two exceptions of one instance",
        withOperation("[{\"instance\"", "[{\"instance\": \"1\", \"stock\": 1}, {\"instance\""),
        BadValue, "a.fff:$.operations[0].exceptions[1]");
    row("a reference to an operation that never was",
        edited("\"section\": 4", "\"section\": {\"operation\": 6, \"instance\": \"1\"}"),
        UnknownReference, "a.fff:$.weights[0].section.operation");
    row("a weight on no section", edited("\"section\": 4", "\"section\": 44"), UnknownReference,
        "a.fff:$.weights[0].section");
    row("a weight whose name is a number", edited("\"mass\": 0.35", "\"mass\": 0.35, \"name\": 7"),
        BadValue, "a.fff:$.weights[0].name");
    row("a weight of 0", edited("0.35", "0"), BadValue, "a.fff:$.weights[0].mass");
    const auto joint = [](const std::string &text) {
        return edited("\"joints\": []", "\"joints\": [" + text + "]");
    };
    row("a joint of a kind that is none", joint(R"({ "a": 2, "b": 4, "kind": "glue" })"), BadValue,
        "a.fff:$.joints[0].kind");
    row("a joint of no section", joint(R"({ "a": 2, "b": 77, "kind": "none" })"), UnknownReference,
        "a.fff:$.joints[0].b");
    row("a joint of a section with itself", joint(R"({ "a": 2, "b": 2, "kind": "none" })"),
        BadValue, "a.fff:$.joints[0]");
    row("a joint of which nothing is wanted", joint(R"({ "a": 2, "b": 4 })"), BadValue,
        "a.fff:$.joints[0]");
    row("a joint that stands there twice",
        joint(R"({ "a": 2, "b": 4, "kind": "none" }, { "a": 2, "b": 4, "kind": "mortise" })"),
        BadValue, "a.fff:$.joints[1]");
    row("a joint that opens to nowhere", joint(R"({ "a": 2, "b": 4, "opens": [0, 0] })"), BadValue,
        "a.fff:$.joints[0].opens");
    row("a slit that takes all",
        joint(R"({ "a": 2, "b": 4, "shares": [ { "at": [1, 2], "ofA": 1 } ] })"), BadValue,
        "a.fff:$.joints[0].shares[0].ofA");
    row("a weight below 0", edited("0.35", "-0.35"), BadValue, "a.fff:$.weights[0].mass");
    row("a weight spread as nothing is", edited("0.35", "0.35, \"spread\": \"cloud\""), BadValue,
        "a.fff:$.weights[0].spread");
    row("a patch that is a point", edited("0.35", "0.35, \"spread\": \"patch\", \"width\": 0"),
        BadValue, "a.fff:$.weights[0].width");
    row("a glass that is fuller than it is heavy", edited("0.35", "0.35, \"filled\": 1"), BadValue,
        "a.fff:$.weights[0].filled");
    const auto push = [&](const std::string &rest) {
        const std::string list =
            "\"pushes\": [ { \"id\": 9, \"section\": 2, \"position\": [0, 0], " + rest +
            " } ], \"weights\": [";
        return test::replacedOnce(edited("\"weights\": [", list), "\"nextId\": 6",
                                  "\"nextId\": 20");
    };
    row("a push without a force", push("\"force\": [0, 0, 0]"), BadValue,
        "a.fff:$.pushes[0].force");
    row("a push of two numbers", push("\"force\": [1, 2]"), BadValue, "a.fff:$.pushes[0].force");
    row("a push beyond all bounds", push("\"force\": [0, 1e7, 0]"), BadValue,
        "a.fff:$.pushes[0].force");
    row("a push that hangs", push("\"force\": [0, 1, 0], \"spread\": \"hanging\""), BadValue,
        "a.fff:$.pushes[0].spread");
    row("a thickness below 0", edited("\"thickness\": 3", "\"thickness\": -3"), BadValue,
        "a.fff:$.stocks[0].thickness");
    row("a thickness that is null", edited("\"thickness\": 3", "\"thickness\": null"), BadValue,
        "a.fff:$.stocks[0].thickness");
    row("a modulus that is missing", edited("\"modulus\": 4000,", ""), BadValue,
        "a.fff:$.stocks[0].modulus");
    row("a clearance beyond all measure", edited("-0.05", "-1e7"), BadValue,
        "a.fff:$.stocks[1].clearance");
    row("an end that slits do not have", edited("-0.05", "-0.05, \"slitEnd\": \"oval\""), BadValue,
        "a.fff:$.stocks[1].slitEnd");
    row("a tool without a diameter", edited("-0.05", "-0.05, \"toolDiameter\": 0"), BadValue,
        "a.fff:$.stocks[1].toolDiameter");
    row("a lead-in below 0", edited("-0.05", "-0.05, \"leadIn\": -1"), BadValue,
        "a.fff:$.stocks[1].leadIn");
    row("ductile as a number", edited("-0.05", "-0.05, \"ductile\": 1"), BadValue,
        "a.fff:$.stocks[1].ductile");
    for (const char *share : {"0", "-0.5", "1.01", "null"})
        row(qPrintable(QStringLiteral("a lasting share of %1").arg(QLatin1String(share))),
            edited("-0.05", std::string("-0.05, \"lastingShare\": ") + share), BadValue,
            "a.fff:$.stocks[1].lastingShare");
    row("bumps as a word", edited("-0.05", "-0.05, \"bumps\": \"high\""), BadValue,
        "a.fff:$.stocks[1].bumps");
    row("a format in a list", edited("\"FlatFitFab\"", "[\"FlatFitFab\"]"), NotAModel, "a.fff");
    row("half a version", edited("\"version\": 3", "\"version\": 1.5"), BadValue,
        "a.fff:$.version");
    row("a version beyond whole numbers", edited("\"version\": 3", "\"version\": 1e300"), BadValue,
        "a.fff:$.version");
    row("two stocks with one id", edited("\"id\": 3", "\"id\": 1"), DuplicateId,
        "a.fff:$.stocks[1].id");
    row("sections as a text", edited("\"sections\": [", "\"sections\": \"two\", \"x\": ["),
        BadValue, "a.fff:$.sections");
    row("a section that is null", edited("\"sections\": [", "\"sections\": [null, "), BadValue,
        "a.fff:$.sections[0]");
    row("no sections", edited("\"sections\"", "\"parts\""), BadValue, "a.fff:$.sections");
    row("no shapes", edited("\"shapes\"", "\"forms\""), BadValue, "a.fff:$.shapes");
    row("holes as null", edited("\"holes\": [", "\"holes\": null, \"x\": ["), BadValue,
        "a.fff:$.shapes[0].holes");
    row("an empty hole", edited("\"holes\": [", "\"holes\": [[], "), BadContour,
        "a.fff:$.shapes[0].holes[0]");
    row("an axis of two numbers", edited("\"x\": [1, 0, 0]", "\"x\": [1, 0]"), BadValue,
        "a.fff:$.sections[0].frame.x");
    row("an axis of words", edited("\"x\": [1, 0, 0]", "\"x\": [1, \"0\", 0]"), BadValue,
        "a.fff:$.sections[0].frame.x[1]");
    row("a parent that is a number",
        edited("\"parent\": {\"section\": 2, \"slitFrom\": [40, 20], \"slitTo\": [40, 65.3125]}",
               "\"parent\": 2"),
        BadValue, "a.fff:$.sections[1].parent");
    row("a section below its own child",
        edited("\"shape\": 0,", "\"shape\": 0, \"parent\": {\"section\": 4, \"slitFrom\": [0, 0], "
                                "\"slitTo\": [1, 1]},"),
        BadValue, "a.fff:$.sections[0].parent");
    row("an operation without a kind", withOperation("\"kind\": \"linear\", ", ""), BadValue,
        "a.fff:$.operations[0].kind");
    row("an operation without an id", edited("\"operations\": []", "\"operations\": [{}]"),
        BadValue, "a.fff:$.operations[0].id");
    row("a reference without an instance",
        edited("\"section\": 4", "\"section\": {\"operation\": 3}"), BadValue,
        "a.fff:$.weights[0].section.instance");
    row("a thousand levels of lists", std::string(2000, '[') + std::string(2000, ']'), BadSyntax,
        "a.fff:1");
    row("a thousand levels in a place nobody reads",
        edited("\"operations\": []", "\"x\": " + std::string(2000, '[')), BadSyntax, "a.fff:82");
    row("an error behind CR LF", test::replaced(edited("83.82", "nan"), "\n", "\r\n"), NonFinite,
        "a.fff:64");
    row("an error behind a byte-order mark", "\xEF\xBB\xBF" + edited("83.82", "nan"), NonFinite,
        "a.fff:64");
    row("a byte-order mark alone", "\xEF\xBB\xBF", Truncated, "a.fff:1");
    // Wrong: the last one would win in silence, and a model would open without its sections.
    row("a list of sections twice", edited("\"operations\": []", "\"sections\": []"), BadSyntax,
        "a.fff:82");
    row("a key twice in an object of an object",
        edited("\"density\": 640.5", "\"density\": 640.5, \"density\": 1"), BadSyntax,
        "a.fff:" + std::to_string(lineOf("\"density\": 640.5")));
    row("a key twice, once escaped",
        edited("\"version\": 3", "\"version\": 3, \"v\\u0065rsion\": 1"), BadSyntax, "a.fff:3");
    row("a key twice in a place nobody reads",
        edited("\"operations\": []", "\"x\": [{\"a\": [{\"b\": 1}, {}], \"a\"\n: 2}]"), BadSyntax,
        "a.fff:82");
    // Wrong: it would be written as another text, and no two programs would agree which.
    row("the first half of a character", edited("Rückwand", "R\\ud83dckwand"), BadSyntax,
        "a.fff:60");
    row("the second half of a character", edited("Rückwand", "R\\uDE00ckwand"), BadSyntax,
        "a.fff:60");
    row("two first halves", edited("Rückwand", "\\ud83d\\ud83d\\ude00"), BadSyntax, "a.fff:60");
    row("half a character in a key", edited("\"version\": 3", "\"\\udc00\": 1, \"version\": 3"),
        BadSyntax, "a.fff:3");
    row("half a character as bytes", edited("Rückwand", "R\xED\xA0\x80"), BadSyntax, "a.fff:60");
    // Wrong: a model would open that nothing can be made of, or with words about an option.
    for (const auto &[key, was] :
         {std::pair("thickness", "2"), std::pair("density", "640.5"),
          std::pair("tensileStrength", "null"), std::pair("flexuralStrength", "null"),
          std::pair("modulus", "null"), std::pair("kerf", "0.15"),
          std::pair("clearance", "-0.05")}) {
        const std::string field = std::string("\"") + key + "\": ";
        for (const char *value : {"1e9", "1e308", "-1e9", "\"2\"", "true"})
            row(qPrintable(
                    QStringLiteral("%1 of %2").arg(QLatin1String(key), QLatin1String(value))),
                edited(field + was, field + value), BadValue,
                std::string("a.fff:$.stocks[1].") + key);
        row(qPrintable(QStringLiteral("%1 of NaN").arg(QLatin1String(key))),
            edited(field + was, field + "NaN"), NonFinite,
            "a.fff:" + std::to_string(lineOf(field + was)));
    }
    for (const char *key : {"thickness", "density"})
        row(qPrintable(QStringLiteral("no %1").arg(QLatin1String(key))),
            edited(std::string("\"") + key + "\": " + (key[0] == 't' ? "2" : "640.5"),
                   std::string("\"") + key + "\": 0"),
            BadValue, std::string("a.fff:$.stocks[1].") + key);
    row("a clearance that leaves no slit", edited("-0.05", "-2"), BadValue,
        "a.fff:$.stocks[1].clearance");
    row("steering characters in a value",
        edited("\"version\": 3", "\"version\": \"\\u001b[31m\\n\\u0085\\u2028\""), BadValue,
        "a.fff:$.version");
}

void TestFffFormat::malformed()
{
    QFETCH(std::string, text);
    QFETCH(ErrorCode, code);
    QFETCH(std::string, place);
    const auto loaded = io::readFff(text, "a.fff");
    QVERIFY(!loaded);
    const QByteArray sentence = io::errorText(loaded.error()).toUtf8();
    QVERIFY2(loaded.error().code == code, sentence);
    QCOMPARE(QString::fromStdString(loaded.error().place), QString::fromStdString(place));
    QCOMPARE(test::unclear(loaded.error()), QString());
}

/// As those of `.txt` files, and for good: what is written then is read without a word.
void TestFffFormat::shapesAreMended_data()
{
    QTest::addColumn<std::vector<Polygon>>("polygons"); // the contour, its holes
    QTest::addColumn<WarningCode>("code");
    QTest::addColumn<std::string>("where");
    QTest::addColumn<double>("area");
    QTest::addColumn<int>("holes");
    using enum WarningCode;
    using Polygons = std::vector<Polygon>;
    const auto square = [](double half, double x) {
        return Polygon{{x - half, -half}, {x + half, -half}, {x + half, half}, {x - half, half}};
    };
    const Polygon eight = {{0, 0}, {40, 40}, {40, 0}, {0, 30}};
    const std::string hole = "holes[0]";
    QTest::newRow("contour like an eight")
        << Polygons{eight} << SelfCrossingContour << std::string("contour")
        << 0.5 * 40 * (40 - 120.0 / 7.0) << 0;
    QTest::newRow("hole outside") << Polygons{square(40, 0), square(5, 60)} << HoleOutside << hole
                                  << 6400.0 << 0;
    QTest::newRow("hole across the contour")
        << Polygons{square(40, 0), square(5, 40)} << NotchedContour << hole << 6350.0 << 0;
    QTest::newRow("hole without area")
        << Polygons{square(40, 0), {{0, 0}, {1, 0}}} << DegenerateHole << hole << 6400.0 << 0;
    QTest::newRow("holes on each other") << Polygons{square(40, 0), square(5, 0), square(5, 5)}
                                         << MergedHoles << std::string("holes[1]") << 6250.0 << 1;
}

void TestFffFormat::shapesAreMended()
{
    QFETCH(std::vector<Polygon>, polygons);
    QFETCH(WarningCode, code);
    QFETCH(std::string, where);
    QFETCH(double, area);
    QFETCH(int, holes);
    std::vector<Contour> contours;
    for (const Polygon &polygon : polygons)
        contours.push_back(Contour::fromPolygon(polygon).value());
    NewSection section;
    const std::vector<Contour> others(contours.begin() + 1, contours.end());
    section.shape = Shape::make(contours.front(), others).value();
    const Document spoilt = addSection(newDocument(), section).value();
    const auto loaded = io::readFff(io::writeFff(spoilt).value(), "a.fff");
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    QCOMPARE(loaded->warnings.size(), std::size_t(1));
    QVERIFY(loaded->warnings.front().code == code);
    QCOMPARE(loaded->warnings.front().place, "a.fff:$.shapes[0]." + where);
    const Shape &shape = *loaded->document.sections.front()->shape;
    QVERIFY(std::abs(shape.area() - area) < 1e-3);
    QCOMPARE(static_cast<int>(shape.holes().size()), holes);

    const auto again = io::readFff(io::writeFff(loaded->document).value());
    QVERIFY(again && again->warnings.empty());
    QVERIFY(again->document == loaded->document);
}

/// Contours that a fuzzer found: mending them once left something to mend.
void TestFffFormat::mendingComesToAnEnd_data()
{
    QTest::addColumn<std::vector<Vec2>>("points");
    QTest::newRow("a loop that crosses itself elsewhere once it is cut")
        << std::vector<Vec2>{{0, 0}, {0, 25.12}, {40, -20}, {40, 0}, {40, 25}, {0, 25}};
    QTest::newRow("a loop that is found to cross itself as it is")
        << std::vector<Vec2>{{0, 0}, {0, 25.12}, {40, -20}, {40, 0}, {36.2, 25}, {0, 25}};
}

void TestFffFormat::mendingComesToAnEnd()
{
    QFETCH(std::vector<Vec2>, points);
    NewSection section;
    section.shape = Shape::make(Contour::fromPoints(points).value()).value();
    const Document drawn = addSection(newDocument(), section).value();
    const auto mended = io::readFff(io::writeFff(drawn).value(), "a.fff");
    QVERIFY(mended);
    QCOMPARE(mended->warnings.size(), std::size_t(1));
    const auto again = io::readFff(io::writeFff(mended->document).value(), "a.fff");
    QVERIFY(again);
    QVERIFY2(again->warnings.empty(), "it was said once");
    QVERIFY(again->document == mended->document);
}

// Found by made-up files: its crossing is cut where it was cut, but it begins elsewhere each time.
void TestFffFormat::mendingOfHolesComesToAnEnd()
{
    const std::vector<Vec2> hole{{48, 25}, {48, 20.581722001353654}, {35.418277998646346, 17},
                                 {40, 17}, {35.581722001353654, 17}, {32, 20.581722001353654},
                                 {32, 25}, {32, 29.418277998646346}, {35.581722001353654, 33},
                                 {40, 33}, {44.418277998646346, 33}, {48, 29.418277998646346}};
    NewSection section;
    section.shape = Shape::make(Contour::fromPolygon({{0, 0}, {80, 0}, {80, 60}, {0, 60}}).value(),
                                {Contour::fromPoints(hole).value()})
                        .value();
    const Document drawn = addSection(newDocument(), section).value();
    const auto mended = io::readFff(io::writeFff(drawn).value(), "a.fff");
    QVERIFY(mended);
    const auto again = io::readFff(io::writeFff(mended->document).value(), "a.fff");
    QVERIFY(again);
    QVERIFY(again->document == mended->document);
}

void TestFffFormat::frames_data()
{
    QTest::addColumn<double>("error");
    QTest::addColumn<bool>("isKept");
    QTest::newRow("exact") << 0.0 << true;
    QTest::newRow("rounding of a double") << 1e-12 << true;
    QTest::newRow("six digits") << 5e-7 << false;
    QTest::newRow("just within rounding of files") << 0.9 * kFrameRounding << false;
}

void TestFffFormat::frames()
{
    QFETCH(double, error);
    QFETCH(bool, isKept);
    const Frame frame{{1, 2, 3}, {1, 0, error}, {0, 1 + error, 0}};
    const auto loaded = io::readFff(io::writeFff(withFrame(frame)).value(), "a.fff").value();
    const Frame &read = loaded.document.sections.front()->frame;
    QCOMPARE(read == frame, isKept);
    QVERIFY(std::abs(read.x.dot(read.y)) < 1e-15 + (isKept ? error : 0.0));
    QCOMPARE(loaded.warnings.empty(), isKept);
    if (!isKept) {
        QVERIFY(loaded.warnings.front().code == WarningCode::SkewFrame);
        QCOMPARE(loaded.warnings.front().place, std::string("a.fff:$.sections[0].frame"));
    }
}

void TestFffFormat::danglingOperationIsKept()
{
    Document document = twoSections();
    document.loads.front().section = SectionRef(OperationId{document.nextId++}, "branch/1/0");
    const auto loaded = io::readFff(io::writeFff(document).value());
    QVERIFY(loaded && loaded->document == document);
}

void TestFffFormat::unknownKeysArePassedOver()
{
    const auto loaded = io::readFff(edited("\"nextId\"", "\"madeBy\": {\"x\": [1]}, \"nextId\""));
    QVERIFY(loaded && loaded->document == twoSections());
}

void TestFffFormat::operationsAreNotLost()
{
    Document document = twoSections();
    Operation operation = newOperation(*operationKind("revolve"));
    operation.id = OperationId{document.nextId++};
    operation.name = "Plates";
    operation.isOn = false;
    // A section that was deleted is still spoken of.
    operation.inputs["section"] = {{SectionId{2}, "Body"}};
    operation.inputs["along"] = {{SectionId{1}, "Gone"}, {{OperationId{3}, "1/4"}, "Rib 4"}};
    operation.parameters["angle"] = 0.1 + 0.2;
    operation.parameters["ofAnotherVersion"] = std::string("kept");
    operation.exceptions["2"] = {Exception::State::Hidden, document.stocks[0]->id};
    operation.exceptions["-1/7"] = {Exception::State::Detached};
    document.operations.push_back(std::make_shared<const Operation>(operation));
    const auto loaded = io::readFff(io::writeFff(document).value());
    QVERIFY(loaded && loaded->document == document);
    QVERIFY(*loaded->document.operations[0] == operation);
}

void TestFffFormat::deepNestingIsAnError()
{
    for (const char bracket : {'[', '{'}) {
        std::string text = "{\"format\": \"FlatFitFab\", \"version\": 1, \"x\": ";
        for (int i = 0; i < 100000; ++i)
            text += bracket == '[' ? "[" : "{\"a\":";
        const auto loaded = io::readFff(text, "a.fff");
        QVERIFY(!loaded);
        QVERIFY(loaded.error().code == ErrorCode::BadSyntax);
        QCOMPARE(loaded.error().place, std::string("a.fff:1"));
    }
}

void TestFffFormat::truncationIsAnError()
{
    const std::string text = golden();
    const std::size_t end = text.find_last_of('}');
    for (std::size_t length = 0; length <= end; ++length) {
        const auto loaded = io::readFff(std::string_view(text).substr(0, length), "a.fff");
        QVERIFY2(!loaded, std::to_string(length).c_str());
        QVERIFY2(loaded.error().place.starts_with("a.fff:"), loaded.error().place.c_str());
    }
    QVERIFY(io::readFff(std::string_view(text).substr(0, end + 1)));
}

void TestFffFormat::flippedBytesNeverCrash()
{
    const unsigned seed = 11;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const std::string text = golden();
    int errors = 0;
    for (int i = 0; i < 5000; ++i) {
        std::string broken = text;
        for (int j = 0; j < 3; ++j)
            broken[random() % broken.size()] = "0123456789-+.eE[]{},:\"\n x\xFF"[random() % 25];
        const auto loaded = io::readFff(broken, "a.fff");
        if (!loaded) {
            ++errors;
            QVERIFY(!io::errorSentence(loaded.error()).isEmpty());
            continue;
        }
        // What is taken as a model can be written and read again.
        const std::string again = io::writeFff(loaded->document).value();
        QVERIFY(io::readFff(again).value().document == loaded->document);
    }
    QVERIFY(errors > 1000);
}

FFF_TEST(TestFffFormat)
#include "tst_fff_format.moc"
