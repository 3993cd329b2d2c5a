#include "core/session/operation_commands.h"

#include "core/interaction/operation_tool.h"
#include "core/interaction/section_edit.h"
#include "core/model/operation_edits.h"
#include "core/operations/baking.h"
#include "core/operations/operation_words.h"
#include "core/session/command_rules.h"
#include "core/session/message_text.h"
#include "core/session/mirror_commands.h"
#include "core/session/operation_script.h"
#include "core/session/operation_text.h"

#include <algorithm>
#include <memory>

namespace fff {

namespace {

constexpr CommandWords kOperationWords[] = {
    {"operation.linear", FFF_TEXT("Command", "&Linear"), FFF_TEXT("Command", "Linear"), "Ctrl+L",
     "linear", FFF_TEXT("Command", "Repeat a section in a row along another one")},
    {"operation.revolve", FFF_TEXT("Command", "&Revolve along contour"),
     FFF_TEXT("Command", "Revolve"), "Ctrl+R", "revolve",
     FFF_TEXT("Command", "Repeat a section round the contour of another one")},
    {"operation.blend", FFF_TEXT("Command", "&Blend"), FFF_TEXT("Command", "Blend"), "Ctrl+E",
     "blend", FFF_TEXT("Command", "Interpolate between sections")},
    {"operation.branch", FFF_TEXT("Command", "Br&anch"), FFF_TEXT("Command", "Branch"), "Ctrl+B",
     "branch", FFF_TEXT("Command", "Grow copies of a section out of itself, like a tree")},
    {"operation.grid", FFF_TEXT("Command", "&Grid with connectors"), FFF_TEXT("Command", "Grid"),
     "Ctrl+G", "grid", FFF_TEXT("Command", "Divide a section that is too large for the sheet")},
    {"operation.radial", FFF_TEXT("Command", "Ra&dial contour"), FFF_TEXT("Command", "Radial"),
     "Ctrl+Shift+R", "radial",
     FFF_TEXT("Command",
              "Turn a section into a circle, a star or a gear, or cut such holes into it")},
    {"operation.mirror", FFF_TEXT("Command", "&Mirror model"), FFF_TEXT("Command", "Mirror"), "",
     "mirror", FFF_TEXT("Command", "Repeat everything drawn on one side on the other")},
    {"operation.rotational", FFF_TEXT("Command", "Ro&tational symmetry"),
     FFF_TEXT("Command", "Rotational"), "", "rotational",
     FFF_TEXT("Command", "Repeat everything drawn once all round an axis")},
    {"operation.array", FFF_TEXT("Command", "Arra&y"), FFF_TEXT("Command", "Array"), "", "array",
     FFF_TEXT("Command", "Repeat sections along a line through space")},
    {"operation.slices", FFF_TEXT("Command", "&Slices of a mesh"), FFF_TEXT("Command", "Slices"),
     "", "slices",
     FFF_TEXT("Command", "Cut a mesh that is drawn over into sections that follow it")},
    {"operation.symmetric", FFF_TEXT("Command", "Make symmetric &now"),
     FFF_TEXT("Command", "Symmetric"), "", "symmetry",
     FFF_TEXT("Command", "Mirror one side to the other, once")},
    {"operation.switch", FFF_TEXT("Command", "&Switch off or on"), FFF_TEXT("Command", "On"), "",
     "operation_switch", FFF_TEXT("Command", "Switch the selected operation off, or on again")},
    {"operation.moveUp", FFF_TEXT("Command", "Earlier in the &order"),
     FFF_TEXT("Command", "Earlier"), "", "move_up",
     FFF_TEXT("Command", "Run the selected operation before the one above it")},
    {"operation.moveDown", FFF_TEXT("Command", "Lat&er in the order"), FFF_TEXT("Command", "Later"),
     "", "move_down", FFF_TEXT("Command", "Run the selected operation after the one below it")},
    {"operation.bake", FFF_TEXT("Command", "Ba&ke into sections"), FFF_TEXT("Command", "Bake"), "",
     "bake", FFF_TEXT("Command", "Turn what the selected operation makes into drawn sections")},
};

//: %1 is the name of an operation
constexpr Text kSwitchOnOperation = FFF_TEXT("Step", "Switch %1 on");
//: %1 is the name of an operation
constexpr Text kSwitchOffOperation = FFF_TEXT("Step", "Switch %1 off");
//: %1 is the name of an operation
constexpr Text kDeleteOperation = FFF_TEXT("Step", "Delete %1");
//: %1 is the name of an operation
constexpr Text kBakeOperation = FFF_TEXT("Step", "Bake %1");
//: %1 is the name of a section that an operation made
constexpr Text kDetachInstance = FFF_TEXT("Step", "Detach %1");

constexpr Text kNothingToWorkOn =
    FFF_TEXT("Hint", "Draw a section first: there is nothing to repeat or divide yet.");

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

/// Where one parameter alone becomes another one, also what it was.
Step changeBetween(const Operation &before, const Operation &after,
                   const CommandParameters &parameters)
{
    std::optional<Step> step;
    for (const auto &[key, text] : parameters) {
        const auto now = after.parameters.find(key);
        if (now == after.parameters.end())
            continue;
        if (step)
            return steps::changed(before);
        const auto was = before.parameters.find(key);
        step = steps::changed(
            before, key, was == before.parameters.end() ? std::nullopt : std::optional(was->second),
            now->second);
    }
    return step ? *std::move(step) : steps::changed(before);
}

/// By the parameter "template", else the last one; null: there is none.
TemplatePointer templateNamed(const Document &document, const CommandParameters &parameters)
{
    const std::string *name = textOf(parameters, "template");
    for (auto one = document.templates.rbegin(); one != document.templates.rend(); ++one)
        if (!name || (*one)->name == *name)
            return *one;
    return nullptr;
}

class OperationCommands
{
public:
    OperationCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    /// Without any word of what it is to be, what misses is asked for in the view.
    Result<void> add(const OperationKind &kind, const CommandParameters &parameters,
                     double time) const
    {
        const Model &model = m_session.committed();
        if (model.sectionCount() == 0 && !kind.isOfTemplate) {
            if (!parameters.empty())
                return failure(ErrorCode::BadValue, kind.key, {"", "a section to work on"});
            m_interaction.carryOut(SectionEdit(tl::unexpected(Hint::refusal(kNothingToWorkOn))),
                                   time);
            return {};
        }
        CommandParameters said = parameters;
        said.erase("template"); // which is no section
        Result<Operation> operation = withParameters(model, kind, newOperation(kind), said);
        if (!operation)
            return tl::unexpected(operation.error());
        if (kind.isOfTemplate) {
            const TemplatePointer subject = templateNamed(model.document, parameters);
            if (!subject)
                return failure(ErrorCode::BadValue, "template", {"", "the name of a template"});
            operation->subject = subject->id;
            operation->stock = model.document.currentStock;
        }
        takeSelected(model, kind, m_interaction.selection(), *operation);
        if (const InputSpec *missing = missingInput(kind, *operation)) {
            if (!parameters.empty())
                return failure(ErrorCode::BadValue, missing->role, {"", "the name of a section"});
            if (model.sectionCount() == 0) {
                m_interaction.carryOut(SectionEdit(tl::unexpected(Hint::refusal(kNothingToWorkOn))),
                                       time);
                return {};
            }
            m_interaction.pickUp(std::make_unique<OperationTool>(
                                     kind, *std::move(operation),
                                     [this_ = *this](const Operation &added) {
                                         return freeOperationName(
                                             this_.m_session.committed().document, added);
                                     }),
                                 time);
            return {};
        }
        if (operation->name.empty())
            operation->name = freeOperationName(model.document, *operation);
        const OperationId id{model.document.nextId};
        const Step step{steps::kAddOperation, {Named{operation->name}}};
        const Result<void> done = commit(step, addOperation(model.document, *std::move(operation)));
        if (done)
            m_interaction.selectOperation(id);
        return done;
    }

