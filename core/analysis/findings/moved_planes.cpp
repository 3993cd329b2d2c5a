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
//: %1 is the name of an operation, such as "Slices"
constexpr Text kSpacePlanes = FFF_TEXT("Step", "Change spacing of planes of %1");
//: of the slices of a mesh; %1 is a number, a part of the distance between two of them
constexpr Text kShiftText = FFF_TEXT("Checks", "Shift the planes by %1 %");
//: of the slices of a mesh; %1 is a length
constexpr Text kSpaceText = FFF_TEXT("Checks", "Planes every %1");
//: of the slices of a mesh; %1 is such as "One plane fewer each way"
constexpr Text kBothText = FFF_TEXT("Checks", "%1, shifted by %2 %");

/// Of the slices of a mesh in two directions, and around an axis.
struct CountWords
{
    Text eachWay, around;
};
constexpr CountWords kOneMoreText{FFF_TEXT("Checks", "One plane more each way"),
                                  FFF_TEXT("Checks", "One plane more")};
constexpr CountWords kOneFewerText{FFF_TEXT("Checks", "One plane fewer each way"),
                                   FFF_TEXT("Checks", "One plane fewer")};
constexpr CountWords kTwoMoreText{FFF_TEXT("Checks", "Two planes more each way"),
                                  FFF_TEXT("Checks", "Two planes more")};
constexpr CountWords kTwoFewerText{FFF_TEXT("Checks", "Two planes fewer each way"),
                                   FFF_TEXT("Checks", "Two planes fewer")};

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

bool isAround(const Operation &slices)
{
    return choiceOf(slices, "direction").starts_with("radial");
}

/// Null: none of the sections is of slices that cross.
const Operation *slicesOf(const Finding &finding, const Document &document)
{
    for (const SectionRef &ref : finding.sections) {
        const Operation *operation = document.find(ref.operation);
        if (ref.operation.isValid() && operation && operation->kind == kSlices.key &&
            (choiceOf(*operation, "direction").size() == 2 || isAround(*operation)))
            return operation;
    }
    return nullptr;
}

/// Those around an axis are always so many.
bool isByCount(const Operation &slices)
{
    return isAround(slices) || choiceOf(slices, "planesBy") == "count";
}

/// What becomes of planes. As a part of their distance, planes in each direction, of the spacing.
template <int kShift, int kMore, int kSpacing>
struct PlaneChange
{
    static Message words(const FindingAction &, const Finding &finding, const Model &model)
    {
        const Operation *slices = slicesOf(finding, model.document);
        if constexpr (kSpacing != 0)
            return {kSpaceText, {lengthOf(slices ? spacingOf(*slices) : 0.0)}};
        if constexpr (kMore == 0)
            return {kShiftText, {kShift}};
        constexpr CountWords kWords = kMore == 1    ? kOneMoreText
                                      : kMore == -1 ? kOneFewerText
                                      : kMore == 2  ? kTwoMoreText
                                                    : kTwoFewerText;
        const Message count{slices && isAround(*slices) ? kWords.around : kWords.eachWay, {}};
        if constexpr (kShift != 0)
            return {kBothText, {count, kShift}};
        return count;
    }

    static std::optional<FindingEdit> edit(const FindingAction &, const Finding &finding,
                                           const Analysis &analysis, const Flips *)
    {
        const Document &document = analysis.model.document;
        const Operation *slices = slicesOf(finding, document);
        if (!slices || (kMore != 0 && !isByCount(*slices)) || (kSpacing != 0 && isByCount(*slices)))
            return {};
        Operation next = *slices;
        if constexpr (kShift != 0) {
            double shift = numberOf(next, "shift") + kShift / kHundredPercent;
            if (shift > kSlices.parameter("shift")->most) // a whole distance further all is there
                shift -= 1.0;
            next.parameters.insert_or_assign("shift", shift);
        }
        if constexpr (kMore != 0) {
            const double count = numberOf(next, "count") + kMore;
            if (!isWithin(*kSlices.parameter("count"), count))
                return {};
            next.parameters.insert_or_assign("count", count);
        }
        if constexpr (kSpacing != 0) {
            if (!isWithin(*kSlices.parameter("spacing"), spacingOf(next)))
                return {};
            next.parameters.insert_or_assign("spacing", spacingOf(next));
        }
        const std::string name = next.name;
        Result<Document> made = setOperation(document, std::move(next));
        if (!made)
            return {};
        return FindingEdit{{kSpacing != 0 ? kSpacePlanes
                            : kMore != 0  ? kMorePlanes
                                          : kShiftPlanes,
                            {Named{name}}},
                           *std::move(made)};
    }

    static bool isWithin(const ParameterSpec &spec, double value)
    {
        return value >= spec.least && value <= spec.most;
    }
    /// To whole halves of a millimetre, as the field's arrows have it.
    static double spacingOf(const Operation &slices)
    {
        const double step = kSlices.parameter("spacing")->step;
        return step *
               std::round((1.0 + kSpacing / kHundredPercent) * numberOf(slices, "spacing") / step);
    }

    static constexpr ActionKind kFirst{words, edit, false};
    static constexpr ActionKind kLast{words, edit, true};
};

} // namespace

std::vector<FindingAction> movedPlanes(const Finding &finding, const Document &document)
{
    if (!slicesOf(finding, document))
        return {};
    return {{&PlaneChange<25, 0, 0>::kFirst},
            {&PlaneChange<50, 0, 0>::kFirst},
            {&PlaneChange<75, 0, 0>::kFirst},
            {&PlaneChange<0, 1, 0>::kFirst}};
}

std::vector<FindingAction> otherPlanes(const Finding &finding, const Document &document)
{
    if (!slicesOf(finding, document))
        return {};
    return {{&PlaneChange<0, -1, 0>::kLast},  {&PlaneChange<10, 0, 0>::kLast},
            {&PlaneChange<90, 0, 0>::kLast},  {&PlaneChange<40, 0, 0>::kLast},
            {&PlaneChange<60, 0, 0>::kLast},  {&PlaneChange<0, 2, 0>::kLast},
            {&PlaneChange<0, -2, 0>::kLast},  {&PlaneChange<50, 1, 0>::kLast},
            {&PlaneChange<50, -1, 0>::kLast}, {&PlaneChange<25, 1, 0>::kLast},
            {&PlaneChange<75, 1, 0>::kLast},  {&PlaneChange<25, -1, 0>::kLast},
            {&PlaneChange<75, -1, 0>::kLast}, {&PlaneChange<0, 0, -10>::kLast},
            {&PlaneChange<0, 0, 10>::kLast},  {&PlaneChange<0, 0, -20>::kLast},
            {&PlaneChange<0, 0, 25>::kLast}};
}

bool areOfCrossingSlices(const Finding &finding, const Document &document)
{
    return slicesOf(finding, document);
}

} // namespace fff
