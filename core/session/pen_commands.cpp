#include "core/session/pen_commands.h"

#include "core/base/units.h"
#include "core/interaction/pen_tool.h"
#include "core/session/command_rules.h"

#include <array>
#include <memory>

namespace fff {

namespace {

constexpr CommandWords kPenWords[] = {
    {"section.snap", FFF_TEXT("Command", "S&nap"), FFF_TEXT("Command", "Snap"), "Q", "snap",
     FFF_TEXT("Command", "Snap to points, alignment lines and grid"), true},
    {"section.pen", FFF_TEXT("Command", "P&en"), FFF_TEXT("Command", "Pen"), "P", "pen",
     FFF_TEXT("Command", "Draw with clicks instead of one stroke: set points, drag to bend"), true},
};

bool holdsPen(const Interaction &interaction)
{
    return interaction.tool() && interaction.tool()->command() == PenTool::kCommand;
}

/// In the order in which they build on each other: a direction needs a length.
struct Parameter
{
    const char *name;
    ToolNumber::Kind kind;
};
constexpr std::array<Parameter, 6> kParameters{{{"x", ToolNumber::Kind::X},
                                                {"y", ToolNumber::Kind::Y},
                                                {"dx", ToolNumber::Kind::DeltaX},
                                                {"dy", ToolNumber::Kind::DeltaY},
                                                {"length", ToolNumber::Kind::Length},
                                                {"angle", ToolNumber::Kind::Angle}}};

Result<void> setPoint(Interaction &interaction, const CommandParameters &parameters, double time)
{
    std::vector<ToolNumber> numbers;
    for (const Parameter &parameter : kParameters) {
        if (parameters.count(parameter.name) == 0)
            continue;
        const Result<double> value = numberOf(parameters, parameter.name, 0.0);
        if (!value)
            return tl::unexpected(value.error());
        const bool isAngle = parameter.kind == ToolNumber::Kind::Angle;
        numbers.push_back({parameter.kind, isAngle ? radians(*value) : *value});
    }
    if (numbers.empty())
        return failure(ErrorCode::BadValue, "section.penPoint",
                       {"no number", "x and y, dx and dy, or length and angle"});
    interaction.setNumbers(numbers, time);
    interaction.key(ToolKey::Enter, time);
    return {};
}

} // namespace

void registerPenCommands(CommandRegistry &registry, Interaction &interaction)
{
    registry.add("section.pen",
                 {[&](const CommandParameters &parameters, double time) -> Result<void> {
                      const bool isHeld = holdsPen(interaction);
                      // The same tool again is laid down.
                      if (switched(parameters, isHeld) != isHeld)
                          interaction.pickUp(std::make_unique<PenTool>(), time);
                      return {};
                  },
                  {},
                  inHand(interaction, "section.pen")});
    registry.add("section.penPoint",
                 {[&](const CommandParameters &parameters, double time) {
                      return setPoint(interaction, parameters, time);
                  },
                  needs([&] { return holdsPen(interaction) && !interaction.numbers().empty(); },
                        FFF_TEXT("Command", "No number is typed"))});
    registry.add("section.snap", {[&](const CommandParameters &parameters, double) -> Result<void> {
                                      bool &snaps = interaction.settings().snaps;
                                      snaps = switched(parameters, snaps);
                                      return {};
                                  },
                                  {},
                                  [&] { return interaction.settings().snaps; }});
    registry.offer(kPenWords);
}

} // namespace fff
