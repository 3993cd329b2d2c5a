#include "core/session/operation_script.h"

#include <sstream>

namespace fff {

namespace {

std::vector<std::string> linesOf(const std::string &text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// In what is there now; drawn sections may also be named while an operation takes their place.
Result<OperationInput> inputNamed(const Model &model, const std::string &key,
                                  const std::string &name)
{
    for (const auto *list : {&model.sections(), &model.document.sections})
        for (const SectionPointer &section : *list)
            if (section->name == name)
                return OperationInput{section->ref(), name};
    return failure(ErrorCode::BadValue, key, {name, "the name of a section"});
}

} // namespace

std::optional<SectionRef> sectionNamed(const Model &model, const std::string &name)
{
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        if (model.section(i)->name == name)
            return model.ref(i);
    return {};
}

const std::string *textOf(const CommandParameters &parameters, const std::string &key)
{
    const auto found = parameters.find(key);
    return found == parameters.end() ? nullptr : &found->second;
}

Result<OperationPointer> operationNamed(const Model &model, const CommandParameters &parameters,
                                        OperationId otherwise)
{
    const std::string *name = textOf(parameters, "operation");
    for (const OperationPointer &operation : model.document.operations)
        if (name ? operation->name == *name : operation->id == otherwise)
            return operation;
    return failure(ErrorCode::BadValue, "operation",
                   {name ? *name : std::string(), "the name of an operation"});
}

Result<Operation> withParameters(const Model &model, const OperationKind &kind, Operation operation,
                                 const CommandParameters &parameters)
{
    for (const auto &[key, text] : parameters) {
        if (key == "operation") {
            continue;
        }
        if (key == "name") {
            operation.name = text;
        } else if (const ParameterSpec *spec = kind.parameter(key); spec && !kind.input(key)) {
            Result<ParameterValue> value = parsedValue(*spec, text);
            if (!value)
                return tl::unexpected(value.error());
            operation.parameters.insert_or_assign(key, *std::move(value));
        } else if (kind.input(key)) {
            std::vector<OperationInput> inputs;
            for (const std::string &name : linesOf(text)) {
                Result<OperationInput> input = inputNamed(model, key, name);
                if (!input)
                    return tl::unexpected(input.error());
                inputs.push_back(*std::move(input));
            }
            operation.inputs.insert_or_assign(key, std::move(inputs));
        } else {
            return failure(ErrorCode::BadValue, key, {text, "a parameter of this operation"});
        }
    }
    return operation;
}

Result<SectionRef> instanceNamed(const Model &model, const std::string &name)
{
    for (const SectionPointer &section : model.sections())
        if (section->name == name && !section->id.isValid())
            return section->ref();
    for (const OperationPointer &operation : model.document.operations)
        if (name.starts_with(operation->name + "/"))
            return SectionRef(operation->id, name.substr(operation->name.size() + 1));
    return failure(ErrorCode::BadValue, "section", {name, "one that an operation made"});
}

} // namespace fff
