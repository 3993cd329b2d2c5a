#include "core/assembly/body.h"

#include "core/base/tolerances.h"
#include "core/geometry/cells.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace fff {

namespace {

constexpr double kCubicMillimetres = 1e-9; // m³
/// Bodies of more triangles than this are cut up into cells: an edit of a long spine, and who asks
/// about one of its ribs, has to do with a few of them.
constexpr std::size_t kManyTriangles = 192;

SolidPointer solidOf(const Triangulation &triangles, const Region &region, const Frame &frame,
                     double thickness)
{
    auto whole = std::make_shared<const Solid>(makeSolid(triangles, frame, thickness));
    if (triangles.triangles.size() <= kManyTriangles)
        return whole;
    const Result<Triangulation> cells = triangulateCells(region);
    if (!cells)
        return whole; // the same, only slower
    return std::make_shared<const Solid>(cutUp(std::move(whole), *cells));
}

/// Points of curves by their place on the grid that pieces are cut on.
class Places
{
public:
    void add(const Contour &contour)
    {
        for (int i = 0; i < contour.segmentCount(); ++i)
            m_numbers.emplace(onGrid(contour.segment(i).p0), static_cast<int>(m_numbers.size()));
    }
    int none() const { return static_cast<int>(m_numbers.size()); }
    /// The first of them that the contour passes; none().
    int firstOf(const Contour &contour) const
    {
        int first = none();
        for (int i = 0; i < contour.segmentCount(); ++i)
            if (const auto known = m_numbers.find(onGrid(contour.segment(i).p0));
                known != m_numbers.end())
                first = std::min(first, known->second);
        return first;
    }

private:
    /// A micron: pieces pass their points to a few nanometres.
    static std::array<long long, 2> onGrid(const Vec2 &p)
    {
        return {std::llround(1e3 * p.x()), std::llround(1e3 * p.y())};
    }
    std::map<std::array<long long, 2>, int> m_numbers;
};

/// Of each part its number among those of its section (BodyKey).
std::vector<int> pieceNumbers(const Shape &shape, const std::vector<CurvedRegion> &parts)
{
    std::vector<int> numbers(parts.size(), 0);
    if (parts.size() < 2)
        return numbers;
    Places places;
    places.add(shape.contour());
    for (const Contour &hole : shape.holes())
        places.add(hole);
    std::vector<int> firsts, order(parts.size());
    for (const CurvedRegion &part : parts) {
        int first = places.firstOf(part.outer);
        for (const Contour &hole : part.holes)
            first = std::min(first, places.firstOf(hole));
        firsts.push_back(first);
    }
    std::iota(order.begin(), order.end(), 0);
    const auto firstOf = [&](int part) { return firsts[static_cast<std::size_t>(part)]; };
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return firstOf(a) < firstOf(b); });
    for (std::size_t i = 0; i < order.size(); ++i)
        numbers[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    return numbers;
}

} // namespace

Body::Body(BodyKey key, CutSectionPointer cut, std::size_t piece, const Frame &frame,
           double thickness, double density)
    : m_key(std::move(key)), m_cut(std::move(cut)), m_piece(piece), m_frame(frame),
      m_thickness(thickness), m_density(density)
{
}

const Box3 &Body::box() const
{
    m_boxOnce.run([this] { m_box = boundsOf(slab()); });
    return m_box;
}

const MassProperties &Body::mass() const
{
    m_massOnce.run([this] {
        Moments total = m_cut->parts().size() == 1 ? m_cut->moments() : moments(outline().outer);
        if (m_cut->parts().size() > 1)
            for (const Contour &hole : outline().holes)
                total += moments(hole);
        if (total.area > 0.0)
            m_mass = {total.area * m_thickness * kCubicMillimetres * m_density,
                      m_frame.toWorld(total.centroid())};
    });
    return m_mass;
}

const GroundContact &Body::contact() const
{
    m_contactOnce.run([this] { m_contact = contactOf(slab()); });
    return m_contact;
}

const Result<SolidPointer> &Body::solid() const
{
    m_solidOnce.run([this] {
        const auto &triangles = m_cut->triangulations();
        if (m_cut->failure())
            m_solid = failure(ErrorCode::NotCutOut);
        else if (!triangles)
            m_solid = failure(ErrorCode::NotSolid);
        else
            m_solid = solidOf((*triangles)[m_piece], outline().region, m_frame, m_thickness);
    });
    return m_solid;
}

bool Body::isOf(const SectionRef &section, const CutSectionPointer &cut, const Frame &frame,
                double thickness, double density) const
{
    return m_cut == cut && m_frame == frame && m_thickness == thickness && m_density == density &&
           m_key.section == section;
}

std::span<const BodyPointer> Bodies::of(int section) const
{
    return std::span(m_all).subspan(static_cast<std::size_t>(firstOf(section)),
                                    static_cast<std::size_t>(countOf(section)));
}

Box3 Bodies::boxOf(int section) const
{
    Box3 box;
    for (const BodyPointer &body : of(section))
        box.extend(body->box());
    return box;
}

MassProperties Bodies::massOf(int section) const
{
    MassProperties sum;
    for (const BodyPointer &body : of(section))
        sum += body->mass();
    return sum;
}

MassProperties Bodies::mass() const
{
    MassProperties sum;
    for (const BodyPointer &body : m_all)
        sum += body->mass();
    return sum;
}

void Bodies::add(std::span<const BodyPointer> ofNext)
{
    m_sections.insert(m_sections.end(), ofNext.size(), static_cast<int>(sectionCount()));
    m_all.insert(m_all.end(), ofNext.begin(), ofNext.end());
    m_first.push_back(static_cast<int>(m_all.size()));
}

void Bodies::reserve(std::size_t sections)
{
    m_all.reserve(sections); // mostly each is one piece
    m_sections.reserve(sections);
    m_first.reserve(sections + 1);
}

Bodies bodiesOf(const Model &model, const std::vector<CutSectionPointer> &cuts,
                const Bodies &before, const std::optional<std::vector<int>> &places)
{
    Bodies bodies;
    bodies.reserve(cuts.size());
    std::vector<BodyPointer> made;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const Section &section = *model.section(i);
        const Stock &stock = model.stockOf(i);
        const SectionRef ref = section.ref();
        const int place = places ? (*places)[i] : static_cast<int>(i);
        if (place >= 0 && static_cast<std::size_t>(place) < before.sectionCount()) {
            const std::span<const BodyPointer> known = before.of(place);
            if (!known.empty() &&
                known.front()->isOf(ref, cuts[i], section.frame, stock.thickness, stock.density)) {
                bodies.add(known);
                continue;
            }
        }
        made.clear();
        const std::vector<int> numbers = pieceNumbers(*section.shape, cuts[i]->parts());
        for (std::size_t k = 0; k < numbers.size(); ++k)
            made.push_back(std::make_shared<const Body>(BodyKey{ref, numbers[k]}, cuts[i], k,
                                                        section.frame, stock.thickness,
                                                        stock.density));
        bodies.add(made);
    }
    return bodies;
}

} // namespace fff
