#include "core/assembly/assembly.h"
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/operations/baking.h"
#include "tests/core/analysed.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

Model divided(const ShapePointer &shape, std::map<std::string, ParameterValue> values)
{
    Document document = newDocument();
    const SectionId panel = add(document, "Panel", shape, frontFrame());
    add(document, operation("grid", {{"section", {panel}}}, std::move(values)));
    return evaluate(document);
}

bool isCell(const Section &section)
{
    return section.made.key.starts_with("c/");
}

double cellArea(const Model &model)
{
    double area = 0.0;
    for (const SectionPointer &section : model.sections())
        if (isCell(*section))
            area += section->shape->area();
    return area;
}

} // namespace

class TestGrid : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cellsCoverTheSection_data();
    void cellsCoverTheSection();
    void connectorsFitTheirCells();
    void sliversGoToNeighbours();
    void fitsTheSheet();
    void jigsawCovers();
    void clearanceOpensSeams();
    void smallSectionsStay();
    void bakedItStays();
};

void TestGrid::cellsCoverTheSection_data()
{
    QTest::addColumn<int>("index");
    const auto all = simpleContours();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (std::abs(all[i].contour.signedArea()) > 50.0)
            QTest::newRow(all[i].name) << static_cast<int>(i);
}

// Wrong: material would be missing, or be there twice.
void TestGrid::cellsCoverTheSection()
{
    QFETCH(int, index);
    const auto shape = shapeOf(simpleContours()[static_cast<std::size_t>(index)].contour);
    for (const double sliver : {0.0, 0.2, 0.5}) {
        const Model model = divided(shape, {{"fitSheet", false},
                                            {"cellWidth", 13.0},
                                            {"cellHeight", 17.0},
                                            {"sliver", sliver},
                                            {"connectorSize", 5.0}});
        if (!model.evaluation.listing)
            continue; // not divided
        // Unions are made on a grid of 1 nm, and dust is left out.
        const double rounding = 1e-6 * (1.0 + shape->bounds().size().sum()) +
                                kMinArea * static_cast<double>(model.sectionCount());
        QVERIFY2(std::abs(cellArea(model) - shape->area()) < rounding,
                 qPrintable(QString::number(cellArea(model) - shape->area())));
    }
}

// Wrong: connectors would fall out, or cells would not go onto them.
void TestGrid::connectorsFitTheirCells()
{
    const Model model = divided(shapeOf(circle({0, 0}, 150)),
                                {{"fitSheet", false}, {"cellWidth", 110.0}, {"cellHeight", 110.0}});
    const Assembly assembly = assemble(model);
    int connectors = 0;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        if (isCell(*model.section(i)))
            continue;
        ++connectors;
        // An H: a slit from either side, each as wide as the panel is thick, half of its half deep.
        const std::vector<Slit> &slits = assembly.slits[i];
        QCOMPARE(slits.size(), 2U);
        QVERIFY(isCell(*model.section(static_cast<std::size_t>(slits[0].guest))));
        QVERIFY(slits[0].guest != slits[1].guest);
        for (const Slit &slit : slits) {
            QVERIFY(slit.isOpen);
            QVERIFY(std::abs(slit.width - 3.0) < 1e-9);
            QVERIFY(std::abs((slit.inner).norm() - 5.0) < 1e-3);
            // The cell's own slit meets it.
            bool isMet = false;
            for (const Slit &other : assembly.slits[static_cast<std::size_t>(slit.guest)])
                isMet = isMet || (other.guest == static_cast<int>(i) && other.isOpen &&
                                  (model.section(static_cast<std::size_t>(slit.guest))
                                       ->frame.toWorld(other.inner) -
                                   model.section(i)->frame.toWorld(slit.inner))
                                          .norm() < 1e-6);
            QVERIFY(isMet);
        }
    }
    QVERIFY(connectors >= 12);
    QCOMPARE(heldGroups(analysed(model)).size(), 1U);
}

// Wrong: strips a millimetre wide would be cut.
void TestGrid::sliversGoToNeighbours()
{
    const auto shape = shapeOf(polygonContour(rectangleAt(0, 0, 203, 100)));
    const Model merged =
        divided(shape, {{"fitSheet", false}, {"cellWidth", 100.0}, {"cellHeight", 100.0}});
    const Model all = divided(
        shape, {{"fitSheet", false}, {"cellWidth", 100.0}, {"cellHeight", 100.0}, {"sliver", 0.0}});
    const auto cells = [](const Model &model) {
        return std::count_if(model.sections().begin(), model.sections().end(),
                             [](const SectionPointer &s) { return isCell(*s); });
    };
    QCOMPARE(cells(merged), 2);
    QCOMPARE(cells(all), 3);
    const Section *wide = merged.find({merged.document.operations[0]->id, "c/1/0"});
    QVERIFY(wide);
    QVERIFY(std::abs(wide->shape->bounds().size().x() - 103.0) < 1e-6);
    QCOMPARE(wide->shape->contour().segmentCount(), 4); // no seam is left in its edges
}

