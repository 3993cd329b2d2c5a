#include "core/session/mark_commands.h"

#include "core/base/units.h"
#include "core/interaction/mark_editing.h"
#include "core/interaction/mark_tool.h"
#include "core/model/origin.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

#include <memory>

namespace fff {

namespace {

constexpr CommandWords kMarkWords[] = {
    {"section.mark", FFF_TEXT("Command", "Add te&xt or lines to engrave"),
     FFF_TEXT("Command", "Engrave"), "E", "engrave",
     FFF_TEXT("Command", "Write or draw on a section, to be engraved or scored"), true},
    {"mark.engrave", FFF_TEXT("Command", "&Engrave"), FFF_TEXT("Command", "Engrave"), "", "engrave",
     FFF_TEXT("Command", "What is drawn next is engraved")},
    {"mark.score", FFF_TEXT("Command", "&Score"), FFF_TEXT("Command", "Score"), "", "score",
     FFF_TEXT("Command", "What is drawn next is scored, to fold or break along")},
};

class MarkCommands
{
public:
    MarkCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> addText(const CommandParameters &parameters, double time) const
    {
        const Section &section = *drawn();
        Lettering lettering;
        lettering.at = section.shape->bounds().center();
        lettering.turn = uprightTurn(section.frame);
        const Result<Lettering> wanted = withNumbers(std::move(lettering), parameters);
        const Result<Mark::Kind> kind =
            kindOf(parameters,
                   m_interaction.settings().scores ? Mark::Kind::Scored : Mark::Kind::Engraved);
        if (!wanted)
            return tl::unexpected(wanted.error());
        if (!kind)
            return tl::unexpected(kind.error());
        m_interaction.carryOut(letteringAdded(model(), selected()->ref(), *wanted, *kind), time);
        return {};
    }

    Result<void> change(const CommandParameters &parameters, double time) const
    {
        const Result<std::size_t> index = indexOf(parameters);
        if (!index)
            return tl::unexpected(index.error());
        const Mark &mark = *drawn()->marks[*index];
        const SectionRef ref = selected()->ref();
        const Result<Mark::Kind> kind = kindOf(parameters, mark.kind);
        if (!kind)
            return tl::unexpected(kind.error());
        if (*kind != mark.kind)
            m_interaction.carryOut(markKindChanged(model(), ref, *index, *kind), time);
        if (!mark.lettering)
            return {};
        const Result<Lettering> wanted = withNumbers(*mark.lettering, parameters);
        if (!wanted)
            return tl::unexpected(wanted.error());
        if (!(*wanted == *mark.lettering))
            m_interaction.carryOut(letteringChanged(model(), ref, *index, *wanted), time);
        return {};
    }

    Result<void> remove(const CommandParameters &parameters, double time) const
    {
        const Result<std::size_t> index = indexOf(parameters);
        if (!index)
            return tl::unexpected(index.error());
        m_interaction.carryOut(markRemoved(model(), selected()->ref(), *index), time);
        return {};
    }

    /// The one section that is selected; null: none, or several, or one of no drawn section.
    const Section *selected() const
    {
        const std::vector<SectionRef> sections = m_interaction.sectionsInFocus();
        return sections.size() == 1 && originOf(model(), sections.front())
                   ? model().find(sections.front())
                   : nullptr;
    }

private:
    const Model &model() const { return m_session.committed(); }
    const Section *drawn() const { return originOf(model(), selected()->ref())->section; }

    Result<std::size_t> indexOf(const CommandParameters &parameters) const
    {
        const Result<double> index = numberOf(parameters, "mark", 0.0);
        if (!index)
            return tl::unexpected(index.error());
        if (!(*index >= 0.0 && *index < static_cast<double>(drawn()->marks.size())))
            return failure(ErrorCode::BadValue, "mark",
                           {std::to_string(*index), "the number of a mark"});
        return static_cast<std::size_t>(*index);
    }

    static Result<Mark::Kind> kindOf(const CommandParameters &parameters, Mark::Kind otherwise)
    {
        const std::string *as = textOf(parameters, "as");
        if (!as)
            return otherwise;
        if (*as != "engraved" && *as != "scored")
            return failure(ErrorCode::BadValue, "as", {*as, "engraved or scored"});
        return *as == "scored" ? Mark::Kind::Scored : Mark::Kind::Engraved;
    }

    /// What is not said stays.
    static Result<Lettering> withNumbers(Lettering lettering, const CommandParameters &parameters)
    {
        if (const std::string *text = textOf(parameters, "text"))
            lettering.text = *text;
        const Result<double> height = numberOf(parameters, "height", lettering.height);
        const Result<double> x = numberOf(parameters, "x", lettering.at.x());
        const Result<double> y = numberOf(parameters, "y", lettering.at.y());
        const Result<double> turn = numberOf(parameters, "turn", degrees(lettering.turn));
        for (const auto *number : {&height, &x, &y, &turn})
            if (!*number)
                return tl::unexpected(number->error());
        lettering.height = *height;
        lettering.at = {*x, *y};
        lettering.turn = radians(*turn);
        return lettering;
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

void registerMarkCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const MarkCommands commands(session, interaction);
    registry.add("section.mark",
                 {[&interaction](const CommandParameters &, double time) -> Result<void> {
                      interaction.pickUp(std::make_unique<MarkTool>(), time);
                      return {};
                  },
                  needsSections(session), inHand(interaction, "section.mark")});
    const auto addKind = [&](const char *id, bool scores) {
        registry.add(id,
                     {[&interaction, scores](const CommandParameters &, double) -> Result<void> {
                          interaction.settings().scores = scores;
                          return {};
                      },
                      {},
                      [&interaction, scores] { return interaction.settings().scores == scores; }});
    };
    addKind("mark.engrave", false);
    addKind("mark.score", true);
    using Run = Result<void> (MarkCommands::*)(const CommandParameters &, double) const;
    const auto add = [&](const char *id, Run run) {
        registry.add(
            id, {[commands, run](const CommandParameters &parameters, double time) {
                     return (commands.*run)(parameters, time);
                 },
                 needs([commands] { return commands.selected() != nullptr; }, kNothingSelected)});
    };
    add("mark.addText", &MarkCommands::addText);
    add("mark.change", &MarkCommands::change);
    add("mark.delete", &MarkCommands::remove);
    registry.offer(kMarkWords);
}

} // namespace fff
