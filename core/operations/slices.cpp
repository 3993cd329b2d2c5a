#include "core/operations/slices.h"

#include "core/base/text.h"
#include "core/base/tolerances.h"
#include "core/geometry/polygon.h"
#include "core/operations/hollow_walls.h"
#include "core/operations/spine_planes.h"
#include "core/templates/template_cut.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>

namespace fff {

namespace {

using Unit = ParameterSpec::Unit;

constexpr int kMostPlanes = 500; // of one direction
/// As this version of the operation makes them, planes of a grid keep off the template's ends, and
/// what is thin all over is no section.
constexpr int kKeepsOffEnds = 2;
/// As this version makes them, a hollow section keeps a wall along each line in which another one
/// crosses it. Two rings that cross in two walls each can be put together by no way: one wall would
/// have to go through the other.
constexpr int kWallsAtCrossings = 3;
/// In a grid, the sections across go on beyond the outermost plane by that much at least, as times
/// the thickness of the sheet, counted from the middle of the slit: what is left beside the slit is
/// as wide as the sheet is thick. Where the template ends in a steep wall, less would be prongs.
constexpr double kLeastEnd = 1.5;
/// A piece that is nowhere wider than this, as times its sheet's thickness, is no section.
constexpr double kLeastWidth = 2.0;

/// Planes of one direction, in their order.
struct SlicePlanes
{
    char key = 'x';
    std::vector<Frame> frames = {};
    int first = 0; // number of the first of them
};

/// Across an axis of the world, upright as it is seen from there.
Frame frameAcross(int axis)
{
    switch (axis) {
    case 0:
        return {Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitY()};
    case 1:
        return {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()};
    default:
        return {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
    }
}

class Slicer
{
public:
    Slicer(OperationContext &context, const Template &subject)
        : m_context(context), m_subject(subject), m_bounds(worldBounds(subject, *subject.mesh)),
          m_thickness(context.stock(context.stockOfNew()).thickness)
    {
    }

    void slice();

private:
    /// mm, of a plane of a grid from the end of the template.
    double leastEnd() const;
    SlicePlanes across(char key, const Frame &base, double low, double high);
    SlicePlanes across(int axis);
    SlicePlanes like(const Section &section);
    SlicePlanes around(int axis) const;
    /// crossing: planes of sections that slide into these.
    void cut(const SlicePlanes &planes, const std::vector<Frame> &crossing = {});
    void cutAlong(const Section &spine);
    /// The piece of a plane that is this loop without those that are holes in it. False: too small.
    bool addPiece(char direction, int plane, int piece, const Frame &frame,
                  const std::vector<TemplateLoop> &loops, std::size_t outer);
    void add(const std::string &key, std::string name, const Frame &frame,
             const TemplateLoop &outer, const std::vector<const TemplateLoop *> &holes);
    void hollow(const Frame &frame, const Contour &contour, std::vector<Contour> &holes) const;
    bool isThin(const TemplateLoop &outer) const;

    OperationContext &m_context;
    const Template &m_subject;
    const Box3 m_bounds;
    const double m_thickness;      // of the sheet, mm
    std::vector<Frame> m_crossing; // those that slide into what is cut now
    int m_made = 0, m_slivers = 0, m_failed = 0;
    int m_atEnds = 0; // planes that are left out
};

double Slicer::leastEnd() const
{
    const bool isGrid = m_context.choice("direction").size() == 2;
    return isGrid && m_context.operation().version >= kKeepsOffEnds ? kLeastEnd * m_thickness : 0.0;
}

SlicePlanes Slicer::across(int axis)
{
    return across("xyz"[axis], frameAcross(axis), m_bounds.min[axis], m_bounds.max[axis]);
}

/// Parallel to its plane, its axes the same.
SlicePlanes Slicer::like(const Section &section)
{
    Frame base = section.frame;
    const Vec3 normal = base.normal();
    const Similarity placement = worldPlacement(m_subject, *m_subject.mesh);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3 &p : m_subject.mesh->mesh->positions()) {
        const double height = normal.dot(placement(p));
        low = std::min(low, height);
        high = std::max(high, height);
    }
    return across('s', base, low, high);
}

/// As many as asked for, or as fit; always evenly about the middle of the template. In a grid they
/// move together as far as they have to keep off its ends; one that is shifted there is left out.
/// low, high: along the normal, what the template reaches over.
SlicePlanes Slicer::across(char key, const Frame &base, double low, double high)
{
    const double size = high - low, end = leastEnd();
    const double room = std::max(size - 2.0 * end, 0.0);
    const Vec3 normal = base.normal(), centre = 0.5 * (m_bounds.min + m_bounds.max);
    const double middle = 0.5 * (low + high) - normal.dot(centre);
    const bool isByCount = m_context.choice("planesBy") == "count";
    const double spacing = m_context.number("spacing");
    int count = m_context.count("count");
    if (!isByCount) {
        count = std::clamp(static_cast<int>(std::ceil(size / spacing)), 1, kMostPlanes);
        if (end > 0.0)
            count = std::min(count, 1 + static_cast<int>(std::floor(room / spacing)));
    } else if (room <= 0.0 && count > 1) {
        m_atEnds += count - 1;
        count = 1;
    }
    const double even = count > 1 ? std::min(size / count, room / (count - 1)) : size;
    const double step = isByCount ? even : spacing;
    SlicePlanes planes{key, {}};
    for (int i = 0; i < count; ++i) {
        const double off = (i - 0.5 * (count - 1) + m_context.number("shift")) * step;
        const Frame frame{centre + (middle + off) * normal, base.x, base.y};
        if (end > 0.0 && count > 1 && std::abs(off) > 0.5 * room + kClipSlack) {
            ++m_atEnds;
            planes.first += planes.frames.empty() ? 1 : 0;
            continue;
        }
        planes.frames.push_back(frame);
    }
    return planes;
}

/// Through an axis in the middle, over half a turn.
SlicePlanes Slicer::around(int axis) const
{
    const int count = m_context.count("count");
    // Of the upright one x begins along X and turns to −Z; the others go round alike.
    const Vec3 y = Vec3::Unit(axis), x = Vec3::Unit((axis + 2) % 3), back = x.cross(y);
    SlicePlanes planes{'r', {}};
    for (int i = 0; i < count; ++i) {
        const double angle = std::numbers::pi * (i + m_context.number("shift")) / count;
        planes.frames.push_back(
            {0.5 * (m_bounds.min + m_bounds.max), std::cos(angle) * x - std::sin(angle) * back, y});
    }
    return planes;
}

void Slicer::hollow(const Frame &frame, const Contour &contour, std::vector<Contour> &holes) const
{
    HollowOptions options;
    options.wall = m_context.number("wall");
    options.smallest = m_context.number("smallest");
    options.thickness = m_thickness;
    if (m_context.operation().version >= kWallsAtCrossings)
        options.crossing = m_crossing;
    for (Contour &hole : hollowOf(frame, contour, holes, options))
        holes.push_back(std::move(hole));
}

void Slicer::add(const std::string &key, std::string name, const Frame &frame,
                 const TemplateLoop &outer, const std::vector<const TemplateLoop *> &inner)
{
    const Result<Contour> contour = curveOf(outer);
    std::vector<Contour> holes;
    for (const TemplateLoop *loop : inner)
        if (Result<Contour> hole = curveOf(*loop))
            holes.push_back(*std::move(hole));
    if (contour && m_context.isOn("hollow"))
        hollow(frame, *contour, holes);
    Result<ShapePointer> shape = contour ? m_context.shape(key, *contour, std::move(holes))
                                         : Result<ShapePointer>(tl::unexpected(contour.error()));
    if (!shape) {
        ++m_failed;
        return;
    }
    Section section;
    section.name = std::move(name);
    section.shape = *std::move(shape);
    section.frame = frame;
    section.stock = m_context.stockOfNew();
    m_context.add(key, std::move(section));
    ++m_made;
}

/// Whether a circle as wide as a section has to be finds no room in it.
bool Slicer::isThin(const TemplateLoop &outer) const
{
    if (m_context.operation().version < kKeepsOffEnds)
        return false;
    const double radius = 0.5 * kLeastWidth * m_thickness;
    Box2 box;
    for (const Vec2 &p : outer.points)
        box.extend(p);
    if (box.size().minCoeff() < 2.0 * radius)
        return true;
    double length = 0.0;
    for (std::size_t i = 0; i < outer.points.size(); ++i)
        length += (outer.points[(i + 1) % outer.points.size()] - outer.points[i]).norm();
    // In any contour a circle of its area by its length has room.
    if (std::abs(signedArea(outer.points)) >= radius * length)
        return false;
    const Result<Contour> contour = curveOf(outer);
    return contour && roomIn(*contour, radius).empty();
}

bool Slicer::addPiece(char direction, int plane, int piece, const Frame &frame,
                      const std::vector<TemplateLoop> &loops, std::size_t outer)
{
    std::vector<const TemplateLoop *> holes;
    double area = std::abs(signedArea(loops[outer].points));
    for (const TemplateLoop &hole : loops)
        if (hole.isHole && hole.around == static_cast<int>(outer)) {
            holes.push_back(&hole);
            area -= std::abs(signedArea(hole.points));
        }
    if (area < m_context.number("smallest") || isThin(loops[outer])) {
        ++m_slivers;
        return false;
    }
    std::string key(1, direction);
    key.append("/").append(std::to_string(plane)).append("/").append(std::to_string(piece));
    std::string name = m_subject.name + " ";
    name += static_cast<char>(std::toupper(direction));
    name += std::to_string(plane + 1);
    if (piece > 0)
        name.append(" ").append(std::to_string(piece + 1));
    add(key, std::move(name), frame, loops[outer], holes);
    return true;
}

void Slicer::cut(const SlicePlanes &planes, const std::vector<Frame> &crossing)
{
    m_crossing = crossing;
    for (std::size_t i = 0; i < planes.frames.size(); ++i) {
        const std::vector<TemplateLoop> loops =
            loopsOn(planes.frames[i], m_subject, *m_subject.mesh);
        int piece = 0;
        for (std::size_t k = 0; k < loops.size(); ++k)
            if (!loops[k].isHole && addPiece(planes.key, planes.first + static_cast<int>(i), piece,
                                             planes.frames[i], loops, k))
                ++piece;
    }
}

void Slicer::cutAlong(const Section &spine)
{
    SpineRequest request;
    request.from = m_context.number("from");
    request.to = m_context.number("to");
    request.isByCount = m_context.choice("planesBy") == "count";
    request.count = m_context.count("count");
    request.spacing = m_context.number("spacing");
    request.shift = m_context.number("shift");
    request.most = kMostPlanes;
    const SpinePlanes planes(spine, request);
    for (const SpinePlane &plane : planes.planes()) {
        const std::vector<TemplateLoop> loops = loopsOn(plane.frame, m_subject, *m_subject.mesh);
        if (const std::optional<std::size_t> outer = planes.loopAt(plane, loops))
            addPiece('c', plane.number, 0, plane.frame, loops, *outer);
    }
}

void Slicer::slice()
{
    const std::string direction = m_context.choice("direction");
    if (direction == "curve" || direction == "section") {
        const std::string_view role = direction == "curve" ? "spine" : "like";
        const SectionPointer input = m_context.input(role);
        if (!input) {
            if (countOf(m_context.operation(), *kSlices.input(role)) == 0)
                m_context.notice({OperationNotice::Kind::InputMissing, std::string(role)});
            return;
        }
        if (direction == "curve")
            cutAlong(*input);
        else
            cut(like(*input));
    } else if (direction.starts_with("radial")) {
        const SlicePlanes planes = around(direction == "radialX"   ? 0
                                          : direction == "radialZ" ? 2
                                                                   : 1);
        cut(planes, planes.frames);
    } else if (direction.size() == 2) {
        const SlicePlanes first = across(direction[0] - 'x'), second = across(direction[1] - 'x');
        cut(first, second.frames);
        cut(second, first.frames);
    } else {
        cut(across(direction[0] - 'x'));
    }
    if (m_slivers > 0)
        m_context.notice({OperationNotice::Kind::Slivers, {}, {}, m_slivers});
    if (m_atEnds > 0)
        m_context.notice({OperationNotice::Kind::LeftOut, {}, {}, m_atEnds});
    if (m_failed > 0)
        m_context.notice({OperationNotice::Kind::Failed});
    if (m_made == 0 && m_failed == 0)
        m_context.notice({OperationNotice::Kind::NothingFits});
}

void make(OperationContext &context)
{
    const TemplatePointer subject = context.subject();
    if (!subject || !subject->mesh) {
        context.notice({OperationNotice::Kind::NoTemplate});
        return;
    }
    Slicer(context, *subject).slice();
}

std::vector<ParameterSpec> parameters()
{
    return {
        {.key = "direction",
         .label = QT_TRANSLATE_NOOP("Operation", "Planes"),
         .unit = Unit::Choice,
         .standard = 4,
         .choices = {{"x", QT_TRANSLATE_NOOP("Operation", "across X")},
                     {"y", QT_TRANSLATE_NOOP("Operation", "across Y")},
                     {"z", QT_TRANSLATE_NOOP("Operation", "across Z")},
                     {"xy", QT_TRANSLATE_NOOP("Operation", "across X and Y")},
                     {"xz", QT_TRANSLATE_NOOP("Operation", "across X and Z")},
                     {"yz", QT_TRANSLATE_NOOP("Operation", "across Y and Z")},
                     {"section", QT_TRANSLATE_NOOP("Operation", "like a section")},
                     {"radial", QT_TRANSLATE_NOOP("Operation", "around Y")},
                     {"radialX", QT_TRANSLATE_NOOP("Operation", "around X")},
                     {"radialZ", QT_TRANSLATE_NOOP("Operation", "around Z")},
                     {"curve", QT_TRANSLATE_NOOP("Operation", "along a curve")}},
         .heading = QT_TRANSLATE_NOOP("Operation", "Slices")},
        {.key = "planesBy",
         .label = QT_TRANSLATE_NOOP("Operation", "By"),
         .unit = Unit::Choice,
         .choices = {{"count", QT_TRANSLATE_NOOP("Operation", "Count")},
                     {"spacing", QT_TRANSLATE_NOOP("Operation", "Spacing")}},
         .countsIf = "direction",
         .countsFor = {"x", "y", "z", "xy", "xz", "yz", "section", "curve"}},
        {.key = "count",
         .label = QT_TRANSLATE_NOOP("Operation", "Count"),
         .unit = Unit::Count,
         .standard = 6,
         .least = 1,
         .most = kMostPlanes,
         .sliderLeast = 1,
         .sliderMost = 30,
         .tip = QT_TRANSLATE_NOOP("Operation", "In each direction")},
        {.key = "spacing",
         .label = QT_TRANSLATE_NOOP("Operation", "Spacing"),
         .unit = Unit::Length,
         .standard = 25.0,
         .least = 0.5,
         .most = 2000.0,
         .step = 0.5,
         .sliderLeast = 2.0,
         .sliderMost = 100.0,
         .countsIf = "planesBy",
         .countsFor = {"spacing"}},
        {.key = "shift",
         .label = QT_TRANSLATE_NOOP("Operation", "Shift"),
         .unit = Unit::Share,
         .standard = 0.0,
         .least = -0.5,
         .most = 0.5,
         .step = 0.01,
         .sliderLeast = -0.5,
         .sliderMost = 0.5,
         .tip = QT_TRANSLATE_NOOP("Operation", "Of all planes, as a part of their spacing")},
        {.key = "from",
         .label = QT_TRANSLATE_NOOP("Operation", "From"),
         .unit = Unit::Share,
         .standard = 0.0,
         .least = 0.0,
         .most = 1.0,
         .step = 0.005,
         .sliderLeast = 0.0,
         .sliderMost = 1.0,
         .countsIf = "direction",
         .countsFor = {"curve"}},
        {.key = "to",
         .label = QT_TRANSLATE_NOOP("Operation", "To"),
         .unit = Unit::Share,
         .standard = 1.0,
         .least = 0.0,
         .most = 1.0,
         .step = 0.005,
         .sliderLeast = 0.0,
         .sliderMost = 1.0,
         .countsIf = "direction",
         .countsFor = {"curve"}},
        {.key = "smallest",
         .label = QT_TRANSLATE_NOOP("Operation", "Smallest piece"),
         .unit = Unit::Number,
         .standard = 25,
         .least = 0,
         .most = 100000,
         .sliderLeast = 0,
         .sliderMost = 500,
         .tip = QT_TRANSLATE_NOOP("Operation", "In mm²; smaller ones are left out, and those "
                                               "that are thin all over")},
        {.key = "hollow",
         .label = QT_TRANSLATE_NOOP("Operation", "Hollow"),
         .unit = Unit::Switch,
         .tip = QT_TRANSLATE_NOOP("Operation", "Only a wall along the contour is left")},
        {.key = "wall",
         .label = QT_TRANSLATE_NOOP("Operation", "Wall"),
         .unit = Unit::Length,
         .standard = 12.0,
         .least = 0.5,
         .most = 500.0,
         .step = 0.5,
         .sliderLeast = 2.0,
         .sliderMost = 50.0,
         .countsIf = "hollow",
         .countsFor = {"true"}},
    };
}

} // namespace

const OperationKind kSlices{
    .key = "slices",
    .version = kWallsAtCrossings,
    .name = QT_TRANSLATE_NOOP("Operation", "Slices"),
    .summary = QT_TRANSLATE_NOOP("Operation", "Cuts a mesh into sections that follow its form."),
    .inputs = {{.role = "spine",
                .label = QT_TRANSLATE_NOOP("Operation", "Along"),
                .prompt = QT_TRANSLATE_NOOP("Operation",
                                            "Click the section whose contour it should run along."),
                .least = 0,
                .countsIf = "direction",
                .countsFor = {"curve"}},
               {.role = "like",
                .label = QT_TRANSLATE_NOOP("Operation", "Like"),
                .prompt = QT_TRANSLATE_NOOP("Operation",
                                            "Click the section that they should be parallel to."),
                .least = 0,
                .countsIf = "direction",
                .countsFor = {"section"}}},
    .parameters = parameters(),
    .make = make,
    .isOfTemplate = true};

} // namespace fff
