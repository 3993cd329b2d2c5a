#include "core/operations/revolve.h"

#include "core/base/text.h"
#include "core/geometry/arc_length.h"
#include "core/model/instance_key.h"
#include "core/operations/copying.h"
#include "core/operations/repeat_parameters.h"
#include "core/operations/root_edge.h"

#include <algorithm>
#include <numbers>

namespace fff {

namespace {

using Unit = ParameterSpec::Unit;

/// Where the section leaves the root, and the boundary from there on.
struct Edge : RootEdge
{
    Edge(const RootEdge &edge, const Section &root)
        : RootEdge(edge), boundary(boundaryOf(root, edge.ring)), source(boundary.of(edge.at))
    {
    }
    ArcLength boundary;
    double source; // length along it where the section leaves

    double length() const { return boundary.total(); }
};

/// A motion of the root's plane: p → matrix (p − from) + to.
struct PlaneMotion
{
    Eigen::Matrix2d matrix;
    Vec2 from, to;

    Vec2 operator()(const Vec2 &p) const { return matrix * (p - from) + to; }
};

/// The same of space, which keeps the root's normal.
Similarity inSpace(const Frame &root, const PlaneMotion &motion)
{
    Eigen::Matrix3d axes;
    axes << root.x, root.y, root.normal();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() = motion.matrix;
    Similarity placement;
    placement.turn = axes * turn * axes.transpose();
    placement.shift = root.toWorld(motion.to) - placement.turn * root.toWorld(motion.from);
    return placement;
}

Eigen::Matrix2d turnBetween(const Vec2 &from, const Vec2 &to)
{
    const double cosine = from.dot(to), sine = cross(from, to);
    return (Eigen::Matrix2d() << cosine, -sine, sine, cosine).finished();
}

class RevolveMaker
{
public:
    RevolveMaker(OperationContext &context, const Section &root, const Section &section,
                 const SourceCrossing &source, const Edge &edge, Branch branch)
        : m_context(context), m_root(root), m_section(section), m_source(source), m_edge(edge),
          m_branch(std::move(branch)), m_isScaled(context.choice("scale") == "thickness"),
          m_isStretched(m_isScaled && context.choice("direction") == "slit")
    {
        const double own = angleToEdge();
        const std::optional<double> angle = context.freeNumber("angle");
        context.found("angle", angle.value_or(own));
        if (angle) {
            const double more = *angle - own;
            m_moreTurn << std::cos(more), -std::sin(more), std::sin(more), std::cos(more);
        }
    }

    /// Between the section's plane and the boundary's direction, 0 … π.
    double angleToEdge() const
    {
        return std::atan2(std::abs(cross(m_edge.tangent, m_edge.outwards)),
                          m_edge.tangent.dot(m_edge.outwards));
    }

    bool add(const RowPlace &place, bool isOutside)
    {
        const CurvePoint at = m_edge.boundary.after(m_edge.at, place.at);
        const Contour &contour = m_edge.boundary.contour();
        const Vec2 point = positionAt(contour, at), tangent = directionAt(contour, at);
        Eigen::Matrix2d turn = turnBetween(m_edge.tangent, tangent) * turnOfAngle();
        if (!isOutside)
            turn = (2.0 * tangent * tangent.transpose() - Eigen::Matrix2d::Identity()) * turn;
        const PlaneMotion motion{turn, m_edge.point, point};

        Copy copy{.key = isOutside ? std::to_string(place.number) : keyBelow("in", place.number),
                  .number = copyNumber(place.number),
                  .section = asCopy(m_section),
                  .placement = inSpace(m_root.frame, motion)};
        if (!isOutside)
            copy.number.append("i");
        if (m_isScaled) {
            const std::optional<double> scale = scaleAt(point, motion.matrix);
            if (!scale || !scaleCopy(copy, *scale))
                return false;
        }
        copy.section.frame = placed(copy.section.frame, copy.placement);
        copy.section.parent = parentFor(motion);
        return addCopy(m_context, m_branch, copy);
    }

private:
    /// Of a positive turn the outwards direction's angle to the tangent grows when it lies to the
    /// tangent's left.
    Eigen::Matrix2d turnOfAngle() const
    {
        return cross(m_edge.tangent, m_edge.outwards) >= 0.0 ? m_moreTurn : m_moreTurn.transpose();
    }

    /// By the girth from the point inwards.
    std::optional<double> scaleAt(const Vec2 &point, const Eigen::Matrix2d &turn) const
    {
        const PlaneLine line{point, turn * m_source.line.direction};
        const auto all = intervalsOn(line, *m_root.shape);
        const bool isHigh = leavesHigh(m_source);
        const auto off = [isHigh](const Interval &i) {
            return std::abs(isHigh ? i.to.at : i.from.at);
        };
        const auto it =
            std::min_element(all.begin(), all.end(),
                             [&](const Interval &a, const Interval &b) { return off(a) < off(b); });
        if (it == all.end())
            return std::nullopt;
        return scaleFor(m_context, it->length() / m_source.girth());
    }

