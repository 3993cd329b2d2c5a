#include "core/analysis/suggesting/first_slices.h"

#include "core/analysis/suggesting/suggestion_judge.h"
#include "core/model/edits.h"
#include "core/model/operation_edits.h"
#include "core/operations/slices.h"

#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace fff {

namespace {

/// What is nearest to the usual comes first: moved along, then fewer or more planes, and then other
/// ways to look at it.
const FirstSlices kTried[] = {
    {"xz", 6, 0.0}, {"xz", 6, 0.5}, {"xz", 5, 0.0}, {"xz", 4, 0.0},
    {"xz", 4, 0.5}, {"xz", 8, 0.0}, {"xy", 6, 0.0}, {"yz", 6, 0.0},
    {"xy", 4, 0.0}, {"yz", 4, 0.0}, {"xy", 4, 0.5}, {"yz", 4, 0.5},
    {"xz", 3, 0.0}, {"xy", 3, 0.0}, {"yz", 3, 0.0}, {"radial", 5, 0.0},
};

/// What else there is, is another thing.
Document withNothingElse(Document document)
{
    const std::vector<OperationPointer> operations = document.operations;
    for (const OperationPointer &operation : operations)
        document = removeOperation(document, operation->id).value_or(document);
    std::vector<SectionId> sections;
    for (const SectionPointer &section : document.sections)
        sections.push_back(section->id);
    return removeSections(document, sections).value_or(document);
}

std::optional<Document> withSlices(const Document &document, TemplateId of,
                                   const FirstSlices &slices)
{
    Operation operation = newOperation(kSlices);
    operation.name = "slices"; // which nobody sees
    operation.subject = of;
    operation.stock = document.currentStock;
    operation.parameters["direction"] = slices.direction;
    operation.parameters["count"] = static_cast<double>(slices.count);
    operation.parameters["shift"] = slices.shift;
    Result<Document> next = addOperation(document, std::move(operation));
    return next ? std::optional(*std::move(next)) : std::nullopt;
}

} // namespace

Result<FirstSlices> firstSlices(const Model &model, TemplateId of, const LongWork &work)
{
    const Template *one = model.document.find(of);
    if (!one || !one->mesh)
        return failure(ErrorCode::UnknownReference, std::to_string(of.value),
                       {std::to_string(of.value)});
    const Document alone = withNothingElse(model.document);
    SuggestionJudge judge(alone, work.stop);
    for (const FirstSlices &slices : kTried) {
        const std::optional<Document> next = withSlices(alone, of, slices);
        const auto verdict = next ? judge.verdictOn(*next) : SuggestionJudge::Verdict::Refused;
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        if (verdict == SuggestionJudge::Verdict::Taken)
            return slices;
        work.tell(static_cast<double>(&slices - std::begin(kTried) + 1) /
                  static_cast<double>(std::size(kTried)));
    }
    return FirstSlices();
}

} // namespace fff
