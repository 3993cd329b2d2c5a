#include "core/analysis/findings/broader_base.h"

#include "core/analysis/findings/pushed_over.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/upright_stand.h"
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/convex_hull.h"
#include "core/model/edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace fff {

namespace {

//: %1 is the name of a section
constexpr Text kWidenStep = FFF_TEXT("Step", "Widen the base of %1");
//: %1 is the name of a section
constexpr Text kFootStep = FFF_TEXT("Step", "Add a foot to %1");

/// A toe, and a foot, are so many thicknesses high at their root, and at their end.
constexpr double kRootHeight = 5.0, kEndHeight = 2.0;
/// To each side of a foot across it the pad of what is too narrow for one is so many times as long
/// as it is high.
constexpr double kPadWidth = 1.4;
/// A foot goes on so far beyond the section that it is across, in thicknesses, at least.
constexpr double kLeastFoot = 6.0;
/// What stands beside another one is a little more than just beside it.
constexpr double kBeside = 1.01;
/// What is left of a foot to each side of a slit in it, in thicknesses.
constexpr double kWall = 2.0;
/// Farther than this nobody wants a foot to reach, mm.
constexpr double kLongest = 400.0;
/// By so much what is stretched stands more firmly than it has to.
constexpr double kFirmly = 1.2;

/// Of the sections that the finding is about.
std::vector<UprightStand> standsOf(const Finding &finding, const Analysis &analysis)
{
    std::vector<UprightStand> stands;
    const int count = static_cast<int>(analysis.model.sectionCount());
    for (int section = 0; section < count; ++section) {
        const SectionRef ref = analysis.model.ref(static_cast<std::size_t>(section));
        const auto &about = finding.sections;
        if (!about.empty() && std::find(about.begin(), about.end(), ref) == about.end())
            continue;
        const auto stand = uprightStandOf(analysis.model, section);
        if (stand && stand->isOnGround())
            stands.push_back(*stand);
    }
    return stands;
}

/// Where what acts on the model meets the ground, (x, z), and how far beside that it takes a foot.
struct Need
{
    Vec2 centre = Vec2::Zero();
    double reach = 0.0;   // mm
    Polygon support = {}; // hull of the feet