    /// About the point on the boundary.
    bool scaleCopy(Copy &copy, double scale)
    {
        const Vec3 about = m_root.frame.toWorld(m_edge.point);
        PlaneMap map = PlaneMap::scaled(scale);
        if (m_isStretched) {
            const Vec3 u = m_source.axis.direction;
            const Vec2 v = m_section.frame.directionToLocal(u);
            map = {Eigen::Matrix2d::Identity() + (scale - 1.0) * v * v.transpose(),
                   m_section.frame.toLocal(about)};
            copy.stretch = (scale - 1.0) * u * u.transpose();
            copy.stretchedFrom = about;
        } else {
            copy.placement = copy.placement * Similarity::scaled(scale, about);
        }
        Result<Section> scaled = stretched(asCopy(m_section), map, shapeOf(m_context, copy.key));
        if (!scaled)
            return false;
        copy.section = *std::move(scaled);
        return true;
    }

    Parent parentFor(const PlaneMotion &motion) const
    {
        const Vec2 low = motion(m_source.line.at(m_source.overlap.from));
        const Vec2 high = motion(m_source.line.at(m_source.overlap.to));
        return leavesHigh(m_source) ? Parent{m_root.ref(), low, high}
                                    : Parent{m_root.ref(), high, low};
    }

    OperationContext &m_context;
    const Section &m_root, &m_section;
    const SourceCrossing &m_source;
    const Edge &m_edge;
    Branch m_branch;
    Eigen::Matrix2d m_moreTurn = Eigen::Matrix2d::Identity();
    bool m_isScaled, m_isStretched;
};

/// Once round from the source.
void setTrack(OperationContext &context, const Section &root, const Edge &edge)
{
    constexpr int kSteps = 180;
    std::vector<std::pair<Vec3, double>> track;
    for (int i = 0; i <= kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        const CurvePoint at = edge.boundary.at(edge.source + share * edge.length());
        track.emplace_back(root.frame.toWorld(positionAt(edge.boundary.contour(), at)), share);
    }
    context.setTrack(std::move(track));
}

RowRequest requestOf(const OperationContext &context, const Edge &edge)
{
    RowRequest request = rowRequest(context);
    const double from = context.number("from"), to = context.number("to");
    request.isRing = context.isOn("closed");
    request.from = request.isRing ? 0.0 : from <= to ? from : from - 1.0;
    request.to = request.isRing ? 1.0 : to;
    request.from *= edge.length();
    request.to *= edge.length();
    request.goesBack = request.from < 0.0;
    return request;
}

void make(OperationContext &context)
{
    const SectionPointer section = context.input("section"), root = context.input("along");
    if (!section || !root)
        return;
    const std::optional<SourceCrossing> source = sourceCrossing(*root, *section);
    if (section == root || !source || !source->isMeeting) {
        context.notice({OperationNotice::Kind::InputsApart});
        return;
    }
    const Edge edge(edgeOf(*root, *source, leavesHigh(*source)), *root);
    setTrack(context, *root, edge);
    const Row row = placesOf(requestOf(context, edge));
    RevolveMaker maker(context, *root, *section, *source, edge,
                       context.isOn("wholeBranch") ? wholeBranchOf(context, section, root)
                                                   : branchOf(section));
    const std::string side = context.choice("side");
    int leftOut = 0;
    for (const RowPlace &place : row.places) {
        bool isWhole = true;
        if (side != "inside")
            isWhole = maker.add(place, true);
        if (side != "outside")
            isWhole = maker.add(place, false) && isWhole;
        leftOut += isWhole ? 0 : 1;
    }
    // The source's own place on the other side.
    if (side == "both")
        maker.add({0, 0.0}, false);
    noticeRow(context, row, leftOut);
}

std::vector<ParameterSpec> parameters()
{
    std::vector<ParameterSpec> all{wholeBranchParameter()};
    const auto append = [&all](std::vector<ParameterSpec> more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    append(rowParameters(13));
    for (ParameterSpec &spec : all) {
        if (std::string_view(spec.key) == "from" || std::string_view(spec.key) == "to") {
            spec.countsIf = "closed";
            spec.countsFor = {"false"};
        }
    }
    append({{.key = "side",
             .label = QT_TRANSLATE_NOOP("Operation", "Side"),
             .unit = Unit::Choice,
             .choices = {{"outside", QT_TRANSLATE_NOOP("Operation", "Outside")},
                         {"inside", QT_TRANSLATE_NOOP("Operation", "Inside")},
                         {"both", QT_TRANSLATE_NOOP("Operation", "Both")}}},
            {.key = "angle",
             .label = QT_TRANSLATE_NOOP("Operation", "Angle to edge"),
             .unit = Unit::Angle,
             .least = 0.0,
             .most = std::numbers::pi,
             .step = std::numbers::pi / 360.0,
             .sliderLeast = 0.0,
             .sliderMost = std::numbers::pi,
             .isFree = true},
            {.key = "closed",
             .label = QT_TRANSLATE_NOOP("Operation", "All the way round"),
             .unit = Unit::Switch}});
    append(scaleParameters());
    return all;
}

} // namespace

const OperationKind kRevolve{
    .key = "revolve",
    .version = 1,
    .name = QT_TRANSLATE_NOOP("Operation", "Revolve"),
    .summary =
        QT_TRANSLATE_NOOP("Operation", "Repeats a section round the contour of another one."),
    //: %1 is the name of a section: "Rib fan"
    .calls = [](const Operation &) { return QT_TRANSLATE_NOOP("Operation", "%1 fan"); },
    .inputs = repeatInputs(),
    .parameters = parameters(),
    .handles = {"from", "to"},
    .make = make};

} // namespace fff
