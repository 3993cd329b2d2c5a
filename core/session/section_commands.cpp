#include "core/session/section_commands.h"

#include "core/base/units.h"
#include "core/interaction/pick_section_tool.h"
#include "core/interaction/section_editing.h"
#include "core/interaction/section_words.h"
#include "core/interaction/transform_tool.h"
#include "core/model/edit_words.h"
#include "core/model/origin.h"
#include "core/operations/evaluate.h"
#include "core/operations/operation_kind.h"
#include "core/session/operation_script.h"

#include <algorithm>
#include <memory>

namespace fff {

namespace {

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
    Result<void> lock(const CommandParameters &parameters, double time) const
    {
        m_interaction.carryOut(locked(model(), sections(), switched(parameters, isLocked())), time);
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

    bool hasSections() const { return !sections().empty(); }
    bool hasOneSection() const { return sections().size() == 1; }
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
    bool canTransform() const { return model().sectionCount() > 0 || isHeld("section.transform"); }
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

private:
    const Model &model() const { return m_session.committed(); }
    std::vector<SectionRef> sections() const { return m_interaction.sectionsInFocus(); }
    bool takesChildren() const { return m_interaction.settings().takesChildren; }
    bool isHeld(std::string_view command) const
    {
        return m_interaction.tool() && m_interaction.tool()->command() == command;
    }

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
                      {}});
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
        bool (Commands::*isEnabled)() const;
    };
    const Row rows[] = {
        {"section.transform", &Commands::transform, &Commands::canTransform},
        {"section.move", &Commands::move, &Commands::hasSections},
        {"section.turn", &Commands::turn, &Commands::hasSections},
        {"section.scale", &Commands::scale, &Commands::hasSections},
        {"section.place", &Commands::place, &Commands::hasSections},
        {"section.free", &Commands::free, &Commands::isOnSome},
        {"section.lock", &Commands::lock, &Commands::hasDrawn},
        {"section.makeOrthogonal", &Commands::makeOrthogonal, &Commands::isOnSome},
        {"section.snapNormal", &Commands::snapNormal, &Commands::hasDrawn},
        {"section.putOn", &Commands::putOn, &Commands::hasOneSection},
        {"operation.editSource", &Commands::editSource, &Commands::hasMade},
    };
    for (const Row &row : rows) {
        const auto run = row.run;
        const auto isEnabled = row.isEnabled;
        registry.add(row.id, {[commands, run](const CommandParameters &parameters, double time) {
                                  return (commands.*run)(parameters, time);
                              },
                              [commands, isEnabled] { return (commands.*isEnabled)(); }});
    }
    registry.add("operation.detach",
                 {[&registry](const CommandParameters &, double time) {
                      return registry.run("operation.exclude", {{"state", "detached"}}, time);
                  },
                  [commands] { return commands.hasMade(); }});
    registry.add("operation.leaveOut",
                 {[&registry](const CommandParameters &, double time) {
                      return registry.run("operation.exclude", {{"state", "hidden"}}, time);
                  },
                  [commands] { return commands.hasMade(); }});
    registerSwitch(registry, interaction, "transform.inSpace", &InteractionSettings::movesInSpace);
    registerSwitch(registry, interaction, "transform.withChildren",
                   &InteractionSettings::takesChildren);
}

} // namespace fff
