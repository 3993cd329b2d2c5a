// Draws one contour on a canvas that was asked for: on a plane, or instead of a section's contour,
// or as a hole in it. The view looks straight at the canvas meanwhile.
#pragma once

#include "core/interaction/contour_target.h"
#include "core/interaction/stroke_gesture.h"
#include "core/interaction/tool.h"

#include <memory>
#include <string>

namespace fff {

class DrawTool : public Tool
{
public:
    /// command: its id. name: of the section that the target is about, or of the plane.
    DrawTool(ContourTarget target, std::string command, std::string name);
    ~DrawTool() override;

    std::string_view command() const override { return m_command; }
    GestureReply begin(GestureContext &context, double time) override;
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void advance(double time, GestureContext &context) override;
    /// A stroke first, then the tool, with the view from before.
    GestureReply cancel(GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override { return Cursor::Pencil; }

private:
    ContourTarget m_target;
    std::string m_command, m_name;
    std::optional<Camera> m_before; // the turn
    std::unique_ptr<StrokeGesture> m_stroke;
};

/// The view straight at a canvas after the least turn, what is to be seen of it in the middle: the
/// target's section, or what the model has there.
Camera cameraAtCanvas(const ContourTarget &target, const GestureContext &context);

} // namespace fff
