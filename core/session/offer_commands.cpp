#include "core/session/offer_commands.h"

namespace fff {

namespace {

constexpr CommandWords kOfferWords[] = {
    {"section.takeOffer", FFF_TEXT("Command", "Ma&ke it what is offered"),
     FFF_TEXT("Command", "Take the offer"), "B", "figure_draw",
     FFF_TEXT("Command",
              "Make a circle, an ellipse, straight lines or right angles of what was just drawn "
              "nearly so, or move its slit in from the edge"),
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
    registry.offer(kOfferWords);
}

} // namespace fff
