#include "core/operations/blend.h"

#include "core/base/easing.h"
#include "core/base/text.h"
#include "core/geometry/arc_length.h"
#include "core/geometry/contour_blend.h"
#include "core/model/instance_key.h"
#include "core/model/mended_shape.h"
#include "core/operations/copying.h"
#include "core/operations/root_edge.h"

#include <algorithm>

namespace fff {

namespace {

using Unit = ParameterSpec::Unit;

/// A section as it stands on the root's boundary.
struct Station
{
    SectionPointer section;
    SourceCrossing source;
    RootEdge edge;
    Frame frame;                 // origin on the boundary, y outwards along the axis
    Eigen::Quaterniond relative; // of the frame's axes to tangent, inwards and the root's normal
    Contour contour;             // in the frame's coordinates
    std::vector<Contour> holes;
};

/// Tangent, its left and the normal of the root, in the world.
Eigen::Matrix3d boundaryAxes(const Frame &root, const Vec2 &tangent)
{
    Eigen::Matrix3d axes;
    axes << root.directionToWorld(tangent), root.directionToWorld(perpendicular(tangent)),
        root.normal();
    return axes;
}

Contour inFrame(const Contour &contour, const Frame &from, const Frame &to)
{
    std::vector<Vec2> points;
    points.reserve(contour.points().size());
    for (const Vec2 &p : contour.points())
        points.push_back(to.toLocal(from.toWorld(p)));
    return Contour::ofPoints(std::move(points));
}

Station stationOf(const Section &root, const SectionPointer &section, const SourceCrossing &source,
                  bool isHigh)
{
    Station station{section, source, edgeOf(root, source, isHigh), {}, {}, {}, {}};
    const Vec3 normal = section->frame.normal(),
               outwards = root.frame.directionToWorld(station.edge.outwards);
    // Both planes contain the axis, so this is square to it.
    const Vec3 across = root.frame.normal() - root.frame.normal().dot(normal) * normal;
    station.frame = {root.frame.toWorld(station.edge.point), across.normalized(), outwards};
    Eigen::Matrix3d axes;
    axes << station.frame.x, station.frame.y, station.frame.normal();
    station.relative =
        Eigen::Quaterniond(boundaryAxes(root.frame, station.edge.tangent).transpose() * axes);
    station.contour = inFrame(section->shape->contour(), section->frame, station.frame);
    for (const Contour &hole : section->shape->holes())
        station.holes.push_back(inFrame(hole, section->frame, station.frame));
    return station;
}

/// All sections on one boundary of the root; empty when one does not meet it, or stands elsewhere.
std::vector<Station> stationsOf(const Section &root, const std::vector<SectionPointer> &sections)
{
    std::vector<Station> stations;
    for (const SectionPointer &section : sections) {
        const std::optional<SourceCrossing> source = sourceCrossing(root, *section);
        if (!source || !source->isMeeting)
            return {};
        const bool isHigh = leavesHigh(*source);
        stations.push_back(stationOf(root, section, *source, isHigh));
        if (stations.back().edge.ring != stations.front().edge.ring)
            stations.back() = stationOf(root, section, *source, !isHigh);
        if (stations.back().edge.ring != stations.front().edge.ring)
            return {};
    }
    return stations;
}

double centredSignedArea(const Contour &contour, Vec2 &centre)
{
    const Moments all = moments(contour);
    centre = all.centroid();
    return all.area;
}

/// What turns one station into another.
class StationBlend
{
public:
    StationBlend(const OperationContext &context, const Station &from, const Station &to)
        : m_isAutomatic(context.choice("match") == "automatic"),
          m_isReversed(context.isOn("reverse")), m_contour(blended(from.contour, to.contour))
    {
        if (from.holes.size() != to.holes.size())
            return;
        std::vector<Contour> left = to.holes;
        for (const Contour &hole : from.holes) {
            Vec2 centre, other;
            centredSignedArea(hole, centre);
            const auto distance = [&](const Contour &contour) {
                centredSignedArea(contour, other);
                return (other - centre).norm();
            };
            const auto nearest =
                std::min_element(left.begin(), left.end(), [&](const Contour &a, const Contour &b) {
                    return distance(a) < distance(b);
                });
            m_holes.push_back(blended(hole, *nearest));
            left.erase(nearest);
        }
    }

    Result<ShapePointer> at(double share) const
    {
        std::vector<PlacedContour> holes;
        for (const ContourBlend &hole : m_holes)
            holes.push_back({hole.at(share), {}});
        std::vector<Warning> mended; // between two contours anything may be
        return makeMendedShape({m_contour.at(share), {}}, holes, {}, mended);
    }

private:
    ContourBlend blended(const Contour &from, const Contour &to) const
    {
        Correspondence way;
        if (m_isAutomatic)
            way = bestCorrespondence(from, to);
        else
            way.isReversed = (from.signedArea() > 0.0) != (to.signedArea() > 0.0);
        way.isReversed = way.isReversed != m_isReversed;
        return {from, to, way};
    }

    bool m_isAutomatic, m_isReversed;
    ContourBlend m_contour;
    std::vector<ContourBlend> m_holes;
};

class BlendMaker
{
public:
    BlendMaker(OperationContext &context, const Section &root, int ring)
        : m_context(context), m_root(root), m_boundary(boundaryOf(root, ring)),
          m_isEased(context.choice("easing") == "slow"), m_count(context.count("count"))
    {
    }

