#include "core/fabrication/marks.h"

#include "core/base/tolerances.h"
#include "core/fabrication/room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace fff {

namespace {

// From one size of a mark to the next smaller one that is tried.
constexpr double kShrink = 0.8;
// A place where the number fits in full size is good enough; only small parts are searched for
// their roomiest.
constexpr double kAmpleRoom = 1.0;

/// How far the box reaches from its middle along a unit direction.
double reach(const Vec2 &half, const Vec2 &direction)
{
    return half.dot(direction.cwiseAbs());
}

void draw(int number, const Vec2 &center, double height, Engraving &engraving)
{
    const Vec2 half = 0.5 * height * strokedSize(number);
    appendNumber(number, center - half, height, engraving.strokes);
    engraving.boxes.push_back({center - half, center + half});
}

/// Middles of the places for a joint's number whose box, with the clearance, has this half size:
/// beyond the slit's bottom, straight on and to either side, then along its two walls.
std::array<Vec2, 11> placesAt(const Part::JointMark &mark, const Vec2 &half)
{
    const Vec2 side = perpendicular(mark.direction);
    // Chords of the drawing's tolerance must not seem to touch what lies along the slit.
    const double along = reach(half, mark.direction) + kDrawChord;
    const double across = reach(half, side) + kDrawChord;
    const double beside = 0.5 * mark.width + across;
    std::array<Vec2, 11> places;
    auto next = places.begin();
    for (double shift : {0.0, across, -across})
        *next++ = mark.inner + along * mark.direction + shift * side;
    for (double back : {0.0, 1.0, 2.0, 3.0}) {
        for (double sign : {1.0, -1.0})
            *next++ = mark.inner - back * along * mark.direction + sign * beside * side;
    }
    return places;
}

bool engraveJoint(const Part::JointMark &mark, const MarkOptions &options, Room &room,
                  Engraving &engraving)
{
    const Vec2 size = strokedSize(mark.joint);
    for (double height = options.jointHeight; height >= options.minHeight; height *= kShrink) {
        const Vec2 half = 0.5 * height * size + Vec2::Constant(options.clearance);
        for (const Vec2 &center : placesAt(mark, half)) {
            if (!room.fits(center, half))
                continue;
            draw(mark.joint, center, height, engraving);
            room.take(engraving.boxes.back());
            return true;
        }
    }
    return false;
}

/// A place for the part's number in full size that is soon found: in one of a few rows, or beside
/// the slits and the joints' numbers there, since parts that are slim elsewhere are wide at slits.
std::optional<Vec2> handyPlace(const Part &part, const Vec2 &half, const MarkOptions &options,
                               const Room &room)
{
    if (const std::optional<Vec2> place = room.findInRows(half))
        return place;
    for (const Part::JointMark &mark : part.joints) {
        Part::JointMark beyond = mark;
        beyond.inner += options.jointHeight * mark.direction;
        for (const Vec2 &center : placesAt(beyond, half)) {
            if (room.fits(center, half))
                return center;
        }
    }
    return std::nullopt;
}

bool engraveNumber(const Part &part, const MarkOptions &options, const Room &room,
                   Engraving &engraving)
{
    const int value = part.number;
    const Vec2 size = strokedSize(value);
    const Vec2 clearance = Vec2::Constant(options.clearance);
    const Vec2 half = 0.5 * options.numberHeight * size + clearance;
    if (const std::optional<Vec2> place = handyPlace(part, half, options, room)) {
        draw(value, *place, options.numberHeight, engraving);
        return true;
    }
    const Vec2 center = room.roomiest(half, kAmpleRoom);
    // The clearance does not shrink with the number.
    const Vec2 left = std::min(room.scaleAt(center, half), 1.0) * half - clearance;
    const double height = 2.0 * left.cwiseQuotient(size).minCoeff();
    if (height < options.minHeight)
        return false;
    draw(value, center, height, engraving);
    return true;
}

/// Boxes along the line, none of them much larger than what they hold.
void takeLine(const CurvePath &path, Room &room)
{
    constexpr double kStep = 4.0; // mm
    const Polygon line = path.flatten(kDrawChord);
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec2 way = line[i] - line[i - 1];
        const int count = std::max(1, static_cast<int>(std::ceil(way.norm() / kStep)));
        for (int k = 0; k < count; ++k) {
            Box2 box;
            box.extend(line[i - 1] + k * way / count);
            box.extend(line[i - 1] + (k + 1) * way / count);
            room.take(box);
        }
    }
}

} // namespace

Engraving engrave(const Part &part, const std::vector<MarkPointer> &drawn,
                  const MarkOptions &options)
{
    Region region;
    region.outer = part.outline.outer.polygon(kDrawChord);
    for (const Contour &hole : part.outline.holes)
        region.holes.push_back(hole.polygon(kDrawChord));
    Engraving engraving;
    if (region.outer.size() < 3)
        return engraving;
    Room room(region);
    engraving.lines = linesOn(part, drawn);
    for (const auto *lines : {&engraving.lines.engraved, &engraving.lines.scored})
        for (const CurvePath &path : *lines)
            takeLine(path, room);
    // Joints first: their places are few, the part's number can go anywhere.
    for (const Part::JointMark &mark : part.joints) {
        if (!engraveJoint(mark, options, room, engraving))
            engraving.jointsLeftOut.push_back(mark.joint);
    }
    engraving.hasNumber = engraveNumber(part, options, room, engraving);
    return engraving;
}

} // namespace fff
