#include "core/analysis/stretching.h"

#include "core/analysis/footing.h"
#include "core/analysis/touching.h"
#include "core/base/tolerances.h"
#include "core/fabrication/summary.h"
#include "core/geometry/convex_hull.h"
#include "core/geometry/stretch.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// Of the cosine of how far a section leans from upright: 60°.
constexpr double kLeastUpright = 0.5;
/// What is stretched gets so many times as long at most.
constexpr double kMostStretched = 2.0;
/// Thicknesses of its sheet that a foot has to lie on the ground with, or it gets a sole.
constexpr double kSole = 3.0;
/// So many of the lowest sections are looked at, and so many stretched at once.
constexpr std::size_t kMostLooked = 32, kMostFeet = 4;

/// A section's plane as seen from the ground.
struct Uprightness
{
    Vec2 up = Vec2::Zero(); // steepest direction in its plane, unit, frame coordinates
    double cosine = 0.0;    // of how far that leans: mm up in the world for a mm along it
    double below = 0.0;     // mm from the mid-plane down to the slab's lower face, straight down
};

std::optional<Uprightness> uprightnessOf(const Section &section, double thickness)
{
    const Vec2 up(section.frame.x.y(), section.frame.y.y());
    if (up.norm() < kLeastUpright)
        return {};
    return Uprightness{up.normalized(), up.norm(),
                       0.5 * thickness * std::abs(section.frame.normal().y())};
}

/// Lowest along `up`; an empty list has none.
std::optional<Vec2> lowest(const Polygon &points, const Vec2 &up)
{
    const auto least =
        std::min_element(points.begin(), points.end(),
                         [&](const Vec2 &a, const Vec2 &b) { return up.dot(a) < up.dot(b); });
    return least == points.end() ? std::nullopt : std::optional(*least);
}

/// Along `up`, from where on the section is held: the lowest point of its slits and of where it
/// meets others. Without any, its centre.
double heldFrom(const Analysis &analysis, int index, const Vec2 &up)
{
    const Section &section = *analysis.model.section(static_cast<std::size_t>(index));
    std::optional<double> held;
    const auto hold = [&](const Vec2 &p) { held = std::min(held.value_or(up.dot(p)), up.dot(p)); };
    for (const Slit &slit : analysis.assembly.slits[static_cast<std::size_t>(index)])
        for (const Polygon &outline : slit.outlines(kCutChord))
            for (const Vec2 &p : outline)
                hold(p);
    for (const Joint &joint : analysis.assembly.joints) {
        if (joint.a != index && joint.b != index)
            continue;
        for (const Overlap &overlap : joint.crossing->overlaps)
            for (const double at : {overlap.from, overlap.to})
                hold(section.frame.toLocal(joint.crossing->axis.at(at)));
    }
    return held.value_or(up.dot(section.shape->centroid()));
}

std::optional<ShapePointer> drawnOut(const Shape &shape, const Halfplane &kept, double factor)
{
    Result<Contour> contour = stretchedOutside(shape.contour(), kept, factor);
    std::vector<Contour> holes;
    for (const Contour &hole : shape.holes()) {
        Result<Contour> next = stretchedOutside(hole, kept, factor);
        if (!next)
            return {};
        holes.push_back(*std::move(next));
    }
    if (!contour)
        return {};
    Result<ShapePointer> made = Shape::make(*std::move(contour), std::move(holes));
    return made ? std::optional(*std::move(made)) : std::nullopt;
}

/// How long what lies on the ground is, mm.
double soleOf(const Shape &shape, const Vec2 &up, double ground)
{
    double from = std::numeric_limits<double>::infinity(), to = -from;
    for (const Vec2 &p : shape.region().outer) {
        if (up.dot(p) > ground + kGroundContact)
            continue;
        from = std::min(from, cross(up, p));
        to = std::max(to, cross(up, p));
    }
    return to - from;
}

/// What lies above; nothing where that is several pieces, or has lost a hole.
std::optional<ShapePointer> cutAt(const Halfplane &ground, const Shape &shape)
{
    Result<std::vector<ClippedPiece>> pieces = clip(shape.contour(), shape.holes(), ground);
    if (!pieces || pieces->size() != 1 || pieces->front().holes.size() != shape.holes().size())
        return {};
    Result<ShapePointer> made =
        Shape::make(std::move(pieces->front().outer), std::move(pieces->front().holes));
    return made ? std::optional(*std::move(made)) : std::nullopt;
}

