#include "core/templates/mesh_edges.h"

#include <algorithm>
#include <numeric>

namespace fff {

namespace {

/// An edge as a face has it, in the row of its lower vertex.
struct FaceEdge
{
    std::uint32_t other = 0; // its higher vertex
    std::uint32_t face = 0;
    bool goesUp = false; // from the lower to the higher vertex
};

/// Rows of edges by their lower vertex; each row by the higher one.
struct EdgeRows
{
    std::vector<std::size_t> starts; // vertices + 1
    std::vector<FaceEdge> edges;     // 3 × faces
};

EdgeRows edgeRows(std::span<const Triangle> triangles, std::size_t vertices)
{
    EdgeRows rows;
    rows.starts.assign(vertices + 2, 0);
    const auto forEdges = [&triangles](auto visit) {
        for (std::size_t f = 0; f < triangles.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i)
                visit(f, triangles[f][i], triangles[f][(i + 1) % 3]);
    };
    // One further on, so that filling the rows leaves the starts where they belong.
    forEdges([&rows](std::size_t, std::uint32_t a, std::uint32_t b) {
        ++rows.starts[std::size_t(std::min(a, b)) + 2];
    });
    std::partial_sum(rows.starts.begin(), rows.starts.end(), rows.starts.begin());
    rows.edges.resize(3 * triangles.size());
    forEdges([&rows](std::size_t f, std::uint32_t a, std::uint32_t b) {
        rows.edges[rows.starts[std::size_t(std::min(a, b)) + 1]++] = {
            std::max(a, b), static_cast<std::uint32_t>(f), a < b};
    });
    rows.starts.pop_back();
    for (std::size_t v = 0; v < vertices; ++v)
        std::sort(rows.edges.begin() + static_cast<std::ptrdiff_t>(rows.starts[v]),
                  rows.edges.begin() + static_cast<std::ptrdiff_t>(rows.starts[v + 1]),
                  [](const FaceEdge &a, const FaceEdge &b) {
                      return a.other != b.other ? a.other < b.other : a.face < b.face;
                  });
    return rows;
}

/// Calls visit(span of the faces at an edge) for every edge, by vertex.
template <class Visit>
void forEachEdge(const EdgeRows &rows, Visit visit)
{
    for (std::size_t v = 0; v + 1 < rows.starts.size(); ++v) {
        for (std::size_t from = rows.starts[v]; from < rows.starts[v + 1];) {
            std::size_t to = from + 1;
            while (to < rows.starts[v + 1] && rows.edges[to].other == rows.edges[from].other)
                ++to;
            visit(std::span(rows.edges).subspan(from, to - from));
            from = to;
        }
    }
}

/// Faces that hang together, and whether each looks as the first of its shell does.
class Shells
{
public:
    explicit Shells(std::size_t faces) : m_parents(faces), m_isTurned(faces, 0)
    {
        std::iota(m_parents.begin(), m_parents.end(), std::uint32_t(0));
    }

    struct Place
    {
        std::uint32_t root = 0;
        bool isTurned = false; // beside the root
    };
    Place find(std::uint32_t face)
    {
        std::uint32_t root = face;
        unsigned turned = 0;
        while (m_parents[root] != root) {
            turned ^= m_isTurned[root];
            root = m_parents[root];
        }
        const bool isTurned = turned != 0;
        // The way there is short the next time.
        while (m_parents[face] != root && face != root) {
            const std::uint32_t next = m_parents[face];
            const unsigned beyond = turned ^ m_isTurned[face];
            m_parents[face] = root;
            m_isTurned[face] = static_cast<std::uint8_t>(turned);
            turned = beyond;
            face = next;
        }
        return {root, isTurned};
    }

    /// False when they hang together already, and look at each other otherwise.
    bool join(std::uint32_t a, std::uint32_t b, bool areOpposed)
    {
        const Place of = find(a), with = find(b);
        const bool isTurned = (of.isTurned != with.isTurned) != areOpposed;
        if (of.root == with.root)
            return !isTurned;
        const std::uint32_t low = std::min(of.root, with.root);
        const std::uint32_t high = std::max(of.root, with.root);
        m_parents[high] = low;
        m_isTurned[high] = isTurned ? 1 : 0;
        return true;
    }

private:
    std::vector<std::uint32_t> m_parents;
    std::vector<std::uint8_t> m_isTurned;
};

/// Turns over the smaller part of each shell, but of those with one of the faces in `oneSided`, in
/// which no way is right. How many faces these were.
std::size_t turnMinorities(std::span<Triangle> triangles, Shells &shells,
                           const std::vector<std::uint32_t> &oneSided)
{
    std::vector<std::int64_t> excess(triangles.size(), 0); // of faces that look as the root does
    std::vector<std::uint8_t> stays(triangles.size(), 0);
    for (const std::uint32_t face : oneSided)
        stays[shells.find(face).root] = 1;
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        const Shells::Place place = shells.find(static_cast<std::uint32_t>(f));
        excess[place.root] += place.isTurned ? -1 : 1;
    }
    std::size_t turned = 0;
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        const Shells::Place place = shells.find(static_cast<std::uint32_t>(f));
        // Of two halves that of the first face is right.
        if (!stays[place.root] && place.isTurned != (excess[place.root] < 0)) {
            std::swap(triangles[f][1], triangles[f][2]);
            ++turned;
        }
    }
    return turned;
}

} // namespace

bool lookTheSameWay(std::span<Triangle> triangles, std::size_t vertices, MeshReport &report,
                    const LongWork &work)
{
    const EdgeRows rows = edgeRows(triangles, vertices);
    work.tell(0.5);
    if (work.isStopped())
        return false;
    // What looks which way is settled by edges of two faces alone; crowded ones only hold together.
    Shells ways(triangles.size()), pieces(triangles.size());
    bool isAllAlike = true;
    std::size_t crowded = 0;
    std::vector<std::uint32_t> oneSided;
    forEachEdge(rows, [&](std::span<const FaceEdge> faces) {
        if (faces.size() == 1)
            ++report.openEdges;
        if (faces.size() > 2)
            ++crowded;
        if (faces.size() != 2)
            return;
        const bool areOpposed = faces[0].goesUp == faces[1].goesUp;
        isAllAlike = isAllAlike && !areOpposed;
        if (!ways.join(faces[0].face, faces[1].face, areOpposed))
            oneSided.push_back(faces[0].face);
    });
    report.crowdedEdges += crowded;
    report.oneSidedEdges += oneSided.size();
    if (work.isStopped())
        return false;
    if (!isAllAlike)
        report.flipped += turnMinorities(triangles, ways, oneSided);
    if (crowded > 0) {
        forEachEdge(rows, [&](std::span<const FaceEdge> faces) {
            for (const FaceEdge &other : faces.subspan(1))
                pieces.join(faces[0].face, other.face, false);
        });
    }
    Shells &held = crowded > 0 ? pieces : ways;
    for (std::size_t f = 0; f < triangles.size(); ++f)
        if (held.find(static_cast<std::uint32_t>(f)).root == f)
            ++report.shells;
    work.tell(1.0);
    return true;
}

} // namespace fff
