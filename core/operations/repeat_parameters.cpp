#include "core/operations/repeat_parameters.h"

#include "core/base/text.h"

#include <cmath>

namespace fff {

using Unit = ParameterSpec::Unit;

std::vector<InputSpec> repeatInputs()
{
    return {{.role = "section",
             .label = QT_TRANSLATE_NOOP("Operation", "Section"),
             .prompt = QT_TRANSLATE_NOOP("Operation", "Click the section to repeat.")},
            {.role = "along",
             .label = QT_TRANSLATE_NOOP("Operation", "Along"),
             .prompt = QT_TRANSLATE_NOOP("Operation", "Click the section it should run along.")}};
}

ParameterSpec wholeBranchParameter()
{
    return {.key = "wholeBranch",
            .label = QT_TRANSLATE_NOOP("Operation", "Whole branch"),
            .unit = Unit::Switch,
            .tip = QT_TRANSLATE_NOOP("Operation", "With everything that is attached to it")};
}

std::vector<ParameterSpec> rowParameters(int standardCount)
{
    return {{.key = "repeatBy",
             .label = QT_TRANSLATE_NOOP("Operation", "Repeat by"),
             .unit = Unit::Choice,
             .choices = {{"count", QT_TRANSLATE_NOOP("Operation", "Count")},
                         {"spacing", QT_TRANSLATE_NOOP("Operation", "Spacing")}},
             .heading = QT_TRANSLATE_NOOP("Operation", "Placing")},
            {.key = "count",
             .label = QT_TRANSLATE_NOOP("Operation", "Count"),
             .unit = Unit::Count,
             .standard = static_cast<double>(standardCount),
             .least = 2,
             .most = kMostReplicas,
             .sliderLeast = 2,
             .sliderMost = 40,
             .countsIf = "repeatBy",
             .countsFor = {"count"}},
            {.key = "spacing",
             .label = QT_TRANSLATE_NOOP("Operation", "Spacing"),
             .unit = Unit::Length,
             .standard = 12.7,
             .least = 0.5,
             .most = 2000.0,
             .step = 0.5,
             .sliderLeast = 2.0,
             .sliderMost = 100.0,
             .countsIf = "repeatBy",
             .countsFor = {"spacing"}},
            {.key = "from",
             .label = QT_TRANSLATE_NOOP("Operation", "From"),
             .unit = Unit::Share,
             .standard = 0.0,
             .least = 0.0,
             .most = 1.0,
             .step = 0.005,
             .sliderLeast = 0.0,
             .sliderMost = 1.0},
            {.key = "to",
             .label = QT_TRANSLATE_NOOP("Operation", "To"),
             .unit = Unit::Share,
             .standard = 1.0,
             .least = 0.0,
             .most = 1.0,
             .step = 0.005,
             .sliderLeast = 0.0,
             .sliderMost = 1.0}};
}

std::vector<ParameterSpec> scaleParameters()
{
    return {{.key = "scale",
             .label = QT_TRANSLATE_NOOP("Operation", "Scale"),
             .unit = Unit::Choice,
             .choices = {{"no", QT_TRANSLATE_NOOP("Operation", "No")},
                         {"thickness", QT_TRANSLATE_NOOP("Operation", "By local thickness")}},
             .heading = QT_TRANSLATE_NOOP("Operation", "Size")},
            {.key = "direction",
             .label = QT_TRANSLATE_NOOP("Operation", "Direction"),
             .unit = Unit::Choice,
             .choices = {{"section", QT_TRANSLATE_NOOP("Operation", "Whole section")},
                         {"slit", QT_TRANSLATE_NOOP("Operation", "Along the slit")}},
             .countsIf = "scale",
             .countsFor = {"thickness"}},
            {.key = "strength",
             .label = QT_TRANSLATE_NOOP("Operation", "Strength"),
             .unit = Unit::Share,
             .standard = 1.0,
             .least = 0.0,
             .most = 2.0,
             .step = 0.01,
             .sliderLeast = 0.0,
             .sliderMost = 2.0,
             .countsIf = "scale",
             .countsFor = {"thickness"}},
            {.key = "notBelow",
             .label = QT_TRANSLATE_NOOP("Operation", "Not below"),
             .unit = Unit::Share,
             .standard = 0.1,
             .least = 0.01,
             .most = 1.0,
             .step = 0.01,
             .sliderLeast = 0.01,
             .sliderMost = 1.0,
             .countsIf = "scale",
             .countsFor = {"thickness"}}};
}

RowRequest rowRequest(const OperationContext &context)
{
    RowRequest request;
    request.isByCount = context.choice("repeatBy") == "count";
    request.count = context.count("count");
    request.spacing = context.number("spacing");
    return request;
}

void noticeRow(OperationContext &context, const Row &row, int leftOut)
{
    using Kind = OperationNotice::Kind;
    // Of count and spacing, what the other one came to.
    const std::vector<RowPlace> &places = row.places;
    if (context.choice("repeatBy") == "spacing")
        context.found("count", static_cast<double>(places.size() + 1));
    else if (!places.empty())
        context.found("spacing", places.size() > 1 && places[0].number * places[1].number > 0
                                     ? places[1].at - places[0].at
                                     : std::abs(places[0].at));
    if (row.isStopped)
        context.notice({.kind = Kind::StoppedAtMost, .count = kMostReplicas});
    if (row.places.empty() || leftOut == static_cast<int>(row.places.size()))
        context.notice({.kind = Kind::NothingFits});
    else if (leftOut > 0)
        context.notice({.kind = Kind::LeftOut, .count = leftOut});
}

std::string copyNumber(int number)
{
    return number > 0 ? std::to_string(number + 1) : std::to_string(-number).insert(0, "\u2212");
}

} // namespace fff
