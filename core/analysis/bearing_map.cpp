#include "core/analysis/bearing_map.h"

#include "core/analysis/finding.h"
#include "core/geometry/polygon.h"
#include "core/physics/plate_mesh.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Coarse: between points the mass is that of a plane through three of them.
constexpr PlateMeshOptions kMapMesh{1.0, 120, 400, 1.0};
constexpr double kFirstGuess = 1.0; // kg, where no neighbour is known

/// The mesh of one body within the map.
struct MapPart
{
    int body = 0;
    int first = 0, count = 0; // of its points
};

Result<MapPart> addPart(int body, BearingMap &map, const LongWork &work)
{
    const Region &region = map.analysis->bodies.at(body).outline().region;
    Result<PlateMesh> mesh = plateMesh(region, kMapMesh, work);
    if (!mesh)
        return tl::unexpected(mesh.error());
    MapPart part{body, static_cast<int>(map.points.size()), mesh->corners};
    map.points.insert(map.points.end(), mesh->points.begin(), mesh->points.begin() + mesh->corners);
    for (const auto &triangle : mesh->triangles)
        map.triangles.push_back(
            {part.first + triangle[0], part.first + triangle[1], part.first + triangle[2]});
    return part;
}

std::vector<std::vector<int>> neighboursIn(const BearingMap &map)
{
    std::vector<std::vector<int>> neighbours(map.points.size());
    for (const auto &triangle : map.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            neighbours[static_cast<std::size_t>(triangle[i])].push_back(triangle[(i + 1) % 3]);
    return neighbours;
}

/// All points of a part, each after one beside it: (point, that one; −1 for the first).
std::vector<std::pair<int, int>> inTurn(const MapPart &part,
                                        const std::vector<std::vector<int>> &neighbours)
{
    std::vector<std::pair<int, int>> turns;
    std::vector<char> isKnown(neighbours.size(), 0);
    for (int start = part.first; start < part.first + part.count; ++start) {
        if (isKnown[static_cast<std::size_t>(start)])
            continue;
        isKnown[static_cast<std::size_t>(start)] = 1;
        turns.emplace_back(start, -1);
        for (std::size_t next = turns.size() - 1; next < turns.size(); ++next) {
            const int from = turns[next].first;
            for (const int to : neighbours[static_cast<std::size_t>(from)])
                if (!std::exchange(isKnown[static_cast<std::size_t>(to)], 1))
                    turns.emplace_back(to, from);
        }
    }
    return turns;
}

bool isAnyRated(const Model &model)
{
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        if (strengthOf(model.stockOf(i)))
            return true;
    return false;
}

void measure(BearingMap &map)
{
    bool isFirst = true;
    for (const Bearing &bearing : map.bearings) {
        if (bearing.end == BearingEnd::NotWorkedOut)
            continue;
        map.least = isFirst ? bearing.mass : std::min(map.least, bearing.mass);
        map.most = isFirst ? bearing.mass : std::max(map.most, bearing.mass);
        isFirst = false;
    }
}

} // namespace

