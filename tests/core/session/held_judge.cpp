#include "tests/core/session/held_judge.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace fff::test {

namespace {

constexpr double kPathStep = 0.2;        // mm: no wall of 0.5 is jumped over
constexpr double kLeastRadius = 0.5;     // mm, of a turn: what is touched in a point would spin
constexpr double kSameWay = 1e-6;        // 1 − cosine
constexpr double kParallelPlanes = 1e-3; // sine

/// The piece and one of the others where they are near each other.
struct Facing
{
    const JudgedPiece *piece = nullptr, *other = nullptr;
    std::vector<Vec3> ofPiece, ofOther; // points that may come to lie in the other one of the two
    std::vector<Vec3> touching;
    double inEachOther = 0.0;
};

/// Square to each other: along the line that both planes have, the normal of one of them, and
/// across both.
using Axes = std::array<Vec3, 3>;

Axes axesOf(const JudgedPiece &piece, const Vec3 &axis)
{
    return {axis, piece.normal(), piece.normal().cross(axis)};
}

/// Of planes that are parallel any line in them.
Vec3 axisOf(const JudgedPiece &piece, const JudgedPiece &other)
{
    const Vec3 axis = piece.normal().cross(other.normal());
    return axis.norm() > kParallelPlanes ? Vec3(axis.normalized()) : piece.frame().x;
}

using Names = std::array<const char *, 3>;
constexpr Names kOfPiece{"axis", "normal", "across"},
    kOfOther{"axis", "other normal", "other across"};

/// So that what blocks a move is mostly among the first.
void shuffle(std::vector<Vec3> &points)
{
    std::mt19937 random(1);
    for (std::size_t i = points.size(); i > 1; --i)
        std::swap(points[i - 1], points[random() % i]);
}

void add(Facing &facing, const std::vector<SurfacePoint> &points, const JudgedPiece &other,
         double play, std::vector<Vec3> &kept)
{
    for (const SurfacePoint &point : points) {
        if (point.distance <= play)
            facing.touching.push_back(point.at);
        const double depth = point.distance > 0.0 ? 0.0 : other.depth(point.at);
        facing.inEachOther = std::max(facing.inEachOther, depth);
        if (depth < kFreeDepth)
            kept.push_back(point.at);
    }
    shuffle(kept);
}

Facing facingOf(const JudgedPiece &piece, const JudgedPiece &other, const Slack &slack)
{
    const double faceReach = slack.play + kTellingMove + kFreeDepth;
    // What turns comes from farther away: the edges of a slit are off the faces of what is in it by
    // no more than the slit is long across the sheet.
    const double reach =
        faceReach + (slack.turn > 0.0 ? 2.0 * std::max(piece.half(), other.half()) : 0.0);
    Facing facing{&piece, &other, {}, {}, {}, 0.0};
    add(facing, piece.pointsNear(other, reach, faceReach), other, slack.play, facing.ofPiece);
    add(facing, other.pointsNear(piece, reach, faceReach), piece, slack.play, facing.ofOther);
    return facing;
}

std::string signedName(int sign, const char *name)
{
    return sign == 0 ? "" : (sign > 0 ? "+" : "-") + std::string(name);
}

/// Keeps one of those that are the same.
class Moves
{
public:
    void shift(const Vec3 &direction, double amount, std::string name)
    {
        const Vec3 way = direction.normalized();
        for (const SmallMove &move : m_all)
            if (move.kind == SmallMove::Kind::Shift && move.direction.dot(way) > 1.0 - kSameWay)
                return;
        m_all.push_back(
            {SmallMove::Kind::Shift, way, Vec3::Zero(), amount, "shift " + std::move(name)});
    }
    void turn(const Vec3 &axis, const Vec3 &through, double amount, std::string name)
    {
        for (const SmallMove &move : m_all)
            if (move.kind == SmallMove::Kind::Turn && move.through == through &&
                move.direction.dot(axis) > 1.0 - kSameWay)
                return;
        m_all.push_back({SmallMove::Kind::Turn, axis, through, amount, "turn " + std::move(name)});
    }
    const std::vector<SmallMove> &all() const { return m_all; }

private:
    std::vector<SmallMove> m_all;
};

void addShifts(const Axes &axes, const Names &names, double amount, Moves &moves)
{
    for (int i = -1; i <= 1; ++i)
        for (int k = -1; k <= 1; ++k)
            for (int m = -1; m <= 1; ++m)
                if (i != 0 || k != 0 || m != 0)
                    moves.shift(i * axes[0] + k * axes[1] + m * axes[2], amount,
                                signedName(i, names[0]) + signedName(k, names[1]) +
                                    signedName(m, names[2]));
}

/// The middle of the box along these axes that the points are in.
Vec3 middleOf(const std::vector<Vec3> &points, const Axes &axes)
{
    Vec3 middle = Vec3::Zero();
    for (const Vec3 &axis : axes) {
        const auto along = [&](const Vec3 &a, const Vec3 &b) { return axis.dot(a) < axis.dot(b); };
        const auto [low, high] = std::minmax_element(points.begin(), points.end(), along);
        middle += 0.5 * axis.dot(*low + *high) * axis;
    }
    return middle;
}

/// Of the slack's own turns the one is about the first of the axes.
void addTurns(const std::vector<Vec3> &touching, const Axes &axes, const Names &names,
              const Vec3 &middle, const Slack &slack, Moves &moves)
{
    for (std::size_t i = 0; i < axes.size(); ++i) {
        double radius = kLeastRadius;
        for (const Vec3 &p : touching)
            radius = std::max(radius, (p - middle).cross(axes[i]).norm());
        const double angle =
            kTellingMove / radius + slack.play / std::min(radius, slack.depth) +
            (i == 0 ? slack.turn : 0.0) +
            (std::abs(axes[i].dot(slack.leanAbout)) > 1.0 - kSameWay ? slack.lean : 0.0);
        for (const int sign : {1, -1})
            moves.turn(sign * axes[i], middle, angle, signedName(sign, names[i]));
    }
}

void addMoves(const Facing &facing, double amount, const Slack &slack, Moves &moves)
{
    const Vec3 axis = axisOf(*facing.piece, *facing.other);
    const Axes ofPiece = axesOf(*facing.piece, axis), ofOther = axesOf(*facing.other, axis);
    const Vec3 middle =
        0.5 * (middleOf(facing.touching, ofPiece) + middleOf(facing.touching, ofOther));
    addShifts(ofPiece, kOfPiece, amount, moves);
    addTurns(facing.touching, ofPiece, kOfPiece, middle, slack, moves);
    if (std::abs(ofPiece[1].dot(ofOther[1])) > 1.0 - kSameWay)
        return; // the same axes
    addShifts(ofOther, kOfOther, amount, moves);
    addTurns(facing.touching, ofOther, kOfOther, middle, slack, moves);
}

Vec3 randomUnit(std::mt19937 &random)
{
    const auto number = [&] { return 2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0; };
    for (;;) {
        const Vec3 v(number(), number(), number());
        if (v.norm() > 0.1 && v.norm() < 1.0)
            return v.normalized();
    }
}

void addRandomMoves(const std::vector<Facing> &facings, double amount, int more, Moves &moves)
{
    std::mt19937 random(3);
    std::vector<Vec3> axes, touching;
    Vec3 low = Vec3::Constant(1e9), high = -low;
    for (const Facing &facing : facings) {
        for (const Vec3 &p : facing.touching) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        touching.insert(touching.end(), facing.touching.begin(), facing.touching.end());
        const Vec3 axis = axisOf(*facing.piece, *facing.other);
        for (const JudgedPiece *piece : {facing.piece, facing.other})
            for (const Vec3 &one : axesOf(*piece, axis))
                axes.push_back(one);
    }
    if (touching.empty())
        return;
    const Vec3 middle = 0.5 * (low + high);
    const double size = std::max((high - low).norm(), 2.0);
    for (int i = 0; i < more; ++i) {
        moves.shift(randomUnit(random), amount, "random");
        Vec3 through = touching[random() % touching.size()];
        if (i % 4 == 1)
            through = middle + 0.5 * size * randomUnit(random);
        else if (i % 4 == 2)
            through += 4.0 * randomUnit(random);
        else if (i % 4 == 3)
            through = {i & 8 ? low.x() : high.x(), i & 16 ? low.y() : high.y(),
                       i & 32 ? low.z() : high.z()};
        const Vec3 axis = random() % 3 == 0 ? randomUnit(random) : axes[random() % axes.size()];
        double radius = kLeastRadius;
        for (const Vec3 &p : touching)
            radius = std::max(radius, (p - through).cross(axis).norm());
        moves.turn(axis, through, amount / radius, "random");
        moves.turn(-axis, through, amount / radius, "random");
    }
}

double wayOf(const SmallMove &move, const std::vector<Vec3> &points)
{
    if (move.kind == SmallMove::Kind::Shift)
        return move.amount;
    double radius = 0.0;
    for (const Vec3 &p : points)
        radius = std::max(radius, (p - move.through).cross(move.direction).norm());
    return radius * move.amount;
}

bool isBlocked(const Facing &facing, const SmallMove &move)
{
    const SmallMove back = move.back();
    const double way = std::max(wayOf(move, facing.ofPiece), wayOf(move, facing.ofOther));
    const int steps = std::max(1, static_cast<int>(std::ceil(way / kPathStep)));
    for (int k = steps; k > 0; --k) {
        const double share = static_cast<double>(k) / steps;
        const auto isAnyIn = [&](const std::vector<Vec3> &points, const SmallMove &by,
                                 const JudgedPiece &in) {
            return std::any_of(points.begin(), points.end(), [&](const Vec3 &p) {
                return in.isWithin(by.applied(p, share), kFreeDepth);
            });
        };
        if (isAnyIn(facing.ofPiece, move, *facing.other) ||
            isAnyIn(facing.ofOther, back, *facing.piece))
            return true;
    }
    return false;
}

} // namespace

