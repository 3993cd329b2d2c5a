#include "core/model/moving.h"

#include "core/base/tolerances.h"
#include "core/geometry/turning.h"
#include "core/model/transformed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace fff {

namespace {

/// Sine of the angle between two planes below which they have no line in common (no unit).
constexpr double kSamePlanes = 1e-6;

bool isSame(const Similarity &a, const Similarity &b)
{
    return a.turn == b.turn && a.scale == b.scale && a.shift == b.shift;
}

/// Turned by rounding only: one drag after the other must not skew the frame.
Frame straight(const Frame &frame)
{
    const Result<Frame> made = makeFrame(frame.origin, frame.x, frame.y);
    return made ? *made : frame;
}

Similarity turnAbout(const Eigen::Quaterniond &turn, const Vec3 &about)
{
    return Similarity::turned(turn.toRotationMatrix(), about);
}

/// The nearest point of the line in which both planes lie; of the first one where there is none.
Vec3 onBoth(const Vec3 &point, const Frame &a, const Frame &b)
{
    const Vec3 n = a.normal(), m = b.normal();
    const double toA = -a.height(point), toB = -b.height(point), cosine = n.dot(m);
    if (n.cross(m).norm() < kSamePlanes)
        return point + toA * n;
    const double along = (toB - cosine * toA) / (1.0 - cosine * cosine);
    return point + (toA - cosine * along) * n + along * m;
}

Vec3 slitMiddle(const Parent &parent, const Frame &frame)
{
    return frame.toWorld(0.5 * (parent.slitFrom + parent.slitTo));
}

/// Where both planes meet, in the slit's direction; nothing where they are parallel.
std::optional<Vec3> slitDirection(const Section &section, const Frame &parent)
{
    const Vec3 line = section.frame.normal().cross(parent.normal());
    if (line.norm() < kSamePlanes)
        return std::nullopt;
    const Vec3 slit = parent.directionToWorld(section.parent->slitTo - section.parent->slitFrom);
    return line.dot(slit) < 0.0 ? Vec3(-line.normalized()) : Vec3(line.normalized());
}

class Mover
{
public:
    Mover(Document document, const MovingRules &rules)
        : m_document(std::move(document)), m_rules(rules), m_ways(m_document.sections.size())
    {
    }

    Result<Document> move(std::span<const SectionMove> moves);
    Result<Document> stretch(SectionId id, const PlaneMap &map);

private:
    struct Way
    {
        const SectionMove *wanted = nullptr;
        bool isKnown = false;
        Similarity placement = {};
    };

    const Section &section(int index) const
    {
        return *m_document.sections[static_cast<std::size_t>(index)];
    }
    Way &way(int index) { return m_ways[static_cast<std::size_t>(index)]; }
    /// Of the parent, where it is drawn; −1 elsewhere.
    int parentIndex(const Section &section) const
    {
        return section.parent ? m_document.indexOf(section.parent->section.drawn) : -1;
    }
    std::optional<MovingRules::Frames> parentFrames(const Section &section);
    Similarity carrier(const Section &section);
    Similarity alongStretch(const Section &section);
    Similarity placementOf(int index);
    Similarity held(const Section &section, const Similarity &placement);
    Result<void> carryOut();
    Result<void> put(int index, const Similarity &placement);
    void follow(Section &next, const Section &before, const Similarity &placement);

