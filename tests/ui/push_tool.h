// A tool that the program does not have: a push at a place, shown as an arrow with words beside it
// and a handle at its foot. It needs this file and the line that registers it.
#pragma once

#include "core/interaction/tool.h"
#include "core/session/command_rules.h"

#include <memory>

namespace fff::test {

inline const Vec3 kFoot(0.0, 60.0, 0.0);

class PushTool : public Tool
{
public:
    static constexpr Text kHint = FFF_TEXT("Test", "Click where it is pushed.");

    std::string_view command() const override { return "test.push"; }
    GestureReply handle(const PointerEvent &, GestureContext &) override { return {}; }
    GestureReply cancel(GestureContext &) override
    {
        GestureReply reply;
        reply.state = GestureReply::State::Over;
        return reply;
    }
    Hint hint() const override { return kHint; }
    Cursor cursor() const override { return Cursor::Arrow; }
    void mark(GestureContext &context, bool) override
    {
        const Message words{Text{"Test", "%1 sideways"}, {lengthOf(25.0)}};
        context.overlay.held.add(sign::Arrow{SignRole::Slit, kFoot, Vec3::UnitX()});
        context.overlay.held.add(sign::Label{SignRole::Measured, {kFoot}, words, {0.0, 60.0}});
        context.overlay.held.add(sign::Handle{SignRole::Place, kFoot});
    }
};

inline void registerPushTool(CommandRegistry &registry, const Session &session,
                             Interaction &interaction)
{
    static constexpr CommandWords kWords[] = {
        {"test.push", FFF_TEXT("Test", "&Push"), FFF_TEXT("Test", "Push"), "Ctrl+Alt+P", "move_up",
         FFF_TEXT("Test", "Push the model at a place"), false, "Checks"}};
    registry.add("test.push",
                 {[&interaction](const CommandParameters &, double time) -> Result<void> {
                      interaction.pickUp(std::make_unique<PushTool>(), time);
                      return {};
                  },
                  needsSections(session), inHand(interaction, "test.push")});
    registry.offer(kWords);
}

} // namespace fff::test
