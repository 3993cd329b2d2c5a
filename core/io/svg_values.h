// The small languages inside an SVG file: numbers, lengths, transforms, path data, styles. Internal
// to io; strings are as in the file, results in user units. Our own in place of SVG++, whose
// numbers are off in the last place, whose errors have no place, and whose arc of radius 0 takes
// all memory.
#pragma once

#include "core/geometry/vector.h"

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fff::io {

using SvgTransform = Eigen::Affine2d;

/// Eats numbers off the front of a text; separators are blanks and at most one comma.
class SvgNumbers
{
public:
    explicit SvgNumbers(std::string_view text) : m_rest(text) {}

    /// Nothing where no number stands, or an infinite one.
    std::optional<double> number();
    /// A single 0 or 1, which needs no separator behind it.
    std::optional<bool> flag();
    /// The letter that stands here, which is eaten; 0 for none.
    char letter();
    bool isAtEnd();
    std::string_view rest() const { return m_rest; }

private:
    void skip();
    std::string_view m_rest;
};

/// "12.5mm": in user units, of which 96 are an inch. percentOf: what 100 % are. Nothing for what is
/// no length.
std::optional<double> svgLength(std::string_view text, double percentOf);
/// Whether the length has a unit that is one of nature: mm, cm, in, pt, pc.
bool isTrueLength(std::string_view text);

std::optional<SvgTransform> svgTransform(std::string_view text);
/// viewBox and preserveAspectRatio, into a box from 0 of this size.
struct SvgViewBox
{
    Vec2 origin = Vec2::Zero(), size = Vec2::Zero();
};
std::optional<SvgViewBox> svgViewBox(std::string_view text);
SvgTransform fitted(const SvgViewBox &box, const Vec2 &size, std::string_view aspect);

/// Chains of control points (3k + 1); closed ones end where they begin.
struct SvgSubpath
{
    std::vector<Vec2> points;
    bool isClosed = false;
};
/// Path data as far as it can be read: `isWhole` is false where an error ended it, which renderers
/// then draw up to there.
struct SvgPathData
{
    std::vector<SvgSubpath> subpaths;
    bool isWhole = true;
    std::string rest; // from the place of the error, its beginning
};
SvgPathData svgPath(std::string_view text);
/// An arc of an ellipse round 0, from angle `from` over `sweep` radians: control points without the
/// first one.
void appendArc(const Vec2 &centre, const Vec2 &radii, double turn, double from, double sweep,
               std::vector<Vec2> &points);

/// "fill: none; stroke: red" by name.
std::map<std::string, std::string> svgDeclarations(std::string_view text);
/// The rules of a style element for classes, ids and names of elements: ".st0", "#a", "path".
std::map<std::string, std::map<std::string, std::string>> svgRules(std::string_view text);

} // namespace fff::io
