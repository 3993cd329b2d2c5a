// Mirrors across a plane. Which one, and what comes of it, is chosen by commands that pick the tool
// up again with another choice; the bar over the view has a button for each. The plane and what
// would come of it are shown meanwhile.
//
//     plane known     Enter does what is shown; drags turn the view
//     of a section    what would come of it is shown over each section; a click does it
//
// Esc lays it down.
#pragma once

#include "core/interaction/section_edit.h"
#include "core/interaction/tool.h"
#include "core/interaction/turning_drag.h"

#include <functional>
#include <optional>

namespace fff {

struct MirrorChoice
{
    enum class Plane { X, Y, Z, Section }; // where that coordinate is 0, or that of a section
    enum class Outcome {
        Copy,   // an image of what is selected
        Always, // an operation: one side follows the other
        Once    // the same sections, drawn
    };
    Plane plane = Plane::X;
    std::optional<SectionRef> across = {}; // of Plane::Section, once it is known
    Outcome outcome = Outcome::Always;

    bool operator==(const MirrorChoice &) const = default;
};

/// The plane of the choice, which is known, through the world's origin or its section's; the
/// frame's normal is the mirror's.
Frame mirrorPlane(const Model &model, const MirrorChoice &choice);

class MirrorTool : public Tool
{
public:
    static constexpr std::string_view kCommand = "edit.mirror";
    /// What a choice, whose plane is known, makes of a model.
    using Edit = std::function<SectionEdit(const Model &, const MirrorChoice &)>;

    /// isChange: the tool in the hand goes on with another choice; else asking again lays it down.
    MirrorTool(const MirrorChoice &choice, Edit edit, bool isChange)
        : m_choice(choice), m_edit(std::move(edit)), m_isChange(isChange)
    {
    }

    const MirrorChoice &choice() const { return m_choice; }

    std::string_view command() const override { return kCommand; }
    bool isSame(const Tool &other) const override;
    GestureReply begin(GestureContext &context, double time) override;
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void mark(GestureContext &context, bool hasCursor) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply interrupt(GestureContext &context) override { return m_drag.interrupt(context); }
    bool wants(ToolKey key) const override;
    GestureReply key(ToolKey key, GestureContext &context) override;
    bool takesClicks() const override { return true; }
    bool marksSections() const override { return asks() && !m_drag.isTurning(); }
    std::vector<std::string_view> commands() const override;
    std::vector<CommandGroup> commandGroups() const override;
    std::string_view mainCommand() const override { return "mirror.apply"; }
    Hint hint() const override;
    Cursor cursor() const override
    {
        return m_drag.isTurning() ? Cursor::TurningArrows : Cursor::Arrow;
    }

private:
    /// A click says which plane.
    bool asks() const { return m_choice.plane == MirrorChoice::Plane::Section; }
    bool isPlaneKnown() const { return !asks() || m_choice.across; }
    void work(const GestureContext &context);
    GestureReply shown() const;
    GestureReply done(const GestureContext &context);

    MirrorChoice m_choice; // while a section is looked for, the one under the cursor
    const Edit m_edit;
    const bool m_isChange;
    TurningDrag m_drag;
    std::optional<SectionEdit> m_made; // of the choice
};

} // namespace fff
