#include "core/operations/grid.h"

#include "core/assembly/intervals.h"
#include "core/base/text.h"
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/offset.h"
#include "core/geometry/radial_contour.h"
#include "core/model/instance_key.h"
#include "core/operations/copying.h"
#include "core/operations/grid_cells.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

using Unit = ParameterSpec::Unit;

/// Left free round a cell on its sheet, as layouts do. mm.
constexpr double kSheetMargin = 6.0;
/// So much of a cell more than a whole number of them is rounding.
constexpr double kRoundedCells = 1e-9;
/// More cells than this nobody wants of one section.
constexpr int kMostCells = 400;

CellGrid gridOf(OperationContext &context, const Section &section)
{
    CellGrid grid;
    const Box2 &box = section.shape->bounds();
    const bool fitsSheet = context.isOn("fitSheet");
    grid.corner = box.min;
    grid.size = {context.number("cellWidth"), context.number("cellHeight")};
    if (fitsSheet) {
        const Vec2 sheet = context.stock(section.stock).sheet;
        grid.size = (sheet.array() - 2.0 * kSheetMargin).max(10.0);
    }
    const auto count = [&](int axis) {
        return std::clamp(
            static_cast<int>(std::ceil(box.size()[axis] / grid.size[axis] - kRoundedCells)), 1,
            kMostCells);
    };
    grid.columns = count(0);
    grid.rows = count(1);
    if (fitsSheet)
        grid.size = {box.size().x() / grid.columns, box.size().y() / grid.rows};
    return grid;
}

/// Places of `count` things in a stretch, each in the middle of its part.
std::vector<double> placesIn(const Seam &seam, int count)
{
    std::vector<double> places;
    for (int i = 0; i < count; ++i)
        places.push_back(seam.from + (i + 0.5) * seam.length() / count);
    return places;
}

Vec2 onSeam(const Seam &seam, double line, double place)
{
    return seam.axis == 0 ? Vec2(line, place) : Vec2(place, line);
}

std::string seamKey(const Seam &seam, int stretch)
{
    return keyBelow(keyBelow(keyBelow(seam.axis == 0 ? "x" : "y", seam.index), seam.row), stretch);
}

class GridMaker
{
public:
    GridMaker(OperationContext &context, const Section &section, const CellGrid &grid,
              GridCells cells)
        : m_context(context), m_section(section), m_grid(grid), m_cells(std::move(cells)),
          m_size(context.number("connectorSize")), m_clearance(context.number("clearance"))
    {
    }

    const GridCells &cells() const { return m_cells; }

    void addConnectors(int perEdge)
    {
        const double half = 0.5 * m_size;
        const std::optional<ShapePointer> shape = m_context.made(Shape::make(
            Contour::ofPolygon({{-half, -half}, {half, -half}, {half, half}, {-half, half}})));
        if (!shape)
            return;
        const ShapePointer shared = m_context.keptOfAny(*shape);
        const double thickness = m_context.stock(m_section.stock).thickness;
        for (const GridCell &one : m_cells.cells) {
            m_regions.push_back({one.outer.polygon(kCutChord), {}});
            for (const Contour &hole : one.holes)
                m_regions.back().holes.push_back(hole.polygon(kCutChord));
        }
        int stretch = 0;
        for (std::size_t i = 0; i < m_cells.seams.size(); ++i) {
            const Seam &seam = m_cells.seams[i];
            stretch = isSameRow(i) ? stretch + 1 : 0;
            // Between two slits there has to stay as much as is cut.
            const int room = static_cast<int>(seam.length() / (3.0 * thickness));
            int number = 0;
            for (const double place : placesIn(seam, std::min(perEdge, room))) {
                ++number;
                const Vec2 at = onSeam(seam, m_grid.line(seam.axis, seam.index), place);
                if (isHeld(seam, at))
                    addConnector(seam, at, keyBelow(seamKey(seam, stretch), number), shared);
            }
        }
    }

