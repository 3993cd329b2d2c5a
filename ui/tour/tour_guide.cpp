#include "ui/tour/tour_guide.h"

#include "core/base/tolerances.h"
#include "core/model/section.h"
#include "core/session/check_list.h"
#include "ui/bench/workbench.h"
#include "ui/tour/tour_card.h"
#include "ui/tour/tour_hint.h"

#include <QApplication>
#include <QPainterPath>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kLook = 200;       // ms
constexpr int kLeastTarget = 12; // px: smaller ones are not laid out yet

QString sentenceOf(Tour::Step step)
{
    switch (step) {
    case Tour::Step::Draw:
        return TourGuide::tr("<b>Draw a body.</b> Press in the middle of the view and draw its "
                             "outline in one go, flat along the top, down to the ground.");
    case Tour::Step::Cross:
        return TourGuide::tr("<b>Draw a section across it.</b> Press inside the body and drag out "
                             "across its edge. Keep the button down: the view turns. Then draw the "
                             "outline, down to the ground again.");
    case Tour::Step::Turn:
        return TourGuide::tr(
            "<b>Look around.</b> Drag beside the model to turn it; roll the wheel to come nearer.");
    case Tour::Step::Thickness:
        return TourGuide::tr(
            "<b>Measure your sheet.</b> Click the stock at the right of the tool bar, then its "
            "thickness, and type what you measured: all slits follow.");
    case Tour::Step::Check:
        return TourGuide::tr(
            "<b>Will it work?</b> The badges over the view tell you. Click one to read more.");
    case Tour::Step::Repeat:
        return TourGuide::tr("<b>Repeat it.</b> Choose <b>Linear</b>, click the section that you "
                             "drew across, then the body: copies stand in a row along it.");
    case Tour::Step::Export:
        return TourGuide::tr(
            "<b>Cut it.</b> <b>Export…</b> shows the sheets and writes the file for the cutter.");
    }
    return {}; // not reached: every step is above
}

QString wordsOfSlip()
{
    return TourGuide::tr("<b>That one is very small.</b> Undo it, then draw it larger, about half "
                         "as wide as the view.");
}

QString lastWords(bool hasDoneAll)
{
    if (!hasDoneAll)
        return TourGuide::tr(
            "<b>The tour ends here.</b> You can take it again from the <b>Help</b> "
            "menu. Press <b>F1</b> for more.");
    return TourGuide::tr("<b>That was all of the way,</b> from the first stroke to the file. What "
                         "is red has links under Checks that fix it. Press <b>F1</b> for more.");
}

/// A body that is flat along the top, so that what stands along it is of one height.
QPolygonF loaf(const QRectF &box)
{
    QPainterPath path;
    const double r = 0.45 * box.height();
    path.moveTo(box.right(), box.bottom() - 0.3 * box.height());
    path.cubicTo(box.right(), box.top(), box.right(), box.top(), box.right() - r, box.top());
    path.lineTo(box.left() + r, box.top());
    path.cubicTo(box.left(), box.top(), box.left(), box.top(), box.left(),
                 box.bottom() - 0.3 * box.height());
    path.lineTo(box.left(), box.bottom());
    path.lineTo(box.right() - 6.0, box.bottom());
    QPolygonF points;
    for (int i = 0; i <= 60; ++i)
        points += path.pointAtPercent(i / 60.0);
    return points;
}

} // namespace

TourGuide::TourGuide(Workbench &bench, const CheckList &checks, QWidget &window, QWidget &view,
                     int top, TargetOf targetOf, QObject *parent)
    : QObject(parent), m_bench(bench), m_checks(checks), m_window(window), m_view(view),
      m_targetOf(std::move(targetOf)), m_tour(bench), m_card(new TourCard(&view, top)),
      m_hint(new TourHint(&window))
{
    connect(&m_tour, &Tour::changed, this, &TourGuide::follow);
    connect(m_card, &TourCard::skipWanted, &m_tour, &Tour::skip);
    connect(m_card, &TourCard::endWanted, &m_tour, &Tour::end);
    connect(&checks, &CheckList::changed, this, [this] {
        if (m_tour.isOn() && !m_tour.isDone() && m_tour.step() == Tour::Step::Export)
            follow();
    });
    m_look.setInterval(kLook);
    connect(&m_look, &QTimer::timeout, this, &TourGuide::point);
}

void TourGuide::refreshColours()
{
    m_card->refreshColours();
    m_hint->update();
}

QString TourGuide::sentence() const
{
    if (m_tour.isDone())
        return lastWords(m_tour.hasDoneAll());
    if (m_tour.isTooSmall())
        return wordsOfSlip();
    const std::vector<Finding> &found = m_checks.all();
    const bool isWrong = std::any_of(found.begin(), found.end(), [](const Finding &finding) {
        return finding.severity == Severity::Error;
    });
    // The row comes as far as it can, and its last sections may be too much.
    if (isWrong && m_tour.step() == Tour::Step::Export &&
        !m_bench.session().committed().document.operations.empty())
        return tr("<b>Nearly.</b> Drag the round handle at the end of the row back until no badge "
                  "is red; then <b>Export…</b> writes the file for the cutter.");
    return sentenceOf(m_tour.step());
}

