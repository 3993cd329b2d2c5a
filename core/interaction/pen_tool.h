// The pen: draws with clicks what a stroke draws in one go. It stays in the hand until it is laid
// down.
//
//     no canvas   the first section's canvas faces the view and is there at once; else a drag out
//     of
//                 a section makes one (slit_turn.h), or one is picked (useCanvas). Clicks select,
//                 other drags turn the view, as without it.
//     canvas      a press sets a point, a drag bends it; what is set can be dragged. Enter, a
//     double
//                 click and a click on the first point close the path to a contour.
//     closed      one step of the history; the view stays, the canvas is given up
//
// Esc takes the path back, then lays the pen down, which brings the view back. Undo and Redo go
// through the steps of an open path. Points snap (snapping.h) unless it is switched off or Ctrl is
// held; Shift holds eight directions.
#pragma once

#include "core/interaction/pen_marks.h"
#include "core/interaction/slit_turn.h"
#include "core/interaction/template_guides.h"
#include "core/interaction/tool.h"

namespace fff {

class PenTool : public Tool
{
public:
    static constexpr std::string_view kCommand = "section.pen";

    std::string_view command() const override { return kCommand; }
    GestureReply begin(GestureContext &context, double time) override;
    bool takes(const PointerEvent &press, GestureContext &context) const override;
    bool takesClicks() const override { return m_canvas.has_value(); }
    bool marksSections() const override { return !m_canvas && !m_slit; }
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void advance(double time, GestureContext &context) override;
    GestureReply interrupt(GestureContext &context) override;
    void finish(GestureContext &context) override;
    bool isAnimating() const override;
    void mark(GestureContext &context, bool hasCursor) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply modelChanged(GestureContext &context) override;
    bool wants(ToolKey key) const override;
    GestureReply key(ToolKey key, GestureContext &context) override;
    bool canUndo() const override { return m_canvas && m_path.canUndo(); }
    bool canRedo() const override { return m_canvas && m_path.canRedo(); }
    GestureReply undo(GestureContext &context) override;
    GestureReply redo(GestureContext &context) override;
    std::optional<GestureReply> useCanvas(CanvasChoice canvas, GestureContext &context) override;
    std::vector<ToolNumber> numbers() const override;
    GestureReply setNumbers(const std::vector<ToolNumber> &numbers,
                            GestureContext &context) override;
    GestureReply dropNumbers(GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override;

private:
    struct Canvas
    {
        CanvasChoice choice;
        SnapTargets targets;   // of the model alone
        TemplateGuides guides; // what it cuts of templates
        bool isFirst = false;  // faces the view until something is set on it
        bool isOnEdge = false; // as the view looks at it now
    };
    /// What a press or the cursor is on.
    struct Place
    {
        enum class Kind { Free, Point, Handle };
        Kind kind = Kind::Free;
        std::size_t index = 0;
        PenPath::End end = PenPath::End::Out;
    };
    struct Press
    {
        Vec2 position = Vec2::Zero(); // px
        double time = 0.0;            // ms
        Place place;                  // of Free: the point that it set
        bool isDrag = false, isOver = false;
    };

    GestureReply press(const PointerEvent &event, GestureContext &context);
    void drag(const PointerEvent &event, GestureContext &context);
    GestureReply release(GestureContext &context);
    GestureReply followSlit(const PointerEvent &event, GestureContext &context);
    void hover(GestureContext &context);
    GestureReply close(GestureContext &context);
    GestureReply addPoint(const Vec2 &point, GestureContext &context);
    void takeSlit(GestureContext &context);

    void setCanvas(CanvasChoice choice, bool isFirst, const GestureContext &context);
    void faceFirstCanvas(const GestureContext &context);
    void forgetPath();
    bool isClosable() const { return m_closed.contour.has_value(); }
    void pathChanged(const GestureContext &context);
    GestureReply shown() const;

    std::optional<Vec2> pointUnder(const Vec2 &position, const GestureContext &context) const;
    double scaleAt(const Vec2 &point, const GestureContext &context) const;
    Place placeAt(const Vec2 &position, const GestureContext &context) const;
    Snap snapTo(const Vec2 &point, std::optional<std::size_t> moved,
                const GestureContext &context) const;
    std::optional<Vec2> pointBefore(std::optional<std::size_t> moved) const;
    Vec2 nextPoint() const;
    bool isClosing() const;

    std::optional<SlitTurn> m_slit;
    std::optional<Canvas> m_canvas;
    std::optional<Camera> m_viewBefore; // the canvas
    PenPath m_path;
    PathContour m_closed;
    std::optional<tl::expected<DrawnContour, Hint>> m_drawn; // none: nothing is enclosed

    std::optional<Press> m_press;      // of the button
    std::optional<Press> m_lastPress;  // the one before, for double clicks
    PointerEvent m_event;              // the last one: where the cursor is, and which keys are held
    Camera m_hoverCamera;              // that m_place and m_snap belong to
    Place m_place;                     // under the cursor
    std::optional<Snap> m_snap;        // of the point that is set or moved next
    std::optional<Vec2> m_typed;       // the next point by numbers
    std::optional<std::string> m_over; // name of the section under the cursor, without a canvas
};

} // namespace fff
