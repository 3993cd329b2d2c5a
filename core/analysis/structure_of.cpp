#include "core/analysis/structure_of.h"

#include "core/analysis/footing.h"
#include "core/analysis/load_points.h"
#include "core/assembly/rings_near.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace fff {

namespace {

constexpr double kUsualModulus = 3000.0; // MPa, of plywood and acrylic about

const Slit *slitAt(const Analysis &analysis, int section, const Joint &joint, int overlap)
{
    for (const Slit &slit :
         slitsOfJoint(analysis.assembly.slits[static_cast<std::size_t>(section)], joint.id))
        if (slit.role == SlitRole::Slit && slit.overlap == overlap && slit.inner != slit.mouth)
            return &slit;
    return nullptr;
}

/// One of the two sections of a joint at one of its overlaps.
struct LinkSide
{
    int section = 0;
    const Slit *slit = nullptr;
    const Section *placed = nullptr;
    const CutSection *cut = nullptr;
    const Stock *stock = nullptr;
};

LinkSide sideOf(const Analysis &analysis, const Joint &joint, int section, int overlap)
{
    const auto index = static_cast<std::size_t>(section);
    return {section, slitAt(analysis, section, joint, overlap), analysis.model.section(index).get(),
            analysis.cuts[index].get(), &analysis.model.stockOf(index)};
}

/// Whether a piece is what one of the two slits holds, or is held by: its material stands beside
/// the walls of its own slit, or, without one, in the other's.
bool isPieceAt(const CurvedRegion &piece, const LinkSide &side, const Overlap &overlap,
               const Axis &axis)
{
    constexpr std::array kShares{0.5, 0.1, 0.9, 0.3, 0.7};
    for (const double share : kShares) {
        const Vec2 at =
            side.placed->frame.toLocal(axis.at(overlap.from + share * (overlap.to - overlap.from)));
        if (!side.slit) {
            if (locate(at, piece.region) == Side::Inside)
                return true;
            continue;
        }
        const Vec2 way = (side.slit->mouth - side.slit->inner).normalized();
        const Vec2 beside = (0.5 * side.slit->width + kGripWall) * perpendicular(way);
        if (locate(at + beside, piece.region) == Side::Inside &&
            locate(at - beside, piece.region) == Side::Inside)
            return true;
    }
    return false;
}

std::optional<Grip> gripAt(const JointGrips &grips, const LinkSide &a, const LinkSide &b,
                           const Overlap &overlap, const Axis &axis)
{
    if (grips.held.size() == 1)
        return grips.held.front();
    for (const Grip &grip : grips.held)
        if (isPieceAt(a.cut->parts()[static_cast<std::size_t>(grip.a)], a, overlap, axis) &&
            isPieceAt(b.cut->parts()[static_cast<std::size_t>(grip.b)], b, overlap, axis))
            return grip;
    return {};
}

/// How deep both walls of a slit are, no deeper than what is in it, mm: where the outline is round,
/// they end before its middle does. Of a slit with one wall that one.
double wallDepth(const LinkSide &side, double depth)
{
    const Slit &slit = *side.slit;
    const Vec2 way = (slit.mouth - slit.inner).normalized();
    std::array<double, 2> ends{};
    for (const std::size_t wall : {0U, 1U}) {
        const double beside = (wall == 0 ? 1.0 : -1.0) * (0.5 * slit.width + kGripWall);
        const PlaneLine line{slit.inner + beside * perpendicular(way), way};
        double longest = 0.0;
        for (std::size_t i = 0; i < side.cut->parts().size(); ++i) {
            const RingsNear near(
                line, side.cut->parts()[i].region,
                [&]() -> const RegionTree & { return side.cut->trees()[i]; }, 0.0);
            for (const Interval &interval : intervalsOn(line, near.region())) {
                const double from = std::max(0.0, interval.from.at);
                const double to = std::min(depth, interval.to.at);
                if (to - from > longest) {
                    longest = to - from;
                    ends[wall] = to;
                }
            }
        }
    }
    const auto [least, most] = std::minmax(ends[0], ends[1]);
    return least > 0.0 ? least : most > 0.0 ? most : depth;
}

/// The slit as far as the other section is in it, or a point.
SlitLine lineOf(const LinkSide &side, const Vec3 &point, double depth)
{
    SlitLine line;
    line.root = side.placed->frame.toLocal(point);
    if (!side.slit)
        return line;
    line.opening = (side.slit->mouth - side.slit->inner).normalized();
    line.width = side.slit->width;
    if (side.slit->isOpen) {
        line.root = side.slit->inner;
        line.depth = wallDepth(side, depth);
    }
    return line;
}

Vec3 wayOf(const LinkSide &side)
{
    return side.placed->frame.directionToWorld((side.slit->mouth - side.slit->inner).normalized());
}

/// In which the guest of a mortise, or with tabs, comes out of its host; of a mortise, one of both.
Vec3 wayOut(const Analysis &analysis, const Joint &joint, const LinkSide &guest)
{
    const Vec3 through =
        guest.placed->frame.normal().cross(joint.crossing->axis.direction).normalized();
    for (const Slit &slit :
         slitsOfJoint(analysis.assembly.slits[static_cast<std::size_t>(guest.section)], joint.id))
        if (slit.role == SlitRole::Tab)
            return through.dot(guest.placed->frame.directionToWorld(slit.inner - slit.mouth)) > 0.0
                       ? through
                       : Vec3(-through);
    return through;
}

/// Of a sheet with fingers: away from the other one, which goes on from their edge that way. There
/// nothing but friction keeps it.
Vec3 outwards(const Vec3 &normal, const Vec3 &otherWay)
{
    return normal.dot(otherWay) > 0.0 ? Vec3(-normal) : normal;
}

void addLink(const Analysis &analysis, const Joint &joint, int index, ModelStructure &made)
{
    const Overlap &overlap = joint.crossing->overlaps[static_cast<std::size_t>(index)];
    const Axis &axis = joint.crossing->axis;
    const LinkSide a = sideOf(analysis, joint, joint.a, index),
                   b = sideOf(analysis, joint, joint.b, index);
    if (!a.slit && !b.slit && joint.kind != JointKind::Tabs) // of tabs: fingers of both
        return;
    const auto grip = gripAt(analysis.grips.of(joint), a, b, overlap, axis);
    if (!grip)
        return;
    Link link;
    link.a = analysis.bodies.firstOf(joint.a) + grip->a;
    link.b = analysis.bodies.firstOf(joint.b) + grip->b;
    link.normalA = a.placed->frame.normal();
    link.normalB = b.placed->frame.normal();
    link.thicknessA = a.stock->thickness;
    link.thicknessB = b.stock->thickness;
    link.modulusA = modulusOf(*a.stock);
    link.modulusB = modulusOf(*b.stock);
    link.isTight = (a.slit ? a : b).stock->clearance <= 0.0;
    LinkPlace place{joint.id, index, {}, joint.kind == JointKind::Mortise};
    if (slidesAlongAxis(joint.kind)) {
        const double meet = std::clamp(overlap.meet, overlap.from, overlap.to);
        link.kind = LinkKind::Slits;
        link.point = axis.at(meet);
        link.axis = a.slit ? wayOf(a) : Vec3(-wayOf(b));
        const bool isUp = link.axis.dot(axis.direction) > 0.0;
        const double above = overlap.to - meet, below = meet - overlap.from;
        link.depthA = a.slit ? (isUp ? above : below) : 0.0;
        link.depthB = b.slit ? (isUp ? below : above) : 0.0;
    } else if (!a.slit && !b.slit) {
        link.kind = LinkKind::Fingers;
        link.point = axis.at(0.5 * (overlap.from + overlap.to));
        link.axis = -outwards(link.normalA, wayOut(analysis, joint, b));
        link.depthA = link.depthB = overlap.to - overlap.from;
        place.slits = {lineOf(a, link.point, link.depthA), lineOf(b, link.point, link.depthB)};
        made.structure.links.push_back(link);
        made.links.push_back(place);
        link.axis = outwards(link.normalB, wayOut(analysis, joint, a));
    } else {
        const bool isHostA = a.slit != nullptr;
        const Vec3 out = wayOut(analysis, joint, isHostA ? b : a);
        link.kind = LinkKind::Slot;
        link.point = axis.at(0.5 * (overlap.from + overlap.to));
        link.axis = isHostA ? out : Vec3(-out);
        link.depthA = link.depthB = overlap.to - overlap.from;
    }
    place.slits = {lineOf(a, link.point, link.depthA), lineOf(b, link.point, link.depthB)};
    made.structure.links.push_back(link);
    made.links.push_back(place);
}

/// mm above the ground, of the corners of a box.
double lowestOf(const Box3 &box, const Ground &ground)
{
    const Vec3 centre = 0.5 * (box.min + box.max), half = 0.5 * (box.max - box.min);
    return ground.above(centre) - ground.up.cwiseAbs().dot(half);
}

/// Whether some of it may touch the ground.
bool isLowEnough(const Bodies &bodies, const std::vector<int> &group)
{
    return std::any_of(group.begin(), group.end(), [&](int body) {
        return bodies.at(body).contact().lowest <= kGroundSunk;
    });
}

/// Of each group that stands by itself. The only one leans as it will on the table.
void addFeet(const Analysis &analysis, Structure &structure)
{
    const Bodies &bodies = analysis.bodies;
    const auto groups = heldGroups(bodies, analysis.assembly.joints, analysis.grips);
    for (const std::vector<int> &group : groups) {
        if (!isLowEnough(analysis.bodies, group))
            continue; // of thousands of chips in the air none has to be weighed
        const Stability stands = stabilityOf(analysis, group);
        if (stands.contacts == 0)
            continue;
        const Ground &ground = stands.ground;
        if (groups.size() == 1 && stands.lean > 0.0) {
            structure.gravity = -structure.gravity.norm() * ground.up;
            structure.up = ground.up;
        }
        for (const int body : group) {
            if (lowestOf(bodies.at(body).box(), ground) > kGroundContact)
                continue;
            const Stock &stock =
                analysis.model.stockOf(static_cast<std::size_t>(bodies.sectionOf(body)));
            for (const Vec3 &point : feetOf(bodies.at(body).slab(), ground))
                structure.feet.push_back({body, point, modulusOf(stock) * stock.thickness, false});
        }
    }
}

/// Of a body with many vertices by its tree: a spine has a slit for each of its ribs.
Side sideOf(const Vec2 &point, const Body &body)
{
    constexpr std::size_t kMany = 64;
    const Region &region = body.outline().region;
    return region.outer.size() < kMany ? locate(point, region)
                                       : body.cut()->trees()[body.piece()].locate(point);
}

/// In the world, N.
Vec3 forceOf(const Load &load, const PlacedLoad &placed, const Frame &frame, const Vec3 &gravity)
{
    if (!load.isPush())
        return load.mass * gravity;
    return placed.push.x() * frame.x + placed.push.y() * frame.y + placed.push.z() * frame.normal();
}

void addLoads(const Analysis &analysis, ModelStructure &made)
{
    const Bodies &bodies = analysis.bodies;
    for (const PlacedLoad &placed : placedLoads(analysis.model)) {
        if (bodies.countOf(placed.section) == 0)
            continue;
        const Load &load = analysis.model.document.loads[static_cast<std::size_t>(placed.load)];
        const int body = bodyAt(bodies, placed.section, placed.position);
        const Region &region = bodies.at(body).outline().region;
        if (locate(placed.position, region) == Side::Outside)
            made.besideLoads.push_back(placed);
        const Frame &frame = bodies.at(body).frame();
        const Vec3 force = forceOf(load, placed, frame, made.structure.gravity);
        (load.isPush() ? made.pushes : made.weights) += load.isPush() ? force.norm() : load.mass;
        for (const LoadPoint &point : loadPoints(load, placed.position, region)) {
            if (load.isPush())
                made.pushLoads.push_back(static_cast<int>(made.structure.loads.size()));
            made.structure.loads.push_back(
                {body, frame.toWorld(point.at), point.share * force, Vec3::Zero()});
        }
    }
}

} // namespace

