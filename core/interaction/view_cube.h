// The cube in the view's upper right corner that shows how the model is looked at and turns it: six
// faces, twelve edges and eight corners to click on. Plain geometry in pixels; drawn elsewhere.
#pragma once

#include "core/geometry/vector.h"

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace fff {

/// By the side of the cube that it lies on in x, y and z: -1, 0 or 1 each, never all 0. One that is
/// not 0: a face (0, 1, 0 is the top); two: an edge; three: a corner.
struct CubePart
{
    int x = 0, y = 0, z = 0;

    int rank() const { return (x != 0) + (y != 0) + (z != 0); } // 1 face, 2 edge, 3 corner
    bool operator==(const CubePart &) const = default;
};

/// A face that is turned to the eye. The half edges run in the directions of its letters: `right`
/// along the line, `up` to their upper end. The face is centre ± right ± up.
struct CubeFace
{
    CubePart part;
    Vec2 centre, right, up; // px
};

/// Side of the square that the cube may take up at most, and of the cube itself, px.
inline constexpr double kCubeRoom = 92.0, kCubeEdge = 51.0;

/// px. None in a view too small for it.
std::optional<Vec2> cubeCentre(const Vec2 &viewport);
/// At most three, in no order that matters: they do not overlap.
std::vector<CubeFace> visibleFaces(const Eigen::Quaterniond &orientation, const Vec2 &viewport);
/// The part of the face's square that belongs to `part`, as its four corners; none when it does not
/// lie on that face.
std::optional<std::array<Vec2, 4>> partOnFace(const CubeFace &face, const CubePart &part);
/// What is under the cursor. None beside the cube.
std::optional<CubePart> cubePartAt(const Vec2 &screen, const Eigen::Quaterniond &orientation,
                                   const Vec2 &viewport);

/// All 26.
std::vector<CubePart> cubeParts();
/// How a camera looks straight at a part, upright: a face as the view of its name, a corner as iso1
/// … iso4 or from below them, an edge from the middle between its faces.
Eigen::Quaterniond orientationOfPart(const CubePart &part);
/// "front", "top" … for a face, "edge", "corner".
std::string_view nameOfPart(const CubePart &part);

} // namespace fff
