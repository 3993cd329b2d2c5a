#include "core/session/operation_commands.h"

#include "core/model/operation_edits.h"
#include "core/operations/baking.h"
#include "core/operations/operation_kind.h"
#include "core/session/operation_text.h"
#include "core/session/session_host.h"

#include <algorithm>
#include <sstream>

namespace fff {

namespace {

const std::string *textOf(const CommandParameters &parameters, const std::string &key)
{
    const auto found = parameters.find(key);
    return found == parameters.end() ? nullptr : &found->second;
}

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

Result<OperationPointer> operationNamed(const Model &model, const CommandParameters &parameters)
{
    const std::string *name = textOf(parameters, "operation");
    for (const OperationPointer &operation : model.document.operations)
        if (name && operation->name == *name)
            return operation;
    return failure(ErrorCode::BadValue, "operation",
                   {name ? *name : std::string(), "the name of an operation"});
}

/// What the parameters say of an operation. Errors  BadValue, place = the key.
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

/// Those that are selected, for the roles that nothing was said of: one each, the last list takes
/// the rest.
void takeSelected(const Model &model, const OperationKind &kind,
                  const std::vector<SectionRef> &selected, Operation &operation)
{
    auto next = selected.begin();
    for (const InputSpec &input : kind.inputs) {
        if (operation.inputs.contains(input.role) || input.least == 0)
            continue;
        for (int i = 0; i < input.most && next != selected.end(); ++i, ++next)
            operation.inputs[input.role].push_back({*next, model.nameOf(*next)});
    }
}

/// The first role that has fewer inputs than it needs, or null.
const InputSpec *missingInput(const OperationKind &kind, const Operation &operation)
{
    for (const InputSpec &input : kind.inputs) {
        const auto found = operation.inputs.find(input.role);
        const int count =
            found == operation.inputs.end() ? 0 : static_cast<int>(found->second.size());
        if (count < input.least)
            return &input;
    }
    return nullptr;
}

class OperationCommands
{
public:
    OperationCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> add(const OperationKind &kind, const CommandParameters &parameters) const
    {
        const Model &model = m_session.committed();
        Result<Operation> operation = withParameters(model, kind, newOperation(kind), parameters);
        if (!operation)
            return tl::unexpected(operation.error());
        takeSelected(model, kind, m_interaction.selection(), *operation);
        if (const InputSpec *missing = missingInput(kind, *operation))
            return failure(ErrorCode::BadValue, missing->role, {"", "the name of a section"});
        if (operation->name.empty())
            operation->name = freeOperationName(model.document, *operation);
        const Step step{Step::Kind::AddOperation, {operation->name}};
        return commit(step, addOperation(model.document, *std::move(operation)));
    }

    Result<void> change(const CommandParameters &parameters) const
    {
        const Model &model = m_session.committed();
        const Result<OperationPointer> known = operationNamed(model, parameters);
        if (!known)
            return tl::unexpected(known.error());
        const OperationKind *kind = operationKind((*known)->kind);
        Result<Operation> next = withParameters(model, *kind, **known, parameters);
        if (!next)
            return tl::unexpected(next.error());
        const Step step{Step::Kind::ChangeOperation, {(*known)->name}};
        return commit(step, setOperation(model.document, *std::move(next)));
    }

    Result<void> turn(const CommandParameters &parameters) const
    {
        const Model &model = m_session.committed();
        const Result<OperationPointer> known = operationNamed(model, parameters);
        if (!known)
            return tl::unexpected(known.error());
        Operation next = **known;
        next.isOn = switched(parameters, next.isOn);
        const Step step{next.isOn ? Step::Kind::SwitchOnOperation : Step::Kind::SwitchOffOperation,
                        {next.name}};
        return commit(step, setOperation(model.document, std::move(next)));
    }

    Result<void> move(const CommandParameters &parameters) const
    {
        const Model &model = m_session.committed();
        const Result<OperationPointer> known = operationNamed(model, parameters);
        if (!known)
            return tl::unexpected(known.error());
        const Result<double> to = numberOf(parameters, "to", 1.0);
        if (!to)
            return tl::unexpected(to.error());
        return commit({Step::Kind::MoveOperation, {(*known)->name}},
                      moveOperation(model.document, (*known)->id, static_cast<int>(*to) - 1));
    }

