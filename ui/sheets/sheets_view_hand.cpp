#include "core/base/units.h"
#include "ui/sheets/sheets_view.h"

#include <QKeyEvent>
#include <QLineF>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kSnapReach = 8.0, kMostSnap = 15.0;  // px; mm, however small sheets are shown
constexpr double kArrowWay = 1.0;                     // mm
constexpr double kTurnByKey = 90.0, kFineTurn = 15.0; // degrees
constexpr double kHandleAbove = 15.0;                 // px, over the box of its part

double degreesTo(const Vec2 &way)
{
    return degrees(std::atan2(way.y(), way.x()));
}

} // namespace

std::vector<SheetsView::Spot> SheetsView::selectedParts() const
{
    std::vector<Spot> spots;
    for (std::size_t sheet = 0; sheet < m_content.facts.size(); ++sheet) {
        if (m_content.facts[sheet].isTooLarge)
            continue;
        for (std::size_t i = 0; i < m_content.facts[sheet].parts.size(); ++i)
            if (m_selected.contains(m_content.facts[sheet].parts[i].section))
                spots.push_back({sheet, i});
    }
    return spots;
}

/// Of those that are selected the one that was clicked, else the only one.
std::optional<SheetsView::Spot> SheetsView::partOfKeys() const
{
    const std::vector<Spot> spots = selectedParts();
    for (const Spot &spot : spots)
        if (m_keys && m_keys->first == factsOf(spot).section &&
            m_keys->second == factsOf(spot).body)
            return spot;
    return spots.size() == 1 ? std::optional(spots.front()) : std::nullopt;
}

QString SheetsView::hintAt(const std::optional<Spot> &spot, bool isPin) const
{
    if (!spot)
        return tr("Drag a part elsewhere, or click it to select it.");
    const QString name = pathsOf(*spot).name.toHtmlEscaped();
    if (isPin)
        //: %1 is the name of a section
        return tr("Click to unpin <b>%1</b>.").arg(name);
    if (m_content.facts[spot->sheet].isTooLarge)
        //: %1 is the name of a section
        return tr("<b>%1</b> is too large for its sheet. Click to select it.").arg(name);
    if (partOfKeys() != spot)
        //: %1 is the name of a section
        return tr("Drag <b>%1</b> elsewhere, or click to select it.").arg(name);
    //: %1 is the name of a section
    return tr("Drag <b>%1</b> elsewhere. <kbd>R</kbd> turns it, <kbd>P</kbd> pins it.").arg(name);
}

std::optional<QPointF> SheetsView::handle() const
{
    const std::optional<Spot> spot = partOfKeys();
    if (!spot || m_content.isOlder || m_hand || !turningStep(factsOf(*spot).turning))
        return std::nullopt;
    const QRectF box = transform(spot->sheet).map(pathsOf(*spot).cuts).boundingRect();
    return QPointF(box.center().x(), box.top() - kHandleAbove);
}

std::optional<int> SheetsView::sheetAt(const QPointF &place) const
{
    for (const PlacedSheet &placed : m_placed.all)
        if (!placed.isTooLarge && rectOf(placed).contains(place))
            return static_cast<int>(placed.sheet);
    return std::nullopt;
}

Vec2 SheetsView::onSheet(const QPointF &place, int sheet) const
{
    const QPointF there = transform(static_cast<std::size_t>(sheet)).inverted().map(place);
    return {there.x(), there.y()};
}

/// The part that was pressed.
bool SheetsView::beginHand()
{
    if (!m_pressedAt || m_button != Qt::LeftButton || m_content.isOlder || m_hand ||
        m_content.facts[m_pressedAt->sheet].isTooLarge)
        return false;
    const Spot spot = *m_pressedAt;
    setHovered(std::nullopt);
    m_keys = {factsOf(spot).section, factsOf(spot).body};
    m_hand.emplace(m_content, spot);
    m_grabbed = onSheet(m_pressed, m_hand->from().sheet) - m_hand->from().offset;
    m_turnedFrom = m_hand->from();
    const QPointF middle = m_hand->middle();
    m_turnedAt = degreesTo(onSheet(m_pressed, m_hand->from().sheet) - Vec2(middle.x(), middle.y()));
    if (!m_selected.contains(m_hand->part().section))
        Q_EMIT selected({m_hand->part().section});
    drawAgain();
    return true;
}

/// Between sheets it goes on as on the last one.
void SheetsView::moveHand(const QPointF &place)
{
    const int under = sheetAt(place).value_or(m_hand->now().sheet);
    const int sheet = m_hand->takes(under) ? under : m_hand->now().sheet;
    const double scale = transform(static_cast<std::size_t>(sheet)).m11(); // px a mm
    const double reach = std::min(kSnapReach / scale, kMostSnap);
    m_hand->moveTo(sheet, onSheet(place, sheet) - m_grabbed, reach);
    setCursor(m_hand->isSound() ? Qt::ClosedHandCursor : Qt::ForbiddenCursor);
    update();
}

