#include "core/fabrication/wholeness.h"

#include <algorithm>

namespace fff {

namespace {

template <class Claim>
std::vector<int> sectionsThat(const std::vector<CutSectionPointer> &cuts, Claim claim)
{
    std::vector<int> sections;
    for (std::size_t i = 0; i < cuts.size(); ++i)
        if (claim(*cuts[i]))
            sections.push_back(static_cast<int>(i));
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

std::vector<int> uncutSections(const std::vector<CutSectionPointer> &cuts)
{
    return sectionsThat(cuts, [](const CutSection &cut) { return cut.failure().has_value(); });
}

std::vector<int> sectionsWithoutSolid(const std::vector<CutSectionPointer> &cuts)
{
    return sectionsThat(
        cuts, [](const CutSection &cut) { return cut.failure() || !cut.triangulations(); });
}

Result<void> haveParts(const Model &model, const std::vector<CutSectionPointer> &cuts)
{
    if (const auto failed = failedOperations(model); !failed.empty())
        return failure(ErrorCode::OperationFailed, {}, {failed.front()->name});
    if (const std::vector<int> uncut = uncutSections(cuts); !uncut.empty())
        return failureOf(ErrorCode::NotCutOut, model, uncut.front());
    return {};
}

Result<void> haveSolids(const Model &model, const std::vector<CutSectionPointer> &cuts)
{
    if (const Result<void> parts = haveParts(model, cuts); !parts)
        return parts;
    if (const std::vector<int> missing = sectionsWithoutSolid(cuts); !missing.empty())
        return failureOf(ErrorCode::NotSolid, model, missing.front());
    return {};
}

} // namespace fff
