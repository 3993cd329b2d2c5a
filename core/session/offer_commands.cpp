#include "core/session/offer_commands.h"

namespace fff {

namespace {

constexpr CommandWords kOfferWords[] = {
    {"section.takeOffer", FFF_TEXT("Command", "Ta&ke the offered shape"),
     FFF_TEXT("Command", "Offered shape"), "B", "figure_draw",
     FFF_TEXT("Command", "Turn what was just drawn into the offered circle, ellipse, straight "
                         "lines or right angles, or move its slit in from the edge"),
     true},
    {"section.takeGuide", FFF_TEXT("Command", "&Take the whole guide"),
     FFF_TEXT("Command", "Take the guide"), "Shift+Return", "section",
     FFF_TEXT("Command",
              "Make the section of all that its plane cuts of a template, with its holes"),
     true},
};

} // namespace

void registerOfferCommands(CommandRegistry &registry, Interaction &interaction)
{
    registry.add("section.takeOffer",
                 {[&interaction](const CommandParameters &, double time) -> Result<void> {
                      interaction.takeOffer(time);
                      return {};
                  },
                  needs([&interaction] { return interaction.hasOffer(); },
                        FFF_TEXT("Command", "Nothing is offered for what was just drawn"))});
    registry.add("section.takeGuide",
                 {[&interaction](const CommandParameters &, double time) -> Result<void> {
                      interaction.takeGuide(time);
                      return {};
                  },
                  needs([&interaction] { return interaction.hasGuide(); },
                        FFF_TEXT("Command", "The plane that is drawn on cuts no template"))});
    registry.offer(kOfferWords);
}

} // namespace fff
