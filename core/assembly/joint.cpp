#include "core/assembly/joint.h"

#include <algorithm>
#include <cassert>

namespace fff {

const Joint &JointList::operator[](std::size_t index) const
{
    const auto after = std::upper_bound(m_starts.begin(), m_starts.end(), index);
    const auto row = static_cast<std::size_t>(after - m_starts.begin()) - 1;
    return m_rows[row][index - m_starts[row]];
}

const Joint &JointList::at(std::size_t index) const
{
    assert(index < size() && "there are as many joints as size() says");
    return (*this)[index];
}

const Joint *JointList::find(int a, int b) const
{
    const std::vector<Joint> &row = m_rows[static_cast<std::size_t>(a)];
    const auto it = std::lower_bound(row.begin(), row.end(), b,
                                     [](const Joint &joint, int other) { return joint.b < other; });
    return it != row.end() && it->b == b ? &*it : nullptr;
}

bool JointList::replace(std::size_t count, std::vector<NewRow> rows)
{
    bool moves = false;
    std::vector<std::size_t> starts(count + 1);
    std::size_t start = 0;
    m_rows.resize(count);
    SharedRows<Joint>::Editor editor(m_rows);
    auto next = rows.begin();
    for (std::size_t i = 0; i < count; ++i) {
        starts[i] = start;
        const bool isNew = next != rows.end() && next->index == i;
        if (isNew || (!m_rows[i].empty() && start != m_starts[i])) {
            std::vector<Joint> row = isNew ? std::move((next++)->joints) : m_rows[i];
            for (std::size_t k = 0; k < row.size(); ++k) {
                const int id = static_cast<int>(start + k) + 1;
                moves |= row[k].id != 0 && row[k].id != id;
                row[k].id = id;
            }
            start += row.size();
            editor.set(i, std::move(row));
        } else {
            start += m_rows[i].size();
        }
    }
    starts.back() = start;
    m_starts = std::move(starts);
    return moves;
}

Polygon Slit::outline() const
{
    const Vec2 half = 0.5 * width * perpendicular((mouth - inner).normalized());
    return {inner - half, mouth - half, mouth + half, inner + half};
}

std::vector<Contour> Slit::cuts() const
{
    if (role == SlitRole::Tab)
        return {};
    if (!form)
        return {Contour::ofPolygon(outline())};
    const double length = (mouth - inner).norm();
    const Vec2 along = (mouth - inner) / length, left = perpendicular(along);
    std::vector<Contour> cuts;
    for (const Contour &cut : slitCuts(*form, {length, 0.5 * width, isOpen})) {
        std::vector<Vec2> points;
        points.reserve(cut.points().size());
        for (const Vec2 &p : cut.points())
            points.push_back(inner + p.x() * along + p.y() * left);
        cuts.push_back(Contour::ofPoints(std::move(points)));
    }
    return cuts;
}

std::vector<Polygon> Slit::outlines(double chord) const
{
    if (!form)
        return {outline()};
    std::vector<Polygon> outlines;
    for (const Contour &cut : cuts())
        outlines.push_back(cut.flatten(chord).points);
    return outlines;
}

Vec2 Slit::bottom() const
{
    if (!form)
        return inner;
    return inner + reachBeyond(*form, 0.5 * width) * (inner - mouth).normalized();
}

bool Slit::operator==(const Slit &other) const
{
    return inner == other.inner && mouth == other.mouth && width == other.width &&
           isOpen == other.isOpen && role == other.role && joint == other.joint &&
           overlap == other.overlap && guest == other.guest &&
           (form == other.form || (form && other.form && *form == *other.form));
}

std::span<const Slit> slitsOfJoint(const std::vector<Slit> &slits, int joint)
{
    struct ByJoint
    {
        bool operator()(const Slit &slit, int id) const { return slit.joint < id; }
        bool operator()(int id, const Slit &slit) const { return id < slit.joint; }
    };
    const auto [first, last] = std::equal_range(slits.begin(), slits.end(), joint, ByJoint());
    return {first, last};
}

} // namespace fff
