#include "core/analysis/findings/second_foot.h"

#include "core/analysis/findings/drawn_source.h"
#include "core/analysis/findings/strength_judge.h"
#include "core/analysis/findings/upright_stand.h"
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/model/edits.h"
#include "core/model/placed_loads.h"
#include "core/model/symmetric_section.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

//: %1 is the name of a section
constexpr Text kLegStep = FFF_TEXT("Step", "Support %1 with a foot");
constexpr Text kLegText = FFF_TEXT("Checks", "Support it with a foot");

/// A leg is so many thicknesses of its sheet wide, and where it meets the section it widens by so
/// many more to both sides.
constexpr double kLegWidth = 4.0, kLegFlare = 2.0;
/// A leg shorter than so many thicknesses is none.
constexpr double kShortestLeg = 2.0;
/// Of the section over a leg, the share that the leg goes into to be one with it.
constexpr double kIntoSection = 0.4;
/// Handles of a quarter of a circle, in radii.
constexpr double kQuarterHandle = 0.5523;

/// What of a section is over a place of its line on the ground: the lowest stretch, mm.
struct Over
{
    double from = 0.0, to = 0.0;
};

/// Nothing where the section is nowhere over it.
std::optional<Over> overGround(const Section &section, const UprightStand &stand, double s)
{
    std::vector<double> heights;
    const auto addRing = [&](const Polygon &ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec3 p = section.frame.toWorld(ring[i]);
            const Vec3 q = section.frame.toWorld(ring[(i + 1) % ring.size()]);
            const double a = stand.placeOf(p) - s, b = stand.placeOf(q) - s;
            if ((a < 0.0) != (b < 0.0))
                heights.push_back(p.y() + a / (a - b) * (q.y() - p.y()));
        }
    };
    addRing(section.shape->region().outer);
    for (const Polygon &hole : section.shape->region().holes)
        addRing(hole);
    if (heights.size() < 2)
        return {};
    std::sort(heights.begin(), heights.end());
    return Over{heights[0], heights[1]};
}

/// From the ground into the section, wider towards it. Nothing where that is not over all of it.
std::optional<Contour> legAt(const Section &section, const UprightStand &stand, double s,
                             double thickness)
{
    const double half = 0.5 * kLegWidth * thickness, flare = kLegFlare * thickness;
    const auto over = overGround(section, stand, s);
    const auto left = overGround(section, stand, s - half - flare);
    const auto right = overGround(section, stand, s + half + flare);
    if (!over || !left || !right)
        return {};
    if (std::min({over->from, left->from, right->from}) < kShortestLeg * thickness + flare)
        return {};
    const auto at = [&](double along, double height) {
        return onPlane(section, stand, s + along, height);
    };
    const auto into = [](const Over &stretch) {
        return stretch.from + kIntoSection * (stretch.to - stretch.from);
    };
    // The fillets lean with what they run into.
    const auto flared = [&](double sign, const Over &side) {
        const double slope = (side.from - over->from) / (half + flare);
        const double foot = std::min(side.from, side.from - slope * flare) - flare;
        const double handle = kQuarterHandle * flare;
        return CubicBezier{at(sign * half, foot), at(sign * half, foot + handle),
                           at(sign * (half + flare - handle), side.from - slope * handle),
                           at(sign * (half + flare), side.from)};
    };
    const CubicBezier up = flared(1.0, *right), down = flared(-1.0, *left).reversed();
    const std::vector<Vec2> corners{up.p3, at(half + flare, into(*right)), at(0.0, into(*over)),
                                    at(-half - flare, into(*left)), down.p0};
    std::vector<CubicBezier> segments{CubicBezier::line(at(-half, 0.0), at(half, 0.0)),
                                      CubicBezier::line(at(half, 0.0), up.p0), up};
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
        segments.push_back(CubicBezier::line(corners[i], corners[i + 1]));
    segments.push_back(down);
    segments.push_back(CubicBezier::line(down.p3, at(-half, 0.0)));
    Contour leg = Contour::ofSegments(segments);
    return leg.signedArea() < 0.0 ? leg.reversed() : leg;
}

