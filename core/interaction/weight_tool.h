// Hangs weights on sections, and moves those that hang there.
//
//     waiting     what would be hung, or the weight under the cursor, is marked
//     dragging    the weight follows the cursor over the sections; where there is none it stays
//                 where it was last. The release is one step of the history
//
// Esc puts the weight back, then lays the tool down.
#pragma once

#include "core/interaction/tool.h"

namespace fff {

class WeightTool : public Tool
{
public:
    static constexpr std::string_view kCommand = "physics.addWeight";

    /// mass: kg, of what is hung next
    explicit WeightTool(double mass) : m_mass(mass) {}

    std::string_view command() const override { return kCommand; }
    /// What is hung is hung to be seen: stress lines are on from then on.
    GestureReply begin(GestureContext &context, double time) override;
    bool takes(const PointerEvent &press, GestureContext &context) const override;
    bool takesClicks() const override { return true; }
    bool marksSections() const override { return true; }
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void mark(GestureContext &context, bool hasCursor) override;
    GestureReply interrupt(GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply modelChanged(GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override;

private:
    GestureReply press(const PointerEvent &event, GestureContext &context);
    GestureReply release(GestureContext &context);
    /// The document with the weight where it is dragged to.
    Result<Document> dragged(const Document &document) const;

    double m_mass;               // kg
    std::optional<Vec3> m_place; // under the cursor, where the next one would hang; world, mm
    WeightId m_hovered;
    std::optional<Weight> m_dragged; // its id is not valid while it is new
    bool m_hasMoved = false;
};

/// The weight whose mark is within reach of the position; not valid: none.
WeightId weightAt(const Vec2 &position, const GestureContext &context);
/// Where it hangs, world, mm; nothing while its section is not there.
std::optional<Vec3> placeOf(const Model &model, const Weight &weight);

} // namespace fff
