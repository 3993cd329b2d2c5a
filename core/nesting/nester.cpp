#include "core/nesting/nester.h"

#include "core/geometry/turning.h"
#include "core/nesting/proof.h"
#include "core/nesting/search.h"

#include <algorithm>
#include <cmath>

namespace fff::nest {

namespace {

Box2 lyingBox(const Problem &problem, const Place &place)
{
    Box2 box = turnedBounds(problem.pieces[static_cast<std::size_t>(place.piece)].outline.outer,
                            place.turn);
    return {box.min + place.offset, box.max + place.offset};
}

/// Off the edge by no less than the margin: shapes had a little more room than pieces have.
void keepMargin(const Problem &problem, const Solution &solution, Place &place)
{
    Box2 room{Vec2::Zero(), Vec2(std::numeric_limits<double>::infinity(), problem.stripHeight)};
    if (!(problem.stripHeight > 0.0)) {
        const int kind = solution.sheets[static_cast<std::size_t>(place.sheet)];
        room = bounds(problem.sheets[static_cast<std::size_t>(kind)].outline.outer);
    }
    const Vec2 margin =
        Vec2::Constant(problem.margin > 0.0 ? problem.margin + problem.chord : problem.margin);
    const Box2 box = lyingBox(problem, place);
    place.offset -= (box.max - (room.max - margin)).cwiseMax(0.0);
    place.offset += ((room.min + margin) - box.min).cwiseMax(0.0);
}

double usedEnd(const Problem &problem, const Solution &solution)
{
    const bool isStrip = problem.stripHeight > 0.0;
    const int last = static_cast<int>(solution.sheets.size()) - 1;
    double end = 0.0;
    for (const Place &place : solution.places) {
        if (!isStrip && place.sheet != last)
            continue;
        const Box2 box = lyingBox(problem, place);
        end = std::max(end, isStrip ? box.max.x() : box.max.y());
    }
    return solution.places.empty() ? 0.0 : end + problem.margin;
}

double densityOf(const Problem &problem, const Solution &solution)
{
    double pieces = 0.0, whole = solution.length * problem.stripHeight;
    for (const Place &place : solution.places)
        pieces += std::abs(area(problem.pieces[static_cast<std::size_t>(place.piece)].outline));
    if (!(problem.stripHeight > 0.0))
        for (const int kind : solution.sheets)
            whole += std::abs(area(problem.sheets[static_cast<std::size_t>(kind)].outline));
    return whole > 0.0 ? pieces / whole : 0.0;
}

Solution solutionOf(const Problem &problem, const Prepared &prepared, const Laid &laid)
{
    Solution solution;
    solution.left = laid.left;
    for (std::size_t i = 0; i < laid.sheets.size(); ++i) {
        const Laid::Sheet &sheet = laid.sheets[i];
        if (!prepared.isStrip)
            solution.sheets.push_back(sheet.kind);
        for (std::size_t k = 0; k < sheet.pieces.size(); ++k) {
            Place place = placeOf(prepared, sheet.pieces[k], static_cast<int>(i), sheet.poses[k]);
            keepMargin(problem, solution, place);
            solution.places.push_back(place);
        }
    }
    std::stable_sort(solution.places.begin(), solution.places.end(),
                     [](const Place &a, const Place &b) { return a.piece < b.piece; });
    solution.length = usedEnd(problem, solution);
    solution.density = densityOf(problem, solution);
    return solution;
}

/// As they lay, seen by the search; none where it is not of all pieces.
std::optional<Laid> laidAs(const Solution &before, const Problem &problem, const Prepared &prepared)
{
    std::vector<int> missing;
    for (const Piece &piece : problem.pieces)
        missing.push_back(piece.demand);
    Laid laid;
    for (const int kind : before.sheets)
        laid.sheets.push_back({kind, {}, {}});
    for (const Place &place : before.places) {
        Laid::Sheet &sheet = laid.sheets[static_cast<std::size_t>(place.sheet)];
        sheet.pieces.push_back(place.piece);
        sheet.poses.push_back(poseOf(prepared, place));
        --missing[static_cast<std::size_t>(place.piece)];
    }
    const bool isOfAll = std::all_of(missing.begin(), missing.end(), [](int n) { return n == 0; });
    return isOfAll && !before.places.empty() ? std::optional(std::move(laid)) : std::nullopt;
}

} // namespace

std::vector<Vec2> turnsOf(Turning turning)
{
    switch (turning) {
    case Turning::None:
        return {Vec2::UnitX()};
    case Turning::Half:
        return {Vec2::UnitX(), -Vec2::UnitX()};
    case Turning::Quarter:
    case Turning::Free:
        break;
    }
    return {Vec2::UnitX(), Vec2::UnitY(), -Vec2::UnitX(), -Vec2::UnitY()};
}

std::int64_t workOf(double seconds)
{
    return std::llround(seconds * kWorkPerSecond);
}

Solution nestPieces(const Problem &problem, const Options &options, const LongWork &longWork,
                    const Solution &before)
{
    Prepared prepared = prepare(problem);
    Steps steps = 0;
    Laid first = firstLayout(prepared, problem, steps);
    Solution solution = solutionOf(problem, prepared, first);
    if (const std::optional<Laid> lay = laidAs(before, problem, prepared)) {
        const bool isSound = !faultOf(problem, before);
        std::optional<Laid> begun =
            isSound ? lay : takenApart(prepared, *lay, options.seed, longWork.stop, steps);
        if (begun && !isBetter(prepared, first, *begun)) {
            // What is sound stays to the last bit.
            Solution again = isSound ? before : solutionOf(problem, prepared, *begun);
            again.length = usedEnd(problem, again);
            again.density = densityOf(problem, again);
            if (isSound || !faultOf(problem, again)) {
                first = *std::move(begun);
                solution = std::move(again);
            }
        }
    }
    if (options.work > 0 && !longWork.isStopped()) {
        const Laid better = improved(prepared, first, options, longWork, steps);
        Solution found = solutionOf(problem, prepared, better);
        if (!faultOf(problem, found))
            solution = std::move(found);
    }
    solution.work = steps;
    return solution;
}

} // namespace fff::nest
