#include "core/templates/mesh_report.h"

#include <algorithm>
#include <limits>

namespace fff {

namespace {

struct ReportRow
{
    std::size_t MeshReport::*count;
    Text one, many;
};

constexpr ReportRow kReportRows[] = {
    {&MeshReport::wrongIndices,
     FFF_TEXT("Mesh", "A face was left out: a corner of it is not there."),
     FFF_TEXT_OF_MANY("Mesh", "%n faces were left out: a corner of theirs is not there.")},
    {&MeshReport::notFinite,
     FFF_TEXT("Mesh", "A face was left out: the place of a corner is no number."),
     FFF_TEXT_OF_MANY("Mesh", "%n faces were left out: the place of a corner is no number.")},
    {&MeshReport::degenerate, FFF_TEXT("Mesh", "A face was left out: it has a corner twice."),
     FFF_TEXT_OF_MANY("Mesh", "%n faces were left out: they have a corner twice.")},
    {&MeshReport::duplicates, FFF_TEXT("Mesh", "A face was left out: it is there twice."),
     FFF_TEXT_OF_MANY("Mesh", "%n faces were left out: they are there twice.")},
    {&MeshReport::flipped, FFF_TEXT("Mesh", "A face looked the wrong way and was turned over."),
     FFF_TEXT_OF_MANY("Mesh", "%n faces looked the wrong way and were turned over.")},
    {&MeshReport::openEdges, FFF_TEXT("Mesh", "The surface has a hole: an edge is open."),
     FFF_TEXT_OF_MANY("Mesh", "The surface has holes: %n edges are open.")},
    {&MeshReport::crowdedEdges, FFF_TEXT("Mesh", "More than two faces meet at an edge."),
     FFF_TEXT_OF_MANY("Mesh", "More than two faces meet at %n edges.")},
    {&MeshReport::oneSidedEdges,
     FFF_TEXT("Mesh", "At an edge faces meet that cannot look the same way."),
     FFF_TEXT_OF_MANY("Mesh", "At %n edges faces meet that cannot look the same way.")},
};

int countOf(std::size_t number)
{
    return static_cast<int>(
        std::min(number, static_cast<std::size_t>(std::numeric_limits<int>::max())));
}

} // namespace

bool MeshReport::isInOrder() const
{
    return messages().empty();
}

std::vector<Message> MeshReport::messages() const
{
    std::vector<Message> found;
    for (const ReportRow &row : kReportRows) {
        const std::size_t count = this->*row.count;
        if (count == 1)
            found.push_back({row.one, {}, {}});
        else if (count > 1)
            found.push_back({row.many, {}, countOf(count)});
    }
    if (wasInsideOut)
        found.push_back({FFF_TEXT("Mesh", "It was inside out and was turned over."), {}, {}});
    return found;
}

} // namespace fff
