// What gestures and tools draw over the model: signs by kind, each painted in one place
// (ui/view/sign_painter.h). A sign has a role, which gives it its look. Whoever has something new
// to show adds signs of the kinds that there are; a kind of its own is for what is laid out anew
// each time that the view is seen from elsewhere.
//
// Places are in the world, mm, unless said otherwise. Equal signs look the same.
#pragma once

#include "core/base/message.h"
#include "core/geometry/polygon.h"
#include "core/geometry/similarity.h"
#include "core/interaction/contour_target.h"
#include "core/interaction/gizmo.h"
#include "core/interaction/joint_marks.h"
#include "core/interaction/operation_handles.h"
#include "core/interaction/pen_marks.h"
#include "core/interaction/point_sight.h"
#include "core/stroke/symmetry.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace fff {

/// What a sign means; ui/view/sign_looks.cpp has colours and lines for it.
enum class SignRole {
    Measured,  // a length in the hand, or a dimension that is pointed at
    Dimension, // one that stays
    Place,     // what is under the cursor would be taken
    Figure,    // what a release makes
    Refused,   // the same where it would not be taken
    Plane,     // that waits to be drawn on
    DeadZone,  // where nothing is drawn yet
    Slit,
    Offer, // what a stroke was meant to be
    Guide, // that what is drawn goes along
    Cue,   // what the hand may do now
    Doubt, // what will not do what it is for
    Load,
    LoadInHand, // that the cursor is over, or moves
    Traced,     // what would be made of a picture
    Mirror,     // the plane that something is mirrored across
};