SmallMove SmallMove::back() const
{
    SmallMove move = *this;
    move.amount = -amount;
    return move;
}

Vec3 SmallMove::applied(const Vec3 &p, double share) const
{
    if (kind == Kind::Shift)
        return p + share * amount * direction;
    return through + Eigen::AngleAxisd(share * amount, direction) * (p - through);
}

bool SmallMove::isShiftAlong(const Vec3 &way) const
{
    return kind == Kind::Shift && direction.dot(way) > 1.0 - kSameWay;
}

bool Freedom::isHeldBut(std::span<const Vec3> ways) const
{
    return touches && std::all_of(free.begin(), free.end(), [&](const SmallMove &move) {
               return std::any_of(ways.begin(), ways.end(),
                                  [&](const Vec3 &way) { return move.isShiftAlong(way); });
           });
}

Freedom judge(const JudgedPiece &piece, std::span<const JudgedPiece *const> others,
              const Slack &slack, std::span<const Vec3> ways)
{
    const double amount = slack.play + kTellingMove;
    std::vector<Facing> facings;
    Moves moves;
    for (const Vec3 &way : ways)
        moves.shift(way, amount, "+way");
    Freedom freedom;
    for (const JudgedPiece *other : others) {
        Facing facing = facingOf(piece, *other, slack);
        freedom.inEachOther = std::max(freedom.inEachOther, facing.inEachOther);
        if (!facing.touching.empty()) {
            freedom.touches = true;
            addMoves(facing, amount, slack, moves);
        }
        facings.push_back(std::move(facing));
    }
    freedom.tried = static_cast<int>(moves.all().size());
    for (const SmallMove &move : moves.all())
        if (std::none_of(facings.begin(), facings.end(),
                         [&](const Facing &facing) { return isBlocked(facing, move); }))
            freedom.free.push_back(move);
    return freedom;
}

Freedom judgeTogether(std::span<const JudgedPiece *const> group,
                      std::span<const JudgedPiece *const> others, int more, const Slack &slack)
{
    const double amount = slack.play + kTellingMove;
    std::vector<Facing> facings;
    Moves moves;
    Freedom freedom;
    for (const JudgedPiece *piece : group)
        for (const JudgedPiece *other : others) {
            Facing facing = facingOf(*piece, *other, slack);
            freedom.inEachOther = std::max(freedom.inEachOther, facing.inEachOther);
            if (!facing.touching.empty()) {
                freedom.touches = true;
                addMoves(facing, amount, slack, moves);
            }
            facings.push_back(std::move(facing));
        }
    addRandomMoves(facings, amount, more, moves);
    freedom.tried = static_cast<int>(moves.all().size());
    for (const SmallMove &move : moves.all())
        if (std::none_of(facings.begin(), facings.end(),
                         [&](const Facing &facing) { return isBlocked(facing, move); })) {
            freedom.free.push_back(move);
            break;
        }
    return freedom;
}

} // namespace fff::test