/// With these sections stretched.
std::optional<Document> stretched(const Analysis &analysis, const std::vector<HighFoot> &feet)
{
    Document document = analysis.model.document;
    for (const HighFoot &foot : feet) {
        const int index = analysis.model.indexOf(foot.section);
        std::optional<ShapePointer> shape;
        if (index >= 0)
            shape = stretchedToGround(analysis, index);
        if (!shape)
            return {};
        Result<Document> next =
            setShape(std::move(document), foot.section.drawn, *std::move(shape));
        if (!next)
            return {};
        document = *std::move(next);
    }
    return document;
}

bool joinTheSame(const JointList &before, const JointList &after)
{
    return std::equal(before.begin(), before.end(), after.begin(), after.end(),
                      [](const Joint &a, const Joint &b) {
                          return a.a == b.a && a.b == b.b && a.kind == b.kind &&
                                 a.crossing->overlaps.size() == b.crossing->overlaps.size();
                      });
}

/// Whether the section touches one that it did not touch before.
bool comesUponOthers(int index, const Analysis &before, const Analysis &next)
{
    const auto boxOf = [&](int section) {
        const auto at = static_cast<std::size_t>(section);
        return slabBounds(*next.model.section(at), next.model.stockOf(at));
    };
    const Box3 own = boxOf(index);
    for (int other = 0; other < static_cast<int>(next.model.sectionCount()); ++other)
        if (other != index && distanceBetween(own, boxOf(other)) <= kTouchingDepth &&
            touchLoosely(next.model, next.assembly.joints, index, other) &&
            !touchLoosely(before.model, before.assembly.joints, index, other))
            return true;
    return false;
}

/// A section that can be stretched.
struct Candidate
{
    HighFoot foot;
    GroundContact contact; // once it is
};

class Search
{
public:
    Search(const Analysis &analysis, const std::vector<int> &group)
        : m_analysis(analysis), m_group(group), m_before(asDrawn(analysis, group)),
          m_centre(centreOf(analysis, group))
    {
    }

    std::vector<HighFoot> find() const
    {
        const std::vector<Candidate> all = candidates();
        for (const Candidate &one : all)
            if (mayStand({one.contact.corners}) && stands({one.foot}))
                return {one.foot};
        std::vector<HighFoot> feet;
        std::vector<std::vector<Vec2>> corners;
        for (const Candidate &one : all) {
            feet.push_back(one.foot);
            corners.push_back(one.contact.corners);
            if (feet.size() > kMostFeet)
                break;
            if (feet.size() < 2 || !mayStand(corners))
                continue;
            dropNeedless(feet, corners);
            if (stands(feet))
                return feet;
            break; // more of them are in more sections' way
        }
        return {};
    }

private:
    static Vec2 centreOf(const Analysis &analysis, const std::vector<int> &group)
    {
        const Vec3 centre = loadedMass(analysis, group).centre;
        return {centre.x(), centre.z()};
    }

    /// The lowest first.
    std::vector<Candidate> candidates() const
    {
        const Model &model = m_analysis.model;
        std::vector<std::pair<double, int>> heights;
        for (const int index : sectionsOf(m_analysis.bodies, m_group)) {
            const Section &section = *model.section(static_cast<std::size_t>(index));
            if (const double height = slabBounds(section, model.document.stockOf(section)).min.y();
                height > kGroundContact)
                heights.emplace_back(height, index);
        }
        std::sort(heights.begin(), heights.end());
        heights.resize(std::min(heights.size(), kMostLooked));
        std::vector<Candidate> all;
        for (const auto &[height, index] : heights) {
            const std::optional<ShapePointer> shape = stretchedToGround(m_analysis, index);
            if (!shape)
                continue;
            const Section &section = *model.section(static_cast<std::size_t>(index));
            const double thickness = model.document.stockOf(section).thickness;
            const Slab before{section.shape->region(), section.frame, thickness};
            all.push_back({{model.ref(static_cast<std::size_t>(index)), height,
                            contactOf(before).lowestPoint},
                           contactOf({(*shape)->region(), section.frame, thickness})});
        }
        return all;
    }