namespace sign {

struct Line
{
    SignRole role = SignRole::Measured;
    std::vector<Vec3> points;
    bool hasTicks = false; // across its ends
    bool operator==(const Line &) const = default;
};
/// Many closed lines of one plane, which are shared: in its coordinates, from where they lie.
struct Outlines
{
    SignRole role = SignRole::Traced;
    Similarity placement;
    std::shared_ptr<const std::vector<Polygon>> lines; // never null
    bool operator==(const Outlines &other) const
    {
        return role == other.role && lines == other.lines &&
               placement.turn == other.placement.turn && placement.scale == other.placement.scale &&
               placement.shift == other.placement.shift;
    }
};
/// A closed line of curves in a plane.
struct Curve
{
    SignRole role = SignRole::Figure;
    Frame frame;
    Contour contour; // frame coordinates
    bool operator==(const Curve &) const = default;
};
/// What can be taken hold of, or has been caught.
struct Handle
{
    SignRole role = SignRole::Place;
    Vec3 at = Vec3::Zero();
    bool operator==(const Handle &) const = default;
};
/// Said as its length, and with how far it goes along each axis.
struct Way
{
    Vec3 by = Vec3::Zero();
    bool isLengthAlone = false;
    bool operator==(const Way &) const = default;
};
/// Words in the middle of these places, as they are seen, and so far beside it (px).
struct Label
{
    SignRole role = SignRole::Measured;
    std::vector<Vec3> places;
    std::variant<Message, Way> words;
    Vec2 offset = Vec2::Zero();
    bool operator==(const Label &) const = default;
};
/// A filled outline.
struct Region
{
    SignRole role = SignRole::Plane;
    std::vector<Vec3> outline;
    bool operator==(const Region &) const = default;
};
/// All that is so near to a piece of a canvas' x axis, from 0 on.
struct Capsule
{
    SignRole role = SignRole::DeadZone;
    Frame canvas;
    double length = 0.0, radius = 0.0; // mm
    bool operator==(const Capsule &) const = default;
};
/// As long wherever it is seen from; end on there is nothing to be seen.
struct Arrow
{
    SignRole role = SignRole::Slit;
    Vec3 from = Vec3::Zero(), direction = Vec3::UnitX(); // unit
    double length = 34.0;                                // px, across the line of sight
    bool operator==(const Arrow &) const = default;
};
/// From one corner to the other on the screen, px.
struct Band
{
    Box2 box;
    bool operator==(const Band &other) const
    {
        return box.min == other.box.min && box.max == other.box.max;
    }
};

// What is laid out by what else is seen.

/// A slit while it is drawn.
struct Slit
{
    Vec3 from = Vec3::Zero(), to = Vec3::Zero(); // pressed point, cursor or leaving point
    bool hasLeft = false;                        // `to` is where the stroke left the section
    std::string section;                         // its name
    Text guide = {};                             // what it goes along; empty: nothing
    double clearance = 0.0;                      // mm that its words keep off it, besides
    bool hasWords = true;                        // else its number is read elsewhere
    bool operator==(const Slit &) const = default;
};
/// A contour while it is drawn. Never equal: it is as long as the hand moves.
struct Stroke
{
    ContourTarget::Purpose purpose = ContourTarget::Purpose::NewSection;
    std::string section; // the name of the one that it makes or changes; empty: none yet
    Frame canvas;
    std::vector<Vec2> samples;       // frame coordinates of canvas
    std::vector<CubicBezier> fitted; // open chain as drawn so far
    /// The pieces that a release would add: before its start, when it is mirrored, and at its
    /// end; and the half that is mirrored.
    std::optional<CubicBezier> opening, closing;
    std::vector<CubicBezier> mirrored;
    std::optional<MirrorAxis> axis;          // there is one, whether it is used or not
    std::optional<SymmetryVerdict> symmetry; // where there is an axis
    bool isMirrored = false, isAxisSlit = true, doHalvesMeet = true;
    int pieces = 0;             // curves of what it encloses
    std::optional<Contour> cut; // what it encloses, where the ground cuts that
    /// Of what a release makes (a hole: its own), as seen, width and height, mm.
    std::optional<Vec2> size;
    bool operator==(const Stroke &) const { return false; }
};
/// A line that may follow guides, as far as it goes.
struct FollowedGuide
{
    std::string name;      // of the template
    double share = 0.0;    // of the line that lies on them, 0 … 1
    double farthest = 0.0; // mm, of the rest from them
    bool isBegun = false;  // there is such a line
    bool operator==(const FollowedGuide &) const = default;
};
/// The curves in which a canvas cuts templates, frame coordinates of the canvas.
struct Guides
{
    struct Loop
    {
        Polygon points;
        bool isHole = false, isOpen = false;
        bool operator==(const Loop &) const = default;
    };
    Frame canvas;
    /// Each from where it is nearest to the canvas' origin on; the same ones as long as the canvas
    /// stays. Never null.
    std::shared_ptr<const std::vector<Loop>> loops;
    std::vector<Vec2> turnouts;                 // where what is drawn leaves one, or comes to it
    std::optional<Vec2> caught;                 // what is drawn follows one there
    std::optional<FollowedGuide> followed = {}; // nothing is to follow them
    bool operator==(const Guides &) const = default;
};
/// Where the canvas meets the ground: a line without ends.
struct Ground
{
    Vec3 point = Vec3::Zero(), direction = Vec3::UnitX(); // unit
    bool operator==(const Ground &) const = default;
};
/// Along the axes of this frame: what is drawn is counted there.
struct Rulers
{
    Frame grid;
    bool operator==(const Rulers &) const = default;
};
/// The control points of the selected section, while they can be edited.
struct Points
{
    SectionRef section; // editedSection() of it has the points
    std::vector<PointAddress> selected;
    std::optional<PointTarget> hovered;
    bool operator==(const Points &) const = default;
};
/// Of the joints of what is selected.
struct Joints
{
    std::vector<JointMark> marks; // those that are not hidden
    int hovered = -1;             // index of one, or dragged
    std::vector<JointLook> lit;   // what is hovered and what is selected
    bool operator==(const Joints &) const = default;
};

} // namespace sign

using Sign = std::variant<sign::Line, sign::Outlines, sign::Curve, sign::Handle, sign::Label,
                          sign::Region, sign::Capsule, sign::Arrow, sign::Band, sign::Slit,
                          sign::Stroke, sign::Guides, sign::Ground, sign::Rulers, sign::Points,
                          sign::Joints, PenMarks, GizmoMarks, OperationMarks>;

} // namespace fff
