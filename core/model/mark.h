// What is drawn on a section and not cut through it: lines and letters that the laser engraves or
// scores on its front.
#pragma once

#include "core/geometry/curve_path.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fff {

/// Words that a mark was made of; it can be written anew as long as it has them.
struct Lettering
{
    std::string text;       // lines end with \n
    double height = 10.0;   // of a capital, mm
    Vec2 at = Vec2::Zero(); // middle of the box round all of it, frame coordinates, mm
    double turn = 0.0;      // radians, counter-clockwise

    bool operator==(const Lettering &other) const
    {
        return text == other.text && height == other.height && at == other.at && turn == other.turn;
    }
};

struct Mark
{
    /// Engraved: a line that is seen. Scored: one that is burnt deeper, to fold or break along.
    enum class Kind { Engraved, Scored };
    Kind kind = Kind::Engraved;
    std::vector<CurvePath> paths; // frame coordinates, mm; at least one
    std::optional<Lettering> lettering = {};

    bool operator==(const Mark &) const = default;
};

using MarkPointer = std::shared_ptr<const Mark>;

/// The mark with each point p at about + matrix (p − about). Lettering goes along where it stays
/// upright and even; else its lines stay, without the words. Errors  as CurvePath::mapped().
Result<MarkPointer> mapped(const MarkPointer &mark, const Eigen::Matrix2d &matrix,
                           const Vec2 &about);
/// All of them. Those that would leave all bounds are left out.
std::vector<MarkPointer> mapped(const std::vector<MarkPointer> &marks,
                                const Eigen::Matrix2d &matrix, const Vec2 &about);

} // namespace fff