    Result<void> change(const CommandParameters &parameters, double) const
    {
        const Model &model = m_session.committed();
        const Result<OperationPointer> known = named(parameters);
        if (!known)
            return tl::unexpected(known.error());
        const OperationKind *kind = operationKind((*known)->kind);
        Result<Operation> next = withParameters(model, *kind, **known, parameters);
        if (!next)
            return tl::unexpected(next.error());
        const Step step = changeBetween(**known, *next, parameters);
        return commit(step, setOperation(model.document, *std::move(next)));
    }

    /// Asks in the view for another section of one role, or one more of a list.
    Result<void> choose(const CommandParameters &parameters, double time) const
    {
        const Result<OperationPointer> known = named(parameters);
        if (!known)
            return tl::unexpected(known.error());
        const OperationKind *kind = operationKind((*known)->kind);
        const std::string *role = textOf(parameters, "role");
        if (!kind || !role || !kind->input(*role))
            return failure(ErrorCode::BadValue, "role",
                           {role ? *role : std::string(), "what the operation asks for"});
        m_interaction.pickUp(std::make_unique<OperationTool>(*kind, **known, *role), time);
        return {};
    }

    Result<void> turn(const CommandParameters &parameters, double) const
    {
        const Result<OperationPointer> known = named(parameters);
        if (!known)
            return tl::unexpected(known.error());
        Operation next = **known;
        next.isOn = switched(parameters, next.isOn);
        const Step step{next.isOn ? kSwitchOnOperation : kSwitchOffOperation, {Named{next.name}}};
        return commit(step, setOperation(m_session.committed().document, std::move(next)));
    }

