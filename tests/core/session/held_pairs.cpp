#include "tests/core/session/held_pairs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace fff::test {

namespace {

const Slit *firstSlit(const Analysis &analysis, int section, const Joint &joint)
{
    for (const Slit &slit : analysis.assembly.slits[static_cast<std::size_t>(section)])
        if (slit.joint == joint.id)
            return &slit;
    return nullptr;
}

const char *nameOf(JointKind kind)
{
    switch (kind) {
    case JointKind::CrossLap:
        return "cross lap";
    case JointKind::ExtendedCrossLap:
        return "extended";
    case JointKind::Mortise:
        return "mortise";
    case JointKind::Tabs:
        return "tabs";
    case JointKind::None:
        break;
    }
    return "none";
}

/// In which b comes off a: out of the mouth of a's slit, and of a closed one square to it.
std::vector<Vec3> waysOf(const Analysis &analysis, const Joint &joint)
{
    const Slit *inA = firstSlit(analysis, joint.a, joint),
               *inB = firstSlit(analysis, joint.b, joint);
    const auto frameOf = [&](int section) -> const Frame & {
        return analysis.model.section(static_cast<std::size_t>(section))->frame;
    };
    const auto along = [&](const Slit &slit, int section) {
        return frameOf(section).directionToWorld((slit.mouth - slit.inner).normalized());
    };
    if (slidesAlongAxis(joint.kind))
        return {inA ? along(*inA, joint.a) : Vec3(-along(*inB, joint.b))};
    const bool hostIsA = inA && inA->role == SlitRole::Slit;
    const int guest = hostIsA ? joint.b : joint.a;
    const Vec3 through = frameOf(guest).normal().cross(joint.crossing->axis.direction).normalized();
    if (joint.kind == JointKind::Mortise)
        return {through, -through};
    // Tabs point to where the guest goes in.
    for (const Slit &slit : analysis.assembly.slits[static_cast<std::size_t>(guest)]) {
        if (slit.joint != joint.id || slit.role != SlitRole::Tab)
            continue;
        const Vec3 out = -along(slit, guest);
        const Vec3 way = through.dot(out) > 0.0 ? through : Vec3(-through);
        return {hostIsA ? way : Vec3(-way)};
    }
    return {through, -through};
}

/// Where the line is inside of the polygon, nearest to the middle: from and to, mm along it.
std::optional<std::pair<double, double>> crossedAt(const Polygon &polygon, const Vec2 &through,
                                                   const Vec2 &along, double middle)
{
    std::vector<double> at;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 p = polygon[i] - through, q = polygon[(i + 1) % polygon.size()] - through;
        const Vec2 across(-along.y(), along.x());
        const double sideP = across.dot(p), sideQ = across.dot(q);
        if ((sideP < 0.0) != (sideQ < 0.0))
            at.push_back(along.dot(p) + along.dot(q - p) * sideP / (sideP - sideQ));
    }
    std::sort(at.begin(), at.end());
    std::optional<std::pair<double, double>> nearest;
    for (std::size_t i = 0; i + 1 < at.size(); i += 2)
        if (at[i] <= middle && middle <= at[i + 1])
            nearest = {at[i], at[i + 1]};
    return nearest;
}

/// How far what is in a mortise turns in its own plane, see Slack::lean.
void addLean(const Analysis &analysis, const Joint &joint, int guestBody, int host, Slack &slack)
{
    const Body &guest = analysis.bodies.at(guestBody);
    const auto &axis = joint.crossing->axis;
    const Vec2 along = guest.frame().directionToLocal(axis.direction).normalized();
    const Vec2 across(-along.y(), along.x());
    const auto &hostSection = *analysis.model.section(static_cast<std::size_t>(host));
    const double half =
        0.5 * analysis.model.stockOf(static_cast<std::size_t>(host)).thickness /
        std::abs(guest.frame().directionToWorld(across).dot(hostSection.frame.normal()));
    const Slit *mortise = firstSlit(analysis, host, joint);
    if (!mortise)
        return;
    const Vec2 middle =
        guest.frame().toLocal(hostSection.frame.toWorld(0.5 * (mortise->inner + mortise->mouth)));
    const Polygon &outer = guest.outline().region.outer;
    const auto below = crossedAt(outer, middle - half * across, along, 0.0),
               above = crossedAt(outer, middle + half * across, along, 0.0);
    if (!below || !above)
        return;
    slack.lean = std::abs(std::atan((above->first - below->first) / (2.0 * half)) +
                          std::atan((above->second - below->second) / (2.0 * half)));
    slack.leanAbout = guest.frame().normal();
}

/// What a joint leaves by its sheets and its angle.
Slack slackOf(const Analysis &analysis, const Joint &joint)
{
    Slack slack;
    double clearance = 0.0;
    for (const int section : {joint.a, joint.b})
        clearance = std::max(clearance,
                             analysis.model.stockOf(static_cast<std::size_t>(section)).clearance);
    slack.play += clearance;
    slack.turn = std::numbers::pi - 2.0 * joint.crossing->angle;
    return slack;
}

