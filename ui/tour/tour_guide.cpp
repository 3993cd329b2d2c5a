#include "ui/tour/tour_guide.h"

#include "core/base/tolerances.h"
#include "ui/bench/workbench.h"
#include "ui/tour/tour_card.h"
#include "ui/tour/tour_hint.h"

#include <QApplication>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr int kLook = 200; // ms

QString sentenceOf(Tour::Step step)
{
    switch (step) {
    case Tour::Step::Draw:
        return TourGuide::tr("<b>Draw a body.</b> Press in the middle of the view and draw its "
                             "outline in one go, down to the ground.");
    case Tour::Step::Cross:
        return TourGuide::tr(
            "<b>Draw a section across it.</b> Press inside the body, drag out across its edge, "
            "keep the button down and draw the outline, down to the ground again.");
    case Tour::Step::Turn:
        return TourGuide::tr("<b>Look around.</b> Drag beside the model to turn it; roll the wheel "
                             "to come nearer.");
    case Tour::Step::Thickness:
        return TourGuide::tr("<b>Measure your sheet.</b> Click its stock at the right of the tool "
                             "bar and type its thickness: all slits follow.");
    case Tour::Step::Check:
        return TourGuide::tr("<b>Will it work?</b> The verdicts over the view say so. Click one to "
                             "read more.");
    case Tour::Step::Repeat:
        return TourGuide::tr("<b>Repeat it.</b> Choose <b>Linear</b>, then click what it asks for: "
                             "copies stand in a row along the body.");
    case Tour::Step::Export:
        return TourGuide::tr("<b>Cut it.</b> <b>Export…</b> shows the sheets and writes the file "
                             "for the cutter.");
    }
    return {}; // not reached: every step is above
}

QString lastWords()
{
    return TourGuide::tr("<b>That is a whole model,</b> from the first stroke to the file. "
                         "<b>F1</b> tells more.");
}

QPolygonF oval(const QPointF &middle, double wide, double tall)
{
    QPolygonF points;
    for (int i = 0; i <= 60; ++i) {
        const double angle = 6.1 * i / 60.0; // not quite round
        points += middle + QPointF(wide * std::cos(angle), -tall * std::sin(angle));
    }
    return points;
}

} // namespace

TourGuide::TourGuide(Workbench &bench, QWidget &window, QWidget &view, int top, TargetOf targetOf,
                     QObject *parent)
    : QObject(parent), m_bench(bench), m_window(window), m_view(view),
      m_targetOf(std::move(targetOf)), m_tour(bench), m_card(new TourCard(&view, top)),
      m_hint(new TourHint(&window))
{
    connect(&m_tour, &Tour::changed, this, &TourGuide::follow);
    connect(m_card, &TourCard::skipWanted, &m_tour, &Tour::skip);
    connect(m_card, &TourCard::endWanted, &m_tour, &Tour::end);
    m_look.setInterval(kLook);
    connect(&m_look, &QTimer::timeout, this, &TourGuide::point);
}

void TourGuide::refreshColours()
{
    m_card->refreshColours();
    m_hint->update();
}

void TourGuide::follow()
{
    if (m_tour.isOn()) {
        m_card->say(m_tour.number(), m_tour.count(),
                    m_tour.isDone() ? lastWords() : sentenceOf(m_tour.step()));
        m_look.start();
    } else {
        m_card->hide();
        m_look.stop();
    }
    point();
}

void TourGuide::point()
{
    const Interaction &interaction = m_bench.interaction();
    const bool isAtWork = interaction.hasGesture() || interaction.isAnimating() ||
                          interaction.tool() || QApplication::activeModalWidget() ||
                          QApplication::activePopupWidget();
    if (!m_tour.isOn() || m_tour.isDone() || isAtWork || !m_view.isVisible()) {
        m_hint->showNothing();
        return;
    }
    const QWidget *target = m_targetOf(m_tour.step());
    if (target && target->isVisible())
        m_hint->showRing({target->mapTo(&m_window, QPoint()), target->size()});
    else if (!target)
        m_hint->showWay(wayOf(m_tour.step()).translated(m_view.mapTo(&m_window, QPoint())));
    else
        m_hint->showNothing();
}

QPolygonF TourGuide::wayOf(Tour::Step step) const
{
    const QPointF middle(0.5 * m_view.width(), 0.5 * m_view.height());
    const double size = std::min(m_view.width(), m_view.height());
    const Camera &camera = m_bench.interaction().camera();
    const Vec2 viewport(m_view.width(), m_view.height());
    switch (step) {
    case Tour::Step::Draw: {
        // Down to the ground, and a little below it, where it is cut flat.
        const double tall = 0.2 * size;
        const double ground = std::clamp(camera.toScreen(Vec3::Zero(), viewport).y(),
                                         middle.y() + 0.5 * tall, middle.y() + 0.45 * size);
        return oval({middle.x(), ground - 0.85 * tall}, 0.3 * size, tall);
    }
    case Tour::Step::Cross: {
        if (m_bench.session().committed().sectionCount() == 0)
            return {};
        const SectionPointer &body = m_bench.session().committed().section(0);
        QPointF top(0.0, m_view.height()), centre;
        const Polygon outline = body->shape->contour().polygon(kDrawChord);
        for (const Vec2 &p : outline) {
            const Vec2 seen = camera.toScreen(body->frame.toWorld(p), viewport);
            const QPointF at(seen.x(), seen.y());
            centre += at / static_cast<double>(outline.size());
            if (at.y() < top.y())
                top = at;
        }
        const double out = std::clamp(0.4 * (centre.y() - top.y()), 24.0, 70.0);
        return {QPointF(top.x(), 0.5 * (centre.y() + top.y())), QPointF(top.x(), top.y() - out)};
    }
    case Tour::Step::Turn: {
        const QPointF from = middle + QPointF(-0.2 * size, 0.38 * size);
        return {from, from + QPointF(0.2 * size, -0.02 * size), from + QPointF(0.4 * size, 0.0)};
    }
    default:
        return {};
    }
}

} // namespace fff::ui