    Result<void> move(const CommandParameters &parameters, double) const
    {
        const Result<OperationPointer> known = named(parameters);
        if (!known)
            return tl::unexpected(known.error());
        const Result<double> to = numberOf(parameters, "to", 1.0);
        if (!to)
            return tl::unexpected(to.error());
        return moveTo(**known, static_cast<int>(*to) - 1);
    }

    /// One place up (−1) or down.
    Result<void> step(const CommandParameters &parameters, int by) const
    {
        const Result<OperationPointer> known = named(parameters);
        if (!known)
            return tl::unexpected(known.error());
        const auto &all = m_session.committed().document.operations;
        const auto at = static_cast<int>(std::find(all.begin(), all.end(), *known) - all.begin());
        return moveTo(**known, std::clamp(at + by, 0, static_cast<int>(all.size()) - 1));
    }
    Result<void> stepUp(const CommandParameters &parameters, double) const
    {
        return step(parameters, -1);
    }
    Result<void> stepDown(const CommandParameters &parameters, double) const
    {
        return step(parameters, 1);
    }

    Result<void> remove(const CommandParameters &parameters, double) const
    {
        const Result<OperationPointer> known = named(parameters);
        if (!known)
            return tl::unexpected(known.error());
        return commit({kDeleteOperation, {Named{(*known)->name}}},
                      removeOperation(m_session.committed().document, (*known)->id));
    }

    Result<void> bake(const CommandParameters &parameters, double) const
    {
        const Result<OperationPointer> known = named(parameters);
        if (!known)
            return tl::unexpected(known.error());
        return commit({kBakeOperation, {Named{(*known)->name}}},
                      baked(m_session.committed(), (*known)->id));
    }

    Result<void> exclude(const CommandParameters &parameters, double) const
    {
        const Model &model = m_session.committed();
        const Result<SectionRef> instance = instanceOf(parameters);
        if (!instance)
            return tl::unexpected(instance.error());
        const std::string *state = textOf(parameters, "state");
        const std::string wanted = state ? *state : "hidden";
        const Named name{model.nameOf(*instance)};
        if (wanted == "detached") {
            const Result<void> done = commit({kDetachInstance, {name}}, detached(model, *instance));
            if (done) // what it became
                m_interaction.select({m_session.committed().document.sections.back()->id});
            return done;
        }
        if (wanted != "hidden" && wanted != "made")
            return failure(ErrorCode::BadValue, "state", {wanted, "hidden, detached, made"});
        const bool isHidden = wanted == "hidden";
        const bool wasSelected = m_interaction.selection() == std::vector{*instance};
        const Result<void> done =
            commit({isHidden ? steps::kHideInstance.one : steps::kShowInstance, {name}},
                   setExceptionState(model.document, *instance,
                                     isHidden ? Exception::State::Hidden : Exception::State::Made));
        if (done && isHidden && wasSelected) // where it can be had back
            m_interaction.selectOperation(instance->operation);
        return done;
    }