    Result<void> remove(const CommandParameters &parameters) const
    {
        const Model &model = m_session.committed();
        const Result<OperationPointer> known = operationNamed(model, parameters);
        if (!known)
            return tl::unexpected(known.error());
        return commit({Step::Kind::DeleteOperation, {(*known)->name}},
                      removeOperation(model.document, (*known)->id));
    }

    Result<void> bake(const CommandParameters &parameters) const
    {
        const Model &model = m_session.committed();
        const Result<OperationPointer> known = operationNamed(model, parameters);
        if (!known)
            return tl::unexpected(known.error());
        return commit({Step::Kind::BakeOperation, {(*known)->name}}, baked(model, (*known)->id));
    }

    Result<void> exclude(const CommandParameters &parameters) const
    {
        const Model &model = m_session.committed();
        const Result<SectionRef> instance = instanceOf(model, parameters);
        if (!instance)
            return tl::unexpected(instance.error());
        const std::string *state = textOf(parameters, "state");
        const std::string wanted = state ? *state : "hidden";
        const std::vector<std::string> names{model.nameOf(*instance)};
        if (wanted == "detached")
            return commit({Step::Kind::DetachInstance, names}, detached(model, *instance));
        if (wanted != "hidden" && wanted != "made")
            return failure(ErrorCode::BadValue, "state", {wanted, "hidden, detached, made"});
        const bool isHidden = wanted == "hidden";
        return commit({isHidden ? Step::Kind::HideInstance : Step::Kind::ShowInstance, names},
                      setException(model.document, *instance,
                                   {isHidden ? Exception::State::Hidden : Exception::State::Made}));
    }

private:
    /// By its name, or that of an operation with the key below it ("Ribs/3"), as one that is hidden
    /// has no name; else the selected one.
    Result<SectionRef> instanceOf(const Model &model, const CommandParameters &parameters) const
    {
        const std::string *name = textOf(parameters, "section");
        if (!name) {
            for (const SectionRef &ref : m_interaction.selection())
                if (!ref.drawn.isValid())
                    return ref;
            return failure(ErrorCode::BadValue, "section", {"", "one that an operation made"});
        }
        for (const SectionPointer &section : model.sections())
            if (section->name == *name && !section->id.isValid())
                return section->ref();
        for (const OperationPointer &operation : model.document.operations)
            if (name->starts_with(operation->name + "/"))
                return SectionRef(operation->id, name->substr(operation->name.size() + 1));
        return failure(ErrorCode::BadValue, "section", {*name, "one that an operation made"});
    }

    Result<void> commit(const Step &step, Result<Document> next) const
    {
        if (!next)
            return tl::unexpected(next.error());
        m_session.commit(SessionHost::undoText(step), *std::move(next));
        return {};
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

std::string freeOperationName(const Document &document, const Operation &operation)
{
    const QString kind = kindName(operation);
    for (int number = 1;; ++number) {
        const std::string name = QStringLiteral("%1 %2").arg(kind).arg(number).toStdString();
        const auto isTaken = [&name](const OperationPointer &known) { return known->name == name; };
        if (std::none_of(document.operations.begin(), document.operations.end(), isTaken))
            return name;
    }
}

void registerOperationCommands(CommandRegistry &registry, Session &session,
                               Interaction &interaction)
{
    const OperationCommands commands(session, interaction);
    for (const OperationKind *kind : operationKinds()) {
        std::string id = "operation.";
        registry.add(id.append(kind->key),
                     {[commands, kind](const CommandParameters &parameters, double) {
                          return commands.add(*kind, parameters);
                      },
                      {}});
    }
    using Work = Result<void> (OperationCommands::*)(const CommandParameters &) const;
    const std::pair<const char *, Work> works[] = {
        {"operation.change", &OperationCommands::change},
        {"operation.switch", &OperationCommands::turn},
        {"operation.move", &OperationCommands::move},
        {"operation.delete", &OperationCommands::remove},
        {"operation.bake", &OperationCommands::bake},
        {"operation.exclude", &OperationCommands::exclude},
    };
    for (const auto &[id, work] : works) {
        const Work wanted = work; // a binding cannot be captured
        registry.add(id, {[commands, wanted](const CommandParameters &parameters, double) {
                              return (commands.*wanted)(parameters);
                          },
                          {}});
    }
}

} // namespace fff