    /// How far it is inside of the feet, these among them, mm.
    double marginWith(const std::vector<Vec2> &feet) const
    {
        std::vector<Vec2> all = support;
        all.insert(all.end(), feet.begin(), feet.end());
        return signedDistance(convexHull(all), centre);
    }
};

/// Of what falls by itself, below its centre of mass; of what is pushed over, where the push and
/// all weights together meet the ground.
Need needOf(const Finding &finding)
{
    if (const auto *pushed = finding.details<PushedOver>())
        return {pushed->onGround, (kFirmly - 1.0) * (pushed->onGround - pushed->centre).norm(),
                pushed->support};
    const Footing &footing = *finding.details<Footing>();
    const Vec3 &centre = footing.mass.centre;
    return {Vec2(centre.x(), centre.z()), kFirmly * centre.y() * std::tan(kSteadyTilt),
            footing.support};
}

std::optional<FindingEdit> widened(const FindingAction &, const Finding &finding,
                                   const Analysis &analysis, const Flips *)
{
    const Need need = needOf(finding);
    std::optional<FindingEdit> best;
    double shortest = kLongest;
    for (const UprightStand &stand : standsOf(finding, analysis)) {
        const auto index = static_cast<std::size_t>(stand.section);
        const Section &section = *analysis.model.section(index);
        const double thickness = analysis.model.stockOf(index).thickness;
        const double centre = stand.along.dot(need.centre - stand.origin);
        const double before = stand.from - (centre - need.reach);
        const double behind = centre + need.reach - stand.to;
        const bool isBehind = behind > before;
        const double by = std::max(before, behind);
        if (by <= 0.0 || by >= shortest)
            continue;
        const double sign = isBehind ? 1.0 : -1.0, end = isBehind ? stand.to : stand.from;
        // It does not fall that way.
        if (need.marginWith({stand.at(end + sign * by)}) <= need.marginWith({}))
            continue;
        const double root = kRootHeight * thickness, tip = kEndHeight * thickness;
        // From inside of the section, so that the two are one.
        const double inside = std::min(root, stand.to - stand.from);
        Polygon toe{onPlane(section, stand, end - sign * inside, 0.0),
                    onPlane(section, stand, end + sign * by, 0.0),
                    onPlane(section, stand, end + sign * by, tip),
                    onPlane(section, stand, end, root),
                    onPlane(section, stand, end - sign * inside, root)};
        if (signedArea(toe) < 0.0)
            std::reverse(toe.begin(), toe.end());
        const auto all = windingRegions({section.shape->contour(), Contour::ofPolygon(toe)},
                                        WindingRule::Positive, kCutChord);
        if (!all || all->size() != 1)
            continue;
        Result<ShapePointer> shape = Shape::make(all->front().outer, section.shape->holes());
        if (!shape)
            continue;
        Result<Document> next = setShape(analysis.model.document, section.id, *std::move(shape));
        if (!next)
            continue;
        shortest = by;
        best = FindingEdit{Step(kWidenStep, {Named{section.name}}), *std::move(next)};
    }
    return best;
}

/// Along the stand, nearest to s where a foot across it is in nobody's way: `margin` from its ends
/// and from slits that are as low as the foot. Nothing where there is no room.
std::optional<double> freePlace(const Analysis &analysis, const UprightStand &stand, double s,
                                double margin)
{
    const auto index = static_cast<std::size_t>(stand.section);
    const Frame &frame = analysis.model.section(index)->frame;
    std::vector<double> taken;
    for (const Slit &slit : analysis.assembly.slits[index])
        for (const Vec3 &at : {frame.toWorld(slit.inner), frame.toWorld(slit.mouth)})
            if (at.y() < 2.0 * margin)
                taken.push_back(stand.placeOf(at));
    std::vector<double> places{std::clamp(s, stand.from + margin, stand.to - margin)};
    for (const double at : taken)
        places.insert(places.end(), {at - kBeside * margin, at + kBeside * margin});
    std::erase_if(places, [&](double place) {
        return place < stand.from + margin || place > stand.to - margin ||
               std::any_of(taken.begin(), taken.end(),
                           [&](double at) { return std::abs(place - at) < margin; });
    });
    const auto nearest = std::min_element(places.begin(), places.end(), [&](double a, double b) {
        return std::abs(a - s) < std::abs(b - s);
    });
    return nearest == places.end() ? std::nullopt : std::optional(*nearest);
}

/// One half of a foot, mm from where it stands: its end, and how far it is as high as at its root.
struct HalfFoot
{
    double end = 0.0, root = 0.0;

