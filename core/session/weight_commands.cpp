#include "core/session/weight_commands.h"

#include "core/interaction/section_edit.h"
#include "core/interaction/weight_editing.h"
#include "core/interaction/weight_tool.h"
#include "core/interaction/weight_words.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

#include <memory>
#include <tuple>
#include <utility>

namespace fff {

namespace {

constexpr CommandWords kWeightWords[] = {
    {"physics.addWeight", FFF_TEXT("Command", "Add &weight"), FFF_TEXT("Command", "Weight"), "W",
     "weight", FFF_TEXT("Command", "Hang a weight on a section, to see what it bears"), true},
};

class WeightCommands
{
public:
    WeightCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> add(const CommandParameters &parameters, double time) const
    {
        const Document &document = m_session.committed().document;
        const std::string *name = textOf(parameters, "section");
        if (!name) { // as heavy as the one that was hung last
            m_interaction.pickUp(std::make_unique<WeightTool>(document.weights.empty()
                                                                  ? Weight().mass
                                                                  : document.weights.back().mass),
                                 time);
            return {};
        }
        const std::optional<SectionRef> ref = sectionNamed(m_session.committed(), *name);
        if (!ref)
            return failure(ErrorCode::BadValue, "section", {*name, "the name of a section"});
        const Section *section = m_session.committed().find(*ref);
        Weight weight;
        weight.section = section->ref();
        const Vec2 middle = section->shape->centroid();
        for (const auto &[key, number, otherwise] :
             {std::tuple("mass", &weight.mass, weight.mass),
              std::tuple("x", &weight.position.x(), middle.x()),
              std::tuple("y", &weight.position.y(), middle.y())}) {
            const Result<double> value = numberOf(parameters, key, otherwise);
            if (!value)
                return tl::unexpected(value.error());
            *number = *value;
        }
        return carryOut(addWeight(document, weight),
                        Step(steps::kAddWeight, {massOf(weight.mass), Named{section->name}}), time);
    }

    /// What is not said stays. One step, whatever is said.
    Result<void> set(const CommandParameters &parameters, double time) const
    {
        Result<Weight> weight = weightOf(parameters);
        if (!weight)
            return tl::unexpected(weight.error());
        for (const auto &[key, number] :
             {std::pair("mass", &weight->mass), std::pair("x", &weight->position.x()),
              std::pair("y", &weight->position.y())}) {
            const Result<double> value = numberOf(parameters, key, *number);
            if (!value)
                return tl::unexpected(value.error());
            *number = *value;
        }
        if (const std::string *name = textOf(parameters, "name"))
            weight->name = *name;
        // A number that is none is the script's fault; what is refused is said to the person.
        if (const auto next = setWeight(m_session.committed().document, *weight); !next)
            return tl::unexpected(next.error());
        m_interaction.carryOut(changedWeight(m_session.committed(), *weight), time);
        return {};
    }

    Result<void> remove(const CommandParameters &parameters, double time) const
    {
        const Result<Weight> weight = weightOf(parameters);
        if (!weight)
            return tl::unexpected(weight.error());
        m_interaction.carryOut(removedWeight(m_session.committed(), weight->id), time);
        return {};
    }

    Result<void> select(const CommandParameters &parameters, double) const
    {
        const Result<Weight> weight = weightOf(parameters);
        if (!weight)
            return tl::unexpected(weight.error());
        m_interaction.selectWeight(weight->id);
        return {};
    }

    Result<void> heavier(const CommandParameters &parameters, double time) const
    {
        return addMass(1.0, parameters, time);
    }
    Result<void> lighter(const CommandParameters &parameters, double time) const
    {
        return addMass(-1.0, parameters, time);
    }

private:
    Result<void> addMass(double sign, const CommandParameters &parameters, double time) const
    {
        const Result<Weight> weight = weightOf(parameters);
        if (!weight)
            return tl::unexpected(weight.error());
        const Result<double> mass = numberOf(parameters, "mass", kMassStep);
        if (!mass)
            return tl::unexpected(mass.error());
        m_interaction.carryOut(withMassAdded(m_session.committed(), weight->id, sign * *mass),
                               time);
        return {};
    }

    /// The one that is meant, or without a number the selected one, else the first.
    Result<Weight> weightOf(const CommandParameters &parameters) const
    {
        const Document &document = m_session.committed().document;
        if (const Weight *selected = document.find(m_interaction.selectedWeight());
            selected && !parameters.contains("weight"))
            return *selected;
        const std::vector<Weight> &weights = document.weights;
        const Result<double> index = numberOf(parameters, "weight", 0.0);
        if (!index)
            return tl::unexpected(index.error());
        if (!(*index >= 0.0 && *index < static_cast<double>(weights.size())))
            return failure(ErrorCode::BadValue, "weight",
                           {std::to_string(*index), "the number of a weight"});
        return weights[static_cast<std::size_t>(*index)];
    }

    Result<void> carryOut(Result<Document> next, Step step, double time) const
    {
        if (!next)
            return tl::unexpected(next.error());
        m_interaction.carryOut(EditedSections{*std::move(next), std::move(step)}, time);
        return {};
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

void registerWeightCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const WeightCommands commands(session, interaction);
    using Run = Result<void> (WeightCommands::*)(const CommandParameters &, double) const;
    const auto runner = [commands](Run run) {
        return [commands, run](const CommandParameters &parameters, double time) {
            return (commands.*run)(parameters, time);
        };
    };
    registry.add("physics.addWeight", {runner(&WeightCommands::add), needsSections(session),
                                       inHand(interaction, std::string(WeightTool::kCommand))});
    const CommandRule hasWeights =
        needs([&session] { return !session.committed().document.weights.empty(); },
              FFF_TEXT("Command", "There is no weight on the model"));
    registry.add("physics.setWeight", {runner(&WeightCommands::set), hasWeights});
    registry.add("physics.removeWeight", {runner(&WeightCommands::remove), hasWeights});
    registry.add("physics.selectWeight", {runner(&WeightCommands::select), hasWeights});
    registry.add("physics.heavier", {runner(&WeightCommands::heavier), hasWeights});
    registry.add("physics.lighter", {runner(&WeightCommands::lighter), hasWeights});
    registry.offer(kWeightWords);
}

} // namespace fff
