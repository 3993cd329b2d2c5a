#include "ui/base/theme.h"
#include "ui/dialogs/sheet_painting.h"
#include "ui/sheets/sheets_view.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr double kOlderSheets = 0.4;                        // opacity
constexpr double kCaptionLine = 16.0, kCaptionAbove = 18.0; // px

} // namespace

/// "Sheet 1 of 2 · 81 parts · 73.3 % used", and at the right that parts keep to the grain.
void SheetsView::paintCaption(const PlacedSheet &placed, QPainter &painter) const
{
    const QRectF where = rectOf(placed);
    const SheetFacts &facts = m_content.facts[placed.sheet];
    QRectF line(where.left(), where.top() - kCaptionAbove, where.width(), kCaptionLine);
    const QString which = facts.isOffcut ? tr("Offcut, sheet %1 of %2") : tr("Sheet %1 of %2");
    QString head = which.arg(placed.number).arg(placed.of);
    if (!facts.stock.isEmpty())
        head = facts.stock + QStringLiteral(" \u00B7 ") + head;
    if (placed.isTooLarge)
        head = tr("Too large");
    QFont bold = font();
    bold.setBold(true);
    const QFontMetricsF metrics(bold);
    painter.setFont(bold);
    painter.setPen(placed.isTooLarge ? theme().problem : theme().text);
    head = metrics.elidedText(head, Qt::ElideRight, std::max(line.width(), 48.0));
    painter.drawText(QRectF(line.topLeft(), QSizeF(std::max(line.width(), 60.0), line.height())),
                     Qt::AlignLeft | Qt::AlignVCenter, head);
    painter.setFont(font());
    if (placed.isTooLarge)
        return;
    painter.setPen(theme().muted);
    if (m_content.hasGrain) {
        const QString grain = tr("grain \u2194");
        const double width = painter.fontMetrics().horizontalAdvance(grain);
        if (width + 8.0 < line.width() - metrics.horizontalAdvance(head)) {
            painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, grain);
            line.setRight(line.right() - width - 8.0);
        }
    }
    line.setLeft(line.left() + metrics.horizontalAdvance(head));
    const QString rest =
        //: behind "Sheet 1 of 2": %n parts lie on it, and cover so much of it
        tr(" \u00B7 %n part(s) \u00B7 %1 % used", nullptr, static_cast<int>(facts.parts.size()))
            .arg(locale().toString(100.0 * facts.usedShare, 'f', 1));
    if (line.width() > 24.0)
        painter.drawText(
            line, Qt::AlignLeft | Qt::AlignVCenter,
            painter.fontMetrics().elidedText(rest, Qt::ElideRight, static_cast<int>(line.width())));
}

SheetPainting SheetsView::paintingOf(const PlacedSheet &placed) const
{
    SheetPainting how{transform(placed.sheet), m_content.margin};
    how.hasGrain = m_content.hasGrain;
    how.isTooLarge = placed.isTooLarge;
    for (const PartOnSheet &part : m_content.facts[placed.sheet].parts)
        how.looks.push_back({part.isPinned, part.keepsToGrain, false});
    if (m_hand && m_hand->spot().sheet == placed.sheet)
        how.looks[m_hand->spot().part].isLeftOut = true;
    return how;
}

void SheetsView::paintHand(QPainter &painter) const
{
    const SheetSpot &spot = m_hand->spot();
    const SheetPainting how{m_hand->way() *
                            transform(static_cast<std::size_t>(m_hand->now().sheet))};
    paintHeld(pathsOf(spot), how, m_hand->isSound(), painter);
}

/// A ring over the box of the part that is selected, to turn it by.
void SheetsView::paintHandle(QPainter &painter) const
{
    const std::optional<QPointF> at = handle();
    if (!at)
        return;
    constexpr double kRing = 7.0, kDot = 2.0; // px
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme().accent, 2.0));
    painter.setBrush(theme().panel);
    painter.drawEllipse(*at, kRing, kRing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().accent);
    painter.drawEllipse(*at, kDot, kDot);
    painter.restore();
}

void SheetsView::paintAll()
{
    m_picture = QPixmap(size() * devicePixelRatioF());
    m_picture.setDevicePixelRatio(devicePixelRatioF());
    m_picture.fill(theme().viewStyle().bottom);
    QPainter painter(&m_picture);
    painter.setFont(font());
    for (const PlacedSheet &placed : m_placed.all) {
        const QRectF seen = rectOf(placed).adjusted(0.0, -kSheetCaption, 0.0, 0.0);
        if (!seen.intersects(QRectF(rect())))
            continue;
        painter.setOpacity(m_content.isOlder && !m_hand ? kOlderSheets : 1.0);
        paintSheet(m_content.sheets()[placed.sheet], paintingOf(placed), painter);
        painter.setOpacity(1.0);
        paintCaption(placed, painter);
    }
}

void SheetsView::paintMarks(QPainter &painter) const
{
    for (const PlacedSheet &placed : m_placed.all) {
        const SheetPainting how{transform(placed.sheet), m_content.margin};
        for (std::size_t i = 0; i < m_content.facts[placed.sheet].parts.size(); ++i) {
            const Spot spot{placed.sheet, i};
            if (m_selected.contains(factsOf(spot).section))
                paintChosen(pathsOf(spot), how, painter);
            else if (isMarked(spot))
                paintHovered(pathsOf(spot), how, painter);
        }
    }
}

void SheetsView::paintEvent(QPaintEvent *)
{
    if (m_picture.isNull())
        paintAll();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_picture);
    if (!m_content.isOlder && !m_hand) {
        paintMarks(painter);
        paintHandle(painter);
    }
    if (m_hand)
        paintHand(painter);
    if (!m_content.note.isEmpty()) {
        painter.setPen(theme().muted);
        painter.drawText(QRectF(rect()).adjusted(24, 24, -24, -24),
                         Qt::AlignCenter | Qt::TextWordWrap, m_content.note);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(hasFocus() ? QPen(theme().accent, 2.0) : QPen(theme().border, 1.0));
    const double inset = hasFocus() ? 1.0 : 0.5;
    painter.drawRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset));
}

} // namespace fff::ui
