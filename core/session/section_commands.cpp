#include "core/session/section_commands.h"

#include "core/base/units.h"
#include "core/interaction/pick_section_tool.h"
#include "core/interaction/section_editing.h"
#include "core/interaction/section_words.h"
#include "core/interaction/symmetry_editing.h"
#include "core/interaction/transform_tool.h"
#include "core/model/edit_words.h"
#include "core/model/holds_to_names.h"
#include "core/model/origin.h"
#include "core/model/symmetric_section.h"
#include "core/model/value_names.h"
#include "core/operations/evaluate.h"
#include "core/operations/operation_kind.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

#include <algorithm>
#include <memory>

namespace fff {

namespace {

constexpr CommandWords kSectionWords[] = {
    {"section.transform", FFF_TEXT("Command", "Move &and turn"), FFF_TEXT("Command", "Move"), "T",
     "transform", FFF_TEXT("Command", "Move, turn and scale with handles or numbers"), true},
    {"transform.inSpace", FFF_TEXT("Command", "&Along world axes"),
     FFF_TEXT("Command", "World axes"), "", "in_space",
     FFF_TEXT("Command", "Move along the world's axes, not in the plane of the section")},
    {"transform.withChildren", FFF_TEXT("Command", "&Move attached sections"),
     FFF_TEXT("Command", "Move attached"), "", "with_children",
     FFF_TEXT("Command", "Sections that were drawn on this one move with it")},
    {"section.putOn", FFF_TEXT("Command", "&Put on another section…"),
     FFF_TEXT("Command", "Put on"), "", "put_on",
     FFF_TEXT("Command", "Click the section to put the selected one on")},
    {"section.free", FFF_TEXT("Command", "&Free from its parent"), FFF_TEXT("Command", "Free"), "",
     "free",
     FFF_TEXT("Command", "Unlink from its parent: it no longer moves with it or keeps its angle")},
    {"section.makeOrthogonal", FFF_TEXT("Command", "Ma&ke orthogonal"),
     FFF_TEXT("Command", "Orthogonal"), "", "orthogonal",
     FFF_TEXT("Command", "Turn the section square to the one it is on")},
    {"section.snapNormal", FFF_TEXT("Command", "Align to nearest a&xis"),
     FFF_TEXT("Command", "Align"), "", "align",
     FFF_TEXT("Command", "Turn the section so that it faces along a world axis")},
    {"section.lock", FFF_TEXT("Command", "Lo&ck"), FFF_TEXT("Command", "Lock"), "", "lock",
     FFF_TEXT("Command", "Protect the selected sections from changes")},
    {"operation.editSource", FFF_TEXT("Command", "Edit &its source"),
     FFF_TEXT("Command", "Edit source"), "", "section",
     FFF_TEXT("Command", "Select the section that the selected one is made from")},
    {"operation.detach", FFF_TEXT("Command", "Deta&ch this one"), FFF_TEXT("Command", "Detach"), "",
     "detach",
     FFF_TEXT("Command",
              "Turn the selected section into a drawn one; its operation still makes the others")},
    {"operation.leaveOut", FFF_TEXT("Command", "Lea&ve this one out"),
     FFF_TEXT("Command", "Leave out"), "", "hide",
     FFF_TEXT("Command", "Leave the selected section out; its operation still makes the others")},
};

class SectionCommands
{
public:
    SectionCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> transform(const CommandParameters &, double time) const
    {
        m_interaction.pickUp(std::make_unique<TransformTool>(), time);
        return {};
    }

    Result<void> move(const CommandParameters &parameters, double time) const
    {
        const bool isOwn =
            parameters.contains("right") || parameters.contains("up") || parameters.contains("out");
        const Gizmo gizmo = gizmoNow(!isOwn);
        Transform transform = about(gizmo);
        const char *names[] = {"x", "y", "z"}, *owns[] = {"right", "up", "out"};
        for (int axis : {0, 1, 2}) {
            const Result<double> way = numberOf(parameters, (isOwn ? owns : names)[axis], 0.0);
            if (!way)
                return tl::unexpected(way.error());
            transform.way += *way * gizmo.axis(axis);
        }
        return carryOut(transform, gizmo, parameters, time);
    }

