#include "core/session/measure_commands.h"

#include "core/interaction/measure_tool.h"
#include "core/interaction/measure_words.h"
#include "core/interaction/section_edit.h"
#include "core/model/edit_words.h"
#include "core/model/named_numbers.h"
#include "core/operations/scaled_model.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

#include <cmath>
#include <memory>

namespace fff {

namespace {

constexpr CommandWords kMeasureWords[] = {
    {"measure.ruler", FFF_TEXT("Command", "M&easure"), FFF_TEXT("Command", "Measure"), "M",
     "measure",
     FFF_TEXT("Command", "Measure between two places; keep the length, or scale the model to it"),
     true},
    {"measure.dimension", FFF_TEXT("Command", "Scale to a &length"),
     FFF_TEXT("Command", "Scale to a length"), "D", "dimension",
     FFF_TEXT("Command", "Set a length and scale the model to match"), true},
    {"measure.keep", FFF_TEXT("Command", "Keep t&he length"), FFF_TEXT("Command", "Keep"), "",
     "keep", FFF_TEXT("Command", "Keep showing this length")},
    {"measure.remove", FFF_TEXT("Command", "Rem&ove this dimension"), FFF_TEXT("Command", "Remove"),
     "", "trash", FFF_TEXT("Command", "Remove this dimension")},
};

//: %1 is the name of a number
constexpr Text kDeleteNumber = FFF_TEXT("Step", "Delete %1");

class MeasureCommands
{
public:
    MeasureCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> keep(double time) const
    {
        const auto line = tool()->line();
        carryOut(addDimension(document(), line->from, line->to), FFF_TEXT("Step", "Keep dimension"),
                 time);
        return {};
    }

    Result<void> remove(const CommandParameters &parameters, double time) const
    {
        DimensionId id = tool() ? tool()->dimension() : DimensionId();
        if (parameters.contains("dimension")) {
            const Result<Dimension> dimension = dimensionOf(parameters);
            if (!dimension)
                return tl::unexpected(dimension.error());
            id = dimension->id;
        }
        if (!id.isValid())
            return failure(ErrorCode::BadValue, "dimension", {"", "the number of a dimension"});
        carryOut(removeDimension(document(), id), FFF_TEXT("Step", "Delete dimension"), time);
        return {};
    }

    Result<void> scale(const CommandParameters &parameters, double time) const
    {
        Result<double> factor = numberOf(parameters, "factor", 1.0);
        if (!factor)
            return tl::unexpected(factor.error());
        if (parameters.contains("dimension")) {
            const Result<double> length = numberOf(parameters, "length", 0.0);
            if (!length)
                return tl::unexpected(length.error());
            const Result<Dimension> dimension = dimensionOf(parameters);
            if (!dimension)
                return tl::unexpected(dimension.error());
            const auto from = placeOf(m_session.committed(), dimension->from);
            const auto to = placeOf(m_session.committed(), dimension->to);
            const double now = from && to ? (*to - *from).norm() : 0.0;
            if (!(now > 0.0))
                return failure(ErrorCode::BadValue, "dimension",
                               {"0 mm", "a dimension with a length"});
            factor = *length / now;
        }
        if (!(std::isfinite(*factor) && *factor > 0.0))
            return failure(ErrorCode::BadValue, "factor", {"", "a number above 0"});
        Result<Document> next = scaledModel(document(), *factor);
        if (!next) {
            m_interaction.say(notScaled(next.error()), time);
            return {};
        }
        carryOut(std::move(next), scaledBy(*factor), time);
        return {};
    }

    Result<void> setNumber(const CommandParameters &parameters, double time) const
    {
        const std::string *name = textOf(parameters, "name");
        const Result<double> value = numberOf(parameters, "value", 0.0);
        if (!name)
            return failure(ErrorCode::BadValue, "name", {"", "a name"});
        if (!value)
            return tl::unexpected(value.error());
        const std::string *expression = textOf(parameters, "expression");
        const std::string *shown = expression ? expression : textOf(parameters, "value");
        Result<Document> next =
            fff::setNumber(document(), {*name, shown ? *shown : std::to_string(*value), *value});
        if (!next)
            return tl::unexpected(next.error());
        carryOut(std::move(next), {steps::kSetNumber, {Named{*name}}}, time);
        return {};
    }

