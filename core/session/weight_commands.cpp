#include "core/session/weight_commands.h"

#include "core/interaction/section_edit.h"
#include "core/interaction/weight_tool.h"
#include "core/interaction/weight_words.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

#include <memory>
#include <tuple>

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

    Result<void> set(const CommandParameters &parameters, double time) const
    {
        Result<Weight> weight = weightOf(parameters);
        if (!weight)
            return tl::unexpected(weight.error());
        const Result<double> mass = numberOf(parameters, "mass", weight->mass);
        if (!mass)
            return tl::unexpected(mass.error());
        weight->mass = *mass;
        return carryOut(setWeight(m_session.committed().document, *weight),
                        Step(steps::kSetWeight, {massOf(*mass)}), time);
    }

    Result<void> remove(const CommandParameters &parameters, double time) const
    {
        const Result<Weight> weight = weightOf(parameters);
        if (!weight)
            return tl::unexpected(weight.error());
        return carryOut(removeWeight(m_session.committed().document, weight->id),
                        steps::kRemoveWeight, time);
    }

private:
    Result<Weight> weightOf(const CommandParameters &parameters) const
    {
        const std::vector<Weight> &weights = m_session.committed().document.weights;
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
    registry.offer(kWeightWords);
}

} // namespace fff