    /// A knob a stretch, of the one cell and out of the other.
    void addKnobs()
    {
        for (std::size_t i = 0; i < m_cells.seams.size(); ++i) {
            const Seam &seam = m_cells.seams[i];
            if (seam.length() < 2.0 * m_size)
                continue;
            const bool isUp = (seam.index + seam.row) % 2 == 0;
            const Vec2 at =
                onSeam(seam, m_grid.line(seam.axis, seam.index), 0.5 * (seam.from + seam.to));
            Vec2 way = Vec2::Zero();
            way[seam.axis] = isUp ? 1.0 : -1.0;
            GridCell &giver = cell(isUp ? seam.below : seam.above);
            GridCell &taker = cell(isUp ? seam.above : seam.below);
            const Contour knob = knobAt(at, way);
            if (holds(taker, at, way))
                fit(knob, giver, taker);
        }
    }

    /// Takes half of the clearance off both sides of every seam.
    void openSeams()
    {
        if (!(m_clearance > 0.0))
            return;
        std::vector<std::vector<Polygon>> cuts(m_cells.cells.size());
        for (const Seam &seam : m_cells.seams) {
            const double line = m_grid.line(seam.axis, seam.index), half = 0.5 * m_clearance;
            const Vec2 a = onSeam(seam, line - half, seam.from - half);
            const Vec2 b = onSeam(seam, line + half, seam.to + half);
            const Polygon band{{a.x(), a.y()}, {b.x(), a.y()}, {b.x(), b.y()}, {a.x(), b.y()}};
            for (const int side : {seam.below, seam.above})
                cuts[static_cast<std::size_t>(side)].push_back(band);
        }
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            GridCell &one = m_cells.cells[i];
            const auto left = m_context.made(subtract(one.outer, one.holes, cuts[i], kCutChord));
            if (!left || left->empty())
                continue;
            one.outer = left->front().outer;
            one.holes = left->front().holes;
        }
    }

    void addCells()
    {
        int number = 0;
        for (const GridCell &one : m_cells.cells) {
            const std::string key = keyOf(one);
            const std::optional<ShapePointer> shape =
                m_context.made(m_context.shape(key, one.outer, one.holes));
            if (!shape)
                continue;
            Section part = asCopy(m_section);
            part.name = copiedName(m_section.name, std::to_string(++number));
            part.shape = *shape;
            m_context.add(key, std::move(part));
        }
    }

