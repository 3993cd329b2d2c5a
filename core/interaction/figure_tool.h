// Draws a circle, rectangle and so on (core/geometry/figure.h) by a drag from its middle outwards:
// as a hole in the section that is selected or lies in the canvas there, else as a new section on
// the canvas that was picked or faces the view. Which kind says InteractionSettings::figure, which
// buttons of the bar change.
//
//     waiting     the middle snaps to points, guides of templates, lines and the grid, as the pen's
//                 points do
//     dragging    half the size to either side, in steps of the grid; Shift: as wide as high.
//                 A click makes one of the usual size. The release is one step of the history.
#pragma once

#include "core/geometry/figure.h"
#include "core/interaction/snapping.h"
#include "core/interaction/solo_view.h"
#include "core/interaction/template_guides.h"
#include "core/interaction/tool.h"

namespace fff::hints {

//: %1 is a shape ("Circle")
inline constexpr Text kPlaceFigure =
    FFF_TEXT("Hint", "%1: drag outwards from its centre; a click makes one of the usual size.");
//: %1 is a shape ("Circle"), %2 the name of a section
inline constexpr Text kPlaceHole =
    FFF_TEXT("Hint", "%1: drag outwards from its centre to cut it out of %2.");
inline constexpr Text kSizeFigure =
    FFF_TEXT("Hint", "Release to make it this size; <kbd>Shift</kbd> keeps both sides equal. "
                     "<kbd>Esc</kbd> cancels.");

} // namespace fff::hints

namespace fff {

class FigureTool : public Tool
{
public:
    static constexpr std::string_view kCommand = "section.addShape";

    std::string_view command() const override { return kCommand; }
    GestureReply begin(GestureContext &context, double time) override;
    bool takes(const PointerEvent &press, GestureContext &context) const override;
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void mark(GestureContext &context, bool hasCursor) override;
    GestureReply interrupt(GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply modelChanged(GestureContext &context) override;
    std::optional<GestureReply> useCanvas(CanvasChoice canvas, GestureContext &context) override;
    std::vector<std::string_view> commands() const override;
    Hint hint() const override;
    Cursor cursor() const override { return Cursor::Pencil; }

private:
    void setCanvas(CanvasChoice canvas, const GestureContext &context);
    void faceFirstCanvas(const GestureContext &context);
    ContourTarget targetAt(const Vec3 &middle, const GestureContext &context) const;
    Figure figureTo(const Vec2 &corner, bool isEven, const GestureContext &context) const;
    GestureReply made(const Figure &figure, bool isOver, GestureContext &context);

    CanvasChoice m_canvas{ContourTarget{}, std::string(kCommand)};
    ContourTarget m_target;  // what a press draws: of the canvas, or a hole in what lies in it
    TemplateGuides m_guides; // on the canvas
    std::optional<SnapTargets> m_targets;
    SoloView m_solo;         // the section that is cut
    bool m_isPicked = false; // the canvas; else it faces the view
    std::optional<Camera> m_before;
    std::optional<Vec2> m_press; // px
    bool m_isDrag = false;
    std::optional<Figure> m_figure; // that a release would make
    bool m_isPossible = false;      // there
    std::optional<Snap> m_middle;   // of the figure, or under the cursor
    std::string m_kind;             // as of the last look
};

} // namespace fff
