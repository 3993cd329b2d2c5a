// A person at the view without any window: a session, the interaction with its commands, a mouse,
// and a clock that goes with the events.
#pragma once

#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/units.h"
#include "core/interaction/interaction.h"
#include "core/session/session_commands.h"
#include "core/session/session_host.h"
#include "tests/core/assembly/plates.h"
#include "tests/told.h"

#include <string>
#include <vector>

namespace fff::test {

inline const Vec2 kViewport(1280.0, 800.0); // px
inline constexpr double kTurnTime = 800.0;  // ms
inline constexpr Modifiers kShift{true, false, false}, kControl{false, true, false};

/// Positions are of the screen, in px. An event comes 8 ms after the one before.
class Desk
{
public:
    using Type = PointerEvent::Type;

    Desk() : host(session), interaction(host)
    {
        host.attach(interaction);
        interaction.setViewport(kViewport);
        registerSessionCommands(commands, session, interaction);
    }

    void send(Type type, const Vec2 &position, Button button = Button::None,
              Modifiers modifiers = {})
    {
        PointerEvent event;
        event.type = type;
        event.position = cursor = position;
        event.button = button;
        event.modifiers = modifiers;
        event.time = time += 8.0;
        event.isFollowed = isBursting && type == Type::Move;
        interaction.handle(event);
    }
    void wheel(const Vec2 &position, double steps)
    {
        PointerEvent event;
        event.type = Type::Wheel;
        event.position = position;
        event.wheelSteps = steps;
        event.time = time += 8.0;
        interaction.handle(event);
    }
    void press(const Vec2 &p, Button button = Button::Left, Modifiers modifiers = {})
    {
        send(Type::Press, p, button, modifiers);
    }
    void release(const Vec2 &p, Button button = Button::Left, Modifiers modifiers = {})
    {
        send(Type::Release, p, button, modifiers);
    }
    void moveTo(const Vec2 &to, Modifiers modifiers = {}, int steps = 10)
    {
        const Vec2 from = cursor;
        for (int i = 1; i <= steps; ++i)
            send(Type::Move, from + (to - from) * (double(i) / steps), Button::None, modifiers);
    }
    /// After a pause: no double click with the one before.
    void click(const Vec2 &p, Modifiers modifiers = {})
    {
        wait(1000.0);
        moveTo(p, modifiers);
        press(p, Button::Left, modifiers);
        release(p, Button::Left, modifiers);
    }
    void doubleClick(const Vec2 &p)
    {
        click(p);
        press(p);
        release(p);
    }
    void drag(const std::vector<Vec2> &way, Button button = Button::Left, Modifiers modifiers = {})
    {
        moveTo(way.front(), modifiers);
        press(way.front(), button, modifiers);
        for (const Vec2 &p : way)
            moveTo(p, modifiers);
        release(way.back(), button, modifiers);
    }
    void wait(double ms) { interaction.advance(time += ms); }
    void run(const std::string &id, const CommandParameters &parameters = {})
    {
        QVERIFY2(commands.run(id, parameters, time += 8.0), id.c_str());
    }

    /// A section in the z = `z` plane, as if it had been there.
    void addPlate(double z = 0.0, const Vec2 &half = {100, 60})
    {
        Frame frame = test::front(z);
        frame.origin.y() = kFirstPlaneHeight;
        session.commit(
            QStringLiteral("Draw"),
            withSection(session.committed().document,
                        polygonShape(rectangle(-half.x(), -half.y(), half.x(), half.y())), frame));
    }
    Vec2 screen(const Vec3 &p) const { return interaction.camera().toScreen(p, kViewport); }
    /// Of the plane z = 0, counted from the ground.
    Vec2 front(double x, double y) const { return screen({x, y, 0.0}); }
    /// The same, counted from the middle of the plate in it.
    Vec2 plate(double x, double y) const { return front(x, kFirstPlaneHeight + y); }

    const std::vector<SectionPointer> &sections() const
    {
        return session.committed().document.sections;
    }
    Text hint() const { return interaction.hint().words.text; }
    int steps() const { return session.history()->count(); }
    QString lastStep() const { return session.history()->undoText(); }

    Session session;
    SessionHost host;
    Interaction interaction;
    CommandRegistry commands;
    Vec2 cursor = Vec2::Zero();
    double time = 0.0;
    bool isBursting = false; // moves are said to be followed by others
};

inline bool isSameCamera(const Camera &a, const Camera &b)
{
    return (a.target - b.target).norm() < 1e-9 &&
           a.orientation.angularDistance(b.orientation) < 1e-9 &&
           a.millimetresPerPixel == b.millimetresPerPixel;
}

} // namespace fff::test
