#include "core/nesting/prepared.h"

#include "core/base/tolerances.h"
#include "core/geometry/turning.h"
#include "core/nesting/grown_outline.h"

#include <algorithm>

namespace fff::nest {

namespace {

Region turnedBack(const Region &region)
{
    const auto turn = [](Polygon polygon) {
        for (Vec2 &p : polygon)
            p = Vec2(p.y(), -p.x());
        return polygon;
    };
    Region result{turn(region.outer), {}};
    for (const Polygon &hole : region.holes)
        result.holes.push_back(turn(hole));
    return result;
}

/// By how much shapes may be larger where that saves corners: hardly to be seen.
double savingOf(const Problem &problem)
{
    constexpr double kShare = 0.02, kMost = 0.05; // of the spacing; mm
    return std::max(std::min(kShare * problem.spacing, kMost), problem.chord);
}

Prepared::Sheet sheetOf(const SheetKind &kind, double inset)
{
    Prepared::Sheet sheet;
    sheet.count = kind.count;
    const Inside inside = insideOf(turnedBack(kind.outline), inset);
    sheet.box = inside.box;
    for (const Region &obstacle : inside.obstacles)
        sheet.obstacles.push_back(
            shapeOf(obstacle, {Vec2::UnitX()}, false, std::abs(fff::area(obstacle))));
    return sheet;
}

Prepared::Sheet stripOf(const Prepared &prepared, const Problem &problem, double inset)
{
    double length = 1.0;
    for (std::size_t i = 0; i < prepared.shapes.size(); ++i)
        length += prepared.shapes[i].diameter * std::max(0, problem.pieces[i].demand);
    Prepared::Sheet sheet;
    sheet.box = {Vec2::Constant(inset), Vec2(inset + length, problem.stripHeight - inset)};
    return sheet;
}

} // namespace

Prepared prepare(const Problem &problem)
{
    Prepared prepared;
    prepared.isStrip = problem.stripHeight > 0.0;
    const double room = 0.5 * problem.spacing + problem.chord + kSlackForRounding;
    // Sheets are larger than they have to be by less than that, so that what just fits does fit.
    const double inset = problem.margin - room - 0.2 * kSlackForRounding;
    for (const Piece &piece : problem.pieces) {
        const Region outline = prepared.isStrip ? piece.outline : turnedBack(piece.outline);
        const double saving =
            problem.spacing > 0.0 || problem.chord > 0.0 ? savingOf(problem) : 0.0;
        Region grown = grownOutline(outline, room, saving);
        const std::vector<Vec2> turns =
            piece.turnsFreely ? goodTurns(grown.outer, piece.turns) : piece.turns;
        prepared.shapes.push_back(
            shapeOf(std::move(grown), turns, piece.turnsFreely, fff::area(piece.outline)));
    }
    if (prepared.isStrip)
        prepared.sheets.push_back(stripOf(prepared, problem, inset));
    else
        for (const SheetKind &kind : problem.sheets)
            prepared.sheets.push_back(sheetOf(kind, inset));
    return prepared;
}

Place placeOf(const Prepared &prepared, int piece, int sheet, const Pose &pose)
{
    const Shape &shape = prepared.shapes[static_cast<std::size_t>(piece)];
    Place place;
    place.piece = piece;
    place.sheet = sheet;
    place.turn = pose.turn == Pose::kFree ? pose.direction
                                          : shape.turns[static_cast<std::size_t>(pose.turn)].turn;
    const Vec2 at = pose.at + turned(shape.moved, place.turn);
    place.offset = prepared.isStrip ? at : Vec2(-at.y(), at.x());
    return place;
}

} // namespace fff::nest
