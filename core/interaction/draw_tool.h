// Draws one contour on a canvas that was asked for: on a plane, or instead of a section's contour,
// or as a hole in it. The view turns to look straight at the canvas, unless that is the section
// that the first drag begins on: then it is drawn on as it is seen.
#pragma once

#include "core/interaction/contour_target.h"
#include "core/interaction/stroke_gesture.h"
#include "core/interaction/tool.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fff {

/// Which section is drawn on says the first press.
struct AskedCanvas
{
    std::string command;
    Hint prompt; // while it waits for that
    /// What is drawn on that section, or why nothing can be.
    std::function<tl::expected<CanvasChoice, Hint>(const Model &, const SectionRef &)> of;
};

class DrawTool : public Tool
{
public:
    explicit DrawTool(CanvasChoice canvas);
    explicit DrawTool(AskedCanvas asked);
    ~DrawTool() override;

    std::string_view command() const override { return m_canvas.command; }
    GestureReply begin(GestureContext &context, double time) override;
    bool takes(const PointerEvent &press, GestureContext &context) const override;
    bool marksSections() const override { return isAsking(); }
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void advance(double time, GestureContext &context) override;
    bool isAnimating() const override { return m_stroke && m_stroke->isAnimating(); }
    GestureReply interrupt(GestureContext &context) override;
    bool isSame(const Tool &other) const override;
    /// It stays in the hand as long as what it is for is there.
    GestureReply modelChanged(GestureContext &context) override;
    /// A stroke first, then the tool, with the view from before.
    GestureReply cancel(GestureContext &context) override;
    bool hasGuide() const override;
    GestureReply takeGuide(GestureContext &context) override;
    void mark(GestureContext &context, bool hasCursor) override;
    /// The distance of a parallel plane, until a stroke is begun.
    std::vector<ToolNumber> numbers() const override;
    GestureReply setNumbers(const std::vector<ToolNumber> &numbers,
                            GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override { return Cursor::Pencil; }

private:
    bool isAsking() const { return m_asked.has_value(); }
    GestureReply pickCanvas(const PointerEvent &press, GestureContext &context);
    GestureReply draw(const PointerEvent &event, GestureContext &context);
    void lookAtTemplates(const GestureContext &context);
    bool isClickOnGuide(const PointerEvent &release, const GestureContext &context) const;

    CanvasChoice m_canvas;
    std::optional<AskedCanvas> m_asked; // until it is known
    bool m_isPicking = false;           // with the press that is held, until it is a drag
    TemplateGuides m_templates;         // of that canvas,
    std::vector<TemplatePointer> m_cut; // of these,
    std::shared_ptr<const PulledTemplates> m_cutAs; // as they were pulled
    Vec2 m_press = Vec2::Zero();                    // px
    std::optional<Camera> m_before;                 // the turn
    std::unique_ptr<StrokeGesture> m_stroke;
    bool m_isOnEdge = false; // as the view looks at the canvas now
};

/// The view straight at a canvas from its nearer side, what is to be seen of it in the middle: the
/// target's section, or what the model has there. None where the section is seen and faced already
/// (section_view.h): then it is drawn on as it is seen.
std::optional<Camera> cameraAtCanvas(const ContourTarget &target, const GestureContext &context);

/// A plane as a frame round what the model has there, for one that is moved to and fro.
sign::Region planeMark(const Frame &canvas, const GestureContext &context);

} // namespace fff
