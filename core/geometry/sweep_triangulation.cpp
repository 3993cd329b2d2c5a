#include "core/geometry/sweep_triangulation.h"

#include "core/geometry/side_of_line.h"
#include "core/geometry/sliver_mender.h"

#include <algorithm>

namespace fff {

namespace {

/// "Forward" is where the sweep goes. The inside lies to the left of every edge, so one that goes
/// forward is the right border of a stretch of the sweep line inside the region, one that goes back
/// its left border. An edge is named by the vertex that it starts at.
class Sweep
{
public:
    explicit Sweep(const Region &region);
    bool run();
    Triangulation take() { return std::move(m_result); }

private:
    /// Of a chain: what is cut off behind the sweep is bordered by it.
    struct Link
    {
        int vertex = 0;
        int toRight = -1, toLeft = -1; // links
    };
    /// A stretch of the sweep line inside the region, and the chain behind it from its right border
    /// to its left one.
    struct Stretch
    {
        int rightEdge = 0, leftEdge = 0;
        int rightEnd = 0, leftEnd = 0; // links
        int last = 0;                  // link of the vertex that the sweep came to last
    };

    const Vec2 &at(int vertex) const { return m_result.points[static_cast<std::size_t>(vertex)]; }
    bool isBefore(int a, int b) const
    {
        return m_rank[static_cast<std::size_t>(a)] < m_rank[static_cast<std::size_t>(b)];
    }
    bool findOrder();
    int addLink(int vertex)
    {
        m_links.push_back({vertex, -1, -1});
        return static_cast<int>(m_links.size()) - 1;
    }
    Link &link(int index) { return m_links[static_cast<std::size_t>(index)]; }
    void addTriangle(int a, int b, int c) { m_result.triangles.push_back({a, b, c}); }
    void addRing(const Polygon &ring);

    bool visit(int vertex);
    void begin(int vertex, int rightEdge, int leftEdge);
    bool split(int vertex, int rightEdge, int leftEdge);
    void bendRight(Stretch &stretch, int vertex);
    void bendLeft(Stretch &stretch, int vertex);
    bool end(std::size_t stretch, int vertex);
    void join(std::size_t right, std::size_t left, int vertex);
    void eatFromRight(int &from, int vertex);
    void eatFromLeft(int &from, int vertex);
    std::size_t stretchOf(int Stretch::*edge, int value) const;
    void remove(std::size_t stretch)
    {
        m_stretches[stretch] = m_stretches.back();
        m_stretches.pop_back();
    }

