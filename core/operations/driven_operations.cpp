// Parameters of operations that expressions can drive: all.
#include "core/model/operation_edits.h"
#include "core/operations/driven_owner.h"
#include "core/operations/operation_kind.h"

#include <string>
#include <variant>

namespace fff {

namespace {

ValueKind kindOf(ParameterSpec::Unit unit)
{
    switch (unit) {
    case ParameterSpec::Unit::Switch:
        return ValueKind::Switch;
    case ParameterSpec::Unit::Choice:
        return ValueKind::Choice;
    case ParameterSpec::Unit::Count:
    case ParameterSpec::Unit::Number:
        return ValueKind::Count;
    case ParameterSpec::Unit::Length:
        return ValueKind::Length;
    case ParameterSpec::Unit::Angle:
        return ValueKind::Angle;
    case ParameterSpec::Unit::Share:
        break;
    }
    return ValueKind::Ratio;
}

struct OfParameter
{
    const Operation *operation = nullptr;
    const ParameterSpec *spec = nullptr;
};

/// spec  null where there is none of that key
OfParameter parameterAt(const Document &document, const DrivenPlace &place)
{
    const Operation *operation = document.find(OperationId{place.id});
    const OperationKind *kind = operation ? operationKind(operation->kind) : nullptr;
    return {operation, kind ? kind->parameter(place.field) : nullptr};
}

Worth worthOfParameter(ValueKind kind, const ParameterValue &value)
{
    if (const std::string *choice = std::get_if<std::string>(&value))
        return worthOf(*choice);
    if (const bool *is = std::get_if<bool>(&value))
        return worthOf(kind, *is ? 1.0 : 0.0);
    return worthOf(kind, std::get<double>(value));
}

/// One that follows from the inputs as long as nobody says it counts as its standard here: it is
/// the number from which a binding begins.
std::optional<DrivenNumber> readParameter(const Document &document, const DrivenPlace &place)
{
    const auto [operation, spec] = parameterAt(document, place);
    if (!spec)
        return std::nullopt;
    const ValueKind kind = kindOf(spec->unit);
    const ParameterValue value =
        valueOf(*spec, *operation).value_or(ParameterValue(spec->standard));
    return DrivenNumber{kind, worthOfParameter(kind, value), Text{"Operation", spec->label}};
}

Result<Document> writeParameter(Document document, const DrivenPlace &place, const Worth &worth)
{
    const auto [operation, spec] = parameterAt(document, place);
    ParameterValue value = worth.number;
    if (worth.type == Worth::Type::Text)
        value = worth.text;
    else if (worth.type == Worth::Type::Truth)
        value = worth.number != 0.0;
    if (!isAllowed(*spec, value))
        return failure(ErrorCode::BadValue, spec->key,
                       {worth.type == Worth::Type::Text ? worth.text : std::to_string(worth.number),
                        rangeText(*spec)});
    Operation next = *operation;
    next.parameters[spec->key] = std::move(value);
    return setOperation(std::move(document), std::move(next));
}

void listParameters(const Document &document, std::vector<DrivenPlace> &places)
{
    for (const OperationPointer &operation : document.operations)
        if (const OperationKind *kind = operationKind(operation->kind))
            for (const ParameterSpec &spec : kind->parameters)
                places.push_back({.of = DrivenPlace::Of::Operation,
                                  .id = operation->id.value,
                                  .field = spec.key});
}

std::string nameOfOperation(const Document &document, const DrivenPlace &place)
{
    const Operation *operation = document.find(OperationId{place.id});
    return operation ? operation->name : std::string();
}

} // namespace

const DrivenOwner kDrivenOperations{readParameter, writeParameter, listParameters, nameOfOperation};

} // namespace fff