    /// Between two stations. How many could not be made.
    int make(const Station &from, const Station &to, int gap)
    {
        const StationBlend blend(m_context, from, to);
        const double start = m_boundary.of(from.edge.at);
        const double half = 0.5 * m_boundary.total();
        double way = m_boundary.of(to.edge.at) - start;
        way += way > half ? -2.0 * half : way < -half ? 2.0 * half : 0.0;
        int leftOut = 0;
        for (int i = 1; i <= m_count; ++i) {
            const double even = static_cast<double>(i) / (m_count + 1);
            const double share = m_isEased ? easeInOutCubic(even) : even;
            const std::optional<ShapePointer> shape = m_context.made(blend.at(share));
            const std::string key = keyBelow(std::to_string(gap), i);
            if (!shape) {
                ++leftOut;
                continue;
            }
            add(from, to, {key, std::to_string(i), start + share * way, share}, *shape);
        }
        return leftOut;
    }

private:
    struct Between
    {
        std::string key, number;
        double length; // along the boundary
        double share;
    };

    void add(const Station &from, const Station &to, const Between &between,
             const ShapePointer &shape)
    {
        const CurvePoint at = m_boundary.at(between.length);
        const Contour &contour = m_boundary.contour();
        const Vec2 point = positionAt(contour, at);
        const Eigen::Matrix3d axes =
            boundaryAxes(m_root.frame, directionAt(contour, at)) *
            from.relative.slerp(between.share, to.relative).toRotationMatrix();
        Section section = *from.section;
        section.name = copiedName(from.section->name, between.number);
        section.shape = m_context.kept(between.key, shape);
        section.marks.clear(); // there is nothing half way between two drawings
        section.copyOf.reset();
        section.frame = {m_root.frame.toWorld(point), axes.col(0), axes.col(1)};
        const double depth =
            (1.0 - between.share) * from.source.depth() + between.share * to.source.depth();
        const Vec2 outwards = m_root.frame.directionToLocal(axes.col(1));
        section.parent = Parent{m_root.ref(), point - depth * outwards, point};
        m_context.add(between.key, std::move(section));
    }

    OperationContext &m_context;
    const Section &m_root;
    ArcLength m_boundary;
    bool m_isEased;
    int m_count;
};

void make(OperationContext &context)
{
    const std::vector<SectionPointer> sections = context.inputs("sections");
    const SectionPointer root = context.input("along");
    if (sections.size() < 2 || !root)
        return;
    const std::vector<Station> stations = stationsOf(*root, sections);
    if (stations.empty()) {
        context.notice({OperationNotice::Kind::InputsApart});
        return;
    }
    BlendMaker maker(context, *root, stations.front().edge.ring);
    int leftOut = 0;
    for (std::size_t i = 0; i + 1 < stations.size(); ++i)
        leftOut += maker.make(stations[i], stations[i + 1], static_cast<int>(i));
    if (leftOut > 0)
        context.notice({.kind = OperationNotice::Kind::LeftOut, .count = leftOut});
}

} // namespace

const OperationKind kBlend{
    .key = "blend",
    .version = 1,
    .name = QT_TRANSLATE_NOOP("Operation", "Blend"),
    .summary = QT_TRANSLATE_NOOP("Operation", "Interpolates between sections."),
    //: %1 is the name of a section: "Rib blend"
    .calls = [](const Operation &) { return QT_TRANSLATE_NOOP("Operation", "%1 blend"); },
    .inputs = {{.role = "sections",
                .label = QT_TRANSLATE_NOOP("Operation", "Sections"),
                .prompt = QT_TRANSLATE_NOOP("Operation", "Click the sections to blend, in order."),
                .least = 2,
                .most = 50},
               {.role = "along",
                .label = QT_TRANSLATE_NOOP("Operation", "Along"),
                .prompt =
                    QT_TRANSLATE_NOOP("Operation", "Click the section it should run along.")}},
    .parameters = {{.key = "count",
                    .label = QT_TRANSLATE_NOOP("Operation", "Count per gap"),
                    .unit = Unit::Count,
                    .standard = 6,
                    .least = 1,
                    .most = 200,
                    .sliderLeast = 1,
                    .sliderMost = 30,
                    .heading = QT_TRANSLATE_NOOP("Operation", "Placing")},
                   {.key = "easing",
                    .label = QT_TRANSLATE_NOOP("Operation", "Easing"),
                    .unit = Unit::Choice,
                    .choices = {{"even", QT_TRANSLATE_NOOP("Operation", "Even")},
                                {"slow", QT_TRANSLATE_NOOP("Operation", "Slow ends")}}},
                   {.key = "match",
                    .label = QT_TRANSLATE_NOOP("Operation", "Match"),
                    .unit = Unit::Choice,
                    .choices = {{"automatic", QT_TRANSLATE_NOOP("Operation", "Automatic")},
                                {"drawn", QT_TRANSLATE_NOOP("Operation", "As drawn")}}},
                   {.key = "reverse",
                    .label = QT_TRANSLATE_NOOP("Operation", "Reverse"),
                    .unit = Unit::Switch}},
    .make = make};

} // namespace fff
