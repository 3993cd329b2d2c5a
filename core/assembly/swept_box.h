// A box that moves on and on: what is nowhere near a part's way is told apart by it.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace fff {

/// Whether a box, moved along a direction without end, shares more than `depth` (mm) with another
/// one on its way.
class SweptBox
{
public:
    SweptBox(Box3 box, const Vec3 &direction, double depth)
        : m_box(std::move(box)), m_direction(direction), m_inverse(direction.cwiseInverse()),
          m_depth(depth)
    {
    }
    bool operator()(const Box3 &other) const
    {
        double from = 0.0, to = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            const double low = other.min[i] + m_depth - m_box.max[i];
            const double high = other.max[i] - m_depth - m_box.min[i];
            if (m_direction[i] == 0.0) {
                if (low >= 0.0 || high <= 0.0)
                    return false;
                continue;
            }
            const double first = low * m_inverse[i], second = high * m_inverse[i];
            from = std::max(from, std::min(first, second));
            to = std::min(to, std::max(first, second));
        }
        return from < to;
    }

private:
    Box3 m_box;
    Vec3 m_direction, m_inverse;
    double m_depth;
};

} // namespace fff