    /// A mirror's copies, drawn at once: one step, and no operation stays.
    Result<void> makeSymmetric(const CommandParameters &parameters, double time) const
    {
        const Model &model = m_session.committed();
        const OperationKind &kind = *operationKind("mirror");
        Result<Operation> mirror = withParameters(model, kind, newOperation(kind), parameters);
        if (!mirror)
            return tl::unexpected(mirror.error());
        m_interaction.carryOut(madeSymmetric(model, *std::move(mirror)), time);
        return {};
    }

private:
    Result<OperationPointer> named(const CommandParameters &parameters) const
    {
        return operationNamed(m_session.committed(), parameters, m_interaction.operationInFocus());
    }

    /// By its name, else the selected one.
    Result<SectionRef> instanceOf(const CommandParameters &parameters) const
    {
        if (const std::string *name = textOf(parameters, "section"))
            return instanceNamed(m_session.committed(), *name);
        for (const SectionRef &ref : m_interaction.selection())
            if (!ref.drawn.isValid())
                return ref;
        return failure(ErrorCode::BadValue, "section", {"", "one that an operation made"});
    }

    Result<void> moveTo(const Operation &operation, int index) const
    {
        return commit({steps::kMoveOperation, {Named{operation.name}}},
                      moveOperation(m_session.committed().document, operation.id, index));
    }

    Result<void> commit(const Step &step, Result<Document> next) const
    {
        if (!next)
            return tl::unexpected(next.error());
        m_session.commit(messageText(step.words), *std::move(next));
        return {};
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

std::string freeOperationName(const Document &document, const Operation &operation)
{
    const OperationKind *kind = operationKind(operation.kind);
    const OperationInput *input = firstInput(operation);
    std::string base = kindName(operation).toStdString();
    if (input && kind && kind->calls)
        base = operationText(kind->calls(operation))
                   .arg(QString::fromStdString(input->name))
                   .toStdString();
    else if (input)
        base.append(" ").append(input->name);
    for (int number = 1;; ++number) {
        std::string name = base;
        if (!input)
            name.append(" ").append(std::to_string(number));
        else if (number > 1)
            name.append(" (").append(std::to_string(number)).append(")");
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
        const std::string id = std::string("operation.").append(kind->key);
        const CommandRule rule =
            kind->isOfTemplate
                ? needs([&session] { return !session.committed().document.templates.empty(); },
                        FFF_TEXT("Command", "There is no mesh to slice: add one first"))
                : CommandRule(); // it asks for what it needs
        registry.add(id, {[commands, kind](const CommandParameters &parameters, double time) {
                              return commands.add(*kind, parameters, time);
                          },
                          rule, inHand(interaction, id)});
    }
    registry.add("operation.symmetric",
                 {[commands](const CommandParameters &parameters, double time) {
                      return commands.makeSymmetric(parameters, time);
                  },
                  needsSections(session)});
    using Work = Result<void> (OperationCommands::*)(const CommandParameters &, double) const;
    const CommandRule one = needsOperation(interaction);
    const auto besides = [one, &session, &interaction](bool isFirst, Text reason) -> CommandRule {
        return [=, &session, &interaction](const CommandParameters &parameters) {
            const WhyNot none = one(parameters);
            if (none || parameters.contains("operation"))
                return none;
            const auto &all = session.committed().document.operations;
            const Operation &end = isFirst ? *all.front() : *all.back();
            return end.id == interaction.operationInFocus() ? WhyNot(reason) : WhyNot();
        };
    };
    struct Row
    {
        const char *id;
        Work work;
        CommandRule rule;
    };
    const Row rows[] = {
        {"operation.change", &OperationCommands::change, {}},
        {"operation.choose", &OperationCommands::choose, {}},
        {"operation.switch", &OperationCommands::turn, one},
        {"operation.move", &OperationCommands::move, {}},
        {"operation.moveUp", &OperationCommands::stepUp,
         besides(true, FFF_TEXT("Command", "It is the first one"))},
        {"operation.moveDown", &OperationCommands::stepDown,
         besides(false, FFF_TEXT("Command", "It is the last one"))},
        {"operation.delete", &OperationCommands::remove, {}},
        {"operation.bake", &OperationCommands::bake, one},
        {"operation.exclude", &OperationCommands::exclude, {}},
    };
    for (const Row &row : rows) {
        const Work work = row.work;
        registry.add(row.id, {[commands, work](const CommandParameters &parameters, double time) {
                                  return (commands.*work)(parameters, time);
                              },
                              row.rule});
    }
    registry.offer(kOperationWords);
}

} // namespace fff
