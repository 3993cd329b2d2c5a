#include "core/operations/branch.h"

#include "core/base/text.h"
#include "core/model/instance_key.h"
#include "core/operations/copying.h"
#include "core/operations/root_edge.h"
#include "core/operations/seeded.h"

#include <algorithm>
#include <deque>
#include <map>
#include <numbers>

namespace fff {

namespace {

using Unit = ParameterSpec::Unit;
using Hold = SourceCrossing::Hold;

/// Where a section is held, and in which direction it grows from there; in the world.
struct Growth
{
    Vec3 from = Vec3::Zero();
    Eigen::Matrix3d axes =
        Eigen::Matrix3d::Identity(); // its way, the section's normal, both square
};

Growth growth(const Vec3 &from, const Vec3 &way, const Vec3 &normal)
{
    Growth result{from, {}};
    result.axes << way, normal, way.cross(normal);
    return result;
}

/// Of a section out of the one that holds it. Nothing when they do not meet.
std::optional<Growth> growthFrom(const Section &host, const Section &section)
{
    const std::optional<SourceCrossing> source = sourceCrossing(host, section);
    if (!source || !source->isMeeting)
        return std::nullopt;
    const bool isHigh = leavesHigh(*source);
    const Overlap &o = source->overlap;
    const double inner = source->hold == Hold::Middle ? 0.5 * (o.a.from.at + o.a.to.at)
                         : isHigh                     ? o.b.from.at
                                                      : o.b.to.at;
    const Vec3 way = isHigh ? source->axis.direction : Vec3(-source->axis.direction);
    return growth(source->axis.at(inner), way, section.frame.normal());
}

/// Of a section that nothing holds: upwards from its lower end.
Growth growthFromBelow(const Section &section)
{
    const Frame &frame = section.frame;
    Vec2 up = frame.directionToLocal(Vec3::UnitY());
    up = up.norm() > 0.0 ? up.normalized() : Vec2::UnitY();
    const PlaneLine line{section.shape->centroid(), up};
    const std::vector<Interval> inside = intervalsOn(line, *section.shape);
    const double low = inside.empty() ? 0.0 : inside.front().from.at;
    return growth(frame.toWorld(line.at(low)), frame.directionToWorld(up), frame.normal());
}

/// A member of the hierarchy whose place copies take.
struct Bud
{
    std::size_t member = 0;
    Growth growth;
};

class BranchMaker
{
public:
    BranchMaker(OperationContext &context, Branch hierarchy, std::vector<Bud> buds,
                const Growth &base)
        : m_context(context), m_hierarchy(std::move(hierarchy)), m_buds(std::move(buds)),
          m_base(base), m_scale(context.number("scale")), m_varyScale(context.number("varyScale")),
          m_varyAngle(context.number("varyAngle")), m_smallest(context.number("smallest")),
          m_seed(static_cast<std::uint64_t>(context.number("seed"))), m_most(context.count("most"))
    {
        // What is on a member goes where that goes.
        m_budOf.assign(members().size(), -1);
        for (std::size_t i = 0; i < members().size(); ++i) {
            const auto isIt = [i](const Bud &bud) { return bud.member == i; };
            const auto bud = std::find_if(m_buds.begin(), m_buds.end(), isIt);
            if (bud != m_buds.end())
                m_budOf[i] = static_cast<int>(bud - m_buds.begin());
            else if (members()[i].parent >= 0)
                m_budOf[i] = m_budOf[static_cast<std::size_t>(members()[i].parent)];
        }
        for (const Vec2 &p : members()[0].section->shape->region().outer)
            m_rootBox.extend(p);
    }

    void make(int iterations)
    {
        std::deque<Replica> open{{}}; // the drawn one first
        open.front().isReplaced.assign(m_buds.size(), false);
        std::vector<Replica> done;
        bool isStopped = false;
        for (; !open.empty(); open.pop_front()) {
            Replica &replica = open.front();
            for (std::size_t i = 0; i < m_buds.size(); ++i) {
                if (replica.depth >= iterations || isStopped)
                    break;
                Replica next = grown(replica, i);
                if (m_rootBox.size().maxCoeff() * next.placement.scale < m_smallest)
                    continue;
                const int more =
                    static_cast<int>(members().size()) - (replica.path.empty() ? 0 : goneWith(i));
                if (m_count + more > m_most) {
                    isStopped = true;
                    break;
                }
                m_count += more;
                replica.isReplaced[i] = true;
                open.push_back(std::move(next));
            }
            done.push_back(open.front());
        }
        for (std::size_t i = 0; i < done.size(); ++i)
            isStopped = !add(done[i], static_cast<int>(i)) || isStopped;
        if (isStopped)
            m_context.notice({.kind = OperationNotice::Kind::StoppedAtMost, .count = m_most});
    }

private:
    struct Replica
    {
        std::string path; // of the children whose place it and those before it took; empty: drawn
        std::string host; // key of the root that it grows from; empty: the drawn one
        int bud = -1;     // whose place it took there
        int depth = 0;
        double hostScale = 1.0;
        Similarity placement;
        std::vector<char> isReplaced; // of its buds
    };

