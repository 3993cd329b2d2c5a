// Makes a template as large as a line over it says: the line is drawn, then told how long it is.
// What is flat is drawn on in its plane, a mesh in the plane through its middle that faces the eye.
//
//     waiting     a press on the template begins the line
//     drawing     by a drag, or with a second click; Shift keeps it to eight directions
//     drawn       another press draws another line; its length can be typed, which shows the
//                 template as it would be, the line's first end staying; Enter is one step
//
// Esc drops what is typed, then the line, then lays the tool down.
#pragma once

#include "core/interaction/tool.h"

#include <optional>

namespace fff {

class SizeLineTool : public Tool
{
public:
    static constexpr std::string_view kCommand = "template.sizeByLine";

    explicit SizeLineTool(TemplateId of) : m_of(of) {}

    TemplateId of() const { return m_of; }

    std::string_view command() const override { return kCommand; }
    bool isSame(const Tool &other) const override;
    bool takes(const PointerEvent &press, GestureContext &context) const override;
    GestureReply begin(GestureContext &context, double time) override;
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
    Hint hint() const override;
    Cursor cursor() const override { return Cursor::ArrowWithPlus; }

private:
    struct Ends
    {
        Vec3 from = Vec3::Zero(), to = Vec3::Zero(); // world
        double length() const { return (to - from).norm(); }
    };
    struct Wanted
    {
        double length = 0.0; // mm
        Result<Document> sized;
    };
    std::optional<Frame> plane(const GestureContext &context) const;
    bool isEdgeOn(const GestureContext &context) const;
    std::optional<Vec3> placeAt(const Vec2 &position, const GestureContext &context) const;
    bool isOver(const Vec3 &place, const GestureContext &context) const;
    void press(const PointerEvent &event);
    void endLine();
    GestureReply shown() const;
    GestureReply over(const GestureContext &context) const;

    const TemplateId m_of;
    std::string m_name;          // of the template
    std::optional<Vec3> m_place; // under the cursor
    bool m_isOver = false;       // that is on the template
    std::optional<Vec3> m_from;  // the first end, while the other is looked for
    std::optional<Vec2> m_press; // px, of the first end, while the button is down
    bool m_isDrag = false;
    std::optional<Ends> m_line;
    std::optional<Wanted> m_wanted;
};

} // namespace fff
