// Boxes on sheets of one size: each as low as it goes on what is there already.
#pragma once

#include "core/base/tolerances.h"
#include "core/geometry/vector.h"

#include <vector>

namespace fff {

/// What is free of one sheet: everything above a skyline. Boxes are put where their upper edge
/// comes lowest, then leftmost; what they leave free below them is lost.
/// Source  J. Jylänki 2010, A Thousand Ways to Pack the Bin, section 5 (skyline bottom-left).
class Skyline
{
public:
    explicit Skyline(const Vec2 &size);

    struct Place
    {
        Vec2 corner = Vec2::Zero(); // lower left
        double top = 0.0;           // of the box there; infinite: it does not fit
    };
    /// O(segments).
    Place find(const Vec2 &box) const;
    void put(const Vec2 &box, const Place &place);
    /// How low the lowest place is, however narrow.
    double lowest() const { return m_lowest; }

    /// Whether something whose upper edge is there stays on a sheet of the size.
    static bool isWithin(double top, const Vec2 &size) { return top <= size.y() + kClipGrid; }

private:
    struct Segment
    {
        double from = 0.0, to = 0.0; // x
        double y = 0.0;
    };

    Vec2 m_size;
    double m_lowest = 0.0;
    std::vector<Segment> m_segments; // from left to right, touching
    std::vector<Segment> m_next;     // space for those after a box is put
};

} // namespace fff