    const std::vector<Branch::Member> &members() const { return m_hierarchy.members; }

    /// How many members go where a copy takes the place of the bud.
    int goneWith(std::size_t bud) const
    {
        return static_cast<int>(std::count(m_budOf.begin(), m_budOf.end(), static_cast<int>(bud)));
    }

    Replica grown(const Replica &on, std::size_t index) const
    {
        const Bud &bud = m_buds[index];
        Replica next;
        next.path = keyBelow(on.path, members()[bud.member].key);
        next.host = on.path.empty() ? std::string() : keyBelow(on.path, 0);
        next.bud = static_cast<int>(index);
        next.depth = on.depth + 1;
        next.hostScale = on.placement.scale;
        next.isReplaced.assign(m_buds.size(), false);
        Seeded random(m_seed, next.path);
        const double scale = m_scale * (1.0 + m_varyScale * random.symmetric());
        const double angle = m_varyAngle * random.symmetric();
        const Vec3 normal = bud.growth.axes.col(1);
        Similarity own;
        own.scale = scale;
        own.turn = Eigen::AngleAxisd(angle, normal).toRotationMatrix() * bud.growth.axes *
                   m_base.axes.transpose();
        own.shift = bud.growth.from - scale * (own.turn * m_base.from);
        next.placement = on.placement * own;
        return next;
    }

    /// Whether all of it could be made.
    bool add(const Replica &replica, int number)
    {
        const auto isGone = [&](std::size_t member) {
            const int bud = m_budOf[member];
            return bud >= 0 && replica.isReplaced[static_cast<std::size_t>(bud)];
        };
        bool isWhole = true;
        for (std::size_t i = 0; i < members().size(); ++i) {
            const SectionPointer &drawn = members()[i].section;
            if (replica.path.empty()) {
                if (isGone(i))
                    m_context.change(drawn->ref(), nullptr);
                continue;
            }
            if (!isGone(i))
                isWhole = addMember(replica, i, number) && isWhole;
        }
        return isWhole;
    }

    bool addMember(const Replica &replica, std::size_t index, int number)
    {
        const Branch::Member &member = members()[index];
        const auto keyOf = [&](const Branch::Member &one) {
            return one.parent < 0 ? keyBelow(replica.path, 0) : keyBelow(replica.path, one.key);
        };
        Result<Section> section = transformed(
            asCopy(*member.section), replica.placement,
            [this](const ShapePointer &shape, const PlaneMap &map) { return scaled(shape, map); });
        if (!section)
            return false;
        section->name = copiedName(section->name, std::to_string(number + 1));
        if (index == 0)
            section->parent = parentOf(replica);
        else if (section->parent) {
            section->parent = transformed(*section->parent, replica.placement);
            section->parent->section =
                SectionRef(m_context.operation().id,
                           keyOf(members()[static_cast<std::size_t>(member.parent)]));
        }
        m_context.add(keyOf(member), *std::move(section));
        return true;
    }

    /// The root of a copy stands where the child stood.
    std::optional<Parent> parentOf(const Replica &replica) const
    {
        const Branch::Member &child =
            members()[m_buds[static_cast<std::size_t>(replica.bud)].member];
        std::optional<Parent> parent = child.section->parent;
        if (!parent)
            return parent;
        if (!replica.host.empty())
            parent->section = SectionRef(m_context.operation().id, replica.host);
        return transformed(*parent, {.scale = replica.hostScale});
    }

    /// Copies of one size share their shapes.
    Result<ShapePointer> scaled(const ShapePointer &shape, const PlaneMap &map)
    {
        ShapePointer &known = m_shapes[{shape.get(), map.matrix(0, 0)}];
        if (!known) {
            const Result<ShapePointer> next = mappedShape(shape, map);
            if (!m_context.made(next))
                return next;
            known = m_context.keptOfAny(*next);
        }
        return known;
    }

