#include "core/analysis/joining_move.h"

#include "core/analysis/touching.h"
#include "core/assembly/found_joint.h"
#include "core/assembly/webs.h"
#include "core/base/tolerances.h"
#include "core/geometry/polygon.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <set>

namespace fff {

namespace {

/// How deep two sections go into each other is tried from half the thicker one's thickness on, each
/// time by so much more, so many times: up to about 30 thicknesses.
constexpr double kFirstDepth = 0.5, kDeeper = 1.35; // no unit
constexpr int kDepths = 15;
/// And then the last step in halves.
constexpr int kHalvings = 5;
/// Of an overlap that holds, in thicknesses of the thicker section.
constexpr double kHeld = 2.0;

const Section &sectionAt(const Model &model, int index)
{
    return *model.section(static_cast<std::size_t>(index));
}

Section movedBy(Section section, const Vec3 &way)
{
    section.frame.origin += way;
    return section;
}

class Search
{
public:
    Search(const Analysis &analysis, std::vector<int> moving, int section, int other,
           const Nearest &nearest)
        : m_analysis(analysis), m_model(analysis.model), m_moving(std::move(moving)),
          m_section(section), m_other(other), m_touching(nearest.onB - nearest.onA),
          m_thickness(std::max(m_model.stockOf(static_cast<std::size_t>(section)).thickness,
                               m_model.stockOf(static_cast<std::size_t>(other)).thickness)),
          m_ownWebs(webs(section, m_analysis.assembly.slits[static_cast<std::size_t>(section)])),
          m_otherWebs(webs(other, m_analysis.assembly.slits[static_cast<std::size_t>(other)]))
    {
    }

    /// The way along one direction.
    std::optional<Vec3> along(const Vec3 &direction) const
    {
        const auto depth = depthAlong(direction, std::numeric_limits<double>::infinity());
        return depth ? std::optional<Vec3>(m_touching + *depth * direction) : std::nullopt;
    }

    /// The shortest of all ways on.
    std::optional<Vec3> find() const
    {
        std::optional<Vec3> best;
        double least = std::numeric_limits<double>::infinity();
        for (const Vec3 &direction : directions()) {
            const std::optional<double> depth = depthAlong(direction, least);
            if (depth && *depth < least) {
                least = *depth;
                best = m_touching + *depth * direction;
            }
        }
        return best;
    }

private:
    std::size_t webs(int section, const std::vector<Slit> &slits) const
    {
        const auto index = static_cast<std::size_t>(section);
        return thinWebs(m_model.section(index)->shape->region(), slits,
                        m_model.stockOf(index).thickness)
            .size();
    }

    /// Unit vectors, each towards the other section.
    std::vector<Vec3> directions() const
    {
        const Section &own = sectionAt(m_model, m_section), &other = sectionAt(m_model, m_other);
        const Vec3 between = other.frame.toWorld(other.shape->centroid()) -
                             own.frame.toWorld(own.shape->centroid()) - m_touching;
        std::vector<Vec3> all;
        if (m_touching.norm() > kTouchingDepth)
            all.push_back(m_touching.normalized());
        const Vec3 a = own.frame.normal().normalized(), b = other.frame.normal().normalized();
        for (const Vec3 &along : {b, a, Vec3(a.cross(b))})
            if (along.norm() > kSameDirection)
                all.push_back(along.normalized() * (along.dot(between) < 0.0 ? -1.0 : 1.0));
        return all;
    }

    std::optional<double> depthAlong(const Vec3 &direction, double limit) const
    {
        double before = 0.0, depth = kFirstDepth * m_thickness;
        for (int i = 0; i < kDepths && before < limit; ++i) {
            if (holds(m_touching + depth * direction)) {
                for (int k = 0; k < kHalvings; ++k) {
                    const double middle = 0.5 * (before + depth);
                    (holds(m_touching + middle * direction) ? depth : before) = middle;
                }
                if (isFree(m_touching + depth * direction))
                    return depth;
                return {}; // deeper it is in the same ones
            }
            before = depth;
            depth *= kDeeper;
        }
        return {};
    }