void TourGuide::follow()
{
    if (m_tour.isOn()) {
        m_card->say(m_tour.number(), m_tour.count(), sentence());
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
    // A card in the way of a stroke is one too many.
    if (m_tour.isOn())
        m_card->setVisible(!interaction.hasGesture() || m_tour.isDone() ||
                           m_tour.step() > Tour::Step::Cross);
    const bool isAtWork = interaction.hasGesture() || interaction.isAnimating() ||
                          interaction.tool() || QApplication::activeModalWidget() ||
                          QApplication::activePopupWidget();
    if (!m_tour.isOn() || m_tour.isDone() || isAtWork || !m_view.isVisible()) {
        m_hint->showNothing();
        return;
    }
    const QWidget *target = m_targetOf(m_tour.step());
    const bool isThere = target && target->isVisible() && target->isEnabled() &&
                         std::min(target->width(), target->height()) >= kLeastTarget;
    if (isThere)
        m_hint->showRing({target->mapTo(&m_window, QPoint()), target->size()});
    else if (!target)
        m_hint->showWay(wayOf(m_tour.step()).translated(m_view.mapTo(&m_window, QPoint())));
    else
        m_hint->showNothing();
}

QPolygonF TourGuide::wayOf(Tour::Step step) const
{
    switch (step) {
    case Tour::Step::Draw:
        return wayOfBody();
    case Tour::Step::Cross:
        return wayOfSlit();
    case Tour::Step::Turn:
        return wayBeside();
    default:
        return {};
    }
}

QPointF TourGuide::seen(const Vec3 &place) const
{
    const Vec2 at =
        m_bench.interaction().camera().toScreen(place, Vec2(m_view.width(), m_view.height()));
    return {at.x(), at.y()};
}

/// Down to the ground, and a little below it, where it is cut flat.
QPolygonF TourGuide::wayOfBody() const
{
    const double size = std::min(m_view.width(), m_view.height()), half = 0.5 * m_view.height();
    const double ground = std::clamp(seen(Vec3::Zero()).y(), half + 0.1 * size, half + 0.45 * size);
    const double top = std::max(ground - 0.28 * size, underCard());
    return loaf({0.5 * m_view.width() - 0.32 * size, top, 0.64 * size, ground + 0.02 * size - top});
}

/// Where the pointer does not cover the words that go with it.
double TourGuide::underCard() const
{
    constexpr double kBelowCard = 14.0; // px
    return m_card->isHidden() ? 0.0 : m_card->geometry().bottom() + kBelowCard;
}

/// Out of the middle of its upper edge.
QPolygonF TourGuide::wayOfSlit() const
{
    const Model &model = m_bench.session().committed();
    const Section *found = bodyOf(model);
    if (!found)
        return {};
    const Section &body = *found;
    const QPointF centre = seen(worldBounds(*body.shape, body.frame).center());
    double top = centre.y(); // of the body, right above that
    const Polygon outline = body.shape->contour().polygon(kDrawChord);
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const QPointF from = seen(body.frame.toWorld(outline[j])),
                      to = seen(body.frame.toWorld(outline[i]));
        if ((from.x() < centre.x()) == (to.x() < centre.x()))
            continue;
        const double share = (centre.x() - from.x()) / (to.x() - from.x());
        top = std::min(top, from.y() + share * (to.y() - from.y()));
    }
    const double half = 0.5 * (centre.y() - top);
    const double end = std::max(top - std::clamp(half, 24.0, 70.0), underCard());
    constexpr double kLeastOut = 12.0; // px: else it is not seen to leave the body
    if (top - end < kLeastOut)
        return {};
    return {{centre.x(), top + half}, {centre.x(), end}};
}

/// Where nothing of the model is, at the side that has more room.
QPolygonF TourGuide::wayBeside() const
{
    QRectF box;
    for (const SectionPointer &section : m_bench.session().committed().sections()) {
        const Box3 its = worldBounds(*section->shape, section->frame);
        for (int corner = 0; corner < 8; ++corner) {
            const QPointF at =
                seen({(corner & 1 ? its.max : its.min).x(), (corner & 2 ? its.max : its.min).y(),
                      (corner & 4 ? its.max : its.min).z()});
            box = box.isNull() ? QRectF(at, QSizeF(1, 1)) : box.united(QRectF(at, QSizeF(1, 1)));
        }
    }
    constexpr double kAside = 30.0; // px
    const double left = box.left() - 2.0 * kAside,
                 right = m_view.width() - box.right() - 2.0 * kAside;
    const double room = std::min(std::max(left, right), 0.3 * m_view.width());
    if (room < 2.0 * kAside)
        return {}; // the words say it
    const double begin = left > right ? box.left() - kAside - room : box.right() + kAside;
    const double y = 0.72 * m_view.height();
    return {{begin, y}, {begin + 0.5 * room, y - 4.0}, {begin + room, y}};
}

} // namespace fff::ui
