#include "core/assembly/body.h"

#include "core/assembly/settling.h"
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

const std::vector<Vec3> &Body::undermost() const
{
    m_undermostOnce.run([this] { m_undermost = fff::undermost(slab()); });
    return m_undermost;
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

/// Some sections after each other, and their bodies.
struct Bodies::Run
{
    std::vector<SectionPointer> sections;
    std::vector<int> counts; // of bodies, of each of these
    std::vector<BodyPointer> bodies;
};

std::span<const BodyPointer> Bodies::of(int section) const
{
    const int count = countOf(section);
    if (count == 0)
        return {};
    return {m_all[static_cast<std::size_t>(firstOf(section))], static_cast<std::size_t>(count)};
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
    for (const Body &body : *this)
        sum += body.mass();
    return sum;
}

/// Makes the list of one model from that of another one.
class BodyLister
{
public:
    BodyLister(const Model &model, const CutList &cuts, const Bodies &before,
               const std::optional<std::vector<int>> &places)
        : m_model(model), m_cuts(cuts), m_before(before), m_places(places),
          m_hasSameStocks(model.document.stocks == before.m_stocks)
    {
    }

    Bodies list() const
    {
        Bodies bodies;
        bodies.m_stocks = m_model.document.stocks;
        bodies.m_cuts = m_cuts;
        bodies.m_runs.reserve(m_cuts.blockCount());
        for (std::size_t block = 0; block < m_cuts.blockCount(); ++block)
            bodies.m_runs.push_back(runOf(block));
        if (isDividedAsBefore(bodies))
            placeAsBefore(bodies);
        else
            place(bodies);
        return bodies;
    }

private:
    using Run = Bodies::Run;

    /// Each section in as many bodies as the one at its place.
    bool isDividedAsBefore(const Bodies &bodies) const
    {
        return std::equal(bodies.m_runs.begin(), bodies.m_runs.end(), m_before.m_runs.begin(),
                          m_before.m_runs.end(), [](const auto &now, const auto &before) {
                              return now == before || now->counts == before->counts;
                          });
    }

    void placeAsBefore(Bodies &bodies) const
    {
        bodies.m_all = m_before.m_all;
        bodies.m_sections = m_before.m_sections;
        bodies.m_first = m_before.m_first;
        for (std::size_t i = 0; i < bodies.m_runs.size(); ++i)
            if (const Run &run = *bodies.m_runs[i]; &run != m_before.m_runs[i].get()) {
                auto at = bodies.m_all.begin() + bodies.m_first[i * CutList::kInBlock];
                for (const BodyPointer &body : run.bodies)
                    *at++ = &body;
            }
    }

    void place(Bodies &bodies) const
    {
        bodies.m_all.reserve(m_cuts.size()); // mostly each is one piece
        bodies.m_sections.reserve(m_cuts.size());
        bodies.m_first.reserve(m_cuts.size() + 1);
        for (const Bodies::RunPointer &run : bodies.m_runs) {
            for (const BodyPointer &body : run->bodies)
                bodies.m_all.push_back(&body);
            for (const int count : run->counts) {
                bodies.m_sections.insert(bodies.m_sections.end(), static_cast<std::size_t>(count),
                                         static_cast<int>(bodies.sectionCount()));
                bodies.m_first.push_back(static_cast<int>(bodies.m_sections.size()));
            }
        }
    }

    Bodies::RunPointer runOf(std::size_t block) const
    {
        const std::size_t first = block * CutList::kInBlock, last = m_cuts.endOf(block);
        if (m_hasSameStocks && !m_places && m_cuts.shares(m_before.m_cuts, block)) {
            const Bodies::RunPointer &known = m_before.m_runs[block];
            if (std::equal(known->sections.begin(), known->sections.end(),
                           &m_model.sections()[first]))
                return known;
        }
        auto run = std::make_shared<Run>();
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t before = run->bodies.size();
            addBodies(i, *run);
            run->sections.push_back(m_model.section(i));
            run->counts.push_back(static_cast<int>(run->bodies.size() - before));
        }
        return run;
    }

    void addBodies(std::size_t i, Run &run) const
    {
        const Section &section = *m_model.section(i);
        const Stock &stock = m_model.stockOf(i);
        const SectionRef ref = section.ref();
        const int place = m_places ? (*m_places)[i] : static_cast<int>(i);
        if (place >= 0 && static_cast<std::size_t>(place) < m_before.sectionCount()) {
            const std::span<const BodyPointer> known = m_before.of(place);
            if (!known.empty() && known.front()->isOf(ref, m_cuts[i], section.frame,
                                                      stock.thickness, stock.density)) {
                run.bodies.insert(run.bodies.end(), known.begin(), known.end());
                return;
            }
        }
        const std::vector<int> numbers = pieceNumbers(*section.shape, m_cuts[i]->parts());
        for (std::size_t k = 0; k < numbers.size(); ++k)
            run.bodies.push_back(std::make_shared<const Body>(BodyKey{ref, numbers[k]}, m_cuts[i],
                                                              k, section.frame, stock.thickness,
                                                              stock.density));
    }

    const Model &m_model;
    const CutList &m_cuts;
    const Bodies &m_before;
    const std::optional<std::vector<int>> &m_places;
    bool m_hasSameStocks;
};

Bodies bodiesOf(const Model &model, const CutList &cuts, const Bodies &before,
                const std::optional<std::vector<int>> &places)
{
    return BodyLister(model, cuts, before, places).list();
}

} // namespace fff