private:
    GridCell &cell(int index) { return m_cells.cells[static_cast<std::size_t>(index)]; }

    static std::string keyOf(const GridCell &one)
    {
        std::string key = keyBelow(keyBelow("c", one.column), one.row);
        return one.part > 0 ? keyBelow(key, one.part) : key;
    }

    /// The seam goes on from the one before on the same stretch of the grid.
    bool isSameRow(std::size_t i) const
    {
        return i > 0 && m_cells.seams[i].axis == m_cells.seams[i - 1].axis &&
               m_cells.seams[i].index == m_cells.seams[i - 1].index &&
               m_cells.seams[i].row == m_cells.seams[i - 1].row;
    }

    /// Whether both cells have all of their half of a connector's length.
    bool isHeld(const Seam &seam, const Vec2 &at)
    {
        Vec2 way = Vec2::Zero();
        way[seam.axis] = 1.0;
        const PlaneLine line{at, way};
        const auto reaches = [&](int index, double from, double to) {
            const auto inside = intervalsOn(line, m_regions[static_cast<std::size_t>(index)]);
            return std::any_of(inside.begin(), inside.end(), [&](const Interval &interval) {
                return interval.from.at <= from + kEqualEnds && interval.to.at >= to - kEqualEnds;
            });
        };
        return reaches(seam.below, -0.5 * m_size, 0.0) && reaches(seam.above, 0.0, 0.5 * m_size);
    }

    void addConnector(const Seam &seam, const Vec2 &at, const std::string &key,
                      const ShapePointer &shape)
    {
        const Frame &frame = m_section.frame;
        Section connector = m_section;
        connector.name = copiedName(m_section.name, key);
        std::replace(connector.name.begin(), connector.name.end(), '/', '.');
        connector.shape = shape;
        connector.marks.clear();
        connector.copyOf.reset();
        connector.frame = {frame.toWorld(at), seam.axis == 0 ? frame.x : frame.y, frame.normal()};
        Vec2 half = Vec2::Zero();
        half[seam.axis] = 0.5 * m_size;
        connector.parent =
            Parent{SectionRef(m_context.operation().id, keyOf(cell(seam.below))), at - half, at};
        m_context.add(key, std::move(connector));
    }

    /// A neck and a round head, which holds: 60 % and 100 % of the size wide.
    Contour knobAt(const Vec2 &at, const Vec2 &way) const
    {
        const Vec2 side = perpendicular(way);
        const double r = 0.5 * m_size;
        const auto p = [&](double x, double y) { return Vec2(at + x * r * side + y * r * way); };
        // From below the seam, so that it is one with its cell.
        const Contour knob =
            Contour::ofSegments({CubicBezier::line(p(0.6, -0.2), p(0.6, 0.0)),
                                 {p(0.6, 0.0), p(0.5, 0.35), p(1.0, 0.6), p(1.0, 1.0)},
                                 {p(1.0, 1.0), p(1.0, 1.55), p(0.55, 1.9), p(0.0, 1.9)},
                                 {p(0.0, 1.9), p(-0.55, 1.9), p(-1.0, 1.55), p(-1.0, 1.0)},
                                 {p(-1.0, 1.0), p(-1.0, 0.6), p(-0.5, 0.35), p(-0.6, 0.0)},
                                 CubicBezier::line(p(-0.6, 0.0), p(-0.6, -0.2)),
                                 CubicBezier::line(p(-0.6, -0.2), p(0.6, -0.2))});
        return knob.signedArea() < 0.0 ? knob.reversed() : knob;
    }

    /// Whether the cell has the knob's place, and something round it.
    bool holds(const GridCell &taker, const Vec2 &at, const Vec2 &way) const
    {
        const Contour place = circleContour(at + 0.5 * m_size * way, 0.8 * m_size);
        const auto isWithin = [&](const Contour &head) {
            return nesting(taker.outer, head, kCutChord) == Nesting::SecondInside;
        };
        const Contour head = circleContour(at + 0.75 * m_size * way, 0.7 * m_size);
        const auto isApart = [&](const Contour &hole) {
            return nesting(hole, place, kCutChord) == Nesting::Apart;
        };
        return isWithin(head) && std::all_of(taker.holes.begin(), taker.holes.end(), isApart);
    }

    void fit(const Contour &knob, GridCell &giver, GridCell &taker)
    {
        std::vector<Contour> outline{giver.outer, knob};
        outline.insert(outline.end(), giver.holes.begin(), giver.holes.end());
        const auto with = m_context.made(windingRegions(outline, WindingRule::Positive, kCutChord));
        CurvedRegion room{knob, {}, {}};
        if (m_clearance > 0.0) {
            auto grown = m_context.made(grow(room, m_clearance));
            if (!grown)
                return;
            room = *std::move(grown);
        }
        const auto without =
            m_context.made(subtractContours(taker.outer, taker.holes, {room.outer}, kCutChord));
        if (!with || !without || with->empty() || without->empty())
            return;
        giver.outer = with->front().outer;
        giver.holes = with->front().holes;
        taker.outer = without->front().outer;
        taker.holes = without->front().holes;
    }

    OperationContext &m_context;
    const Section &m_section;
    CellGrid m_grid;
    GridCells m_cells;
    std::vector<Region> m_regions; // of the cells, while connectors are added
    double m_size, m_clearance;
};

