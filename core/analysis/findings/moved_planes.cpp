#include "core/analysis/findings/moved_planes.h"

#include "core/model/operation_edits.h"
#include "core/operations/slices.h"

#include <array>
#include <cmath>

namespace fff {

namespace {

constexpr double kHundredPercent = 100.0;

//: %1 is the name of an operation, such as "Slices"
constexpr Text kShiftPlanes = FFF_TEXT("Step", "Shift planes of %1");
//: %1 is the name of an operation, such as "Slices"
constexpr Text kMorePlanes = FFF_TEXT("Step", "Change number of planes of %1");
//: of the slices of a mesh; %1 is a number, a part of the distance between two of them
constexpr Text kShiftText = FFF_TEXT("Checks", "Shift the planes by %1 %");
//: of the slices of a mesh
constexpr Text kMoreText = FFF_TEXT("Checks", "One plane more each way");

double numberOf(const Operation &slices, const char *key)
{
    const auto value = valueOf(*kSlices.parameter(key), slices);
    const double *number = value ? std::get_if<double>(&*value) : nullptr;
    return number ? *number : 0.0;
}

std::string choiceOf(const Operation &slices, const char *key)
{
    const auto value = valueOf(*kSlices.parameter(key), slices);
    const std::string *choice = value ? std::get_if<std::string>(&*value) : nullptr;
    return choice ? *choice : std::string();
}

/// Null: none of the sections is of a grid.
const Operation *gridOf(const Finding &finding, const Document &document)
{
    for (const SectionRef &ref : finding.sections) {
        const Operation *operation = document.find(ref.operation);
        if (ref.operation.isValid() && operation && operation->kind == kSlices.key &&
            choiceOf(*operation, "direction").size() == 2)
            return operation;
    }
    return nullptr;
}

std::optional<FindingEdit> edited(const Document &document, Operation next, Text step)
{
    const std::string name = next.name;
    Result<Document> made = setOperation(document, std::move(next));
    if (!made)
        return {};
    return FindingEdit{{step, {Named{name}}}, *std::move(made)};
}

template <int kPercent>
Message shiftWords(const FindingAction &, const Finding &, const Model &)
{
    return {kShiftText, {kPercent}};
}

template <int kPercent>
std::optional<FindingEdit> shifted(const FindingAction &, const Finding &finding,
                                   const Analysis &analysis, const Flips *)
{
    const Operation *grid = gridOf(finding, analysis.model.document);
    if (!grid)
        return {};
    Operation next = *grid;
    double shift = numberOf(next, "shift") + kPercent / kHundredPercent;
    if (shift > kSlices.parameter("shift")->most) // a whole distance further all is where it was
        shift -= 1.0;
    next.parameters.insert_or_assign("shift", shift);
    return edited(analysis.model.document, std::move(next), kShiftPlanes);
}

std::optional<FindingEdit> withMore(const FindingAction &, const Finding &finding,
                                    const Analysis &analysis, const Flips *)
{
    const Operation *grid = gridOf(finding, analysis.model.document);
    if (!grid)
        return {};
    Operation next = *grid;
    if (choiceOf(next, "planesBy") != "count")
        return {}; // as many as have room
    const double count = numberOf(next, "count") + 1.0;
    if (count > kSlices.parameter("count")->most)
        return {};
    next.parameters.insert_or_assign("count", count);
    return edited(analysis.model.document, std::move(next), kMorePlanes);
}

constexpr ActionKind kShiftByQuarter{shiftWords<25>, shifted<25>};
constexpr ActionKind kShiftByHalf{shiftWords<50>, shifted<50>};
constexpr ActionKind kShiftByThree{shiftWords<75>, shifted<75>};
constexpr ActionKind kOneMore{plainWords<kMoreText>, withMore};

} // namespace

std::vector<FindingAction> movedPlanes(const Finding &finding, const Document &document)
{
    if (!gridOf(finding, document))
        return {};
    return {{&kShiftByQuarter}, {&kShiftByHalf}, {&kShiftByThree}, {&kOneMore}};
}

} // namespace fff