    Document m_document;
    std::vector<std::pair<int, SectionPointer>> m_moved; // where they go in
    const MovingRules &m_rules;
    std::vector<Way> m_ways;
    int m_stretched = -1;
    PlaneMap m_stretch;
};

std::optional<MovingRules::Frames> Mover::parentFrames(const Section &section)
{
    if (!section.parent)
        return std::nullopt;
    const int parent = parentIndex(section);
    if (parent < 0)
        return m_rules.framesOf ? m_rules.framesOf(section.parent->section) : std::nullopt;
    const Frame &before = this->section(parent).frame;
    return MovingRules::Frames{before, placed(before, placementOf(parent))};
}

/// How that which the section is on is moved.
Similarity Mover::carrier(const Section &section)
{
    if (const int parent = parentIndex(section); parent >= 0)
        return placementOf(parent);
    const std::optional<MovingRules::Frames> frames = parentFrames(section);
    if (!frames || frames->before == frames->after)
        return {};
    const auto axes = [](const Frame &frame) {
        Eigen::Matrix3d matrix;
        matrix << frame.x, frame.y, frame.normal();
        return matrix;
    };
    const Eigen::Matrix3d turn = axes(frames->after) * axes(frames->before).transpose();
    return {.turn = turn, .shift = frames->after.origin - turn * frames->before.origin};
}

/// Turned so that its angle to what it is on is as before.
Similarity Mover::held(const Section &section, const Similarity &placement)
{
    const std::optional<MovingRules::Frames> on = parentFrames(section);
    if (!on || section.parent->isFree)
        return placement;
    double cosine = section.frame.normal().dot(on->before.normal());
    if (std::abs(cosine) <= kRightAngle)
        cosine = 0.0;
    const Vec3 anchor = slitMiddle(*section.parent, on->before);
    const auto turned = [&](const Similarity &by) -> std::optional<Similarity> {
        const Vec3 now = placed(section.frame, by).normal(), m = on->after.normal();
        const Vec3 beside = now - now.dot(m) * m;
        if (beside.norm() < kSamePlanes)
            return std::nullopt;
        const Vec3 wanted =
            cosine * m + std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) * beside.normalized();
        return turnAbout(Eigen::Quaterniond::FromTwoVectors(now, wanted), by(anchor)) * by;
    };
    if (const auto result = turned(placement))
        return *result;
    // It would lie in the other one's plane: then it goes there as it is.
    const Similarity straightOn{.scale = placement.scale,
                                .shift = placement(anchor) - placement.scale * anchor};
    return turned(straightOn).value_or(straightOn);
}

/// As far as the middle of its slit goes in the section that is stretched, or the end that it holds
/// to.
Similarity Mover::alongStretch(const Section &section)
{
    const Vec2 at = 0.5 * (section.parent->slitFrom + section.parent->slitTo);
    Vec2 by = m_stretch(at) - at;
    const Box2 box = turnedBounds(this->section(m_stretched).shape->contour(), Vec2::UnitX());
    const auto asEnd = [&](int axis, double end) {
        Vec2 beside = at;
        beside[axis] = end;
        by[axis] = m_stretch(beside)[axis] - end;
    };
    switch (section.parent->holdsTo) {
    case HoldsTo::Proportion:
        break;
    case HoldsTo::Left:
        asEnd(0, box.min.x());
        break;
    case HoldsTo::Right:
        asEnd(0, box.max.x());
        break;
    case HoldsTo::Bottom:
        asEnd(1, box.min.y());
        break;
    case HoldsTo::Top:
        asEnd(1, box.max.y());
        break;
    }
    return Similarity::moved(this->section(m_stretched).frame.directionToWorld(by));
}

/// Parents are asked for first; no section is its own ancestor.
Similarity Mover::placementOf(int index)
{
    Way &own = way(index);
    if (own.isKnown)
        return own.placement;
    const Section &moved = section(index);
    const int parent = parentIndex(moved);
    Similarity placement;
    if (own.wanted) {
        placement = own.wanted->placement;
        const bool isAlike = parent >= 0 && isSame(placement, placementOf(parent));
        if (!isAlike && !own.wanted->breaksAngle)
            placement = held(moved, placement);
    } else if (moved.parent && !moved.parent->isFree) {
        const Similarity carried =
            parent >= 0 && parent == m_stretched ? alongStretch(moved) : carrier(moved);
        if (m_rules.takesChildren)
            placement = carried;
        else if (!isSame(carried, Similarity()))
            placement = held(moved, placement);
    }
    own.isKnown = true;
    own.placement = placement;
    return placement;
}

/// The slit stays in both planes.
void Mover::follow(Section &next, const Section &before, const Similarity &placement)
{
    const std::optional<MovingRules::Frames> on = parentFrames(before);
    const bool isStretched = m_stretched >= 0 && parentIndex(before) == m_stretched;
    const Similarity by = carrier(before);
    if (!on || (isSame(placement, by) && by.scale == 1.0 && !isStretched))
        return;
    for (Vec2 *end : {&next.parent->slitFrom, &next.parent->slitTo})
        *end =
            on->after.toLocal(onBoth(placement(on->before.toWorld(*end)), next.frame, on->after));
}

Result<void> Mover::put(int index, const Similarity &placement)
{
    const Section &before = section(index);
    const PlaneMap map = index == m_stretched ? m_stretch : PlaneMap::scaled(placement.scale);
    Result<Section> next = stretched(before, map);
    if (!next)
        return tl::unexpected(next.error());
    next->frame = placed(before.frame, placement);
    if (placement.turn != Eigen::Matrix3d::Identity())
        next->frame = straight(next->frame);
    const Box3 box = worldBounds(*next->shape, next->frame);
    if (!(box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff() <= kMaxCoordinate))
        return failure(ErrorCode::NonFinite, before.name);
    follow(*next, before, placement);
    if (placement.turn.determinant() < 0.0) // the normal is the other one
        for (Load &load : m_document.loads)
            if (load.section == before.id)
                load.push.z() = -load.push.z();
    if (!map.isIdentity())
        mapPlaces(
            m_document, [&](const SectionRef &ref) { return ref == before.id; }, map);
    m_moved.emplace_back(index, std::make_shared<const Section>(*std::move(next)));
    return {};
}