    /// Whether moved so the two have a joint that deserves the name.
    bool holds(const Vec3 &way) const
    {
        // The two alone, in their order, so that their joint is as in the whole model.
        Document pair = m_model.document;
        pair.sections.clear();
        for (const int index : {std::min(m_section, m_other), std::max(m_section, m_other)})
            pair.sections.push_back(
                index == m_section
                    ? std::make_shared<const Section>(movedBy(sectionAt(m_model, index), way))
                    : m_model.section(static_cast<std::size_t>(index)));
        const std::optional<FoundJoint> found = findJoint(evaluate(std::move(pair)), 0, 1);
        if (!found || found->joint.kind == JointKind::None)
            return false;
        const auto &overlaps = found->joint.crossing->overlaps;
        if (std::none_of(overlaps.begin(), overlaps.end(), [&](const Overlap &overlap) {
                return overlap.to - overlap.from >= kHeld * m_thickness;
            }))
            return false;
        const bool isFirst = m_section < m_other;
        return isEnclosed(m_section, isFirst ? found->slitsOfA : found->slitsOfB) &&
               isEnclosed(m_other, isFirst ? found->slitsOfB : found->slitsOfA) &&
               webs(m_section, withOld(m_section, isFirst ? found->slitsOfA : found->slitsOfB)) <=
                   m_ownWebs &&
               webs(m_other, withOld(m_other, isFirst ? found->slitsOfB : found->slitsOfA)) <=
                   m_otherWebs;
    }

    /// Whether the section goes on to both sides of its slits, where they end and halfway out: one
    /// that only reaches into the other has a step there, which holds nothing.
    bool isEnclosed(int section, const std::vector<Slit> &slits) const
    {
        const auto index = static_cast<std::size_t>(section);
        const Region &region = m_model.section(index)->shape->region();
        const double thickness = m_model.stockOf(index).thickness;
        for (const Slit &slit : slits) {
            const Vec2 out = (slit.mouth - slit.inner).normalized();
            const Vec2 beside = (0.5 * slit.width + thickness) * perpendicular(out);
            for (const double along : {0.0, 0.25 * kHeld * m_thickness})
                for (const double side : {-1.0, 1.0})
                    if (locate(slit.inner + along * out + side * beside, region) != Side::Inside)
                        return false;
        }
        return true;
    }

    std::vector<Slit> withOld(int section, std::vector<Slit> slits) const
    {
        const std::vector<Slit> &old = m_analysis.assembly.slits[static_cast<std::size_t>(section)];
        slits.insert(slits.end(), old.begin(), old.end());
        return slits;
    }

    /// Whether moved so nothing is in anything without a slit, or in the ground.
    bool isFree(const Vec3 &way) const
    {
        JoiningMove move{{}, way};
        for (const int index : m_moving)
            move.sections.push_back(sectionAt(m_model, index).id);
        const Model next = evaluate(moved(m_model.document, move));
        std::vector<char> moves(next.sectionCount(), 0);
        for (const int index : m_moving) {
            moves[static_cast<std::size_t>(index)] = 1;
            const Section &before = sectionAt(m_model, index), &now = sectionAt(next, index);
            const double height = worldBounds(*now.shape, now.frame).min.y();
            if (height < -kGroundSunk && height < worldBounds(*before.shape, before.frame).min.y())
                return false;
        }
        const Assembly assembly = assemble(next, m_model, m_analysis.assembly);
        for (const Joint &joint : assembly.joints)
            if (joint.kind == JointKind::None && moves[static_cast<std::size_t>(joint.a)] !=
                                                     moves[static_cast<std::size_t>(joint.b)])
                return false;
        for (const int index : m_moving)
            for (std::size_t i = 0; i < next.sectionCount(); ++i)
                if (!moves[i] && touchLoosely(next, assembly.joints, index, static_cast<int>(i)))
                    return false;
        return true;
    }