    Triangulation m_result;
    std::vector<int> m_before, m_after; // neighbours of each vertex in its ring
    std::vector<int> m_order, m_rank;   // as the sweep comes to them; of each where in that order
    std::vector<Link> m_links;
    std::vector<Stretch> m_stretches;
    bool m_alongY = false;
    bool m_isPlain = true;
};

Sweep::Sweep(const Region &region)
{
    std::size_t count = region.outer.size();
    for (const Polygon &hole : region.holes)
        count += hole.size();
    m_result.points.reserve(count);
    m_before.reserve(count);
    m_after.reserve(count);
    addRing(region.outer);
    for (const Polygon &hole : region.holes)
        addRing(hole);
    m_result.triangles.reserve(count + 2 * region.holes.size());
    m_links.reserve(2 * count);
    const Vec2 size = bounds(region.outer).size();
    m_alongY = size.y() > size.x(); // the longer way: fewer stretches at once
}

void Sweep::addRing(const Polygon &ring)
{
    if (ring.size() < 3)
        m_isPlain = false;
    const int first = static_cast<int>(m_result.points.size());
    const int count = static_cast<int>(ring.size());
    for (int i = 0; i < count; ++i) {
        m_before.push_back(first + (i > 0 ? i - 1 : count - 1));
        m_after.push_back(first + (i + 1 < count ? i + 1 : 0));
    }
    m_result.points.insert(m_result.points.end(), ring.begin(), ring.end());
}

std::size_t Sweep::stretchOf(int Stretch::*edge, int value) const
{
    // The newest ones are at the end, and mostly there is one or two.
    std::size_t i = m_stretches.size();
    while (i > 0 && m_stretches[i - 1].*edge != value)
        --i;
    return i - 1;
}

/// Cuts triangles off the right end of a chain, as far as the vertex sees it; `from` is then what
/// the vertex is joined to.
void Sweep::eatFromRight(int &from, int vertex)
{
    for (int next = link(from).toLeft; next >= 0; next = link(from).toLeft) {
        const int a = link(from).vertex, b = link(next).vertex;
        if (!(sideOfLine(at(a), at(vertex), at(b)) > 0.0))
            return;
        addTriangle(a, vertex, b);
        from = next;
    }
}

void Sweep::eatFromLeft(int &from, int vertex)
{
    for (int next = link(from).toRight; next >= 0; next = link(from).toRight) {
        const int a = link(from).vertex, b = link(next).vertex;
        if (!(sideOfLine(at(b), at(vertex), at(a)) > 0.0))
            return;
        addTriangle(b, vertex, a);
        from = next;
    }
}

void Sweep::begin(int vertex, int rightEdge, int leftEdge)
{
    const int only = addLink(vertex);
    m_stretches.push_back({rightEdge, leftEdge, only, only, only});
}

void Sweep::bendRight(Stretch &stretch, int vertex)
{
    int from = stretch.rightEnd;
    eatFromRight(from, vertex);
    const int added = addLink(vertex);
    link(added).toLeft = from;
    link(from).toRight = added;
    stretch.rightEnd = stretch.last = added;
}

void Sweep::bendLeft(Stretch &stretch, int vertex)
{
    int from = stretch.leftEnd;
    eatFromLeft(from, vertex);
    const int added = addLink(vertex);
    link(added).toRight = from;
    link(from).toLeft = added;
    stretch.leftEnd = stretch.last = added;
}

/// The vertex sees the whole chain of the stretch that it closes.
bool Sweep::end(std::size_t index, int vertex)
{
    int from = m_stretches[index].rightEnd;
    eatFromRight(from, vertex);
    const bool isDone = from == m_stretches[index].leftEnd;
    remove(index);
    return isDone;
}

/// The vertex lies inside a stretch and cuts it in two. It sees the vertex that came last there.
bool Sweep::split(int vertex, int rightEdge, int leftEdge)
{
    const auto isInside = [&](const Stretch &s) {
        const auto left = [&](int edge) {
            return sideOfLine(at(edge), at(m_after[static_cast<std::size_t>(edge)]), at(vertex)) >
                   0.0;
        };
        return left(s.rightEdge) && left(s.leftEdge);
    };
    const auto found = std::find_if(m_stretches.begin(), m_stretches.end(), isInside);
    if (found == m_stretches.end())
        return false;
    Stretch right = *found, left = *found;
    right.leftEdge = leftEdge;
    left.rightEdge = rightEdge;
    // The last vertex ends both chains.
    int fromRight = found->last;
    int fromLeft = addLink(link(fromRight).vertex);
    if (const int next = link(fromRight).toLeft; next >= 0) {
        link(fromLeft).toLeft = next;
        link(next).toRight = fromLeft;
    } else {
        left.leftEnd = fromLeft;
    }
    link(fromRight).toLeft = -1;
    eatFromLeft(fromRight, vertex);
    eatFromRight(fromLeft, vertex);
    const int ofRight = addLink(vertex), ofLeft = addLink(vertex);
    link(ofRight).toRight = fromRight;
    link(fromRight).toLeft = ofRight;
    link(ofLeft).toLeft = fromLeft;
    link(fromLeft).toRight = ofLeft;
    right.leftEnd = right.last = ofRight;
    left.rightEnd = left.last = ofLeft;
    *found = right;
    m_stretches.push_back(left);
    return true;
}

/// Two stretches become one behind the vertex at which the boundary between them ends.
void Sweep::join(std::size_t right, std::size_t left, int vertex)
{
    int fromRight = m_stretches[right].leftEnd, fromLeft = m_stretches[left].rightEnd;
    eatFromLeft(fromRight, vertex);
    eatFromRight(fromLeft, vertex);
    const int added = addLink(vertex);
    link(added).toRight = fromRight;
    link(fromRight).toLeft = added;
    link(added).toLeft = fromLeft;
    link(fromLeft).toRight = added;
    m_stretches[right].leftEdge = m_stretches[left].leftEdge;
    m_stretches[right].leftEnd = m_stretches[left].leftEnd;
    m_stretches[right].last = added;
    remove(left);
}

bool Sweep::visit(int v)
{
    const int before = m_before[static_cast<std::size_t>(v)];
    const int after = m_after[static_cast<std::size_t>(v)];
    const bool comesForward = isBefore(before, v), goesForward = isBefore(v, after);
    const std::size_t none = static_cast<std::size_t>(-1);
    if (comesForward && goesForward) {
        const std::size_t stretch = stretchOf(&Stretch::rightEdge, before);
        if (stretch == none)
            return false;
        bendRight(m_stretches[stretch], v);
        m_stretches[stretch].rightEdge = v;
        return true;
    }
    if (!comesForward && !goesForward) {
        const std::size_t stretch = stretchOf(&Stretch::leftEdge, v);
        if (stretch == none)
            return false;
        bendLeft(m_stretches[stretch], v);
        m_stretches[stretch].leftEdge = before;
        return true;
    }
    const double turn = sideOfLine(at(before), at(v), at(after));
    if (turn == 0.0)
        return false;
    if (goesForward) {
        if (turn < 0.0)
            return split(v, v, before);
        begin(v, v, before);
        return true;
    }
    const std::size_t ofRight = stretchOf(&Stretch::rightEdge, before);
    const std::size_t ofLeft = stretchOf(&Stretch::leftEdge, v);
    if (ofRight == none || ofLeft == none || (ofRight == ofLeft) != (turn > 0.0))
        return false;
    if (ofRight == ofLeft)
        return end(ofRight, v);
    join(ofLeft, ofRight, v);
    return true;
}

/// False where two vertices are at one place.
bool Sweep::findOrder()
{
    struct Place
    {
        double along, across;
        int vertex;
    };
    const int first = m_alongY ? 1 : 0;
    const auto count = static_cast<int>(m_result.points.size());
    std::vector<Place> places;
    places.reserve(m_result.points.size());
    for (int i = 0; i < count; ++i)
        places.push_back({at(i)[first], at(i)[1 - first], i});
    std::sort(places.begin(), places.end(), [](const Place &a, const Place &b) {
        return a.along != b.along ? a.along < b.along : a.across < b.across;
    });
    m_order.reserve(places.size());
    m_rank.resize(places.size());
    for (const Place &place : places) {
        if (!m_order.empty() && at(m_order.back()) == at(place.vertex))
            return false;
        m_rank[static_cast<std::size_t>(place.vertex)] = static_cast<int>(m_order.size());
        m_order.push_back(place.vertex);
    }
    return true;
}

bool Sweep::run()
{
    return m_isPlain && findOrder() &&
           std::all_of(m_order.begin(), m_order.end(), [this](int v) { return visit(v); }) &&
           m_stretches.empty();
}

} // namespace

std::optional<Triangulation> sweepTriangles(const Region &region)
{
    Sweep sweep(region);
    if (!sweep.run())
        return std::nullopt;
    Triangulation result = sweep.take();
    if (result.triangles.size() + 2 != result.points.size() + 2 * region.holes.size() ||
        !mendSlivers(result))
        return std::nullopt;
    return result;
}

} // namespace fff
