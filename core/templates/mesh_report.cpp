#include "core/templates/mesh_report.h"

#include <algorithm>
#include <limits>

namespace fff {

namespace {

struct ReportRow
{
    std::size_t MeshReport::*count;
    Text text;
};

constexpr ReportRow kReportRows[] = {
    {&MeshReport::wrongIndices,
     FFF_TEXT_OF_MANY("Mesh", "%n faces were left out: a corner of theirs is not there.")},
    {&MeshReport::notFinite,
     FFF_TEXT_OF_MANY("Mesh", "%n faces were left out: the place of a corner is no number.")},
    {&MeshReport::degenerate,
     FFF_TEXT_OF_MANY("Mesh", "%n faces were left out: they have a corner twice.")},
    {&MeshReport::duplicates,
     FFF_TEXT_OF_MANY("Mesh", "%n faces were left out: they are there twice.")},
    {&MeshReport::flipped,
     FFF_TEXT_OF_MANY("Mesh", "%n faces looked the wrong way and were turned over.")},
    {&MeshReport::openEdges, FFF_TEXT_OF_MANY("Mesh", "The surface has holes: %n edges are open.")},
    {&MeshReport::crowdedEdges, FFF_TEXT_OF_MANY("Mesh", "More than two faces meet at %n edges.")},
    {&MeshReport::oneSidedEdges,
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
    for (const ReportRow &row : kReportRows)
        if (this->*row.count > 0)
            found.push_back({row.text, {}, countOf(this->*row.count)});
    if (wasInsideOut)
        found.push_back({FFF_TEXT("Mesh", "It was inside out and was turned over."), {}, {}});
    return found;
}

Message sizeOfMesh(std::size_t faces, std::size_t shells)
{
    const Message of{FFF_TEXT_OF_MANY("Mesh", "%n shells"), {}, countOf(shells)};
    return {FFF_TEXT_OF_MANY("Mesh", "%n faces in %1"), {of}, countOf(faces)};
}

} // namespace fff