    Result<void> turn(const CommandParameters &parameters, double time) const
    {
        const std::string *axis = textOf(parameters, "axis");
        const std::string wanted = axis ? *axis : "normal";
        const std::size_t index = std::string("xyz").find(wanted);
        const bool isOwn = wanted == "normal";
        if (!isOwn && (wanted.size() != 1 || index == std::string::npos))
            return failure(ErrorCode::BadValue, "axis", {wanted, "x, y, z or normal"});
        const Result<double> angle = numberOf(parameters, "angle", 0.0);
        if (!angle)
            return tl::unexpected(angle.error());
        const Gizmo gizmo = gizmoNow(!isOwn);
        Transform transform = about(gizmo);
        transform.axis = gizmo.axis(isOwn ? 2 : static_cast<int>(index));
        transform.angle = radians(*angle);
        return carryOut(transform, gizmo, parameters, time);
    }

    Result<void> scale(const CommandParameters &parameters, double time) const
    {
        const Result<double> factor = numberOf(parameters, "factor", 1.0);
        const Result<double> x = numberOf(parameters, "x", 1.0), y = numberOf(parameters, "y", 1.0);
        for (const auto *number : {&factor, &x, &y})
            if (!*number)
                return tl::unexpected(number->error());
        if (!(*factor > 0.0 && *x > 0.0 && *y > 0.0))
            return failure(ErrorCode::BadValue, "factor", {"", "a number above 0"});
        const bool isOwn = parameters.contains("x") || parameters.contains("y");
        const Gizmo gizmo = gizmoNow(!isOwn);
        Transform transform = about(gizmo);
        transform.factor = *factor;
        transform.stretch = {*x, *y};
        return carryOut(transform, gizmo, parameters, time);
    }

    /// What is not said stays. One step, whatever is said.
    Result<void> place(const CommandParameters &parameters, double time) const
    {
        const Result<double> angle = numberOf(parameters, "angle", 90.0);
        if (!angle)
            return tl::unexpected(angle.error());
        Model now = model();
        SectionEdit edit = tl::unexpected(Hint::refusal(hints::kEditFailed));
        const auto go = [&](SectionEdit next) {
            edit = std::move(next);
            if (edit)
                now = evaluate(edit->document, now);
            return edit.has_value();
        };
        const std::vector<SectionRef> moved = sections();
        bool goesOn = !parameters.contains("angle") ||
                      go(withAngle(now, moved, radians(*angle), takesChildren()));
        const char *names[] = {"x", "y", "z"};
        for (int axis : {0, 1, 2}) {
            const Result<double> value = numberOf(parameters, names[axis], 0.0);
            if (!value)
                return tl::unexpected(value.error());
            if (goesOn && parameters.contains(names[axis]))
                goesOn = go(withPosition(now, moved, axis, *value, takesChildren()));
        }
        m_interaction.carryOut(std::move(edit), time);
        return {};
    }

    Result<void> free(const CommandParameters &parameters, double time) const
    {
        m_interaction.carryOut(freed(model(), sections(), switched(parameters, isFree())), time);
        return {};
    }
    Result<void> holdTo(const CommandParameters &parameters, double time) const
    {
        const std::string *end = textOf(parameters, "end");
        const std::optional<HoldsTo> wanted = end ? namedIn(kHoldsToNames, *end) : std::nullopt;
        if (!wanted)
            return failure(ErrorCode::BadValue, "end",
                           {end ? *end : std::string(), "proportion, left, right, bottom or top"});
        m_interaction.carryOut(heldTo(model(), sections(), *wanted), time);
        return {};
    }
    Result<void> lock(const CommandParameters &parameters, double time) const
    {
        m_interaction.carryOut(locked(model(), sections(), switched(parameters, isLocked())), time);
        return {};
    }
    Result<void> keepSymmetric(const CommandParameters &parameters, double time) const
    {
        m_interaction.carryOut(
            keptSymmetric(model(), sections(), switched(parameters, isSymmetric())), time);
        return {};
    }
    Result<void> makeOrthogonal(const CommandParameters &, double time) const
    {
        m_interaction.carryOut(fff::madeOrthogonal(model(), sections(), takesChildren()), time);
        return {};
    }
    Result<void> snapNormal(const CommandParameters &, double time) const
    {
        m_interaction.carryOut(alignedToAxis(model(), sections(), takesChildren()), time);
        return {};
    }