    /// Through what stands there, and beyond it, with walls to both sides of that slit: a foot that
    /// ends in it would be cut to nothing.
    void passThrough(double place, double thickness)
    {
        if (place >= end + kWall * thickness)
            return;
        root = std::max(root, place + kWall * thickness);
        end = std::max(end, place + kRootHeight * thickness);
    }
};

/// x along it from where it stands, y upwards.
Result<ShapePointer> footShape(const HalfFoot &left, const HalfFoot &right, double thickness)
{
    const double root = kRootHeight * thickness, tip = kEndHeight * thickness;
    return Shape::make(Contour::ofPolygon({{-left.end, 0.0},
                                           {right.end, 0.0},
                                           {right.end, tip},
                                           {right.root, root},
                                           {-left.root, root},
                                           {-left.end, tip}}));
}

/// Where other sections stand across the line of a foot: mm along that from its middle, the nearest
/// first.
std::vector<double> standingAcross(const Analysis &analysis, const UprightStand &stand,
                                   const Vec2 &middle, const Vec2 &along)
{
    std::vector<double> places;
    const int count = static_cast<int>(analysis.model.sectionCount());
    for (int section = 0; section < count; ++section) {
        const auto other =
            section == stand.section ? std::nullopt : uprightStandOf(analysis.model, section);
        if (!other || !other->isOnGround())
            continue;
        const double sine = cross(along, other->along);
        if (std::abs(sine) < kPracticallyParallel)
            continue;
        const Vec2 way = other->origin - middle;
        const double onOther = cross(way, along) / sine;
        const double slack =
            kWall * analysis.model.stockOf(static_cast<std::size_t>(section)).thickness;
        if (onOther > other->from - slack && onOther < other->to + slack)
            places.push_back(cross(way, other->along) / sine);
    }
    std::sort(places.begin(), places.end(),
              [](double a, double b) { return std::abs(a) < std::abs(b); });
    return places;
}

/// The section with a pad on the ground below it, in its plane, wide enough for a foot across it: s
/// is where. Errors  EmptyContour where the pad would stand apart.
Result<ShapePointer> withPad(const Section &section, const UprightStand &stand, double s,
                             double thickness)
{
    const double root = kRootHeight * thickness, tip = kEndHeight * thickness;
    const double half = kPadWidth * root;
    Polygon pad{onPlane(section, stand, s - half, 0.0),  onPlane(section, stand, s + half, 0.0),
                onPlane(section, stand, s + half, tip),  onPlane(section, stand, s + root, root),
                onPlane(section, stand, s - root, root), onPlane(section, stand, s - half, tip)};
    if (signedArea(pad) < 0.0)
        std::reverse(pad.begin(), pad.end());
    const auto all = windingRegions({section.shape->contour(), Contour::ofPolygon(pad)},
                                    WindingRule::Positive, kCutChord);
    if (!all || all->size() != 1)
        return failure(ErrorCode::EmptyContour);
    return Shape::make(all->front().outer, section.shape->holes());
}

std::optional<FindingEdit> footAdded(const FindingAction &, const Finding &finding,
                                     const Analysis &analysis, const Flips *)
{
    const Need need = needOf(finding);
    const std::vector<UprightStand> stands = standsOf(finding, analysis);
    std::optional<FindingEdit> best;
    double shortest = kLongest;
    for (const UprightStand &stand : stands) {
        const auto index = static_cast<std::size_t>(stand.section);
        const Section &section = *analysis.model.section(index);
        const double thickness = analysis.model.stockOf(index).thickness;
        const double margin = kRootHeight * thickness;
        // No room for a slit with two walls.
        const bool isNarrow = stand.to - stand.from < 2.0 * margin;
        const Vec2 across(-stand.along.y(), stand.along.x());
        const double beside = across.dot(need.centre - stand.origin);
        const double below = stand.along.dot(need.centre - stand.origin);
        const std::optional<double> s = isNarrow ? std::optional(0.5 * (stand.from + stand.to))
                                                 : freePlace(analysis, stand, below, margin);
        if (!s)
            continue;
        const double reach = std::max(kLeastFoot * thickness, need.reach);
        const Vec2 at = stand.at(*s);
        HalfFoot leftHalf{std::max(reach, reach - beside), margin},
            rightHalf{std::max(reach, reach + beside), margin};
        for (const double place : standingAcross(analysis, stand, at, across))
            (place < 0.0 ? leftHalf : rightHalf).passThrough(std::abs(place), thickness);
        const double left = leftHalf.end, right = rightHalf.end;
        std::vector<Vec2> feet{at - left * across, at + right * across};
        if (isNarrow) // what stands on a point has no side
            for (const double sign : {-1.0, 1.0})
                feet.push_back(stand.at(*s + sign * kPadWidth * kRootHeight * thickness));
        if (left + right >= shortest || need.marginWith(feet) <= need.marginWith({}))
            continue;
        Result<ShapePointer> shape = footShape(leftHalf, rightHalf, thickness);
        if (!shape)
            continue;
        NewSection foot;
        foot.shape = *std::move(shape);
        foot.frame = {Vec3(at.x(), 0.0, at.y()), Vec3(across.x(), 0.0, across.y()), Vec3::UnitY()};
        foot.stock = section.stock;
        foot.parent = Parent{section.ref(), onPlane(section, stand, *s, 0.0),
                             onPlane(section, stand, *s, margin)};
        Result<Document> next = analysis.model.document;
        if (isNarrow) {
            Result<ShapePointer> padded = withPad(section, stand, *s, thickness);
            if (!padded)
                continue;
            next = setShape(*std::move(next), section.id, *std::move(padded));
        }
        if (next)
            next = addSection(*std::move(next), std::move(foot));
        if (!next)
            continue;
        shortest = left + right;
        best = FindingEdit{Step(kFootStep, {Named{section.name}}), *std::move(next)};
    }
    return best;
}

constexpr Text kWidenText = FFF_TEXT("Checks", "Widen the base");
constexpr Text kFootText = FFF_TEXT("Checks", "Add a foot");

} // namespace

const ActionKind kWidenBase{plainWords<kWidenText>, widened};
const ActionKind kAddFoot{plainWords<kFootText>, footAdded};

} // namespace fff
