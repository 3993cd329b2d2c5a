#include "core/session/skin_commands.h"

#include "core/analysis/asked_skin.h"
#include "core/session/command_rules.h"
#include "core/session/scheduler.h"

namespace fff {

namespace {

constexpr CommandWords kSkinWords[] = {
    {"view.skin", FFF_TEXT("Command", "S&kin"), FFF_TEXT("Command", "Skin"), "", "skin",
     FFF_TEXT("Command", "Show the form that the sections suggest, as a surface over them"), true},
};

} // namespace

void registerSkinCommands(CommandRegistry &registry, Session &session)
{
    const auto isOn = [&session] { return session.scheduler().questions().skin; };
    registry.add(
        "view.skin",
        {[&session, isOn](const CommandParameters &parameters, double) -> Result<void> {
             Scheduler &scheduler = session.scheduler();
             Questions questions = scheduler.questions();
             questions.skin = switched(parameters, isOn());
             scheduler.want(kSkin.name);
             scheduler.ask(questions);
             return {};
         },
         needs([&session, isOn] { return isOn() || session.committed().sectionCount() > 0; },
               kNothingThere),
         isOn});
    registry.offer(kSkinWords);
}

} // namespace fff