    Result<void> putOn(const CommandParameters &parameters, double time) const
    {
        const SectionRef section = sections().front();
        const std::string *on = textOf(parameters, "on");
        if (!on) {
            const Hint hint{hints::kPickParent, {Named{model().nameOf(section)}}};
            m_interaction.pickUp(std::make_unique<PickSectionTool>(
                                     "section.putOn", hint,
                                     [section](const Model &model, const SectionRef &picked) {
                                         return fff::putOn(model, section, picked);
                                     }),
                                 time);
            return {};
        }
        SectionRef parent;
        for (const SectionPointer &known : model().sections())
            if (known->name == *on && !on->empty())
                parent = known->ref();
        if (!on->empty() && parent == SectionRef())
            return failure(ErrorCode::BadValue, "on", {*on, "the name of a section"});
        m_interaction.carryOut(fff::putOn(model(), section, parent), time);
        return {};
    }

    /// Drawn ones, or those that operations above made.
    Result<void> editSource(const CommandParameters &, double) const
    {
        std::vector<SectionRef> sources;
        const auto add = [&](const Operation *operation) {
            const OperationInput *input = operation ? firstInput(*operation) : nullptr;
            if (input && model().find(input->section) &&
                std::find(sources.begin(), sources.end(), input->section) == sources.end())
                sources.push_back(input->section);
        };
        if (m_interaction.selectedOperation().isValid())
            add(model().document.find(m_interaction.selectedOperation()));
        else
            for (const SectionRef &ref : m_interaction.selection())
                add(model().document.find(ref.operation));
        if (!sources.empty())
            m_interaction.select(std::move(sources));
        return {};
    }

    bool hasDrawn() const
    {
        const std::vector<SectionRef> all = sections();
        return std::any_of(all.begin(), all.end(), [this](const SectionRef &ref) {
            return originOf(model(), ref).has_value();
        });
    }
    bool isOnSome() const
    {
        const std::vector<SectionRef> all = sections();
        return std::any_of(all.begin(), all.end(), [this](const SectionRef &ref) {
            return model().find(ref)->parent.has_value();
        });
    }
    bool hasMade() const
    {
        const std::vector<SectionRef> all = sections();
        return std::any_of(all.begin(), all.end(),
                           [](const SectionRef &ref) { return ref.operation.isValid(); });
    }
    /// Of all that are on something.
    bool isFree() const
    {
        const std::vector<SectionRef> all = sections();
        return !all.empty() && std::all_of(all.begin(), all.end(), [this](const SectionRef &ref) {
            const auto &parent = model().find(ref)->parent;
            return parent && parent->isFree;
        });
    }
    bool isLocked() const
    {
        const std::vector<SectionRef> all = sections();
        return !all.empty() && std::all_of(all.begin(), all.end(), [this](const SectionRef &ref) {
            const auto origin = originOf(model(), ref);
            return origin && origin->section->isLocked;
        });
    }
    bool isSymmetric() const
    {
        const std::vector<SectionRef> all = sections();
        return !all.empty() && std::all_of(all.begin(), all.end(), [this](const SectionRef &ref) {
            return symmetryOf(*model().find(ref)) != nullptr;
        });
    }
    bool canBeSymmetric() const
    {
        const std::vector<SectionRef> all = sections();
        return std::any_of(all.begin(), all.end(), [this](const SectionRef &ref) {
            return symmetryAxis(*model().find(ref), model().document).has_value();
        });
    }

private:
    const Model &model() const { return m_session.committed(); }
    std::vector<SectionRef> sections() const { return m_interaction.sectionsInFocus(); }
    bool takesChildren() const { return m_interaction.settings().takesChildren; }
    /// As the tool would show it; with one that cannot be edited, the world's.
    Gizmo gizmoNow(bool isInSpace) const
    {
        return gizmoOf(model(), sections(), isInSpace, m_interaction.targetCamera().orientation);
    }
    static Transform about(const Gizmo &gizmo)
    {
        Transform transform;
        transform.pivot = gizmo.frame.origin;
        return transform;
    }

