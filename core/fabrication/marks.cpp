#include "core/fabrication/marks.h"

#include "core/base/tolerances.h"
#include "core/fabrication/room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

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

/// A number that has its place.
struct Mark
{
    int number = 0;
    Vec2 center = Vec2::Zero();
    double height = 0.0;
    Vec2 half = Vec2::Zero(); // of its box

    /// With so much about it.
    Box2 box(double around = 0.0) const
    {
        const Vec2 reaching = half + Vec2::Constant(around);
        return {center - reaching, center + reaching};
    }
};

struct Marks
{
    std::vector<Mark> joints;
    std::vector<int> leftOut; // joints' numbers
    std::optional<Mark> number;

    bool isComplete() const { return number && leftOut.empty(); }
};

Engraving drawn(const Marks &marks)
{
    Engraving engraving;
    for (const Mark &joint : marks.joints) {
        appendJointNumber(joint.number, joint.box().min, joint.height, engraving.strokes);
        engraving.joints.resize(engraving.strokes.size(), joint.number);
        engraving.boxes.push_back(joint.box());
    }
    engraving.jointsLeftOut = marks.leftOut;
    engraving.hasNumber = marks.number.has_value();
    if (marks.number) {
        appendNumber(marks.number->number, marks.number->box().min, marks.number->height,
                     engraving.strokes);
        engraving.boxes.push_back(marks.number->box());
    }
    return engraving;
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

std::optional<Mark> placeJoint(const Part::JointMark &mark, double largest,
                               const MarkOptions &options, const Room &room)
{
    const Vec2 size = strokedJointSize(mark.joint);
    for (double height = largest; height >= options.minHeight; height *= kShrink) {
        const Vec2 half = 0.5 * height * size;
        const Vec2 needed = half + Vec2::Constant(options.clearance);
        for (const Vec2 &center : placesAt(mark, needed))
            if (room.fits(center, needed))
                return Mark{mark.joint, center, height, half};
    }
    return std::nullopt;
}

/// Their places are few, so they come before the part's number.
void placeJoints(const Part &part, double largest, const MarkOptions &options, Room &room,
                 Marks &marks)
{
    for (const Part::JointMark &mark : part.joints) {
        const std::optional<Mark> placed = placeJoint(mark, largest, options, room);
        if (!placed) {
            marks.leftOut.push_back(mark.joint);
            continue;
        }
        room.take(placed->box(placed->height - options.clearance));
        marks.joints.push_back(*placed);
    }
}

/// A place for the part's number in full size that is soon found: in one of a few rows, or beside
/// the slits beyond the joints' numbers there, since parts that are slim elsewhere are wide at
/// slits.
std::optional<Vec2> handyPlace(const Part &part, double height, const Vec2 &half,
                               const MarkOptions &options, const Room &room)
{
    if (const std::optional<Vec2> place = room.findInRows(half))
        return place;
    for (const Part::JointMark &mark : part.joints) {
        Part::JointMark beyond = mark;
        beyond.inner += (options.jointHeight + kHeightsApart * height) * mark.direction;
        for (const Vec2 &center : placesAt(beyond, half)) {
            if (room.fits(center, half))
                return center;
        }
    }
    return std::nullopt;
}

std::optional<Mark> placeNumber(const Part &part, double largest, double smallest,
                                const MarkOptions &options, const Room &room)
{
    const Vec2 size = strokedSize(part.number);
    const Vec2 clearance = Vec2::Constant(options.clearance);
    const Vec2 whole = 0.5 * largest * size, half = whole + clearance;
    if (const std::optional<Vec2> place = handyPlace(part, largest, half, options, room))
        return Mark{part.number, *place, largest, whole};
    const Vec2 center = room.roomiest(half, kAmpleRoom);
    const double scale = room.scaleAt(center, half);
    if (scale >= 1.0)
        return Mark{part.number, center, largest, whole};
    // The clearance does not shrink with the number.
    const Vec2 left = scale * half - clearance;
    const double height = 2.0 * left.cwiseQuotient(size).minCoeff();
    if (height < smallest)
        return std::nullopt;
    return Mark{part.number, center, height, 0.5 * height * size};
}

/// All marks, the part's number in this height and no joint's larger.
Marks placeAll(const Part &part, double height, const MarkOptions &options, Room &room)
{
    const std::size_t taken = room.takenCount();
    Marks marks;
    placeJoints(part, std::min(options.jointHeight, height), options, room, marks);
    if (marks.leftOut.empty()) {
        room.giveBack(taken);
        for (const Mark &joint : marks.joints)
            room.take(joint.box(kHeightsApart * height - options.clearance));
        marks.number = placeNumber(part, height, height, options, room);
    }
    room.giveBack(taken);
    return marks;
}

/// Where there is no room for all: the part's number, and of the joints' what keeps away from it.
Marks placeNumberFirst(const Part &part, double largest, const MarkOptions &options, Room &room)
{
    const std::size_t taken = room.takenCount();
    Marks marks;
    marks.number = placeNumber(part, largest, options.minHeight, options, room);
    double height = options.jointHeight;
    if (marks.number) {
        height = std::min(height, marks.number->height);
        room.take(marks.number->box(kHeightsApart * marks.number->height - options.clearance));
    }
    placeJoints(part, height, options, room, marks);
    room.giveBack(taken);
    return marks;
}

Marks place(const Part &part, const MarkOptions &options, Room &room)
{
    // Without regard to joints: larger it will not be.
    const std::optional<Mark> alone =
        placeNumber(part, options.numberHeight, options.minHeight, options, room);
    if (!alone || part.joints.empty()) {
        Marks marks;
        marks.number = alone;
        placeJoints(part, options.jointHeight, options, room, marks);
        return marks;
    }
    for (double height = alone->height;; height = std::max(height * kShrink, options.minHeight)) {
        Marks marks = placeAll(part, height, options, room);
        if (marks.isComplete())
            return marks;
        if (height <= options.minHeight)
            break;
    }
    // The smaller the number, the less it keeps from the joints.
    Marks best = placeNumberFirst(part, options.minHeight, options, room);
    const Marks larger = placeNumberFirst(part, options.jointHeight, options, room);
    return larger.leftOut.size() <= best.leftOut.size() ? larger : best;
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

Engraving engrave(const Part &part, const std::vector<MarkPointer> &onSection,
                  const MarkOptions &options)
{
    Region region;
    region.outer = part.outline.outer.polygon(kDrawChord);
    for (const Contour &hole : part.outline.holes)
        region.holes.push_back(hole.polygon(kDrawChord));
    if (region.outer.size() < 3)
        return {};
    Room room(region);
    MarkedLines lines = linesOn(part, onSection);
    for (const auto *paths : {&lines.engraved, &lines.scored})
        for (const CurvePath &path : *paths)
            takeLine(path, room);
    Engraving engraving = drawn(place(part, options, room));
    engraving.lines = std::move(lines);
    return engraving;
}

} // namespace fff
