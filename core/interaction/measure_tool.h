// Measures the length between two places: a drag from one to the other, or a click on each. As the
// dimension tool it says in which length the model is to be: the whole model is scaled so that this
// line becomes that long.
//
//     waiting     the place under the cursor is marked; lines that stay can be picked up
//     dragging    from the first place to the cursor; Ctrl: exactly what is under it
//     measured    the line stays in the hand, until another one is begun: it can be kept; of the
//                 dimension tool its length can be typed, which shows the model as it would be;
//                 Enter scales it, one step of the history
//
// Esc drops what is typed, then the line, then lays the tool down.
#pragma once

#include "core/interaction/measuring.h"
#include "core/interaction/tool.h"

namespace fff {

class MeasureTool : public Tool
{
public:
    static constexpr std::string_view kMeasure = "measure.ruler";
    static constexpr std::string_view kDimension = "measure.dimension";

    explicit MeasureTool(bool isDimension) : m_isDimension(isDimension) {}
    /// Of the same line as the other one, which is asked for in the other way.
    MeasureTool(bool isDimension, const MeasureTool &other)
        : m_isDimension(isDimension), m_line(other.m_line), m_dimension(other.m_dimension)
    {
    }

    std::string_view command() const override { return m_isDimension ? kDimension : kMeasure; }
    bool takes(const PointerEvent &press, GestureContext &context) const override;
    bool takesControl(const PointerEvent &press, GestureContext &context) const override;
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void mark(GestureContext &context, bool hasCursor) override;
    GestureReply interrupt(GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply modelChanged(GestureContext &context) override;
    std::vector<ToolNumber> numbers() const override;
    GestureReply setNumbers(const std::vector<ToolNumber> &numbers,
                            GestureContext &context) override;
    GestureReply dropNumbers(GestureContext &context) override;
    bool wants(ToolKey key) const override { return key == ToolKey::Enter && m_wanted.has_value(); }
    GestureReply key(ToolKey key, GestureContext &context) override;
    std::vector<std::string_view> commands() const override;
    Hint hint() const override;
    Cursor cursor() const override { return Cursor::ArrowWithPlus; }

    /// The line in the hand, as one that would stay; none: there is none, or it stays already.
    struct Line
    {
        Anchor from, to;
    };
    std::optional<Line> line() const;
    /// That is in the hand; not valid: none, or one that does not stay.
    DimensionId dimension() const { return m_dimension; }

private:
    struct Ends
    {
        MeasuredPlace from, to;
        double length() const { return (to.point - from.point).norm(); }
    };
    /// Typed, and made of the model once: the cursor may pass by meanwhile.
    struct Wanted
    {
        double length; // mm
        Result<Document> scaled;
    };
    GestureReply press(const PointerEvent &event, GestureContext &context);
    GestureReply shown() const;
    double factor() const { return m_wanted->length / m_line->length(); }
    void follow(const GestureContext &context);

    bool m_isDimension;
    std::optional<MeasuredPlace> m_place; // under the cursor
    std::optional<MeasuredPlace> m_from;  // the first place, while the second is looked for
    std::optional<Vec2> m_press;          // px, of the first place, while the button is down
    bool m_isDrag = false;
    std::optional<Ends> m_line; // measured
    DimensionId m_dimension, m_hovered;
    std::optional<Wanted> m_wanted;
};

} // namespace fff
