#include "core/templates/mended_mesh.h"

#include "core/templates/mesh_edges.h"
#include "core/templates/vertex_merger.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

namespace fff {

namespace {

bool isInMeasure(const Vec3 &p)
{
    return std::abs(p.x()) <= kMostMeshCoordinate && std::abs(p.y()) <= kMostMeshCoordinate &&
           std::abs(p.z()) <= kMostMeshCoordinate; // not so for NaN
}

/// A number beyond what a mesh may have, of those that faces have; none where each is in measure,
/// or is no number.
std::optional<double> firstTooLarge(const MeshDraft &draft)
{
    for (const Triangle &t : draft.triangles)
        for (const std::uint32_t corner : t)
            if (corner < draft.positions.size())
                for (const double number : draft.positions[corner])
                    if (std::isfinite(number) && std::abs(number) > kMostMeshCoordinate)
                        return number;
    return std::nullopt;
}

std::string written(double number)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

/// Faces with corners that are not there, or are nowhere.
void dropImpossible(MeshDraft &draft, MeshReport &report)
{
    const std::size_t count = draft.positions.size();
    std::vector<std::uint8_t> isNowhere(count, 0);
    bool isAny = false;
    for (std::size_t i = 0; i < count; ++i) {
        isNowhere[i] = !isInMeasure(draft.positions[i]);
        isAny = isAny || isNowhere[i];
    }
    std::erase_if(draft.triangles, [&](const Triangle &t) {
        if (std::max({t[0], t[1], t[2]}) >= count) {
            ++report.wrongIndices;
            return true;
        }
        const bool isGone = isAny && (isNowhere[t[0]] | isNowhere[t[1]] | isNowhere[t[2]]);
        report.notFinite += isGone;
        return isGone;
    });
}

/// Only vertices that a face has, equal ones once, in the order in which faces name them.
void mergeVertices(MeshDraft &draft)
{
    std::vector<std::uint32_t> places(draft.positions.size(), kNoVertex);
    if (draft.isMerged) {
        std::vector<Vec3> kept;
        kept.reserve(draft.positions.size());
        for (Triangle &triangle : draft.triangles)
            for (std::uint32_t &corner : triangle) {
                std::uint32_t &place = places[corner];
                if (place == kNoVertex) {
                    place = static_cast<std::uint32_t>(kept.size());
                    kept.push_back(draft.positions[corner]);
                }
                corner = place;
            }
        draft.positions = std::move(kept);
        return;
    }
    VertexMerger merger(draft.positions.size());
    for (Triangle &triangle : draft.triangles)
        for (std::uint32_t &corner : triangle) {
            std::uint32_t &place = places[corner];
            if (place == kNoVertex)
                place = merger.add(draft.positions[corner]);
            corner = place;
        }
    draft.positions = merger.take();
    draft.isMerged = true;
}

void dropDegenerate(MeshDraft &draft, MeshReport &report)
{
    report.degenerate += std::erase_if(draft.triangles, [](const Triangle &t) {
        return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    });
}

/// The corners in rising order, and whether an even number of swaps makes them so.
struct SortedCorners
{
    Triangle corners{};
    bool isEven = true;
};

SortedCorners sortedCorners(Triangle t)
{
    bool isEven = true;
    const auto order = [&](std::size_t i, std::size_t j) {
        if (t[i] > t[j]) {
            std::swap(t[i], t[j]);
            isEven = !isEven;
        }
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    return {t, isEven};
}

/// Of faces with the same corners as many are kept as are needed for the edges to stay closed: one
/// that looks as most of them do, or one each way where there are as many of both.
void dropDuplicates(MeshDraft &draft, MeshReport &report)
{
    std::vector<std::size_t> starts(draft.positions.size() + 2, 0);
    const auto lowest = [](const Triangle &t) { return std::min({t[0], t[1], t[2]}); };
    for (const Triangle &t : draft.triangles)
        ++starts[std::size_t(lowest(t)) + 2];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<std::uint32_t> rows(draft.triangles.size());
    for (std::size_t f = 0; f < draft.triangles.size(); ++f)
        rows[starts[std::size_t(lowest(draft.triangles[f])) + 1]++] = static_cast<std::uint32_t>(f);
    struct Entry
    {
        SortedCorners sorted;
        std::uint32_t face = 0;
    };
    std::vector<Entry> row;
    std::vector<std::uint32_t> gone;
    for (std::size_t v = 0; v < draft.positions.size(); ++v) {
        if (starts[v + 1] - starts[v] < 2)
            continue;
        row.clear();
        for (std::size_t i = starts[v]; i < starts[v + 1]; ++i)
            row.push_back({sortedCorners(draft.triangles[rows[i]]), rows[i]});
        std::sort(row.begin(), row.end(), [](const Entry &a, const Entry &b) {
            return a.sorted.corners != b.sorted.corners ? a.sorted.corners < b.sorted.corners
                                                        : a.face < b.face;
        });
        for (std::size_t from = 0, to = 0; from < row.size(); from = to) {
            int excess = 0;
            for (to = from; to < row.size() && row[to].sorted.corners == row[from].sorted.corners;
                 ++to)
                excess += row[to].sorted.isEven ? 1 : -1;
            // How many of each way may stay.
            int even = excess >= 0 ? 1 : 0, odd = excess <= 0 ? 1 : 0;
            for (std::size_t i = from; i < to; ++i)
                if (int &left = row[i].sorted.isEven ? even : odd; left-- <= 0)
                    gone.push_back(row[i].face);
        }
    }
    if (gone.empty())
        return;
    report.duplicates += gone.size();
    for (const std::uint32_t face : gone)
        draft.triangles[face] = {0, 0, 0};
    std::erase_if(draft.triangles, [](const Triangle &t) { return t[0] == t[1]; });
}

} // namespace

Result<MendedMesh> mended(MeshDraft draft, const LongWork &work)
{
    MeshReport report;
    auto step = [&work, done = 0]() mutable {
        constexpr double kSteps = 5.0;
        work.tell(++done / kSteps);
        return !work.isStopped();
    };
    const std::optional<double> tooLarge = firstTooLarge(draft);
    dropImpossible(draft, report);
    if (!step())
        return failure(ErrorCode::Cancelled);
    mergeVertices(draft);
    if (!step())
        return failure(ErrorCode::Cancelled);
    dropDegenerate(draft, report);
    dropDuplicates(draft, report);
    if (!step())
        return failure(ErrorCode::Cancelled);
    if (draft.triangles.empty() && tooLarge)
        return failure(ErrorCode::BadValue, {},
                       {written(*tooLarge), QT_TRANSLATE_NOOP("Error", "coordinates up to 1e12")});
    if (draft.triangles.empty())
        return failure(ErrorCode::BadValue, {},
                       {"", QT_TRANSLATE_NOOP("Error", "a mesh with at least one triangle")});
    LongWork stopOnly;
    stopOnly.stop = work.stop;
    if (!lookTheSameWay(draft.triangles, draft.positions.size(), report, stopOnly) || !step())
        return failure(ErrorCode::Cancelled);
    if (report.degenerate > 0 || report.duplicates > 0) {
        draft.isMerged = true;
        mergeVertices(draft); // of those that only such faces had
    }
    auto mesh = std::make_shared<TriangleMesh>(std::move(draft.positions),
                                               std::move(draft.triangles), draft.unit);
    if (report.isClosed() && report.oneSidedEdges == 0 && mesh->volume() < 0.0) {
        report.wasInsideOut = true;
        std::vector<Triangle> turned = mesh->triangles();
        for (Triangle &triangle : turned)
            std::swap(triangle[1], triangle[2]);
        mesh = std::make_shared<TriangleMesh>(mesh->positions(), std::move(turned), mesh->unit());
    }
    work.tell(1.0);
    return MendedMesh{std::move(mesh), report};
}

} // namespace fff
