#include "core/fabrication/pins.h"

#include "core/base/tolerances.h"
#include "core/fabrication/outer_chords.h"
#include "core/geometry/turning.h"
#include "core/nesting/proof.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace fff {

namespace {

/// Of a turn's length, by which it would make a part larger or smaller.
constexpr double kTurnError = 1e-9;

/// Where it lies.
Polygon outlineOf(const Part &part, const PinnedPart &pinned)
{
    Polygon outline;
    for (const Vec2 &p : outerChords(part.outline).outer)
        outline.push_back(turned(p, pinned.turn) + pinned.offset);
    return outline;
}

const Part &partOf(const std::vector<Part> &parts, const PinnedPart &pinned)
{
    return parts[static_cast<std::size_t>(pinned.part)];
}

bool isUnitTurn(const Vec2 &turn)
{
    return turn.allFinite() && std::abs(turn.norm() - 1.0) <= kTurnError;
}

/// Makes no sense whatever else lies there.
bool isNonsense(const PinnedPart &pinned, const SheetSupply &supply, std::size_t partCount)
{
    return !supply.has(pinned.sheet) || pinned.sheet >= static_cast<int>(partCount) ||
           !isUnitTurn(pinned.turn) || !pinned.offset.allFinite() ||
           pinned.offset.cwiseAbs().maxCoeff() > kMaxCoordinate;
}

nest::Problem problemOn(const SheetSupply &supply, const LayoutOptions &options, int wholes)
{
    nest::Problem problem;
    problem.margin = options.margin;
    problem.spacing = options.spacing;
    problem.sheets = supply.kinds(wholes);
    return problem;
}

/// All of them as they lie, as a problem that is solved already.
std::pair<nest::Problem, nest::Solution> solvedBy(const std::vector<Part> &parts,
                                                  const SheetSupply &supply,
                                                  const LayoutOptions &options,
                                                  const std::vector<PinnedPart> &pinned)
{
    nest::Problem problem = problemOn(supply, options, wholeSheetsOf(pinned));
    nest::Solution solution;
    for (std::size_t kind = 0; kind < problem.sheets.size(); ++kind)
        solution.sheets.push_back(static_cast<int>(kind));
    for (std::size_t i = 0; i < pinned.size(); ++i) {
        nest::Piece piece;
        piece.outline = partOf(parts, pinned[i]).outline.region;
        piece.turnsFreely = true;
        problem.pieces.push_back(std::move(piece));
        solution.places.push_back({static_cast<int>(i), supply.kindOf(pinned[i].sheet),
                                   pinned[i].turn, pinned[i].offset});
    }
    return {std::move(problem), std::move(solution)};
}

/// Which of the two goes.
std::size_t losing(const nest::Fault &fault, const std::vector<PinnedPart> &pinned)
{
    const auto first = static_cast<std::size_t>(fault.first);
    if (fault.second < 0)
        return first;
    const auto second = static_cast<std::size_t>(fault.second);
    if (pinned[first].yields != pinned[second].yields)
        return pinned[first].yields ? first : second;
    return std::max(first, second);
}

} // namespace

int wholeSheetsOf(const std::vector<PinnedPart> &pinned)
{
    int wholes = 0;
    for (const PinnedPart &one : pinned)
        wholes = std::max(wholes, one.sheet + 1);
    return wholes;
}

nest::Problem sheetsAround(const std::vector<Part> &parts, const SheetSupply &supply,
                           const LayoutOptions &options, const std::vector<PinnedPart> &pinned)
{
    nest::Problem problem = problemOn(supply, options, wholeSheetsOf(pinned));
    for (const PinnedPart &one : pinned)
        problem.sheets[static_cast<std::size_t>(supply.kindOf(one.sheet))].taken.push_back(
            outlineOf(partOf(parts, one), one));
    return problem;
}

SoundPins soundPins(const std::vector<Part> &parts, const SheetSupply &supply,
                    const LayoutOptions &options, std::vector<PinnedPart> pinned)
{
    SoundPins sound;
    std::set<int> seen;
    for (const PinnedPart &one : pinned) {
        if (!seen.insert(one.part).second)
            continue;
        if (isNonsense(one, supply, parts.size()))
            sound.loosened.push_back(one.part);
        else
            sound.pinned.push_back(one);
    }
    while (!sound.pinned.empty()) {
        const auto [problem, solution] = solvedBy(parts, supply, options, sound.pinned);
        const std::optional<nest::Fault> fault = nest::faultOf(problem, solution);
        if (!fault)
            break;
        const std::size_t goes = losing(*fault, sound.pinned);
        sound.loosened.push_back(sound.pinned[goes].part);
        sound.pinned.erase(sound.pinned.begin() + static_cast<std::ptrdiff_t>(goes));
    }
    return sound;
}

} // namespace fff
