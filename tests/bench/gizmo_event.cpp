#include "tests/bench/gizmo_event.h"

#include "core/interaction/transform_tool.h"
#include "core/interaction/view_fit.h"
#include "core/session/session_host.h"
#include "tests/bench/stopwatch.h"

#include <memory>
#include <vector>

namespace fff::bench {

namespace {

const Vec2 kViewport(1280.0, 800.0); // px
constexpr int kMoves = 21;
constexpr double kStep = 0.73; // px, each

} // namespace

double gizmoMove(const Document &document, SectionId section)
{
    Session session;
    session.reset(document);
    SessionHost host(session);
    Interaction interaction(host);
    host.attach(interaction);
    interaction.setViewport(kViewport);
    Camera camera;
    orientationOfView("iso1", camera.orientation);
    interaction.setCamera(fitted(camera, session.committed().bounds(), kViewport));
    interaction.select({section});
    interaction.pickUp(std::make_unique<TransformTool>(), 0.0);
    const auto *gizmo = interaction.overlay().find<GizmoMarks>();
    if (!gizmo)
        return 0.0; // it is locked, or made by an operation
    const Vec2 tip = GizmoLook(gizmo->gizmo, interaction.camera(), kViewport).tip(1);
    double time = 0.0;
    const auto send = [&](PointerEvent::Type type, const Vec2 &at) {
        PointerEvent event;
        event.type = type;
        event.position = at;
        if (type == PointerEvent::Type::Press)
            event.button = Button::Left;
        event.time = time += 8.0;
        interaction.handle(event);
    };
    send(PointerEvent::Type::Move, tip);
    send(PointerEvent::Type::Press, tip);
    send(PointerEvent::Type::Move, tip + Vec2(0.0, -20.0)); // begins the drag
    std::vector<double> moves;
    for (int i = 1; i <= kMoves; ++i) {
        double milliseconds = 0.0;
        timed(milliseconds, [&] {
            send(PointerEvent::Type::Move, tip + Vec2(0.0, -20.0 - kStep * i));
            return 0;
        });
        moves.push_back(milliseconds);
    }
    return median(std::move(moves));
}

} // namespace fff::bench
