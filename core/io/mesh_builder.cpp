#include "core/io/mesh_builder.h"

#include "core/io/loaded_document.h"

#include <QtCore/QCoreApplication>

#include <algorithm>

namespace fff::io {

namespace {

/// Twice its area, towards its outside, for corners that go round counter-clockwise (Newell).
Vec3 polygonNormal(std::span<const std::uint32_t> corners, const std::vector<Vec3> &positions)
{
    Vec3 normal = Vec3::Zero();
    const Vec3 &first = positions[corners[0]];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal += (positions[corners[i]] - first).cross(positions[corners[i + 1]] - first);
    return normal;
}

/// Cuts off one corner after the other.
class EarCutter
{
public:
    EarCutter(std::span<const std::uint32_t> corners, const std::vector<Vec3> &positions)
        : m_corners(corners.begin(), corners.end())
    {
        const Vec3 normal = polygonNormal(corners, positions);
        int axis = 0;
        normal.cwiseAbs().maxCoeff(&axis);
        const int x = (axis + 1) % 3, y = (axis + 2) % 3;
        const double side = normal[axis] < 0.0 ? -1.0 : 1.0;
        for (const std::uint32_t corner : corners)
            m_points.emplace_back(positions[corner][x], side * positions[corner][y]);
    }

    template <class Add>
    void cut(Add add)
    {
        while (m_corners.size() > 3) {
            const std::size_t ear = findEar();
            add(at(ear, -1), at(ear, 0), at(ear, 1));
            m_corners.erase(m_corners.begin() + static_cast<std::ptrdiff_t>(ear));
            m_points.erase(m_points.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        add(m_corners[0], m_corners[1], m_corners[2]);
    }

private:
    std::size_t index(std::size_t i, int by) const
    {
        const auto count = static_cast<std::ptrdiff_t>(m_corners.size());
        return static_cast<std::size_t>((static_cast<std::ptrdiff_t>(i) + by + count) % count);
    }
    std::uint32_t at(std::size_t i, int by) const { return m_corners[index(i, by)]; }
    double turn(const Vec2 &a, const Vec2 &b, const Vec2 &c) const { return cross(b - a, c - a); }

    bool isEar(std::size_t i) const
    {
        const Vec2 &a = m_points[index(i, -1)], &b = m_points[i], &c = m_points[index(i, 1)];
        if (!(turn(a, b, c) > 0.0))
            return false;
        return std::none_of(m_points.begin(), m_points.end(), [&](const Vec2 &p) {
            return p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 &&
                   turn(c, a, p) >= 0.0;
        });
    }
    /// The first one; of what has none, as it crosses itself or lies on a line, any corner.
    std::size_t findEar() const
    {
        for (std::size_t i = 1; i < m_corners.size(); ++i)
            if (isEar(i))
                return i;
        return isEar(0) ? 0 : 1;
    }

    std::vector<std::uint32_t> m_corners;
    std::vector<Vec2> m_points;
};

constexpr std::size_t kMostEars = 1000; // corners; the work is up to their cube

/// Just as much the first time, and twice as much where it comes by and by.
template <class T>
void makeRoom(std::vector<T> &list, std::uint64_t count)
{
    const std::size_t needed = list.size() + static_cast<std::size_t>(count);
    if (needed > list.capacity())
        list.reserve(std::max(needed, list.empty() ? std::size_t(0) : 2 * list.capacity()));
}

} // namespace

void cutPolygon(std::span<const std::uint32_t> corners, const std::vector<Vec3> &positions,
                const std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)> &add)
{
    const bool isKnown = std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
        return corner < positions.size() && positions[corner].allFinite();
    });
    if (isKnown && corners.size() > 3 && corners.size() <= kMostEars) {
        EarCutter(corners, positions).cut(add);
        return;
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        add(corners[0], corners[i], corners[i + 1]);
}

std::string byteAt(std::uint64_t offset)
{
    return "byte " + std::to_string(offset);
}

void MeshBuilder::addPolygon(std::span<const std::uint32_t> corners)
{
    if (corners.size() == 3)
        return addTriangle(corners[0], corners[1], corners[2]);
    if (corners.size() < 3)
        return;
    m_corners.insert(m_corners.end(), corners.begin(), corners.end());
    m_ends.push_back(m_corners.size());
    const std::size_t triangles = draft.triangles.size() + m_corners.size() - 2 * m_ends.size();
    if (triangles > m_options.mostTriangles)
        tooMany(triangles);
}

void MeshBuilder::takeVertices(VertexMerger &merger)
{
    draft.positions = merger.take();
    draft.isMerged = true;
    const auto nowhere = static_cast<std::uint32_t>(draft.positions.size());
    bool isAny = false;
    for (Triangle &triangle : draft.triangles)
        for (std::uint32_t &corner : triangle)
            if (corner == kNowhere) {
                corner = nowhere;
                isAny = true;
            }
    if (isAny)
        draft.positions.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
}

bool MeshBuilder::expect(std::uint64_t count, std::uint64_t bytesEach, std::uint64_t bytes,
                         const std::string &where, const char *what)
{
    if (failed())
        return false;
    if (count > bytes / std::max<std::uint64_t>(bytesEach, 1))
        fail(ErrorCode::BadCount, where,
             {std::to_string(count), std::to_string(bytes / std::max<std::uint64_t>(bytesEach, 1)),
              what});
    return !failed();
}

bool MeshBuilder::expectTriangles(std::uint64_t count, std::uint64_t bytesEach, std::uint64_t bytes,
                                  const std::string &where)
{
    if (count > m_options.mostTriangles)
        tooMany(count);
    if (!expect(count, bytesEach, bytes, where, QT_TRANSLATE_NOOP("Error", "triangles")))
        return false;
    makeRoom(draft.triangles, count);
    return true;
}

bool MeshBuilder::expectVertices(std::uint64_t count, std::uint64_t bytesEach, std::uint64_t bytes,
                                 const std::string &where)
{
    if (count >= kNoVertex)
        fail(ErrorCode::BadCount, where,
             {std::to_string(count), std::to_string(kNoVertex - 1),
              QT_TRANSLATE_NOOP("Error", "vertices")});
    if (!expect(count, bytesEach, bytes, where, QT_TRANSLATE_NOOP("Error", "vertices")))
        return false;
    makeRoom(draft.positions, count);
    return true;
}

void MeshBuilder::tooMany(std::uint64_t count)
{
    fail(ErrorCode::BadCount, {},
         {std::to_string(count), std::to_string(m_options.mostTriangles),
          QT_TRANSLATE_NOOP("Error", "triangles")});
}

void MeshBuilder::fail(ErrorCode code, const std::string &where, std::vector<std::string> args)
{
    if (!m_error)
        m_error = Error{code, placeIn(m_options.name, where), std::move(args)};
}

bool MeshBuilder::goOn(double share)
{
    if (m_options.work.isStopped())
        fail(ErrorCode::Cancelled, {});
    else
        m_options.work.tell(share);
    return !failed();
}

Result<MeshDraft> MeshBuilder::finish()
{
    for (std::size_t i = 0, from = 0; i < m_ends.size() && !failed(); from = m_ends[i++])
        cutPolygon(
            std::span(m_corners).subspan(from, m_ends[i] - from), draft.positions,
            [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) { addTriangle(a, b, c); });
    if (m_error)
        return tl::unexpected(*m_error);
    return std::move(draft);
}

} // namespace fff::io