std::optional<Document> withLeg(const Model &model, const UprightStand &stand, double s)
{
    const auto index = static_cast<std::size_t>(stand.section);
    const Section &section = *model.section(index);
    const auto leg = legAt(section, stand, s, model.stockOf(index).thickness);
    if (!leg)
        return {};
    const auto all =
        windingRegions({section.shape->contour(), *leg}, WindingRule::Positive, kCutChord);
    // A leg that closes a bay would be a frame, which nobody asked for.
    if (!all || all->size() != 1 || !all->front().holes.empty())
        return {};
    Result<ShapePointer> shape = Shape::make(all->front().outer, section.shape->holes());
    if (!shape)
        return {};
    if (const MirrorAxis *axis = symmetryOf(section); axis && !isSymmetric(**shape, *axis)) {
        shape = symmetrised(*section.shape, *shape, *axis);
        if (!shape)
            return {};
    }
    Result<Document> next = setShape(model.document, section.id, *std::move(shape));
    return next ? std::optional(*std::move(next)) : std::nullopt;
}

/// Along its line: under what it bears, the farthest from its feet first, and at its ends.
std::vector<double> placesFor(const Analysis &analysis, const UprightStand &stand)
{
    const Model &model = analysis.model;
    const auto index = static_cast<std::size_t>(stand.section);
    const Section &section = *model.section(index);
    const double thickness = model.stockOf(index).thickness;
    const double margin = (0.5 * kLegWidth + kLegFlare) * thickness;
    std::vector<double> places;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Vec2 &p : section.shape->region().outer) {
        const double s = stand.placeOf(section.frame.toWorld(p));
        least = std::min(least, s);
        most = std::max(most, s);
    }
    places = {least + 1.01 * margin, most - 1.01 * margin};
    for (const PlacedLoad &load : placedLoads(model))
        if (load.section == stand.section)
            places.push_back(stand.placeOf(section.frame.toWorld(load.position)));
    for (const Slit &slit : analysis.assembly.slits[index])
        for (const double beside : {-2.0, 2.0}) // not where the other section is
            places.push_back(stand.placeOf(section.frame.toWorld(slit.inner)) + beside * margin);
    const auto away = [&](double s) { return std::max(stand.from - s, s - stand.to); };
    std::erase_if(places, [&](double s) {
        return (stand.isOnGround() && away(s) < margin) || s < least + margin || s > most - margin;
    });
    std::sort(places.begin(), places.end(), [&](double a, double b) {
        return away(a) > away(b) || (away(a) == away(b) && a < b);
    });
    return places;
}

std::optional<FindingEdit> secondFoot(const FindingAction &, const Finding &finding,
                                      const Analysis &analysis, const Flips *)
{
    const Model &model = analysis.model;
    const int weakest = model.indexOf(finding.sections.front());
    if (weakest < 0)
        return {};
    const auto source = drawnSourceOf(model, static_cast<std::size_t>(weakest));
    if (!source)
        return {};
    const int section = model.indexOf(source->section->ref());
    const auto stand = section < 0 ? std::nullopt : uprightStandOf(model, section);
    if (!stand)
        return {};
    StrengthJudge judge(analysis, finding);
    return firstThatHolds(
        placesFor(analysis, *stand), judge, [&](double s) -> std::optional<FindingEdit> {
            std::optional<Document> next = withLeg(model, *stand, s);
            if (!next || !meetAsBefore(analysis, *judge.on(*next).analysis))
                return {};
            return FindingEdit{Step(kLegStep, {Named{source->section->name}}), *std::move(next)};
        });
}

} // namespace

const ActionKind kSecondFoot{plainWords<kLegText>, secondFoot};

} // namespace fff
