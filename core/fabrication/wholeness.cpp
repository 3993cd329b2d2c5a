#include "core/fabrication/wholeness.h"

#include <algorithm>

namespace fff {

namespace {

template <class Claim>
std::vector<int> sectionsThat(const Bodies &bodies, Claim claim)
{
    std::vector<int> sections;
    for (int section = 0; section < static_cast<int>(bodies.sectionCount()); ++section)
        if (const auto pieces = bodies.of(section);
            !pieces.empty() && claim(*pieces.front()->cut()))
            sections.push_back(section);
    return sections;
}

tl::unexpected<Error> failureOf(ErrorCode code, const Model &model, int section)
{
    return failure(code, {}, {model.section(static_cast<std::size_t>(section))->name});
}

} // namespace

std::vector<const Operation *> failedOperations(const Model &model)
{
    std::vector<const Operation *> failed;
    for (const OperationResultPointer &result : model.evaluation.results)
        if (std::any_of(result->notices.begin(), result->notices.end(),
                        [](const OperationNotice &notice) {
                            return notice.kind == OperationNotice::Kind::Failed;
                        }))
            failed.push_back(result->operation.get());
    return failed;
}

std::vector<int> uncutSections(const Bodies &bodies)
{
    return sectionsThat(bodies, [](const CutSection &cut) { return cut.failure().has_value(); });
}

std::vector<int> sectionsWithoutPart(const Bodies &bodies)
{
    std::vector<int> sections;
    for (int section = 0; section < static_cast<int>(bodies.sectionCount()); ++section)
        if (bodies.of(section).empty())
            sections.push_back(section);
    return sections;
}

std::vector<int> sectionsWithoutSolid(const Bodies &bodies)
{
    return sectionsThat(
        bodies, [](const CutSection &cut) { return cut.failure() || !cut.triangulations(); });
}

Result<void> haveParts(const Model &model, const Bodies &bodies)
{
    if (const auto failed = failedOperations(model); !failed.empty())
        return failure(ErrorCode::OperationFailed, {}, {failed.front()->name});
    if (const std::vector<int> uncut = uncutSections(bodies); !uncut.empty())
        return failureOf(ErrorCode::NotCutOut, model, uncut.front());
    return {};
}

Result<void> haveSolids(const Model &model, const Bodies &bodies)
{
    if (const Result<void> parts = haveParts(model, bodies); !parts)
        return parts;
    if (const std::vector<int> missing = sectionsWithoutSolid(bodies); !missing.empty())
        return failureOf(ErrorCode::NotSolid, model, missing.front());
    return {};
}

} // namespace fff
