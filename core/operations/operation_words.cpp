#include "core/operations/operation_words.h"

#include <cmath>

namespace fff {

Argument valueWords(const ParameterSpec &spec, const std::optional<ParameterValue> &value)
{
    using Unit = ParameterSpec::Unit;
    if (!value)
        return FFF_TEXT("OperationNotice", "automatic");
    if (const bool *isOn = std::get_if<bool>(&*value))
        return *isOn ? FFF_TEXT("OperationNotice", "on") : FFF_TEXT("OperationNotice", "off");
    if (const std::string *key = std::get_if<std::string>(&*value)) {
        for (const ChoiceSpec &choice : spec.choices)
            if (*key == choice.key)
                return operationWord(choice.label);
        return Named{*key};
    }
    // Two digits are more than is shown of any step.
    const double spoken = spokenValue(spec.unit, std::get<double>(*value));
    const Decimal number{std::round(100.0 * spoken) / 100.0};
    switch (spec.unit) {
    case Unit::Length:
        return Message{FFF_TEXT("OperationNotice", "%1\u202fmm"), {number}};
    case Unit::Share:
        return Message{FFF_TEXT("OperationNotice", "%1\u202f%"), {number}};
    case Unit::Angle:
        return Message{FFF_TEXT("OperationNotice", "%1°"), {number}};
    default:
        return number;
    }
}

Step steps::changed(const Operation &operation, const std::string &key,
                    const std::optional<ParameterValue> &before,
                    const std::optional<ParameterValue> &after)
{
    const OperationKind *kind = operationKind(operation.kind);
    const ParameterSpec *spec = kind ? kind->parameter(key) : nullptr;
    const InputSpec *input = kind ? kind->input(key) : nullptr;
    const Named name{operation.name};
    if (input && after && std::holds_alternative<std::string>(*after))
        //: %1 is the name of an operation, %2 of what it works on ("Along"), %3 of a section
        return {FFF_TEXT("Step", "%1: %2 → %3"),
                {name, operationWord(input->label), Named{std::get<std::string>(*after)}}};
    if (!spec)
        return changed(operation);
    //: %1 is the name of an operation, %2 of a number ("Count"), %3 and %4 what it was and is
    return {
        FFF_TEXT("Step", "%1: %2 %3 → %4"),
        {name, operationWord(spec->label), valueWords(*spec, before), valueWords(*spec, after)}};
}

Step steps::changed(const Operation &operation)
{
    //: %1 is the name of an operation
    return {FFF_TEXT("Step", "Change %1"), {Named{operation.name}}};
}

} // namespace fff