    OperationContext &m_context;
    Branch m_hierarchy;
    std::vector<Bud> m_buds;
    std::vector<int> m_budOf; // of each member; −1: it stays
    Growth m_base;
    Box2 m_rootBox;
    double m_scale, m_varyScale, m_varyAngle, m_smallest;
    std::uint64_t m_seed;
    int m_most, m_count = 0;
    std::map<std::pair<const Shape *, double>, ShapePointer> m_shapes;
};

SectionPointer holderOf(OperationContext &context, const Section &root)
{
    const std::vector<SectionPointer> where = context.inputs("where");
    if (!where.empty())
        return where.front();
    return root.parent ? context.find(root.parent->section) : nullptr;
}

void make(OperationContext &context)
{
    const SectionPointer root = context.input("root");
    const std::vector<SectionPointer> children = context.inputs("children");
    if (!root || children.empty())
        return;
    const SectionPointer holder = holderOf(context, *root);
    const std::optional<Growth> held = holder ? growthFrom(*holder, *root) : std::nullopt;
    Branch hierarchy = wholeBranchOf(context, root, holder);
    std::vector<Bud> buds;
    for (const SectionPointer &child : children) {
        const auto it = std::find_if(
            hierarchy.members.begin(), hierarchy.members.end(),
            [&child](const Branch::Member &member) { return member.section == child; });
        const std::optional<Growth> growth = growthFrom(*root, *child);
        if (it == hierarchy.members.end() || it->parent != 0 || !growth) {
            context.notice({OperationNotice::Kind::InputsApart});
            return;
        }
        buds.push_back({static_cast<std::size_t>(it - hierarchy.members.begin()), *growth});
    }
    BranchMaker(context, std::move(hierarchy), std::move(buds),
                held ? *held : growthFromBelow(*root))
        .make(context.count("iterations"));
}

std::vector<ParameterSpec> parameters()
{
    constexpr double kDegree = std::numbers::pi / 180.0;
    return {{.key = "iterations",
             .label = QT_TRANSLATE_NOOP("Operation", "Iterations"),
             .unit = Unit::Count,
             .standard = 1,
             .least = 0,
             .most = 50,
             .sliderLeast = 0,
             .sliderMost = 12,
             .heading = QT_TRANSLATE_NOOP("Operation", "Growth")},
            {.key = "scale",
             .label = QT_TRANSLATE_NOOP("Operation", "Size of a copy"),
             .unit = Unit::Share,
             .standard = 0.8,
             .least = 0.01,
             .most = 2.0,
             .step = 0.01,
             .sliderLeast = 0.2,
             .sliderMost = 1.2},
            {.key = "varyScale",
             .label = QT_TRANSLATE_NOOP("Operation", "Vary size ±"),
             .unit = Unit::Share,
             .standard = 0.0,
             .least = 0.0,
             .most = 0.5,
             .step = 0.01,
             .sliderLeast = 0.0,
             .sliderMost = 0.5},
            {.key = "varyAngle",
             .label = QT_TRANSLATE_NOOP("Operation", "Vary angle ±"),
             .unit = Unit::Angle,
             .standard = 0.0,
             .least = 0.0,
             .most = 90.0 * kDegree,
             .step = kDegree,
             .sliderLeast = 0.0,
             .sliderMost = 90.0 * kDegree},
            {.key = "seed",
             .label = QT_TRANSLATE_NOOP("Operation", "Seed"),
             .unit = Unit::Number,
             .standard = 1,
             .least = 0,
             .most = 9999,
             .sliderLeast = 0,
             .sliderMost = 100},
            {.key = "smallest",
             .label = QT_TRANSLATE_NOOP("Operation", "Smallest"),
             .unit = Unit::Length,
             .standard = 5.0,
             .least = 0.0,
             .most = 100.0,
             .step = 0.5,
             .sliderLeast = 0.0,
             .sliderMost = 50.0,
             .heading = QT_TRANSLATE_NOOP("Operation", "Limits")},
            {.key = "most",
             .label = QT_TRANSLATE_NOOP("Operation", "At most"),
             .unit = Unit::Count,
             .standard = 500,
             .least = 10,
             .most = 5000,
             .sliderLeast = 10,
             .sliderMost = 1000}};
}

} // namespace

const OperationKind kBranch{
    .key = "branch",
    .version = 1,
    .name = QT_TRANSLATE_NOOP("Operation", "Branch"),
    .summary = QT_TRANSLATE_NOOP("Operation", "Grows copies of a section and all that is on it in "
                                              "place of its children, again and again."),
    //: %1 is the name of a section: "Rib branch"
    .calls = [](const Operation &) { return QT_TRANSLATE_NOOP("Operation", "%1 branch"); },
    .inputs = {{.role = "root",
                .label = QT_TRANSLATE_NOOP("Operation", "Root"),
                .prompt = QT_TRANSLATE_NOOP("Operation", "Click the section that branches.")},
               {.role = "where",
                .label = QT_TRANSLATE_NOOP("Operation", "Held by"),
                .prompt = QT_TRANSLATE_NOOP(
                    "Operation", "Click the section that holds it: copies are held the same way."),
                .least = 0},
               {.role = "children",
                .label = QT_TRANSLATE_NOOP("Operation", "Children"),
                .prompt = QT_TRANSLATE_NOOP(
                    "Operation", "Click the attached sections that copies should replace."),
                .most = 50}},
    .parameters = parameters(),
    .make = make};

} // namespace fff
