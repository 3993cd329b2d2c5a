#include "ui/sheets/sheets_view.h"

#include "ui/bench/measures.h"
#include "ui/dialogs/sheet_painting.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kSheetsAround = 14.0;   // px, round all of them
constexpr double kMostSheetsZoom = 60.0; // of what fits
constexpr double kSheetsZoomStep = 1.25; // of a key; and of a notch of the wheel
constexpr double kSheetsPanStep = 40.0;  // px
constexpr double kHandleReach = 9.0;     // px, about the handle that turns a part
constexpr int kWheelNotch = 120;         // eighths of a degree

} // namespace

SheetsView::SheetsView(QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("sheetsView"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Sheets, as they will be cut"));
    setAccessibleDescription(tr("Page Up and Page Down go from part to part, the arrow keys move "
                                "a part by 1 mm, R turns it, P pins it. Plus and minus zoom, Home "
                                "shows all sheets."));
}

/// Nothing moves while a part is dragged.
void SheetsView::setContent(SheetsContent content)
{
    if (m_doing == Hand::None)
        setContentNow(std::move(content));
    else
        m_next = std::move(content);
}

void SheetsView::setContentNow(SheetsContent content)
{
    m_next.reset();
    // What was put down lies there until it is laid, or until all is of something else.
    if (!content.isOlder || content.made != m_content.made)
        m_hand.reset();
    m_content = std::move(content);
    m_hovered.reset();
    place();
    drawAgain();
}

void SheetsView::setSelected(const std::vector<SectionRef> &sections)
{
    std::set<SectionRef> next(sections.begin(), sections.end());
    if (next == m_selected)
        return;
    m_selected = std::move(next);
    update();
    if (m_hovered && m_button == Qt::NoButton)
        Q_EMIT hinted(hintAt(m_hovered, false));
}

void SheetsView::setLit(std::optional<SectionRef> section)
{
    if (section == m_lit)
        return;
    m_lit = section;
    update();
}

QRectF SheetsView::room() const
{
    return QRectF(rect()).adjusted(kSheetsAround, 6.0, -kSheetsAround, -kSheetsAround);
}

void SheetsView::place()
{
    std::vector<bool> areTooLarge;
    for (const SheetFacts &facts : m_content.facts)
        areTooLarge.push_back(facts.isTooLarge);
    m_placed = placeSheets(m_content.sheets(), areTooLarge, room().size());
    moveBy({});
}

void SheetsView::fit()
{
    m_zoom = 1.0;
    m_shift = {};
    moveBy({});
}

QRectF SheetsView::rectOf(const PlacedSheet &placed) const
{
    return {room().topLeft() + m_shift + m_zoom * placed.rect.topLeft(),
            m_zoom * placed.rect.size()};
}

QTransform SheetsView::transform(std::size_t sheet) const
{
    const auto placed =
        std::find_if(m_placed.all.begin(), m_placed.all.end(),
                     [sheet](const PlacedSheet &one) { return one.sheet == sheet; });
    QTransform transform;
    if (placed == m_placed.all.end())
        return transform;
    const QRectF where = rectOf(*placed);
    const double scale = where.width() / m_content.sheets()[sheet].size.width();
    transform.translate(where.left(), where.bottom());
    transform.scale(scale, -scale); // y is up on a sheet
    return transform;
}

std::optional<SheetsView::Spot> SheetsView::partAt(const QPointF &place) const
{
    if (m_content.isOlder || m_hand)
        return std::nullopt;
    for (const PlacedSheet &placed : m_placed.all) {
        if (!rectOf(placed).contains(place))
            continue;
        const QPointF onSheet = transform(placed.sheet).inverted().map(place);
        const std::vector<PartPaths> &parts = m_content.sheets()[placed.sheet].parts;
        for (std::size_t i = parts.size(); i-- > 0;)
            if (parts[i].cuts.contains(onSheet))
                return Spot{placed.sheet, i};
    }
    return std::nullopt;
}

/// Of several on each other that which was painted last.
std::optional<SheetsView::Spot> SheetsView::pinAt(const QPointF &place) const
{
    if (m_content.isOlder || m_hand)
        return std::nullopt;
    std::optional<Spot> found;
    for (const PlacedSheet &placed : m_placed.all) {
        const SheetPainting how{transform(placed.sheet), m_content.margin};
        for (std::size_t i = 0; i < m_content.facts[placed.sheet].parts.size(); ++i) {
            const Spot spot{placed.sheet, i};
            if (factsOf(spot).isPinned &&
                QLineF(pinPlace(pathsOf(spot), how), place).length() <= kPinRadius)
                found = spot;
        }
    }
    return found;
}

const PartOnSheet &SheetsView::factsOf(const Spot &spot) const
{
    return m_content.facts[spot.sheet].parts[spot.part];
}

const PartPaths &SheetsView::pathsOf(const Spot &spot) const
{
    return m_content.sheets()[spot.sheet].parts[spot.part];
}

bool SheetsView::isMarked(const Spot &spot) const
{
    return m_hovered == spot || (m_lit && factsOf(spot).section == *m_lit);
}

QString SheetsView::tipOf(const Spot &spot) const
{
    const PartOnSheet &part = factsOf(spot);
    const PartPaths &paths = pathsOf(spot);
    //: a part on a sheet: its number, its section's name, its size, and by how much it is turned
    return tr("%1 %2 \u00B7 %3 \u00B7 turned %4°")
        .arg(QString::number(paths.number), paths.name,
             sizeText({part.size.x(), part.size.y()}, 0, locale()),
             locale().toString(std::lround(part.turn) % 360));
}

void SheetsView::zoomAt(const QPointF &place, double factor)
{
    const double zoom = std::clamp(m_zoom * factor, 1.0, kMostSheetsZoom);
    // What is under the cursor stays there.
    const QPointF from = place - room().topLeft() - m_shift;
    m_shift += from * (1.0 - zoom / m_zoom);
    m_zoom = zoom;
    moveBy({});
}

/// What is smaller than the room stands in its middle, what is larger leaves no gap at its ends.
void SheetsView::moveBy(const QPointF &way)
{
    const QSizeF there = m_zoom * m_placed.size, room = this->room().size();
    const auto within = [](double shift, double size, double space) {
        return size <= space ? 0.5 * (space - size) : std::clamp(shift, space - size, 0.0);
    };
    m_shift += way;
    m_shift = {within(m_shift.x(), there.width(), room.width()),
               within(m_shift.y(), there.height(), room.height())};
    drawAgain();
}

void SheetsView::setHovered(std::optional<Spot> spot)
{
    if (spot == m_hovered)
        return;
    m_hovered = spot;
    update();
    Q_EMIT sectionHovered(spot ? std::optional(factsOf(*spot).section) : std::nullopt);
}

void SheetsView::choose(std::optional<Spot> spot, Qt::KeyboardModifiers keys)
{
    const bool addsTo = keys & (Qt::ControlModifier | Qt::ShiftModifier);
    std::set<SectionRef> next = addsTo ? m_selected : std::set<SectionRef>();
    if (spot) {
        m_keys = {factsOf(*spot).section, factsOf(*spot).body};
        const SectionRef &section = factsOf(*spot).section;
        if (!next.insert(section).second)
            next.erase(section);
    } else if (addsTo) {
        return;
    }
    Q_EMIT selected({next.begin(), next.end()});
}

void SheetsView::chooseNext(int by)
{
    std::vector<std::pair<int, SectionRef>> parts; // by number
    for (std::size_t sheet = 0; sheet < m_content.facts.size(); ++sheet)
        for (std::size_t i = 0; i < m_content.facts[sheet].parts.size(); ++i)
            parts.emplace_back(pathsOf({sheet, i}).number, factsOf({sheet, i}).section);
    if (parts.empty())
        return;
    std::sort(parts.begin(), parts.end());
    const auto count = static_cast<int>(parts.size());
    int at = by > 0 ? -1 : count;
    for (int i = 0; i < count; ++i)
        if (m_selected.contains(parts[static_cast<std::size_t>(i)].second) &&
            (by > 0 || at == count))
            at = i;
    m_keys.reset();
    Q_EMIT selected({parts[static_cast<std::size_t>((at + by + count) % count)].second});
}

void SheetsView::drawAgain()
{
    m_picture = {};
    update();
}

void SheetsView::wheelEvent(QWheelEvent *event)
{
    const QPoint turn = event->angleDelta();
    if (std::abs(turn.x()) > std::abs(turn.y()))
        moveBy({static_cast<double>(turn.x()) / kWheelNotch * kSheetsPanStep, 0.0});
    else
        zoomAt(event->position(),
               std::pow(kSheetsZoomStep, static_cast<double>(turn.y()) / kWheelNotch));
    event->accept();
}

void SheetsView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)
        return;
    m_button = event->button();
    m_isMoved = false;
    m_pressed = m_last = event->position();
    const std::optional<Spot> pin = pinAt(m_pressed);
    m_pressedPin = pin ? std::optional(factsOf(*pin).section) : std::nullopt;
    m_pressedAt = pin ? pin : partAt(m_pressed); // dragged by its pin it goes along
    const std::optional<QPointF> handle = this->handle();
    const bool isOnHandle = handle && QLineF(*handle, m_pressed).length() <= kHandleReach;
    if (event->button() == Qt::LeftButton && isOnHandle) {
        m_pressedAt = partOfKeys();
        if (beginHand())
            m_doing = Hand::Turns;
    }
}