Result<void> Mover::carryOut()
{
    for (int i = 0; i < static_cast<int>(m_ways.size()); ++i) {
        const Similarity placement = placementOf(i);
        const bool stays = isSame(placement, Similarity()) && i != m_stretched;
        if (stays && isSame(carrier(section(i)), Similarity()))
            continue; // nor does what it is on
        if (const Result<void> done = put(i, placement); !done)
            return done;
    }
    for (auto &[index, moved] : m_moved) {
        SectionPointer &place = m_document.sections[static_cast<std::size_t>(index)];
        if (moved->shape != place->shape || !(*moved == *place))
            place = std::move(moved);
    }
    return {};
}

Result<Document> Mover::move(std::span<const SectionMove> moves)
{
    for (const SectionMove &move : moves) {
        const int index = m_document.indexOf(move.section);
        if (index < 0)
            return failure(ErrorCode::UnknownReference, std::to_string(move.section.value),
                           {std::to_string(move.section.value)});
        way(index).wanted = &move;
    }
    if (const Result<void> done = carryOut(); !done)
        return tl::unexpected(done.error());
    return std::move(m_document);
}

Result<Document> Mover::stretch(SectionId id, const PlaneMap &map)
{
    m_stretched = m_document.indexOf(id);
    m_stretch = map;
    if (m_stretched < 0)
        return failure(ErrorCode::UnknownReference, std::to_string(id.value),
                       {std::to_string(id.value)});
    if (const Result<void> done = carryOut(); !done)
        return tl::unexpected(done.error());
    return std::move(m_document);
}

} // namespace

Result<Document> movedSections(Document document, std::span<const SectionMove> moves,
                               const MovingRules &rules)
{
    return Mover(std::move(document), rules).move(moves);
}

Result<Document> stretchedSection(Document document, SectionId id, const PlaneMap &map,
                                  const MovingRules &rules)
{
    if (map.isIdentity() && document.find(id))
        return document;
    return Mover(std::move(document), rules).stretch(id, map);
}

Similarity turnToNormal(const Section &section, const Frame *parent, const Vec3 &normal)
{
    const Vec3 now = section.frame.normal();
    const Vec3 wanted = now.dot(normal) < 0.0 ? Vec3(-normal) : normal;
    const Vec3 about = section.parent && parent ? slitMiddle(*section.parent, *parent)
                                                : section.frame.toWorld(section.shape->centroid());
    return turnAbout(Eigen::Quaterniond::FromTwoVectors(now, wanted), about);
}

double angleToParent(const Section &section, const Frame &parent)
{
    const std::optional<Vec3> slit = slitDirection(section, parent);
    if (!slit)
        return 0.0;
    const Vec3 up = parent.normal(), beside = slit->cross(up);
    const Vec3 inPlane = section.frame.normal().cross(*slit);
    const double angle = std::atan2(inPlane.dot(up), inPlane.dot(beside));
    return angle < 0.0 ? angle + std::numbers::pi : angle;
}

Similarity turnToAngle(const Section &section, const Frame &parent, double angle)
{
    const std::optional<Vec3> slit = slitDirection(section, parent);
    const Vec3 axis =
        slit ? *slit
             : parent.directionToWorld(section.parent->slitTo - section.parent->slitFrom)
                   .normalized();
    if (!axis.allFinite())
        return {};
    const double by = angleToParent(section, parent) - angle;
    return turnAbout(Eigen::Quaterniond(Eigen::AngleAxisd(by, axis)),
                     slitMiddle(*section.parent, parent));
}

Result<Document> setFree(Document document, SectionId id, bool isFree)
{
    const int index = document.indexOf(id);
    if (index < 0)
        return failure(ErrorCode::UnknownReference, std::to_string(id.value),
                       {std::to_string(id.value)});
    SectionPointer &place = document.sections[static_cast<std::size_t>(index)];
    if (!place->parent)
        return failure(ErrorCode::BadValue, "parent");
    if (place->parent->isFree == isFree)
        return document;
    Section next = *place;
    next.parent->isFree = isFree;
    place = std::make_shared<const Section>(std::move(next));
    return document;
}

} // namespace fff