    Result<void> removeNumber(const CommandParameters &parameters, double time) const
    {
        const std::string *name = textOf(parameters, "name");
        Result<Document> next = fff::removeNumber(document(), name ? *name : std::string());
        if (!next)
            return tl::unexpected(next.error());
        carryOut(std::move(next), {kDeleteNumber, {Named{*name}}}, time);
        return {};
    }

    Result<void> renameNumber(const CommandParameters &parameters, double time) const
    {
        const std::string *name = textOf(parameters, "name"), *to = textOf(parameters, "to");
        Result<Document> next =
            fff::renameNumber(document(), name ? *name : std::string(), to ? *to : std::string());
        if (!next)
            return tl::unexpected(next.error());
        carryOut(std::move(next), {steps::kSetNumber, {Named{*to}}}, time);
        return {};
    }

    const MeasureTool *tool() const
    {
        return dynamic_cast<const MeasureTool *>(m_interaction.tool());
    }
    void pickUp(bool isDimension, double time) const
    {
        // One tool in two ways: the line in the hand stays there.
        const MeasureTool *held = tool();
        m_interaction.pickUp(held ? std::make_unique<MeasureTool>(isDimension, *held)
                                  : std::make_unique<MeasureTool>(isDimension),
                             time);
    }

private:
    const Document &document() const { return m_session.committed().document; }

    void carryOut(Result<Document> next, Step step, double time) const
    {
        SectionEdit edit = tl::unexpected(Hint::refusal(hints::kEditFailed));
        if (next)
            edit = EditedSections{*std::move(next), std::move(step)};
        m_interaction.carryOut(std::move(edit), time);
    }

    Result<Dimension> dimensionOf(const CommandParameters &parameters) const
    {
        const Result<double> index = numberOf(parameters, "dimension", 0.0);
        if (!index)
            return tl::unexpected(index.error());
        if (!(*index >= 0.0 && *index < static_cast<double>(document().dimensions.size())))
            return failure(ErrorCode::BadValue, "dimension",
                           {std::to_string(*index), "the number of a dimension"});
        return document().dimensions[static_cast<std::size_t>(*index)];
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

void registerMeasureCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const MeasureCommands commands(session, interaction);
    const auto addTool = [&](const char *id, bool isDimension) {
        registry.add(
            id, {[commands, isDimension](const CommandParameters &, double time) -> Result<void> {
                     commands.pickUp(isDimension, time);
                     return {};
                 },
                 needsSections(session), inHand(interaction, id)});
    };
    addTool("measure.ruler", false);
    addTool("measure.dimension", true);
    registry.add(
        "measure.keep",
        {[commands](const CommandParameters &, double time) { return commands.keep(time); },
         needs([commands] { return commands.tool() && commands.tool()->line(); },
               FFF_TEXT("Command", "Nothing is measured"))});
    using Run = Result<void> (MeasureCommands::*)(const CommandParameters &, double) const;
    const auto add = [&](const char *id, Run run, CommandRule rule = {}) {
        registry.add(id, {[commands, run](const CommandParameters &parameters, double time) {
                              return (commands.*run)(parameters, time);
                          },
                          std::move(rule)});
    };
    add("measure.remove", &MeasureCommands::remove,
        [commands](const CommandParameters &parameters) -> WhyNot {
            const MeasureTool *tool = commands.tool();
            if (parameters.contains("dimension") || (tool && tool->dimension().isValid()))
                return {};
            return FFF_TEXT("Command", "No dimension is picked: click one with Measure");
        });
    add("measure.scale", &MeasureCommands::scale);
    add("numbers.set", &MeasureCommands::setNumber);
    add("numbers.remove", &MeasureCommands::removeNumber);
    add("numbers.rename", &MeasureCommands::renameNumber);
    registry.offer(kMeasureWords);
}

} // namespace fff