void SheetsView::mouseMoveEvent(QMouseEvent *event)
{
    if (m_button == Qt::NoButton) {
        hover(event->position());
        return;
    }
    const QPointF way = event->position() - m_pressed;
    m_isMoved = m_isMoved || way.manhattanLength() >= QApplication::startDragDistance();
    const bool moves = m_button == Qt::MiddleButton || !m_pressedAt;
    if (m_isMoved && !moves && m_doing == Hand::None && beginHand())
        m_doing = Hand::Drags;
    if (m_doing == Hand::Drags)
        moveHand(event->position());
    else if (m_doing == Hand::Turns)
        turnHand(event->position(), event->modifiers() & Qt::ControlModifier);
    else if (m_isMoved && moves) {
        setCursor(Qt::ClosedHandCursor);
        moveBy(event->position() - m_last);
    }
    m_last = event->position();
}

void SheetsView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != m_button)
        return;
    unsetCursor();
    m_button = Qt::NoButton;
    if (m_doing != Hand::None)
        endHand(true);
    else if (event->button() == Qt::LeftButton && !m_isMoved && m_pressedPin)
        Q_EMIT letGo({*m_pressedPin});
    else if (event->button() == Qt::LeftButton && !m_isMoved)
        choose(m_pressedAt, event->modifiers());
}