Result<BearingMap> bearingMap(AnalysisPointer analysis, const SectionRef &section,
                              const StrengthRules &rules, StrengthCaches &caches,
                              const LongWork &work)
{
    BearingMap map;
    map.section = section;
    map.analysis = std::move(analysis);
    const Model &model = map.analysis->model;
    const Bodies &bodies = map.analysis->bodies;
    const int index = model.indexOf(section);
    if (index < 0 || bodies.countOf(index) == 0) {
        map.obstacle = BearingMap::Obstacle::NotThere;
        return map;
    }
    if (!isAnyRated(model)) {
        map.obstacle = BearingMap::Obstacle::NotRated;
        return map;
    }
    BearingProbe probe(*map.analysis, rules, caches, work);
    if (!probe.stands()) {
        map.obstacle = BearingMap::Obstacle::Falls;
        return map;
    }
    if (probe.breaks()) {
        map.obstacle = BearingMap::Obstacle::Breaks;
        return map;
    }
    std::vector<MapPart> parts;
    for (int body = bodies.firstOf(index); body < bodies.firstOf(index) + bodies.countOf(index);
         ++body) {
        Result<MapPart> part = addPart(body, map, work);
        if (!part && part.error().code == ErrorCode::Cancelled)
            return tl::unexpected(part.error());
        if (!part)
            return failure(ErrorCode::NotWorkedOut, model.nameOf(section));
        parts.push_back(*part);
    }
    const auto neighbours = neighboursIn(map);
    map.bearings.resize(map.points.size());
    std::size_t done = 0;
    for (const MapPart &part : parts)
        for (const auto &[point, beside] : inTurn(part, neighbours)) {
            if (work.isStopped())
                return failure(ErrorCode::Cancelled);
            const double known =
                beside < 0 ? 0.0 : map.bearings[static_cast<std::size_t>(beside)].mass;
            map.bearings[static_cast<std::size_t>(point)] =
                probe.at(part.body, map.points[static_cast<std::size_t>(point)],
                         known > 0.0 ? known : kFirstGuess);
            work.tell(static_cast<double>(++done) / static_cast<double>(map.points.size()));
        }
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    measure(map);
    return map;
}

std::optional<Bearing> bearingAt(const BearingMap &map, const Vec2 &point)
{
    for (const auto &triangle : map.triangles) {
        std::array<Vec2, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = map.points[static_cast<std::size_t>(triangle[i])];
        const double area = cross(corners[1] - corners[0], corners[2] - corners[0]);
        std::array<double, 3> shares;
        for (std::size_t i = 0; i < 3; ++i)
            shares[i] = cross(corners[(i + 1) % 3] - point, corners[(i + 2) % 3] - point) / area;
        const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
        if (!(*least >= 0.0))
            continue;
        const auto cornerAt = [&](std::size_t i) -> const Bearing & {
            return map.bearings[static_cast<std::size_t>(triangle[i])];
        };
        Bearing bearing = cornerAt(static_cast<std::size_t>(most - shares.begin()));
        bearing.mass = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
            bearing.mass += shares[i] * cornerAt(i).mass;
        return bearing;
    }
    return {};
}

Message bearingText(const Bearing &bearing, const Model &model)
{
    const bool isLoaded = !model.document.loads.empty(); // by what it bears besides
    switch (bearing.end) {
    case BearingEnd::Cracks:
        if (!bearing.cracks)
            break;
        //: %1 is a mass, %2 a section, %3 a place such as "beside its slit for Body"
        return {isLoaded ? FFF_TEXT("Checks", "Holds %1 more here before %2 cracks %3.")
                         : FFF_TEXT("Checks", "Holds %1 here before %2 cracks %3."),
                {massOf(bearing.mass), nameOf(model, bearing.cracks->section),
                 spotText(*bearing.cracks, model)}};
    case BearingEnd::Falls:
        //: %1 is a mass
        return {isLoaded ? FFF_TEXT("Checks", "Holds %1 more here before it falls over.")
                         : FFF_TEXT("Checks", "Holds %1 here before it falls over."),
                {massOf(bearing.mass)}};
    case BearingEnd::PullsOut:
        //: %1 is a mass
        return {isLoaded ? FFF_TEXT("Checks", "Holds %1 more here before a joint is pulled open.")
                         : FFF_TEXT("Checks", "Holds %1 here before a joint is pulled open."),
                {massOf(bearing.mass)}};
    case BearingEnd::BearsAll:
        //: %1 is a mass
        return {FFF_TEXT("Checks", "Holds more than %1 here."), {massOf(bearing.mass)}};
    case BearingEnd::NotWorkedOut:
        break;
    }
    return {FFF_TEXT("Checks", "How much it holds here could not be worked out."), {}};
}

} // namespace fff