    Result<void> carryOut(const Transform &transform, const Gizmo &gizmo,
                          const CommandParameters &parameters, double time) const
    {
        const Result<double> wanted = numberOf(parameters, "copies", 0.0);
        if (!wanted)
            return tl::unexpected(wanted.error());
        const int copies = static_cast<int>(std::clamp(*wanted, 0.0, kMostCopies));
        m_interaction.carryOut(
            copies > 0 ? transformedCopies(copied(model(), sections(), copies), model(), sections(),
                                           transform)
                       : transformed(model(), sections(), transform, gizmo.frame, takesChildren()),
            time);
        return {};
    }

    Session &m_session;
    Interaction &m_interaction;
};

void registerSwitch(CommandRegistry &registry, Interaction &interaction, const char *id,
                    bool InteractionSettings::*field)
{
    registry.add(id, {[&interaction, field](const CommandParameters &parameters,
                                            double time) -> Result<void> {
                          bool &is = interaction.settings().*field;
                          is = switched(parameters, is);
                          interaction.advance(time); // a tool in the hand follows
                          return {};
                      },
                      {},
                      [&interaction, field] { return interaction.settings().*field; }});
}

} // namespace

void registerSectionCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const SectionCommands commands(session, interaction);
    using Commands = SectionCommands;
    struct Row
    {
        const char *id;
        Result<void> (Commands::*run)(const CommandParameters &, double) const;
        CommandRule rule;
        std::function<std::optional<bool>()> isOn = {};
    };
    const CommandRule selected = needsSelection(interaction);
    const CommandRule onSome = needsAmongSelected(
        interaction, [commands] { return commands.isOnSome(); },
        FFF_TEXT("Command", "The selection is not on another section"));
    const CommandRule drawn = needsAmongSelected(
        interaction, [commands] { return commands.hasDrawn(); },
        FFF_TEXT("Command", "The selection is made by an operation"));
    const CommandRule symmetric = needsAmongSelected(
        interaction, [commands] { return commands.canBeSymmetric(); },
        FFF_TEXT("Command", "The selection is not symmetric"));
    const CommandRule made = needsAmongSelected(
        interaction, [commands] { return commands.hasMade(); },
        FFF_TEXT("Command", "The selection is drawn, not made by an operation"));
    const Row rows[] = {
        {"section.transform", &Commands::transform, needsSections(session),
         inHand(interaction, "section.transform")},
        {"section.move", &Commands::move, selected},
        {"section.turn", &Commands::turn, selected},
        {"section.scale", &Commands::scale, selected},
        {"section.place", &Commands::place, selected},
        {"section.free", &Commands::free, onSome, [commands] { return commands.isFree(); }},
        {"section.holdTo", &Commands::holdTo, onSome},
        {"section.lock", &Commands::lock, drawn, [commands] { return commands.isLocked(); }},
        {"section.symmetric", &Commands::keepSymmetric, symmetric,
         [commands] { return commands.isSymmetric(); }},
        {"section.makeOrthogonal", &Commands::makeOrthogonal, onSome},
        {"section.snapNormal", &Commands::snapNormal, drawn},
        {"section.putOn", &Commands::putOn,
         needsAnother(session, needsOneSection(interaction, "section.putOn")),
         inHand(interaction, "section.putOn")},
        {"operation.editSource", &Commands::editSource, made},
    };
    for (const Row &row : rows) {
        const auto run = row.run;
        registry.add(row.id, {[commands, run](const CommandParameters &parameters, double time) {
                                  return (commands.*run)(parameters, time);
                              },
                              row.rule, row.isOn});
    }
    registry.add("operation.detach",
                 {[&registry](const CommandParameters &, double time) {
                      return registry.run("operation.exclude", {{"state", "detached"}}, time);
                  },
                  made});
    registry.add("operation.leaveOut",
                 {[&registry](const CommandParameters &, double time) {
                      return registry.run("operation.exclude", {{"state", "hidden"}}, time);
                  },
                  made});
    registerSwitch(registry, interaction, "transform.inSpace", &InteractionSettings::movesInSpace);
    registerSwitch(registry, interaction, "transform.withChildren",
                   &InteractionSettings::takesChildren);
    registry.offer(kSectionWords);
}

} // namespace fff