void SheetsView::turnHand(const QPointF &place, bool isInSteps)
{
    const QPointF middle = m_hand->middle();
    const Vec2 way = onSheet(place, m_hand->now().sheet) - Vec2(middle.x(), middle.y());
    const double allowed = turningStep(m_hand->part().turning).value_or(0.0);
    const double step = std::max(allowed, isInSteps ? kFineTurn : 0.0);
    double by = degreesTo(way) - m_turnedAt;
    if (isInSteps && allowed == 0.0) {
        const double before = degreesTo(m_turnedFrom.turn);
        by = kFineTurn * std::round((before + by) / kFineTurn) - before;
    } else if (step > 0.0) {
        by = step * std::round(by / step);
    }
    m_hand->turnFrom(m_turnedFrom, by);
    update();
}

/// Where it has no room it goes back.
void SheetsView::endHand(bool isKept)
{
    unsetCursor();
    const bool hadRoom = m_hand->isSound();
    m_doing = Hand::None;
    if (isKept && hadRoom && m_hand->isMoved()) {
        const PinnedPlace place = m_hand->place();
        if (m_next)
            m_content.isOlder = true; // what comes is of the place that follows
        m_next.reset();
        update();
        Q_EMIT placed(place, false);
        return;
    }
    m_hand.reset();
    drawAgain();
    if (m_next)
        setContentNow(std::move(*m_next));
    if (isKept && !hadRoom)
        Q_EMIT refused(tr("There is no room for it."));
}

/// The part that keys are for: where it was just put, else where it lies. False: there is none.
bool SheetsView::holdByKey()
{
    const std::optional<Spot> spot = partOfKeys();
    if (m_hand || !spot || m_content.isOlder)
        return m_hand && m_hand->spot() == spot;
    m_hand.emplace(m_content, *spot);
    return true;
}

/// Nothing changes where it has no room.
void SheetsView::putByKey(const HandPlace &before)
{
    const bool hasRoom = m_hand->isSound();
    if (!hasRoom && before == m_hand->from())
        m_hand.reset();
    else if (!hasRoom)
        m_hand->put(before);
    drawAgain();
    if (hasRoom)
        Q_EMIT placed(m_hand->place(), true);
    else
        Q_EMIT refused(tr("There is no room for it."));
}

void SheetsView::nudge(const Vec2 &way)
{
    if (!holdByKey())
        return;
    const HandPlace before = m_hand->now();
    m_hand->moveBy(way);
    putByKey(before);
}

void SheetsView::turnByKey(bool isFine)
{
    const std::optional<Spot> spot = partOfKeys();
    if (!spot)
        return;
    const std::optional<double> allowed = turningStep(factsOf(*spot).turning);
    if (!allowed || (isFine && *allowed > 0.0)) {
        Q_EMIT refused(allowed ? tr("It may not be turned by so little.")
                               : tr("It lies as it is drawn."));
        return;
    }
    if (!holdByKey())
        return;
    const HandPlace before = m_hand->now();
    m_hand->turnBy(isFine ? kFineTurn : std::max(kTurnByKey, *allowed));
    putByKey(before);
}

/// All of them, unless all are pinned already.
void SheetsView::togglePins()
{
    if (m_content.isOlder)
        return;
    std::vector<PinnedPlace> loose;
    std::vector<SectionRef> sections;
    for (const Spot &spot : selectedParts()) {
        const PartOnSheet &part = factsOf(spot);
        if (!part.isPinned)
            loose.push_back(placeOf(m_content, spot));
        if (std::find(sections.begin(), sections.end(), part.section) == sections.end())
            sections.push_back(part.section);
    }
    if (!loose.empty())
        Q_EMIT pinned(loose);
    else if (!sections.empty())
        Q_EMIT letGo(sections);
}

/// What keys do with parts; false: nothing.
bool SheetsView::handKey(const QKeyEvent &event)
{
    if (m_doing != Hand::None) {
        if (event.key() == Qt::Key_Escape)
            endHand(false);
        return true;
    }
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier) ||
        selectedParts().empty())
        return false;
    const bool isShift = event.modifiers() & Qt::ShiftModifier;
    switch (event.key()) {
    case Qt::Key_Left:
        nudge({-kArrowWay, 0.0});
        return true;
    case Qt::Key_Right:
        nudge({kArrowWay, 0.0});
        return true;
    case Qt::Key_Up:
        nudge({0.0, kArrowWay});
        return true;
    case Qt::Key_Down:
        nudge({0.0, -kArrowWay});
        return true;
    case Qt::Key_R:
        turnByKey(isShift);
        return true;
    case Qt::Key_P:
        if (isShift)
            return false;
        togglePins();
        return true;
    default:
        return false;
    }
}

} // namespace fff::ui
