#include "core/templates/vertex_merger.h"

#include <algorithm>
#include <bit>

namespace fff {

namespace {

std::size_t hashOfPoint(const Vec3 &p)
{
    // Multiplied and folded: the low bits of coordinates that came from floats are all 0.
    constexpr std::uint64_t kX = 0x9E3779B97F4A7C15u, kY = 0xC2B2AE3D27D4EB4Fu,
                            kZ = 0x165667B19E3779F9u;
    std::uint64_t hash = std::bit_cast<std::uint64_t>(p.x()) * kX;
    hash = (hash ^ (hash >> 32)) + std::bit_cast<std::uint64_t>(p.y()) * kY;
    hash = (hash ^ (hash >> 29)) + std::bit_cast<std::uint64_t>(p.z()) * kZ;
    hash ^= hash >> 32;
    return static_cast<std::size_t>((hash * kX) >> 20);
}

constexpr std::size_t kLeastSlots = 64;

} // namespace

VertexMerger::VertexMerger(std::size_t expected)
    : m_slots(std::bit_ceil(std::max(kLeastSlots, 2 * expected)), 0), m_mask(m_slots.size() - 1)
{
    m_points.reserve(expected);
}

std::uint32_t VertexMerger::add(const Vec3 &given)
{
    const Vec3 point = given.array() + 0.0; // −0 becomes 0
    for (std::size_t slot = hashOfPoint(point) & m_mask;; slot = (slot + 1) & m_mask) {
        if (m_slots[slot] == 0) {
            m_points.push_back(point);
            m_slots[slot] = static_cast<std::uint32_t>(m_points.size());
            const auto index = m_slots[slot] - 1;
            if (4 * m_points.size() > 3 * m_slots.size())
                grow();
            return index;
        }
        if (m_points[m_slots[slot] - 1] == point)
            return m_slots[slot] - 1;
    }
}

void VertexMerger::grow()
{
    m_slots.assign(2 * m_slots.size(), 0);
    m_mask = m_slots.size() - 1;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        std::size_t slot = hashOfPoint(m_points[i]) & m_mask;
        while (m_slots[slot] != 0)
            slot = (slot + 1) & m_mask;
        m_slots[slot] = static_cast<std::uint32_t>(i + 1);
    }
}

} // namespace fff
