#include "core/templates/mesh_tree.h"

#include <cassert>
#include <limits>

namespace fff {

namespace {

constexpr int kBitsAnAxis = 10;

/// Two zeros behind each of ten bits.
std::uint32_t spread(std::uint32_t bits)
{
    bits = (bits | (bits << 16)) & 0x030000FFu;
    bits = (bits | (bits << 8)) & 0x0300F00Fu;
    bits = (bits | (bits << 4)) & 0x030C30C3u;
    return (bits | (bits << 2)) & 0x09249249u;
}

struct CurvePlace
{
    std::uint32_t key = 0, face = 0;
};

/// By key, equal ones as they were.
void sortByKey(std::vector<CurvePlace> &places)
{
    constexpr int kDigits = 10, kPasses = 3;
    constexpr std::uint32_t kMask = (1u << kDigits) - 1;
    std::vector<CurvePlace> other(places.size());
    for (int pass = 0; pass < kPasses; ++pass) {
        const int shift = pass * kDigits;
        std::array<std::size_t, std::size_t(kMask) + 2> starts{};
        for (const CurvePlace &place : places)
            ++starts[((place.key >> shift) & kMask) + 1];
        for (std::size_t i = 1; i < starts.size(); ++i)
            starts[i] += starts[i - 1];
        for (const CurvePlace &place : places)
            other[starts[(place.key >> shift) & kMask]++] = place;
        places.swap(other);
    }
}

float roundedDown(double value)
{
    const auto near = static_cast<float>(value);
    return near <= value ? near : std::nextafter(near, -std::numeric_limits<float>::infinity());
}

float roundedUp(double value)
{
    const auto near = static_cast<float>(value);
    return near >= value ? near : std::nextafter(near, std::numeric_limits<float>::infinity());
}

} // namespace

Result<MeshTree> MeshTree::make(const TriangleMesh &mesh, const LongWork &work)
{
    const std::vector<Vec3> &positions = mesh.positions();
    const std::vector<Triangle> &triangles = mesh.triangles();
    const double size = mesh.size();
    constexpr double kCells = 1 << kBitsAnAxis;
    const double scale = size > 0.0 ? kCells / size : 0.0;
    const Vec3 low = mesh.bounds().min;

    std::vector<CurvePlace> places(triangles.size());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        const Triangle &t = triangles[f];
        const Vec3 middle = (positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3.0 - low;
        std::uint32_t key = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double cell = std::clamp(middle[axis] * scale, 0.0, kCells - 1.0);
            key |= spread(static_cast<std::uint32_t>(cell)) << axis;
        }
        places[f] = {key, static_cast<std::uint32_t>(f)};
    }
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    sortByKey(places);
    work.tell(0.5);
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    std::vector<std::uint32_t> order(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        order[i] = places[i].face;
    MeshTree tree;
    tree.m_order = std::make_shared<const std::vector<std::uint32_t>>(std::move(order));
    tree.fit(mesh);
    work.tell(1.0);
    return tree;
}

MeshTree MeshTree::refitted(const TriangleMesh &mesh) const
{
    assert(mesh.triangles().size() == m_order->size() && "a mesh of the same triangles");
    MeshTree tree;
    tree.m_order = m_order;
    tree.fit(mesh);
    return tree;
}

void MeshTree::fit(const TriangleMesh &mesh)
{
    m_middle = mesh.bounds().center();
    m_levels.clear();
    std::vector<Box> leaves((m_order->size() + kLeafFaces - 1) / kLeafFaces);
    for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
        Box3 box;
        const std::size_t last = std::min(kLeafFaces * (leaf + 1), m_order->size());
        for (std::size_t i = kLeafFaces * leaf; i < last; ++i)
            for (const std::uint32_t corner : mesh.triangles()[(*m_order)[i]])
                box.extend(mesh.positions()[corner]);
        for (int axis = 0; axis < 3; ++axis) {
            leaves[leaf].low[std::size_t(axis)] = roundedDown(box.min[axis] - m_middle[axis]);
            leaves[leaf].high[std::size_t(axis)] = roundedUp(box.max[axis] - m_middle[axis]);
        }
    }
    m_levels.push_back(std::move(leaves));
    while (m_levels.back().size() > 1) {
        const std::vector<Box> &below = m_levels.back();
        std::vector<Box> level((below.size() + kFanOut - 1) / kFanOut);
        for (std::size_t i = 0; i < level.size(); ++i) {
            level[i] = below[kFanOut * i];
            const std::size_t last = std::min(kFanOut * (i + 1), below.size());
            for (std::size_t j = kFanOut * i + 1; j < last; ++j)
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    level[i].low[axis] = std::min(level[i].low[axis], below[j].low[axis]);
                    level[i].high[axis] = std::max(level[i].high[axis], below[j].high[axis]);
                }
        }
        m_levels.push_back(std::move(level));
    }
}

MeshTree::PlaneTest MeshTree::testOf(const CutPlane &plane) const
{
    PlaneTest test;
    test.normal = plane.normal;
    test.size = plane.normal.cwiseAbs();
    const Vec3 origin = plane.origin - m_middle;
    test.offset = plane.normal.dot(origin);
    // All that is rounded, of the plane and of the largest box, some sixteen times over.
    constexpr double kRounding = 32.0 * std::numeric_limits<double>::epsilon();
    const Box &all = m_levels.back().front();
    Vec3 reach = origin.cwiseAbs() + m_middle.cwiseAbs();
    for (int axis = 0; axis < 3; ++axis)
        reach[axis] += std::max(std::abs(double(all.low[std::size_t(axis)])),
                                std::abs(double(all.high[std::size_t(axis)])));
    test.slack = kRounding * test.size.dot(reach);
    return test;
}

std::size_t MeshTree::bytes() const
{
    std::size_t sum = m_order->size() * sizeof(std::uint32_t);
    for (const std::vector<Box> &level : m_levels)
        sum += level.size() * sizeof(Box);
    return sum;
}

} // namespace fff
