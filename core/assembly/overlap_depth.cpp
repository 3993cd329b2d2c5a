#include "core/assembly/overlap_depth.h"

#include "core/assembly/crossing.h"
#include "core/assembly/encounter.h"
#include "core/base/groups.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace fff {

namespace {

/// A cross product of less is of parallels (of unit vectors; of edges, mm).
constexpr double kSameWay = 1e-9;

/// A half-space: normal · p ≤ reach.
struct Bound
{
    Vec3 normal;
    double reach;
};

/// One half of a convex prism's surface after the other, corner by corner.
struct Prism
{
    Prism(const Plate &plate, const std::array<Vec3, 3> &corners)
    {
        const Vec3 up = plate.half * plate.normal;
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        bounds = {{plate.normal, plate.normal.dot(middle) + plate.half},
                  {-plate.normal, -plate.normal.dot(middle) + plate.half}};
        faces = {{corners[0] + up, corners[1] + up, corners[2] + up},
                 {corners[0] - up, corners[1] - up, corners[2] - up}};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 &from = corners[i], &to = corners[(i + 1) % 3];
            Vec3 outward = plate.normal.cross(to - from);
            if (outward.dot(middle - from) > 0.0)
                outward = -outward;
            bounds.push_back({outward, outward.dot(from)});
            faces.push_back({from - up, to - up, to + up, from + up});
        }
    }

    std::vector<Bound> bounds;
    std::vector<std::vector<Vec3>> faces;
};

std::vector<Vec3> clipped(std::vector<Vec3> face, const std::vector<Bound> &bounds)
{
    for (const Bound &bound : bounds) {
        std::vector<Vec3> kept;
        for (std::size_t i = 0; i < face.size(); ++i) {
            const Vec3 &from = face[i], &to = face[(i + 1) % face.size()];
            const double a = bound.normal.dot(from) - bound.reach;
            const double b = bound.normal.dot(to) - bound.reach;
            if (a <= 0.0)
                kept.push_back(from);
            if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0))
                kept.push_back(from + a / (a - b) * (to - from));
        }
        face = std::move(kept);
    }
    return face;
}

/// The corners of what two prisms share.
std::vector<Vec3> sharedCorners(const Prism &a, const Prism &b)
{
    std::vector<Vec3> corners;
    for (const auto &[prism, other] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (const std::vector<Vec3> &face : prism->faces)
            for (const Vec3 &corner : clipped(face, other->bounds))
                corners.push_back(corner);
    return corners;
}

/// What the prisms of one pair share.
struct Piece
{
    std::vector<Vec3> corners;
    Box3 box;
    double depth = 0.0;
    std::vector<Vec3> edges; // of both prisms' triangles
};

std::vector<Piece> piecesOf(const Solid &a, const Solid &b, Encounter &still)
{
    std::vector<Piece> pieces;
    for (const Encounter::Meeting &meeting : still.meetings()) {
        Piece piece;
        piece.depth = meeting.depth;
        const std::array<Vec3, 3> &ofA = a.triangles[meeting.prisms.mover];
        const std::array<Vec3, 3> &ofB = b.triangles[meeting.prisms.other];
        piece.corners =
            sharedCorners(Prism({a.normal, a.half}, ofA), Prism({b.normal, b.half}, ofB));
        if (piece.corners.empty()) // they share no more than rounding
            piece.corners = {(ofA[0] + ofA[1] + ofA[2] + ofB[0] + ofB[1] + ofB[2]) / 6.0};
        for (const Vec3 &corner : piece.corners)
            piece.box.extend(corner);
        for (const std::array<Vec3, 3> *corners : {&ofA, &ofB})
            for (std::size_t i = 0; i < 3; ++i)
                piece.edges.push_back((*corners)[(i + 1) % 3] - (*corners)[i]);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// Of a room its extent in the direction in which that is least: those of the planes, their axis,
/// and square to the edges of its thickest piece.
double thinnest(const Solid &a, const Solid &b, const std::vector<const Piece *> &room,
                const Piece &thickest)
{
    std::vector<Vec3> ways{a.normal, b.normal};
    const auto add = [&ways](const Vec3 &way) {
        if (const double length = way.norm(); length > kSameWay)
            ways.push_back(way / length);
    };
    const Vec3 axis = a.normal.cross(b.normal);
    for (const Vec3 &way : {axis, Vec3(a.normal.cross(axis)), Vec3(b.normal.cross(axis)),
                            Vec3(a.normal + b.normal), Vec3(a.normal - b.normal)})
        add(way);
    for (const Vec3 &edge : thickest.edges) {
        add(a.normal.cross(edge));
        add(b.normal.cross(edge));
    }
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3 &way : ways) {
        Extent extent;
        for (const Piece *piece : room)
            for (const Vec3 &corner : piece->corners) {
                extent.min = std::min(extent.min, way.dot(corner));
                extent.max = std::max(extent.max, way.dot(corner));
            }
        least = std::min(least, extent.max - extent.min);
    }
    return least;
}

Vec3 middleOf(const Piece &piece)
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3 &corner : piece.corners)
        sum += corner;
    return sum / static_cast<double>(piece.corners.size());
}

} // namespace

std::optional<Interpenetration> overlapOf(const Solid &a, const Solid &b, double depth)
{
    Encounter still(a, b, depth);
    return overlapOf(a, b, still);
}

std::optional<Interpenetration> overlapOf(const Solid &a, const Solid &b, Encounter &still)
{
    const std::vector<Piece> pieces = piecesOf(a, b, still);
    if (pieces.empty())
        return {};
    std::vector<Box3> boxes;
    for (const Piece &piece : pieces) {
        boxes.push_back(piece.box);
        boxes.back().min.array() -= kTouchingDepth;
        boxes.back().max.array() += kTouchingDepth;
    }
    Groups rooms(pieces.size());
    for (const auto &[i, k] : meetingPairs(boxes))
        rooms.join(static_cast<std::size_t>(i), static_cast<std::size_t>(k));
    std::optional<Interpenetration> deepest;
    for (const std::vector<std::size_t> &group : rooms.all()) {
        std::vector<const Piece *> room;
        const Piece *thickest = nullptr;
        for (const std::size_t i : group) {
            room.push_back(&pieces[i]);
            if (!thickest || pieces[i].depth > thickest->depth)
                thickest = &pieces[i];
        }
        const double deep = std::max(thickest->depth, thinnest(a, b, room, *thickest));
        if (!deepest || deep > deepest->depth)
            deepest = Interpenetration{deep, middleOf(*thickest)};
    }
    return deepest;
}

} // namespace fff
