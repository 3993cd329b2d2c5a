#include "core/operations/linear.h"

#include "core/base/text.h"
#include "core/operations/copying.h"
#include "core/operations/repeat_parameters.h"
#include "core/operations/source_crossing.h"

#include <algorithm>

namespace fff {

namespace {

using Unit = ParameterSpec::Unit;
using Hold = SourceCrossing::Hold;

/// What all replicas of a row have in common.
struct LinearRow
{
    const Section &root;
    const Section &section;
    SourceCrossing source;
    Vec2 way;                    // in the root's plane, unit, at a right angle to the axis, forward
    double from = 0.0, to = 0.0; // of the root along it, from the source, mm

    Vec3 wayInWorld() const { return root.frame.directionToWorld(way); }
    PlaneLine lineAt(double s) const
    {
        return {source.line.point + s * way, source.line.direction};
    }
};

LinearRow linearRow(const Section &root, const Section &section, const SourceCrossing &source)
{
    LinearRow row{root, section, source, perpendicular(source.line.direction)};
    if (row.wayInWorld().dot(section.frame.normal()) < 0.0)
        row.way = -row.way;
    const Polygon &outer = root.shape->region().outer;
    row.from = row.to = row.way.dot(outer.front() - source.line.point);
    for (const Vec2 &p : outer) {
        const double at = row.way.dot(p - source.line.point);
        row.from = std::min(row.from, at);
        row.to = std::max(row.to, at);
    }
    return row;
}

/// The value along the axis that a replica is held by, in an interval of the root.
double heldAt(Hold hold, const Interval &root)
{
    switch (hold) {
    case Hold::Low:
        return root.from.at;
    case Hold::High:
        return root.to.at;
    case Hold::Middle:
        break;
    }
    return 0.5 * (root.from.at + root.to.at);
}

/// The end of a shape's interval on the axis that lies inside the root, or its middle.
double innerAt(const SourceCrossing &source, const Interval &section)
{
    switch (source.hold) {
    case Hold::Low:
        return section.to.at;
    case Hold::High:
        return section.from.at;
    case Hold::Middle:
        break;
    }
    return heldAt(Hold::Middle, source.overlap.a);
}

/// The direction along the axis in which a section goes deeper into the root.
double inwards(Hold hold)
{
    return hold == Hold::Low ? 1.0 : hold == Hold::High ? -1.0 : 0.0;
}

class LinearMaker
{
public:
    LinearMaker(OperationContext &context, const LinearRow &row, Branch branch)
        : m_context(context), m_row(row), m_branch(std::move(branch)),
          m_isEqualDepth(context.isOn("equalDepth")),
          m_isScaled(context.choice("scale") == "thickness"),
          m_isStretched(m_isScaled && context.choice("direction") == "slit")
    {
        m_axisInSection = lineInFrame(row.source.axis, row.section.frame);
    }

    /// Numbers go from the source outwards, so that each place goes on from the one before.
    int make(const std::vector<RowPlace> &places)
    {
        int leftOut = 0;
        const auto begin = std::find_if(places.begin(), places.end(),
                                        [](const RowPlace &place) { return place.number > 0; });
        m_last = m_row.source.overlap.a;
        for (auto it = begin; it != places.end(); ++it)
            leftOut += makeOne(*it) ? 0 : 1;
        m_last = m_row.source.overlap.a;
        for (auto it = begin; it != places.begin();)
            leftOut += makeOne(*--it) ? 0 : 1;
        return leftOut;
    }

private:
    bool makeOne(const RowPlace &place)
    {
        const SourceCrossing &source = m_row.source;
        double scale = 1.0, shift = 0.0;
        std::optional<Interval> root;
        if (source.isMeeting) {
            root = continued(intervalsOn(m_row.lineAt(place.at), *m_row.root.shape), m_last);
            if (!root)
                return false;
            m_last = *root;
            if (m_isScaled)
                scale = scaleFor(m_context, root->length() / source.girth());
            if (m_isEqualDepth)
                shift = heldAt(source.hold, *root) - heldAt(source.hold, source.overlap.a);
        }
        return addReplica(place, scale, shift);
    }

    bool addReplica(const RowPlace &place, double scale, double shift)
    {
        const SourceCrossing &source = m_row.source;
        Copy copy{.key = std::to_string(place.number),
                  .number = copyNumber(place.number),
                  .section = asCopy(m_row.section)};
        const double inner = source.isMeeting ? innerAt(source, source.overlap.b) : 0.0;
        const Vec3 held = source.axis.at(inner);
        Similarity size;
        if (scale != 1.0) {
            Result<Section> scaled =
                stretched(copy.section, {scaling(scale), m_axisInSection.at(inner)},
                          shapeOf(m_context, copy.key));
            if (!scaled)
                return false;
            copy.section = *std::move(scaled);
            // Its end on the axis is that of its chords, and as deep as it is large.
            if (m_isEqualDepth)
                shift += inner - innerOf(*copy.section.shape, inner) +
                         inwards(source.hold) * (scale - 1.0) * source.depth();
            if (m_isStretched) {
                const Vec3 u = source.axis.direction;
                copy.stretch = (scale - 1.0) * u * u.transpose();
                copy.stretchedFrom = held;
            } else {
                size = Similarity::scaled(scale, held);
            }
        }
        const Vec3 way = place.at * m_row.wayInWorld() + shift * source.axis.direction;
        copy.section.frame.origin += way;
        copy.placement = Similarity::moved(way) * size;
        if (source.isMeeting)
            copy.section.parent = parentAt(place.at, shift, scale);
        return addCopy(m_context, m_branch, copy);
    }

