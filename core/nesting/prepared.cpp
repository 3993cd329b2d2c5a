#include "core/nesting/prepared.h"

#include "core/base/tolerances.h"
#include "core/geometry/turning.h"
#include "core/nesting/grown_outline.h"

#include <algorithm>
#include <cmath>

namespace fff::nest {

namespace {

Vec2 swapped(const Vec2 &p)
{
    return {p.y(), p.x()};
}

Polygon swapped(const Polygon &polygon)
{
    Polygon result;
    for (auto p = polygon.rbegin(); p != polygon.rend(); ++p) // a mirror image runs the other way
        result.push_back(swapped(*p));
    return result;
}

Region swapped(const Region &region)
{
    Region result{swapped(region.outer), {}};
    for (const Polygon &hole : region.holes)
        result.holes.push_back(swapped(hole));
    return result;
}

/// What a turn is in the mirror, either way.
Vec2 swappedTurn(const Vec2 &turn)
{
    return {turn.x(), -turn.y()};
}

std::vector<Vec2> swappedTurns(std::vector<Vec2> turns)
{
    for (Vec2 &turn : turns)
        turn = swappedTurn(turn);
    return turns;
}

/// By how much shapes may be larger where that saves corners: hardly to be seen.
double savingOf(const Problem &problem)
{
    constexpr double kShare = 0.02, kMost = 0.05; // of the spacing; mm
    return std::max(std::min(kShare * problem.spacing, kMost), problem.chord);
}

/// Sheets are larger than they have to be by this, mm, so that what just fits does fit: pieces are
/// moved back by so much in the end (nester.cpp), but not off holes and bays.
constexpr double kSheetSlack = 0.2 * kSlackForRounding;

/// Where the room round outlines is more than the margin a sheet is larger by the rest. An edge
/// that turns inwards would lose its corner by that, and a piece could lie over it: what is no
/// rectangle stays as large as it is.
bool isBox(const Region &outline)
{
    constexpr double kSame = 1e-9; // share
    const Vec2 size = bounds(outline.outer).size();
    return outline.holes.empty() &&
           std::abs(signedArea(outline.outer)) >= (1.0 - kSame) * size.x() * size.y();
}

/// room  round every outline
Prepared::Sheet sheetOf(const SheetKind &kind, double inset, double room)
{
    Prepared::Sheet sheet;
    sheet.count = kind.count;
    sheet.isFree = kind.isFree;
    const Inside inside =
        insideOf(swapped(kind.outline), isBox(kind.outline) ? inset : std::max(inset, 0.0));
    sheet.box = inside.box;
    if (!sheet.box.isEmpty())
        sheet.box = {sheet.box.min - Vec2::Constant(kSheetSlack),
                     sheet.box.max + Vec2::Constant(kSheetSlack)};
    const auto add = [&sheet](const Region &obstacle) {
        sheet.obstacles.push_back(
            shapeOf(obstacle, {Vec2::UnitX()}, false, std::abs(fff::area(obstacle))));
    };
    for (const Region &obstacle : inside.obstacles)
        add(obstacle);
    for (const Polygon &outline : kind.taken)
        add(grownOutline({swapped(outline), {}}, room, 0.0));
    return sheet;
}

Prepared::Sheet stripOf(const Prepared &prepared, const Problem &problem, double inset)
{
    double length = 1.0;
    for (std::size_t i = 0; i < prepared.shapes.size(); ++i)
        length += prepared.shapes[i].diameter * std::max(0, problem.pieces[i].demand);
    Prepared::Sheet sheet;
    inset -= kSheetSlack;
    sheet.box = {Vec2::Constant(inset), Vec2(inset + length, problem.stripHeight - inset)};
    return sheet;
}

} // namespace

Prepared prepare(const Problem &problem)
{
    Prepared prepared;
    prepared.isStrip = problem.stripHeight > 0.0;
    const double room = 0.5 * problem.spacing + problem.chord + kSlackForRounding;
    const double inset = problem.margin - room;
    for (const Piece &piece : problem.pieces) {
        const Region outline = prepared.isStrip ? piece.outline : swapped(piece.outline);
        const std::vector<Vec2> given = prepared.isStrip ? piece.turns : swappedTurns(piece.turns);
        const double saving =
            problem.spacing > 0.0 || problem.chord > 0.0 ? savingOf(problem) : 0.0;
        Region grown = grownOutline(outline, room, saving);
        const std::vector<Vec2> turns = piece.turnsFreely ? goodTurns(grown.outer, given) : given;
        prepared.shapes.push_back(
            shapeOf(std::move(grown), turns, piece.turnsFreely, fff::area(piece.outline)));
    }
    if (prepared.isStrip)
        prepared.sheets.push_back(stripOf(prepared, problem, inset));
    else
        for (const SheetKind &kind : problem.sheets)
            prepared.sheets.push_back(sheetOf(kind, inset, room));
    return prepared;
}

Place placeOf(const Prepared &prepared, int piece, int sheet, const Pose &pose)
{
    const Shape &shape = prepared.shapes[static_cast<std::size_t>(piece)];
    Place place;
    place.piece = piece;
    place.sheet = sheet;
    const Vec2 turn = pose.turn == Pose::kFree
                          ? pose.direction
                          : shape.turns[static_cast<std::size_t>(pose.turn)].turn;
    const Vec2 at = pose.at + turned(shape.moved, turn);
    place.turn = prepared.isStrip ? turn : swappedTurn(turn);
    place.offset = prepared.isStrip ? at : swapped(at);
    return place;
}

Pose poseOf(const Prepared &prepared, const Place &place)
{
    const Shape &shape = prepared.shapes[static_cast<std::size_t>(place.piece)];
    const Vec2 turn = prepared.isStrip ? place.turn : swappedTurn(place.turn);
    const auto nearest = std::min_element(
        shape.turns.begin(), shape.turns.end(), [&turn](const Posed &a, const Posed &b) {
            return (a.turn - turn).squaredNorm() < (b.turn - turn).squaredNorm();
        });
    Pose pose;
    pose.turn = static_cast<int>(nearest - shape.turns.begin());
    if (shape.turnsFreely && nearest->turn != turn) {
        pose.turn = Pose::kFree;
        pose.direction = turn;
    }
    pose.at = (prepared.isStrip ? place.offset : swapped(place.offset)) - turned(shape.moved, turn);
    return pose;
}

} // namespace fff::nest
