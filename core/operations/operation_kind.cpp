#include "core/operations/operation_kind.h"

#include "core/base/units.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

namespace fff {

namespace {

using Unit = ParameterSpec::Unit;

bool isWhole(Unit unit)
{
    return unit == Unit::Count || unit == Unit::Number;
}

ParameterValue standardOf(const ParameterSpec &spec)
{
    switch (spec.unit) {
    case Unit::Switch:
        return spec.standard != 0.0;
    case Unit::Choice:
        return std::string(spec.choices[static_cast<std::size_t>(spec.standard)].key);
    default:
        return spec.standard;
    }
}

/// In text, as a file or a script has it.
std::string asKey(const ParameterValue &value)
{
    if (const bool *is = std::get_if<bool>(&value))
        return *is ? "true" : "false";
    const std::string *key = std::get_if<std::string>(&value);
    return key ? *key : std::string();
}

bool hasChoice(const ParameterSpec &spec, const std::string &key)
{
    return std::any_of(spec.choices.begin(), spec.choices.end(),
                       [&](const ChoiceSpec &choice) { return key == choice.key; });
}

/// Of its type, the number finite; its range is another matter.
bool isOfType(const ParameterSpec &spec, const ParameterValue &value)
{
    switch (spec.unit) {
    case Unit::Switch:
        return std::holds_alternative<bool>(value);
    case Unit::Choice: {
        const std::string *key = std::get_if<std::string>(&value);
        return key && hasChoice(spec, *key);
    }
    default: {
        const double *number = std::get_if<double>(&value);
        return number && std::isfinite(*number);
    }
    }
}

tl::unexpected<Error> badValue(const ParameterSpec &spec, const std::string &text)
{
    return failure(ErrorCode::BadValue, spec.key, {text, rangeText(spec)});
}

} // namespace

const ParameterSpec *OperationKind::parameter(std::string_view wanted) const
{
    const auto it =
        std::find_if(parameters.begin(), parameters.end(),
                     [wanted](const ParameterSpec &spec) { return wanted == spec.key; });
    return it == parameters.end() ? nullptr : &*it;
}

const InputSpec *OperationKind::input(std::string_view wanted) const
{
    const auto it = std::find_if(inputs.begin(), inputs.end(),
                                 [wanted](const InputSpec &spec) { return wanted == spec.role; });
    return it == inputs.end() ? nullptr : &*it;
}

const OperationKind *operationKind(std::string_view key)
{
    const auto kinds = operationKinds();
    const auto it = std::find_if(kinds.begin(), kinds.end(),
                                 [key](const OperationKind *kind) { return key == kind->key; });
    return it == kinds.end() ? nullptr : *it;
}

Operation newOperation(const OperationKind &kind)
{
    Operation operation;
    operation.kind = kind.key;
    operation.version = kind.version;
    for (const ParameterSpec &spec : kind.parameters)
        if (!spec.isFree)
            operation.parameters.emplace(spec.key, standardOf(spec));
    return operation;
}

int countOf(const Operation &operation, const InputSpec &input)
{
    const auto found = operation.inputs.find(input.role);
    return found == operation.inputs.end() ? 0 : static_cast<int>(found->second.size());
}

const OperationInput *firstInput(const Operation &operation)
{
    if (const OperationKind *kind = operationKind(operation.kind))
        for (const InputSpec &input : kind->inputs)
            if (countOf(operation, input) > 0)
                return &operation.inputs.at(input.role).front();
    return nullptr;
}

const InputSpec *missingInput(const OperationKind &kind, const Operation &operation)
{
    for (const InputSpec &input : kind.inputs)
        if (countOf(operation, input) < input.least)
            return &input;
    return nullptr;
}

namespace {

template <class Spec>
bool countsAs(const Spec &spec, const Operation &operation)
{
    const OperationKind *kind = operationKind(operation.kind);
    const ParameterSpec *other = kind && spec.countsIf ? kind->parameter(spec.countsIf) : nullptr;
    if (!other)
        return true;
    if (!counts(*other, operation))
        return false;
    const std::optional<ParameterValue> value = valueOf(*other, operation);
    return value && std::any_of(spec.countsFor.begin(), spec.countsFor.end(),
                                [text = asKey(*value)](const char *key) { return text == key; });
}

} // namespace

bool counts(const InputSpec &spec, const Operation &operation)
{
    return countsAs(spec, operation);
}

bool counts(const ParameterSpec &spec, const Operation &operation)
{
    return countsAs(spec, operation);
}

std::optional<ParameterValue> valueOf(const ParameterSpec &spec, const Operation &operation)
{
    const auto it = operation.parameters.find(spec.key);
    if (it == operation.parameters.end() || !isOfType(spec, it->second))
        return spec.isFree ? std::nullopt : std::optional(standardOf(spec));
    ParameterValue value = it->second;
    if (double *number = std::get_if<double>(&value)) {
        *number = std::clamp(*number, spec.least, spec.most);
        if (isWhole(spec.unit))
            *number = std::round(*number);
    }
    return value;
}

bool isAllowed(const ParameterSpec &spec, const ParameterValue &value)
{
    if (!isOfType(spec, value))
        return false;
    const double *number = std::get_if<double>(&value);
    return !number || (*number >= spec.least && *number <= spec.most &&
                       (!isWhole(spec.unit) || *number == std::round(*number)));
}

std::string rangeText(const ParameterSpec &spec)
{
    if (spec.unit == Unit::Switch)
        return "true, false";
    if (spec.unit == Unit::Choice) {
        std::string text;
        for (const ChoiceSpec &choice : spec.choices)
            text += (text.empty() ? "" : ", ") + std::string(choice.key);
        return text;
    }
    const auto said = [&spec](double value) {
        std::string text(32, '\0');
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), spokenValue(spec.unit, value),
                          std::chars_format::general, 6);
        text.resize(static_cast<std::size_t>(end.ptr - text.data()));
        return text;
    };
    return said(spec.least) + " … " + said(spec.most);
}

double spokenValue(ParameterSpec::Unit unit, double value)
{
    return unit == Unit::Angle ? degrees(value) : unit == Unit::Share ? 100.0 * value : value;
}

double valueSpoken(ParameterSpec::Unit unit, double spoken)
{
    return unit == Unit::Angle ? radians(spoken) : unit == Unit::Share ? 0.01 * spoken : spoken;
}

Result<ParameterValue> parsedValue(const ParameterSpec &spec, const std::string &text)
{
    ParameterValue value = text;
    if (spec.unit == Unit::Switch) {
        if (text != "true" && text != "false")
            return badValue(spec, text);
        value = text == "true";
    } else if (spec.unit != Unit::Choice) {
        double number = 0.0;
        const char *end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, number);
        if (error != std::errc() || stop != end)
            return badValue(spec, text);
        // Degrees and percent do not come back bit for bit: what is at a bound is the bound.
        const double read = valueSpoken(spec.unit, number);
        const bool isBound = number == spokenValue(spec.unit, spec.least) ||
                             number == spokenValue(spec.unit, spec.most);
        value = isBound ? std::clamp(read, spec.least, spec.most) : read;
    }
    if (!isAllowed(spec, value))
        return badValue(spec, text);
    return value;
}

} // namespace fff