// Wrong: cells that are still too large for the sheet.
void TestGrid::fitsTheSheet()
{
    const Model model = divided(shapeOf(polygonContour(rectangleAt(0, 0, 1300, 500))), {});
    const Vec2 sheet = model.document.stocks[0]->sheet;
    QVERIFY(model.sectionCount() > 4);
    for (const SectionPointer &section : model.sections())
        QVERIFY((section->shape->bounds().size().array() < sheet.array()).all());
    // Another sheet, other cells.
    Stock small = *model.document.stocks[0];
    small.sheet = {300, 200};
    const Model more = evaluate(setStock(model.document, small).value(), model);
    QVERIFY(more.sectionCount() > model.sectionCount());
}

// Wrong: knobs would be added without being taken away.
void TestGrid::jigsawCovers()
{
    const auto shape = shapeOf(polygonContour(rectangleAt(0, 0, 300, 200)), {circle({75, 40}, 20)});
    const Model model = divided(shape, {{"fitSheet", false},
                                        {"cellWidth", 100.0},
                                        {"cellHeight", 100.0},
                                        {"edge", std::string("jigsaw")}});
    QCOMPARE(model.sectionCount(), 6U);
    QVERIFY2(std::abs(cellArea(model) - shape->area()) < 0.5,
             qPrintable(QString::number(cellArea(model) - shape->area())));
    int knobs = 0;
    for (const SectionPointer &section : model.sections()) {
        const Vec2 size = section->shape->bounds().size();
        knobs += (size.x() > 105.0) + (size.y() > 105.0);
        QVERIFY(section->shape->isPlain());
    }
    QVERIFY(knobs >= 4);
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const auto both = *windingRegions(
                {model.section(i)->shape->contour(), model.section(j)->shape->contour()},
                WindingRule::NonZero, 0.01);
            double area = 0.0;
            for (const CurvedRegion &region : both)
                area += region.outer.signedArea();
            // What both enclose is no more than rounding.
            const double sum = model.section(i)->shape->contour().signedArea() +
                               model.section(j)->shape->contour().signedArea();
            QVERIFY2(sum - area < 0.2, qPrintable(QString::number(sum - area)));
        }
}

// Wrong: sawn edges would be too tight.
void TestGrid::clearanceOpensSeams()
{
    const auto shape = shapeOf(polygonContour(rectangleAt(0, 0, 200, 100)));
    for (const char *edge : {"straight", "jigsaw"}) {
        const Model model = divided(shape, {{"fitSheet", false},
                                            {"cellWidth", 100.0},
                                            {"cellHeight", 100.0},
                                            {"edge", std::string(edge)},
                                            {"clearance", 0.4}});
        const double missing = shape->area() - cellArea(model);
        QVERIFY2(missing > 39.9 && missing < 80.0, qPrintable(QString::number(missing)));
    }
}

// Wrong: what fits would be copied for nothing.
void TestGrid::smallSectionsStay()
{
    const Model model = divided(shapeOf(circle({0, 0}, 50)), {});
    QVERIFY(!model.evaluation.listing);
    QCOMPARE(model.sectionCount(), 1U);
}

// Wrong: the panel would come back beside its cells, or a file would name a parent that is gone.
void TestGrid::bakedItStays()
{
    Document document = newDocument();
    const SectionId panel =
        add(document, "Panel", shapeOf(polygonContour(rectangleAt(0, 0, 400, 100))), frontFrame());
    add(document, "Foot", shapeOf(circle({0, 0}, 20)), sideFrame({50, 0, 0}),
        Parent{SectionRef(panel), {50, 0}, {50, 9}});
    add(document, operation("grid", {{"section", {panel}}}, {{"fitSheet", false}}));
    const Model model = evaluate(document);
    QVERIFY(!model.find(SectionRef(panel)));
    const Document next = baked(model, document.operations[0]->id).value();
    QCOMPARE(next.sections.size(), model.sectionCount());
    QVERIFY(!next.find(panel));
    QVERIFY(!next.sections[0]->parent);
}

FFF_TEST(TestGrid)
#include "tst_grid.moc"
