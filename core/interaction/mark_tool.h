// Draws what is engraved or scored on a section: a drag draws a line, a click sets words, which are
// then written in Properties. The view turns to the section's front, which is the side that the
// machine sees, also when it looks from behind, and says so then. It stays in the hand until it is
// laid down.
//
//     no section   a click picks one, which the view turns to; a drag draws on the one that it
//                  begins on, as that is seen
//     section      a drag draws a line as the hand goes; with Shift a straight one, in one of the
//                  eight directions. It may begin and end beside the section, so that it goes to
//                  the very edge. Each is one step of the history. Other sections stand back.
#pragma once

#include "core/interaction/snapping.h"
#include "core/interaction/solo_view.h"
#include "core/interaction/tool.h"
#include "core/stroke/stroke.h"

namespace fff {

class MarkTool : public Tool
{
public:
    static constexpr std::string_view kCommand = "section.mark";

    std::string_view command() const override { return kCommand; }
    GestureReply begin(GestureContext &context, double time) override;
    bool takes(const PointerEvent &press, GestureContext &context) const override;
    bool marksSections() const override { return !m_section; }
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void mark(GestureContext &context, bool hasCursor) override;
    GestureReply interrupt(GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply modelChanged(GestureContext &context) override;
    std::vector<std::string_view> commands() const override;
    Hint hint() const override;
    Cursor cursor() const override { return m_section ? Cursor::Pen : Cursor::Arrow; }

private:
    GestureReply take(const SectionRef &section, GestureContext &context);
    bool isFromBehind(const GestureContext &context) const;
    void lookAt(const GestureContext &context, GestureReply &reply);
    MarkPointer drawn(const GestureContext &context, bool isWhole) const;
    GestureReply release(GestureContext &context);
    bool isOnSection(const Mark &mark, const GestureContext &context) const;

    std::optional<SectionRef> m_section;
    std::string m_name;
    Frame m_canvas;
    SoloView m_solo;
    std::optional<Camera> m_before; // the turn
    std::optional<Vec2> m_press;    // px
    bool m_isDrag = false, m_isStraight = false;
    bool m_isPicking = false; // with the press that is held, until it is a drag
    struct Drawn              // canvas coordinates, mm
    {
        Drawn(const Vec2 &from, const FitOptions &fit);
        void add(const Vec2 &p);

        FitOptions options;
        SteadyHand hand;
        ThinnedLine line;
        SettledFit settled;
        Vec2 start, end; // as they were pressed and moved to
    };
    std::optional<Drawn> m_drawn; // since the press
};

} // namespace fff