void SheetsView::hover(const QPointF &place)
{
    const std::optional<Spot> pin = pinAt(place);
    setHovered(pin ? pin : partAt(place));
    Q_EMIT hinted(hintAt(m_hovered, pin.has_value()));
    if (pin)
        setCursor(Qt::PointingHandCursor);
    else
        unsetCursor();
}

void SheetsView::leaveEvent(QEvent *)
{
    setHovered(std::nullopt);
    Q_EMIT hinted({});
}

void SheetsView::keyPressEvent(QKeyEvent *event)
{
    if (handKey(*event))
        return;
    switch (event->key()) {
    case Qt::Key_Home:
        return fit();
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoomAt(room().center(), kSheetsZoomStep);
    case Qt::Key_Minus:
        return zoomAt(room().center(), 1.0 / kSheetsZoomStep);
    case Qt::Key_Left:
        return moveBy({kSheetsPanStep, 0.0});
    case Qt::Key_Right:
        return moveBy({-kSheetsPanStep, 0.0});
    case Qt::Key_Up:
        return moveBy({0.0, kSheetsPanStep});
    case Qt::Key_Down:
        return moveBy({0.0, -kSheetsPanStep});
    case Qt::Key_PageDown:
        return chooseNext(1);
    case Qt::Key_PageUp:
        return chooseNext(-1);
    default:
        QWidget::keyPressEvent(event);
    }
}

void SheetsView::resizeEvent(QResizeEvent *)
{
    place();
}

void SheetsView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        drawAgain();
    QWidget::changeEvent(event);
}

bool SheetsView::event(QEvent *event)
{
    // Home is the window's, and Esc is everybody's: while a part is dragged it is for that.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool isHome = key->key() == Qt::Key_Home && key->modifiers() == Qt::NoModifier;
        if (isHome || (key->key() == Qt::Key_Escape && m_doing != Hand::None)) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        const auto spot = partAt(help->pos());
        QString tip = spot ? tipOf(*spot).toHtmlEscaped() : QString();
        if (pinAt(help->pos()))
            tip = tr("Pinned: stays where it lies. Click to unpin it.");
        QToolTip::showText(help->globalPos(), tip, this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace fff::ui
