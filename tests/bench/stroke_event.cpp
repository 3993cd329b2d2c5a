#include "tests/bench/stroke_event.h"

#include "core/session/session_host.h"
#include "tests/bench/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

namespace fff::bench {

namespace {

const Vec2 kViewport(1280.0, 800.0);   // px
constexpr double kInterval = 1.0;      // ms between events: a mouse of 1,000 Hz
constexpr double kTremor = 1.5;        // px
constexpr double kScribbleSpeed = 1.0; // px an event

/// Round the middle of the view with a few bays, `u` from 0 to 1.
Vec2 alongHand(double u)
{
    const double a = 2.0 * std::numbers::pi * u;
    const double radius = 250.0 + 40.0 * std::sin(3.0 * a) + 20.0 * std::cos(7.0 * a + 0.4);
    return 0.5 * kViewport + radius * Vec2(std::cos(a), 0.9 * std::sin(a));
}

/// To and fro over the view, across itself again and again.
Vec2 alongScribble(double length)
{
    const double a = length / 160.0;
    return 0.5 * kViewport + Vec2(420.0 * std::cos(0.311 * a) * std::cos(a),
                                  300.0 * std::sin(0.277 * a + 0.3) * std::sin(1.37 * a));
}

Vec2 sampleOf(const std::string &hand, int i, int samples, std::mt19937 &random)
{
    const double u = double(i) / samples;
    if (hand == "scribble")
        return alongScribble(kScribbleSpeed * i);
    if (hand == "spiral") {
        const double a = 2.0 * std::numbers::pi * 0.05 * samples / 100.0 * u;
        return 0.5 * kViewport + (30.0 + 320.0 * u) * Vec2(std::cos(a), std::sin(a));
    }
    Vec2 at = alongHand(0.995 * u);
    if (hand == "tremor") {
        std::uniform_real_distribution<double> jitter(-kTremor, kTremor);
        at += Vec2(jitter(random), jitter(random));
    }
    return at;
}

} // namespace

std::vector<std::string> strokeHands()
{
    return {"smooth", "tremor", "scribble", "spiral"};
}

StrokeTiming drawStroke(const std::string &hand, int samples)
{
    Session session;
    SessionHost host(session);
    Interaction interaction(host);
    host.attach(interaction);
    interaction.setViewport(kViewport);
    interaction.settings().mirrorsFirst = false;
    std::mt19937 random(7);
    StrokeTiming timing{hand, samples};
    double time = 0.0;
    const auto send = [&](PointerEvent::Type type, const Vec2 &at) {
        PointerEvent event;
        event.type = type;
        event.position = at;
        if (type != PointerEvent::Type::Move)
            event.button = Button::Left;
        event.time = time += kInterval;
        double milliseconds = 0.0;
        timed(milliseconds, [&] {
            interaction.handle(event);
            return 0;
        });
        timing.total += milliseconds;
        double &dearest = type == PointerEvent::Type::Release ? timing.release : timing.dearest;
        dearest = std::max(dearest, milliseconds);
    };
    send(PointerEvent::Type::Press, sampleOf(hand, 0, samples, random));
    for (int i = 1; i <= samples; ++i)
        send(PointerEvent::Type::Move, sampleOf(hand, i, samples, random));
    if (interaction.overlay().find<sign::Stroke>())
        timing.kept = static_cast<int>(interaction.overlay().find<sign::Stroke>()->samples.size());
    send(PointerEvent::Type::Release, sampleOf(hand, samples, samples, random));
    return timing;
}

std::string strokeTable(const std::vector<StrokeTiming> &rows)
{
    std::string text =
        "\nA stroke, all of its events\n"
        "hand        samples    kept        ms  kernels  growth  dearest ms  kernels  release\n";
    const StrokeTiming *before = nullptr;
    for (const StrokeTiming &row : rows) {
        const bool grows = before && before->hand == row.hand;
        const double unit = row.kernel > 0.0 ? row.kernel : 0.0;
        char line[160];
        std::snprintf(line, sizeof line, "%-10s %8d %7d %9.1f %8.3f %7.2f %11.3f %8.4f %8.4f\n",
                      row.hand.c_str(), row.samples, row.kept, row.total,
                      unit > 0.0 ? row.total / unit : 0.0, grows ? row.total / before->total : 0.0,
                      row.dearest, unit > 0.0 ? row.dearest / unit : 0.0,
                      unit > 0.0 ? row.release / unit : 0.0);
        text += line;
        before = &row;
    }
    return text;
}

} // namespace fff::bench
