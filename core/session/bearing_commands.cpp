#include "core/session/bearing_commands.h"

#include "core/analysis/asked_bearing.h"
#include "core/session/command_rules.h"
#include "core/session/scheduler.h"

namespace fff {

namespace {

constexpr CommandWords kBearingWords[] = {
    {"physics.whereStrong", FFF_TEXT("Command", "Stren&gth map"),
     FFF_TEXT("Command", "Strength map"), "", "stress",
     FFF_TEXT("Command", "Colour a section by the mass that each place of it can hold"), true},
};
constexpr Text kSelectToAsk = FFF_TEXT("Command", "Select the section to look at first");

/// The one section that is selected.
std::optional<SectionRef> sectionToAsk(const Interaction &interaction)
{
    const std::vector<SectionRef> sections = interaction.sectionsInFocus();
    return sections.size() == 1 ? std::optional(sections.front()) : std::nullopt;
}

} // namespace

void registerBearingCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const auto isOn = [&session] { return session.scheduler().questions().bearing.has_value(); };
    registry.add(
        "physics.whereStrong",
        {[&session, &interaction, isOn](const CommandParameters &parameters,
                                        double) -> Result<void> {
             Scheduler &scheduler = session.scheduler();
             Questions questions = scheduler.questions();
             const std::optional<SectionRef> section = sectionToAsk(interaction);
             // Of another one it is asked anew.
             const bool isSame = !section || section == questions.bearing;
             const bool on =
                 parameters.contains("on") ? switched(parameters, isOn()) : !(isOn() && isSame);
             if (on && !isSame)
                 questions.bearing = section;
             else if (!on)
                 questions.bearing.reset();
             scheduler.want(kBearing.name);
             scheduler.ask(questions);
             return {};
         },
         needs([&interaction, isOn] { return isOn() || sectionToAsk(interaction); }, kSelectToAsk),
         isOn});
    registry.offer(kBearingWords);
}

} // namespace fff
