// Makes one vertex of those that are equal: files of loose triangles, and those that give a vertex
// twice where a texture has its seam, then hang together.
#pragma once

#include "core/geometry/vector.h"

#include <cstdint>
#include <vector>

namespace fff {

/// Equal are points whose three coordinates are equal; 0 and −0 are. Not for NaN.
class VertexMerger
{
public:
    /// expected: different vertices, roughly.
    explicit VertexMerger(std::size_t expected);

    /// The index of this point, a new one if it is the first of its kind.
    std::uint32_t add(const Vec3 &point);

    const std::vector<Vec3> &points() const { return m_points; }
    std::vector<Vec3> take() { return std::move(m_points); }

private:
    void grow();

    std::vector<Vec3> m_points;
    std::vector<std::uint32_t> m_slots; // index + 1, 0: free; a power of two of them
    std::size_t m_mask = 0;
};

} // namespace fff