    /// Whether the centre of mass, as it is before, would lie above the feet.
    bool mayStand(const std::vector<std::vector<Vec2>> &corners) const
    {
        std::vector<Vec2> all = m_before.support;
        for (const std::vector<Vec2> &more : corners)
            all.insert(all.end(), more.begin(), more.end());
        const Polygon hull = convexHull(all);
        return hull.size() >= 3 && signedDistance(hull, m_centre) > 0.0;
    }

    void dropNeedless(std::vector<HighFoot> &feet, std::vector<std::vector<Vec2>> &corners) const
    {
        for (std::size_t i = 0; i < feet.size() && feet.size() > 2;) {
            std::vector<std::vector<Vec2>> others = corners;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
            if (mayStand(others)) {
                corners = std::move(others);
                feet.erase(feet.begin() + static_cast<std::ptrdiff_t>(i));
            } else {
                ++i;
            }
        }
    }

    bool stands(const std::vector<HighFoot> &feet) const
    {
        return standingOn(m_analysis, m_group, feet).has_value();
    }

    const Analysis &m_analysis;
    const std::vector<int> &m_group;
    Stability m_before;
    Vec2 m_centre; // (x, z), of mass
};

} // namespace

std::optional<ShapePointer> stretchedToGround(const Analysis &analysis, int section)
{
    const Model &model = analysis.model;
    const auto index = static_cast<std::size_t>(section);
    const Section &own = *model.section(index);
    const double thickness = model.stockOf(index).thickness;
    const std::optional<Uprightness> plane = uprightnessOf(own, thickness);
    const std::optional<Vec2> foot =
        plane ? lowest(own.shape->region().outer, plane->up) : std::nullopt;
    if (!foot || !model.ref(index).drawn.isValid())
        return {};
    const double height = own.frame.toWorld(*foot).y() - plane->below;
    if (height <= kGroundContact)
        return {};
    const double level = heldFrom(analysis, section, plane->up) - thickness;
    const double length = level - plane->up.dot(*foot);
    const double factor = 1.0 + height / plane->cosine / length;
    if (length <= 0.0 || factor > kMostStretched)
        return {};
    const Halfplane kept{level * plane->up, plane->up};
    const std::optional<ShapePointer> shape = drawnOut(*own.shape, kept, factor);
    const double ground = plane->up.dot(*foot) - height / plane->cosine;
    if (!shape || soleOf(**shape, plane->up, ground) >= kSole * thickness)
        return shape;
    const double withSole = factor + thickness / length;
    const std::optional<ShapePointer> longer =
        withSole > kMostStretched ? std::nullopt : drawnOut(*own.shape, kept, withSole);
    const std::optional<ShapePointer> soled =
        longer ? cutAt({ground * plane->up, plane->up}, **longer) : std::nullopt;
    return soled ? soled : shape;
}

std::vector<HighFoot> feetToStretch(const Analysis &analysis, const std::vector<int> &group)
{
    return Search(analysis, group).find();
}

std::optional<Document> standingOn(const Analysis &analysis, const std::vector<int> &group,
                                   const std::vector<HighFoot> &feet)
{
    if (feet.empty())
        return {};
    std::optional<Document> document = stretched(analysis, feet);
    if (!document)
        return {};
    AnalysisCaches caches;
    caches.last = AnalysisPointer(AnalysisPointer(), &analysis); // it outlives them
    const Analysis next = analyse(evaluate(*document, analysis.model), caches);
    const int first = analysis.bodies.sectionOf(group.front());
    const Stability then = stabilityOf(next, groupOf(next, first));
    if (then.standing != Standing::Stands || std::max(then.lean, then.rocking) > kPlainLean ||
        !joinTheSame(analysis.assembly.joints, next.assembly.joints) ||
        std::any_of(feet.begin(), feet.end(), [&](const HighFoot &foot) {
            return comesUponOthers(analysis.model.indexOf(foot.section), analysis, next);
        }))
        return {};
    return document;
}

} // namespace fff
