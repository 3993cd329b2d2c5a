#include "core/session/magnet_commands.h"

#include "core/interaction/magnet_editing.h"
#include "core/model/magnet_edits.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

namespace fff {

namespace {

Result<void> pull(const CommandParameters &parameters, double time, Session &session,
                  Interaction &interaction)
{
    const Model &model = session.committed();
    const std::vector<SectionRef> sections = interaction.selection();
    const std::string *on = textOf(parameters, "on");
    if (on && *on != "true" && *on != "false")
        return failure(ErrorCode::BadValue, "on", {*on, "true or false"});
    const Result<double> radius = numberOf(
        parameters, "radius", magnetOf(model.document, sections.front()).value_or(kMagnetRadius));
    if (!radius)
        return tl::unexpected(radius.error());
    if (!(*radius >= kLeastMagnet && *radius <= kMostMagnet))
        return failure(ErrorCode::BadValue, "radius",
                       {*textOf(parameters, "radius"), "a length from 0.1 to 1000 mm"});
    const bool isOff = on && *on == "false";
    interaction.carryOut(
        magnetsChanged(model, sections, isOff ? std::nullopt : std::optional(*radius)), time);
    return {};
}

} // namespace

void registerMagnetCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    registry.add(
        "section.pull",
        {[&session, &interaction](const CommandParameters &parameters, double time) {
             return pull(parameters, time, session, interaction);
         },
         needsAmongSelected(
             interaction, [&session] { return canPullTemplates(session.committed().document); },
             FFF_TEXT("Command", "There is no mesh that could be pulled"))});
}

} // namespace fff
