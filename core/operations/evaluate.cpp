#include "core/operations/evaluate.h"

#include "core/operations/driven.h"
#include "core/operations/operation_kind.h"
#include "core/operations/section_lookup.h"

#include <algorithm>

namespace fff {

namespace {

/// null: there is none
bool isSameTemplate(const TemplatePointer &before, const Template *now)
{
    return before.get() == now ||
           (before && now && before->name == now->name && before->hasFormOf(*now));
}

/// Whether the operation would see all that it looked at as it was.
bool seesTheSame(const OperationResult &before, const OperationPointer &operation,
                 const Document &document, const SectionLookup &above)
{
    if (before.operation != operation)
        return false;
    const auto isSameSection = [&above](const auto &read) {
        return above.find(read.first) == read.second;
    };
    const auto isSameStock = [&document](const auto &read) {
        return document.find(read.first) == read.second.get();
    };
    return std::all_of(before.readSections.begin(), before.readSections.end(), isSameSection) &&
           std::all_of(before.readStocks.begin(), before.readStocks.end(), isSameStock) &&
           isSameTemplate(before.readTemplate, document.find(operation->subject)) &&
           (!before.readAll || *before.readAll == above.sections());
}

OperationResultPointer resultOf(const OperationPointer &operation, const Document &document,
                                const SectionLookup &above, const OperationResultPointer &before)
{
    if (before && seesTheSame(*before, operation, document, above))
        return before;
    const OperationKind *kind = operationKind(operation->kind);
    if (!kind)
        return nullptr; // readers refuse them, so nobody has one
    OperationContext context(document, *kind, operation, above, before.get());
    kind->make(context);
    return std::make_shared<const OperationResult>(context.take());
}

bool isSameListing(const Listing &a, const Listing &b)
{
    return a.sections == b.sections && a.blocks == b.blocks;
}

} // namespace

Model evaluate(Document document, const Model &previous)
{
    Model model;
    Driven agreed = driven(std::move(document), previous.evaluation.values);
    model.document = std::move(agreed.document);
    model.evaluation.values = std::move(agreed.values);
    model.evaluation.drivingErrors = std::move(agreed.errors);
    if (model.document.isSame(previous.document)) {
        model.evaluation.results = previous.evaluation.results;
        model.evaluation.listing = previous.evaluation.listing;
        return model;
    }
    if (model.document.operations.empty())
        return model;
    const auto resultBefore = [&previous](OperationId id) -> OperationResultPointer {
        for (const OperationResultPointer &result : previous.evaluation.results)
            if (result->operation->id == id)
                return result;
        return nullptr;
    };
    SectionLookup sections(model.document);
    for (const OperationPointer &operation : model.document.operations) {
        if (!operation->isOn)
            continue;
        OperationResultPointer result =
            resultOf(operation, model.document, sections, resultBefore(operation->id));
        if (!result)
            continue;
        sections.append(result);
        model.evaluation.results.push_back(std::move(result));
    }
    model.evaluation.listing = sections.listing();
    const auto &before = previous.evaluation.listing;
    if (model.evaluation.listing && before && isSameListing(*model.evaluation.listing, *before))
        model.evaluation.listing = before;
    return model;
}

} // namespace fff