void make(OperationContext &context)
{
    const SectionPointer section = context.input("section");
    if (!section)
        return;
    const CellGrid grid = gridOf(context, *section);
    if (grid.columns * grid.rows > kMostCells) {
        context.notice({.kind = OperationNotice::Kind::StoppedAtMost, .count = kMostCells});
        return;
    }
    std::optional<GridCells> cells =
        context.made(cutIntoCells(*section->shape, grid, context.number("sliver")));
    if (!cells)
        return;
    GridMaker maker(context, *section, grid, *std::move(cells));
    if (maker.cells().cells.size() < 2) { // it fits as it is
        context.notice({OperationNotice::Kind::NothingToDo});
        return;
    }
    context.change(section->ref(), nullptr);
    if (context.choice("edge") == "jigsaw") {
        maker.openSeams();
        maker.addKnobs();
    } else {
        maker.addConnectors(context.count("connectors"));
        maker.openSeams();
    }
    maker.addCells();
}

ParameterSpec cellSize(const char *key, const char *label)
{
    return {.key = key,
            .label = label,
            .unit = Unit::Length,
            .standard = 200.0,
            .least = 10.0,
            .most = 2000.0,
            .step = 1.0,
            .sliderLeast = 20.0,
            .sliderMost = 600.0,
            .countsIf = "fitSheet",
            .countsFor = {"false"}};
}

} // namespace

const OperationKind kGrid{
    .key = "grid",
    .version = 1,
    .name = QT_TRANSLATE_NOOP("Operation", "Grid"),
    .summary = QT_TRANSLATE_NOOP("Operation", "Divides a section that is too large into cells that "
                                              "hold together."),
    //: %1 is the name of a section: "Rib grid"
    .calls = [](const Operation &) { return QT_TRANSLATE_NOOP("Operation", "%1 grid"); },
    .inputs = {{.role = "section",
                .label = QT_TRANSLATE_NOOP("Operation", "Section"),
                .prompt = QT_TRANSLATE_NOOP("Operation", "Click the section to divide.")}},
    .parameters = {{.key = "fitSheet",
                    .label = QT_TRANSLATE_NOOP("Operation", "Fit my sheet"),
                    .unit = Unit::Switch,
                    .standard = 1.0,
                    .heading = QT_TRANSLATE_NOOP("Operation", "Cells")},
                   cellSize("cellWidth", QT_TRANSLATE_NOOP("Operation", "Cell width")),
                   cellSize("cellHeight", QT_TRANSLATE_NOOP("Operation", "Cell height")),
                   {.key = "edge",
                    .label = QT_TRANSLATE_NOOP("Operation", "Edge"),
                    .unit = Unit::Choice,
                    .choices = {{"straight",
                                 QT_TRANSLATE_NOOP("Operation", "Straight with connectors")},
                                {"jigsaw", QT_TRANSLATE_NOOP("Operation", "Jigsaw")}},
                    .heading = QT_TRANSLATE_NOOP("Operation", "Edges")},
                   {.key = "connectors",
                    .label = QT_TRANSLATE_NOOP("Operation", "Connectors per edge"),
                    .unit = Unit::Count,
                    .standard = 2,
                    .least = 1,
                    .most = 10,
                    .sliderLeast = 1,
                    .sliderMost = 10,
                    .countsIf = "edge",
                    .countsFor = {"straight"}},
                   {.key = "connectorSize",
                    .label = QT_TRANSLATE_NOOP("Operation", "Connector size"),
                    .unit = Unit::Length,
                    .standard = 20.0,
                    .least = 5.0,
                    .most = 200.0,
                    .step = 0.5,
                    .sliderLeast = 5.0,
                    .sliderMost = 60.0},
                   {.key = "clearance",
                    .label = QT_TRANSLATE_NOOP("Operation", "Clearance"),
                    .unit = Unit::Length,
                    .standard = 0.0,
                    .least = 0.0,
                    .most = 1.0,
                    .step = 0.01,
                    .sliderLeast = 0.0,
                    .sliderMost = 1.0},
                   {.key = "sliver",
                    .label = QT_TRANSLATE_NOOP("Operation", "Merge slivers below"),
                    .unit = Unit::Share,
                    .standard = 0.2,
                    .least = 0.0,
                    .most = 0.5,
                    .step = 0.01,
                    .sliderLeast = 0.0,
                    .sliderMost = 0.5}},
    .make = make};

} // namespace fff