bool isAlongAny(const SmallMove &move, const std::vector<Vec3> &ways)
{
    return std::any_of(ways.begin(), ways.end(),
                       [&](const Vec3 &way) { return move.isShiftAlong(way); });
}

} // namespace

std::vector<JudgedPiece> judgedPieces(const Bodies &bodies)
{
    std::vector<JudgedPiece> pieces;
    for (const Body &body : bodies) {
        const Region &region = body.outline().region;
        pieces.emplace_back(Prism{region.outer, region.holes, body.frame(), body.thickness()});
    }
    return pieces;
}

bool JudgedPair::comesOff() const
{
    return std::any_of(pair.ways.begin(), pair.ways.end(), [this](const Vec3 &way) {
        return std::any_of(freedom.free.begin(), freedom.free.end(),
                           [&](const SmallMove &move) { return move.isShiftAlong(way); });
    });
}

std::vector<JudgedPair> judged(const std::vector<JudgedPiece> &pieces,
                               const std::vector<HeldPair> &pairs)
{
    std::vector<JudgedPair> result;
    for (const HeldPair &pair : pairs)
        result.push_back(
            {pair, judge(pieces[static_cast<std::size_t>(pair.piece)],
                         pieces[static_cast<std::size_t>(pair.other)], pair.slack, pair.ways)});
    return result;
}

bool JudgedPair::goesSideways() const
{
    constexpr double kSquare = 1e-3; // cosine
    return std::any_of(freedom.free.begin(), freedom.free.end(), [this](const SmallMove &move) {
        return move.kind == SmallMove::Kind::Shift &&
               std::all_of(pair.ways.begin(), pair.ways.end(), [&](const Vec3 &way) {
                   return std::abs(way.dot(move.direction)) < kSquare;
               });
    });
}

QByteArray toText(const JudgedPair &judged)
{
    QByteArray text = judged.pair.name + " | ";
    if (!judged.freedom.touches)
        return text + "does not touch";
    constexpr int kNamed = 3;
    int count = 0;
    QByteArray names;
    for (const SmallMove &move : judged.freedom.free) {
        if (isAlongAny(move, judged.pair.ways))
            continue;
        if (++count <= kNamed)
            names += (count > 1 ? ", " : "") + QByteArray::fromStdString(move.name);
    }
    if (count == 0)
        return text + "held";
    return text + (judged.goesSideways() ? "sideways, " : "on a slant, ") +
           QByteArray::number(count) + " of " + QByteArray::number(judged.freedom.tried) + " | " +
           names + (count > kNamed ? ", ..." : "");
}

Freedom judgedAmongAll(const std::vector<JudgedPiece> &pieces, int piece,
                       std::span<const Vec3> ways)
{
    std::vector<const JudgedPiece *> others;
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i)
        if (i != piece)
            others.push_back(&pieces[static_cast<std::size_t>(i)]);
    return judge(pieces[static_cast<std::size_t>(piece)], others, {}, ways);
}

HeldPair pairOf(const Analysis &analysis, const Joint &joint, int bodyOfB, int bodyOfA)
{
    const auto named = [&](int body) {
        const int section = analysis.bodies.sectionOf(body);
        QByteArray name = QByteArray::fromStdString(
            analysis.model.section(static_cast<std::size_t>(section))->name);
        if (analysis.bodies.countOf(section) > 1)
            name += '.' + QByteArray::number(body - analysis.bodies.firstOf(section));
        return name;
    };
    Slack slack = slackOf(analysis, joint);
    if (joint.kind == JointKind::Mortise) {
        const Slit *inA = firstSlit(analysis, joint.a, joint);
        const bool hostIsA = inA && inA->role == SlitRole::Slit;
        addLean(analysis, joint, hostIsA ? bodyOfB : bodyOfA, hostIsA ? joint.a : joint.b, slack);
    }
    return {bodyOfB, bodyOfA, waysOf(analysis, joint), slack,
            QByteArray::number(joint.id) + " | " + nameOf(joint.kind) + " | " + named(bodyOfB) +
                " in " + named(bodyOfA)};
}

std::vector<HeldPair> pairsOfWholeSections(const Analysis &analysis)
{
    std::vector<HeldPair> pairs;
    for (const Joint &joint : analysis.assembly.joints) {
        const auto isWhole = [&](int section) {
            return analysis.bodies.countOf(section) == 1 &&
                   !analysis.cuts[static_cast<std::size_t>(section)]->failure();
        };
        if (joint.kind != JointKind::None && isWhole(joint.a) && isWhole(joint.b))
            pairs.push_back(pairOf(analysis, joint, analysis.bodies.firstOf(joint.b),
                                   analysis.bodies.firstOf(joint.a)));
    }
    return pairs;
}

HeldPair turnedRound(HeldPair pair)
{
    std::swap(pair.piece, pair.other);
    for (Vec3 &way : pair.ways)
        way = -way;
    return pair;
}

} // namespace fff::test
