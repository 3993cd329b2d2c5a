#include "core/fabrication/pins.h"

#include "core/base/tolerances.h"
#include "core/geometry/turning.h"
#include "core/nesting/proof.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace fff {

namespace {

/// Of a turn's length, by which it would make a part larger or smaller.
constexpr double kTurnError = 1e-9;

Polygon rectangleOf(const Box2 &box)
{
    return {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
}

/// Where it lies, clockwise.
Polygon holeOf(const Part &part, const PinnedPart &pinned)
{
    Polygon hole;
    for (const Vec2 &p : part.outline.region.outer)
        hole.push_back(turned(p, pinned.turn) + pinned.offset);
    if (signedArea(hole) > 0.0)
        std::reverse(hole.begin(), hole.end());
    return hole;
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
bool isNonsense(const PinnedPart &pinned, std::size_t partCount)
{
    return pinned.sheet < 0 || static_cast<std::size_t>(pinned.sheet) >= partCount ||
           !isUnitTurn(pinned.turn) || !pinned.offset.allFinite() ||
           pinned.offset.cwiseAbs().maxCoeff() > kMaxCoordinate;
}

/// All of them as they lie, as a problem that is solved already.
std::pair<nest::Problem, nest::Solution> solvedBy(const std::vector<Part> &parts, const Vec2 &size,
                                                  const LayoutOptions &options,
                                                  const std::vector<PinnedPart> &pinned)
{
    nest::Problem problem = plainSheets(size, options);
    problem.chord = 0.0; // what lies by its box has the spacing and no more
    nest::Solution solution;
    solution.sheets.assign(static_cast<std::size_t>(kindsAround(pinned)), 0);
    for (std::size_t i = 0; i < pinned.size(); ++i) {
        nest::Piece piece;
        piece.outline = partOf(parts, pinned[i]).outline.region;
        piece.turnsFreely = true;
        problem.pieces.push_back(std::move(piece));
        solution.places.push_back(
            {static_cast<int>(i), pinned[i].sheet, pinned[i].turn, pinned[i].offset});
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

nest::Problem plainSheets(const Vec2 &size, const LayoutOptions &options)
{
    nest::Problem problem;
    problem.margin = options.margin;
    problem.spacing = options.spacing;
    problem.chord = kCutChord;
    problem.sheets = {{{rectangleOf({Vec2::Zero(), size}), {}}, nest::SheetKind::kUnlimited}};
    return problem;
}

int kindsAround(const std::vector<PinnedPart> &pinned)
{
    int kinds = 0;
    for (const PinnedPart &one : pinned)
        kinds = std::max(kinds, one.sheet + 1);
    return kinds;
}

nest::Problem sheetsAround(const std::vector<Part> &parts, const Vec2 &size,
                           const LayoutOptions &options, const std::vector<PinnedPart> &pinned)
{
    nest::Problem problem = plainSheets(size, options);
    // What is pinned is a hole of its sheet. A sheet has one margin for its edge and its holes, so
    // that is the spacing, and the edge goes inwards by what the margin is more.
    problem.margin = options.spacing + kCutChord;
    const Vec2 inset = Vec2::Constant(options.margin - problem.margin);
    const Box2 room{inset, size - inset};
    const Polygon edge = rectangleOf(room.isEmpty() ? Box2{Vec2::Zero(), size} : room);
    problem.sheets.clear();
    for (int sheet = 0; sheet < kindsAround(pinned); ++sheet)
        problem.sheets.push_back({{edge, {}}, 1});
    for (const PinnedPart &one : pinned)
        problem.sheets[static_cast<std::size_t>(one.sheet)].outline.holes.push_back(
            holeOf(partOf(parts, one), one));
    problem.sheets.push_back({{edge, {}}, nest::SheetKind::kUnlimited});
    return problem;
}

SoundPins soundPins(const std::vector<Part> &parts, const Vec2 &size, const LayoutOptions &options,
                    std::vector<PinnedPart> pinned)
{
    SoundPins sound;
    std::set<int> seen;
    for (const PinnedPart &one : pinned) {
        if (!seen.insert(one.part).second)
            continue;
        if (isNonsense(one, parts.size()))
            sound.loosened.push_back(one.part);
        else
            sound.pinned.push_back(one);
    }
    while (!sound.pinned.empty()) {
        const auto [problem, solution] = solvedBy(parts, size, options, sound.pinned);
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