ModelStructure structureOf(const Analysis &analysis)
{
    ModelStructure made;
    Structure &structure = made.structure;
    Box3 box;
    structure.thickness = std::numeric_limits<double>::infinity();
    for (const Body &body : analysis.bodies) {
        structure.members.push_back({body.mass().mass, body.mass().centre});
        structure.thickness = std::min(structure.thickness, body.thickness());
        box.extend(body.box());
    }
    if (structure.members.empty())
        structure.thickness = Structure().thickness;
    else
        structure.size = std::max(box.size().maxCoeff(), kMinOverlap);
    for (const Joint &joint : analysis.assembly.joints) {
        if (joint.kind == JointKind::None || analysis.grips.of(joint).held.empty())
            continue;
        for (std::size_t i = 0; i < joint.crossing->overlaps.size(); ++i)
            addLink(analysis, joint, static_cast<int>(i), made);
    }
    addFeet(analysis, structure);
    addLoads(analysis, made);
    return made;
}

double modulusOf(const Stock &stock)
{
    return stock.modulus.value_or(kUsualModulus);
}

Vec3 inFrame(const Frame &frame, const Vec3 &v)
{
    return {frame.x.dot(v), frame.y.dot(v), frame.normal().dot(v)};
}

std::vector<SlitLine> slitsOf(const Analysis &analysis, int body)
{
    const int section = analysis.bodies.sectionOf(body);
    const Shape &shape = *analysis.model.section(static_cast<std::size_t>(section))->shape;
    std::vector<SlitLine> lines;
    for (const Slit &slit : analysis.assembly.slits[static_cast<std::size_t>(section)]) {
        if (slit.role != SlitRole::Slit || !slit.isOpen || slit.inner == slit.mouth)
            continue;
        const Vec2 way = (slit.mouth - slit.inner).normalized();
        if (sideOf(slit.bottom() - kGripWall * way, analysis.bodies.at(body)) != Side::Inside)
            continue;
        // The mouth lies beyond the contour: as deep as there is material beside it.
        double depth = (slit.mouth - slit.inner).norm();
        const PlaneLine axis{slit.inner, way};
        const RingsNear near(axis, shape, 0.0);
        for (const Interval &interval : intervalsOn(axis, near.region()))
            if (interval.from.at <= kMinOverlap && interval.to.at > kMinOverlap)
                depth = std::min(depth, interval.to.at);
        lines.push_back({slit.inner, way, depth, slit.width});
    }
    return lines;
}

} // namespace fff