    const Analysis &m_analysis;
    const Model &m_model;
    std::vector<int> m_moving;
    int m_section, m_other;
    Vec3 m_touching; // to where the two touch
    double m_thickness;
    std::size_t m_ownWebs, m_otherWebs;
};

/// The group and what was drawn on it; empty unless all of them are drawn.
std::vector<int> movingSections(const Analysis &analysis, const std::vector<SectionRef> &group,
                                int other)
{
    const Model &model = analysis.model;
    std::set<int> moving;
    for (const SectionRef &ref : group) {
        const int index = ref.drawn.isValid() ? model.indexOf(ref) : -1;
        if (index < 0)
            return {};
        moving.insert(index);
    }
    std::set<int> held; // with the other one
    for (const int section : sectionsOf(analysis.bodies, groupOf(analysis, other)))
        held.insert(section);
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t i = 0; i < model.document.sections.size(); ++i) {
            const std::optional<Parent> &parent = model.document.sections[i]->parent;
            const int on = parent ? model.indexOf(parent->section) : -1;
            if (on >= 0 && moving.count(on) > 0 && held.count(static_cast<int>(i)) == 0)
                grows = moving.insert(static_cast<int>(i)).second || grows;
        }
    }
    return {moving.begin(), moving.end()};
}

} // namespace

std::optional<JoiningMove>
joiningMove(const Analysis &analysis, const std::vector<SectionRef> &group, const SectionRef &other)
{
    const int target = analysis.model.indexOf(other);
    if (target < 0)
        return {};
    const std::vector<int> moving = movingSections(analysis, group, target);
    if (moving.empty() || std::binary_search(moving.begin(), moving.end(), target))
        return {};
    Nearest nearest;
    int section = -1;
    for (const SectionRef &ref : group) {
        const int own = analysis.model.indexOf(ref);
        if (own < 0)
            continue;
        for (const BodyPointer &body : analysis.bodies.of(own)) {
            for (const BodyPointer &mate : analysis.bodies.of(target)) {
                if (distanceBetween(body->box(), mate->box()) >= nearest.distance)
                    continue;
                const Nearest found = nearestPoints(body->slab(), mate->slab(), nearest.distance);
                if (found.distance < nearest.distance) {
                    nearest = found;
                    section = own;
                }
            }
        }
    }
    if (section < 0)
        return {};
    JoiningMove move;
    for (const int index : moving)
        move.sections.push_back(sectionAt(analysis.model, index).id);
    const std::optional<Vec3> way = Search(analysis, moving, section, target, nearest).find();
    if (!way)
        return {};
    move.way = *way;
    return move;
}

std::optional<JoiningMove> moveAlong(const Analysis &analysis, const SectionRef &section,
                                     const SectionRef &other, const Vec3 &direction)
{
    const Model &model = analysis.model;
    const int own = model.indexOf(section), target = model.indexOf(other);
    if (own < 0 || target < 0 || own == target || !section.drawn.isValid())
        return {};
    const std::optional<Vec3> way =
        Search(analysis, {own}, own, target, Nearest{}).along(direction);
    return way ? std::optional(JoiningMove{{section.drawn}, *way}) : std::nullopt;
}

std::vector<SectionRef> nearestSections(const Analysis &analysis,
                                        const std::vector<SectionRef> &group, std::size_t most)
{
    const Model &model = analysis.model;
    const auto boxOf = [&](std::size_t index) {
        const Section &section = *model.section(index);
        return worldBounds(*section.shape, section.frame);
    };
    std::vector<Box3> own;
    std::vector<std::pair<double, int>> others;
    std::vector<char> isOwn(model.sectionCount(), 0);
    for (const SectionRef &ref : group) {
        if (const int index = model.indexOf(ref); index >= 0) {
            isOwn[static_cast<std::size_t>(index)] = 1;
            own.push_back(boxOf(static_cast<std::size_t>(index)));
        }
    }
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        if (isOwn[i])
            continue;
        double distance = std::numeric_limits<double>::infinity();
        for (const Box3 &box : own)
            distance = std::min(distance, distanceBetween(box, boxOf(i)));
        others.emplace_back(distance, static_cast<int>(i));
    }
    std::sort(others.begin(), others.end());
    others.resize(std::min(others.size(), most));
    std::vector<SectionRef> refs;
    for (const auto &[distance, index] : others)
        refs.push_back(model.ref(static_cast<std::size_t>(index)));
    return refs;
}

Document moved(Document document, const JoiningMove &move)
{
    for (const SectionId id : move.sections) {
        const Section *section = document.find(id);
        if (!section)
            continue;
        Frame frame = section->frame;
        frame.origin += move.way;
        document = *moveSection(std::move(document), id, frame); // it is there
    }
    return document;
}

} // namespace fff