    Eigen::Matrix2d scaling(double scale) const
    {
        const Vec2 u = m_axisInSection.direction;
        if (m_isStretched)
            return Eigen::Matrix2d::Identity() + (scale - 1.0) * u * u.transpose();
        return scale * Eigen::Matrix2d::Identity();
    }

    double innerOf(const Shape &shape, double inner) const
    {
        if (m_row.source.hold == Hold::Middle)
            return inner;
        const auto all = intervalsOn(m_axisInSection, shape);
        const auto it =
            std::min_element(all.begin(), all.end(), [&](const Interval &a, const Interval &b) {
                return std::abs(innerAt(m_row.source, a) - inner) <
                       std::abs(innerAt(m_row.source, b) - inner);
            });
        return it == all.end() ? inner : innerAt(m_row.source, *it);
    }

    /// From the inner end to the edge.
    Parent parentAt(double at, double shift, double scale) const
    {
        const SourceCrossing &source = m_row.source;
        const PlaneLine line = m_row.lineAt(at);
        const double depth = scale * source.depth();
        const double inner = source.hold == Hold::Middle
                                 ? innerAt(source, source.overlap.b) + 0.5 * depth
                                 : innerAt(source, source.overlap.b);
        const double way = source.hold == Hold::High ? 1.0 : -1.0;
        return {m_row.root.ref(), line.at(inner + shift), line.at(inner + shift + way * depth)};
    }

    OperationContext &m_context;
    const LinearRow &m_row;
    Branch m_branch;
    PlaneLine m_axisInSection;
    Interval m_last;
    bool m_isEqualDepth, m_isScaled, m_isStretched;
};

/// Along the middle of the root, as far as it goes.
void setTrack(OperationContext &context, const LinearRow &row)
{
    const double middle = row.source.isMeeting ? heldAt(Hold::Middle, row.source.overlap.a) : 0.0;
    const auto at = [&](double s) { return row.root.frame.toWorld(row.lineAt(s).at(middle)); };
    context.setTrack({{at(row.from), 0.0}, {at(row.to), 1.0}});
}

void make(OperationContext &context)
{
    const SectionPointer section = context.input("section"), root = context.input("along");
    if (!section || !root)
        return;
    const std::optional<SourceCrossing> source = sourceCrossing(*root, *section);
    if (section == root || !source) {
        context.notice({OperationNotice::Kind::InputsApart});
        return;
    }
    const LinearRow linear = linearRow(*root, *section, *source);
    setTrack(context, linear);
    const auto ofRange = [&](const char *key) {
        return linear.from + context.number(key) * (linear.to - linear.from);
    };
    RowRequest request = rowRequest(context);
    request.from = std::min(ofRange("from"), ofRange("to"));
    request.to = std::max(ofRange("from"), ofRange("to"));
    request.goesForward = context.choice("side") != "back";
    request.goesBack = context.choice("side") != "forward";
    const Row row = placesOf(request);
    Branch branch =
        context.isOn("wholeBranch") ? wholeBranchOf(context, section, root) : branchOf(section);
    const int leftOut = LinearMaker(context, linear, std::move(branch)).make(row.places);
    noticeRow(context, row, leftOut);
}

std::vector<ParameterSpec> parameters()
{
    std::vector<ParameterSpec> all{wholeBranchParameter()};
    const auto append = [&all](std::vector<ParameterSpec> more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    append(rowParameters(8));
    append({{.key = "side",
             .label = QT_TRANSLATE_NOOP("Operation", "Side"),
             .unit = Unit::Choice,
             .choices = {{"forward", QT_TRANSLATE_NOOP("Operation", "Forward")},
                         {"back", QT_TRANSLATE_NOOP("Operation", "Back")},
                         {"both", QT_TRANSLATE_NOOP("Operation", "Both")}}},
            {.key = "equalDepth",
             .label = QT_TRANSLATE_NOOP("Operation", "Equal depth inside"),
             .unit = Unit::Switch,
             .standard = 1.0,
             .tip = QT_TRANSLATE_NOOP(
                 "Operation", "The same length of each copy lies inside the other section")}});
    append(scaleParameters());
    return all;
}

} // namespace

const OperationKind kLinear{
    .key = "linear",
    .version = 1,
    .name = QT_TRANSLATE_NOOP("Operation", "Linear"),
    .summary = QT_TRANSLATE_NOOP("Operation", "Repeats a section in a row along another one."),
    //: %1 is the name of a section: "Rib row"
    .calls = [](const Operation &) { return QT_TRANSLATE_NOOP("Operation", "%1 row"); },
    .inputs = repeatInputs(),
    .parameters = parameters(),
    .handles = {"from", "to"},
    .make = make};

} // namespace fff
