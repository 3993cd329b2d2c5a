// Where pictures and drawings lie: on which plane, how large, and turned how. Pure: what comes back
// is the template as it would be (setTemplate() puts it into a document).
#pragma once

#include "core/base/result.h"
#include "core/model/model.h"

#include <array>
#include <optional>
#include <utility>

namespace fff {

/// As a person looks at them, x is to the right: of the ground along the world's x, with y away
/// along −z; of the front along x; of the side, which is seen along −x, along −z.
enum class StandardPlane { Ground, Front, Side };

/// Width and height in the file's units: pixels, or mm of a drawing. Zero where it is not read.
Vec2 flatExtent(const Template &one);
/// The same as it lies, mm.
Vec2 flatSize(const Template &one);

/// From the file's coordinates, about its middle, y upwards, to the world; none while the section
/// that it lies on is not there.
std::optional<Similarity> worldPlacement(const Template &one, const Model &model);
/// Its plane: x to the right in it and y up, however it is flipped.
std::optional<Frame> worldFrame(const Template &one, const Model &model);
/// In the space of the placement: lower left, lower right, upper right, upper left of the file.
std::array<Vec3, 4> cornersOf(const Template &one, const Similarity &placement);

/// Upright there and about the plane's origin; but for the ground it stands on that.
Template laidOn(Template one, StandardPlane plane);
/// Upright on the section's plane, about the middle of its box; it goes with the section.
Template laidOn(Template one, const Section &section);
/// Moved straight up or down until it stands on the ground. One on a section stays.
Template flatOnGround(Template one);

/// From upright, of a plane as worldFrame() has it; of a level one from the world's x. Radians,
/// counter-clockwise as seen from where its normal points.
double turnOf(const Frame &world);
/// By this angle more about its middle.
Template turned(Template one, double by);

/// So that it is as large in its largest extent, mm, about its middle. Not for one that is not
/// read.
Template sizedTo(Template one, double size);
/// What is drawn in it, in the file's units about its middle; of a drawing all of it.
Box2 drawnBox(const Template &one);

/// Front and side of the same thing, each with the box of it in there: the one on the plane of the
/// front, as large as it is, the other one as high on that of the side; both stand on the ground
/// with the middle of their boxes above the world's origin.
///
/// Errors  BadValue, place = "front" or "side", for a box without a height, and for what would be
///         too large or too small
/// Source  J. McCrae et al. 2014, FlatFitFab, figure 1: traced over pictures on two planes at right
///         angles
Result<std::pair<Template, Template>> aligned(Template front, const Box2 &frontBox, Template side,
                                              const Box2 &sideBox);

} // namespace fff
