#include "ui/dialogs/sheet_painting.h"

#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/measures.h"
#include "ui/view/heading_weight.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

struct SheetPaintingTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::SheetView)
};

/// What is engraved is read as it is from so many px a mm on: the numbers of joints are 3 mm high.
/// Before, a part's own number stands there in a font.
constexpr double kReadableScale = 2.5;
constexpr double kGapToBar = 10.0;  // mm, as between sheets in a file
constexpr QSizeF kBar(100.0, 10.0); // mm, the writers'
constexpr double kHoverWidth = 2.0; // px
constexpr float kHoverAlpha = 0.6F, kFillAlpha = 0.16F, kHeldAlpha = 0.85F;
constexpr double kGrainStep = 12.0;   // mm
constexpr double kBesideWhole = 16.0; // px, before the words of what stays whole
const QColor kWhole(0x1E, 0x6B, 0x2E);

/// The material's, whatever the theme; in high contrast black on white but for what is cut.
struct SheetColours
{
    QColor ground{0xFC, 0xF6, 0xEA}, edge{0x9B, 0x83, 0x58}, margin{0xC9, 0xB8, 0x8F};
    QColor part{0xF3, 0xE3, 0xC3}, cut{0xDB, 0x6A, 0x63}, number{0x1F, 0x43, 0x96};
    QColor pinned{0xEB, 0xD9, 0xB2}, engraved{0x3A, 0x2E, 0x1C}, scored{0x2E, 0x7D, 0x32},
        grain{0xE6, 0xD6, 0xB4};
    double cutWidth = 0.8; // px
};

SheetColours sheetColours()
{
    SheetColours colours;
    if (theme().isHighContrast) {
        colours.ground = colours.part = colours.grain = colours.pinned = Qt::white;
        colours.edge = colours.engraved = Qt::black;
        colours.margin = QColor(0x55, 0x55, 0x55);
        colours.cut = QColor(0xB0, 0x00, 0x00);
        colours.number = QColor(0x00, 0x00, 0x8B);
        colours.scored = QColor(0x00, 0x5A, 0x00);
        colours.cutWidth = 1.4;
    }
    return colours;
}

QPen hairline(const QColor &colour, double width, Qt::PenStyle style = Qt::SolidLine)
{
    QPen pen(colour, width, style);
    pen.setCosmetic(true);
    pen.setJoinStyle(Qt::RoundJoin);
    return pen;
}

double scaleOf(const QTransform &transform)
{
    return std::sqrt(std::abs(transform.determinant()));
}

void paintNumber(const PartPaths &part, const QTransform &transform, QPainter &painter)
{
    const int size = digitsThatFit(part, transform, painter.font());
    if (size == 0)
        return;
    const QFont before = painter.font();
    QFont font = before;
    font.setPixelSize(size);
    font.setBold(true);
    painter.setFont(font);
    const QPointF middle = transform.map(part.roomiest);
    painter.drawText(QRectF(middle.x() - 50.0, middle.y() - size, 100.0, 2.0 * size),
                     Qt::AlignCenter, QString::number(part.number));
    painter.setFont(before);
}

/// The pen is that of numbers.
void paintLabel(const PartPaths &part, const QTransform &transform, QPainter &painter)
{
    painter.drawPath(transform.map(part.label));
    for (const auto &[colour, path] : part.jointLabels) {
        painter.setPen(hairline(QColor::fromRgb(colour), 1.0));
        painter.drawPath(transform.map(path));
    }
}

constexpr double kBeside = 22.0; // px, of what stands beside a number

bool hasRoomFor(const PartPaths &part, const SheetPainting &how, const QPointF &at)
{
    const QRectF box(at - QPointF(kPinRadius, kPinRadius),
                     QSizeF(2.0 * kPinRadius, 2.0 * kPinRadius));
    return part.cuts.contains(how.transform.inverted().mapRect(box));
}

void paintPin(const QPointF &at, QPainter &painter)
{
    const int side = static_cast<int>(1.5 * kPinRadius);
    painter.setPen(hairline(theme().border, 1.0));
    painter.setBrush(theme().panel);
    painter.drawEllipse(at, kPinRadius, kPinRadius);
    painter.drawPixmap(at - 0.5 * QPointF(side, side),
                       tintedPixmap(QStringLiteral("pin"), side, theme().text,
                                    painter.device()->devicePixelRatioF()));
}

/// That it is pinned; and before its number, where there is room, that it keeps to the grain.
void paintLook(const PartPaths &part, const PartLook &look, const SheetPainting &how,
               QPainter &painter)
{
    constexpr double kHead = 3.0; // px
    if (look.isPinned)
        paintPin(pinPlace(part, how), painter);
    const QPointF at = how.transform.map(part.roomiest) - QPointF(kBeside, 0.0);
    if (!look.keepsToGrain || !hasRoomFor(part, how, at))
        return;
    painter.setPen(hairline(sheetColours().edge, 1.5));
    const QPointF end(kPinRadius, 0.0);
    painter.drawLine(at - end, at + end);
    for (const double way : {-1.0, 1.0})
        for (const double up : {-kHead, kHead})
            painter.drawLine(at + way * end,
                             at + way * (end - QPointF(kHead, 0.0)) + QPointF(0.0, up));
}

void paintGrain(const SheetPaths &sheet, const SheetPainting &how, QPainter &painter)
{
    for (double y = kGrainStep; y < sheet.size.height(); y += kGrainStep)
        painter.drawLine(how.transform.map(QPointF(0.0, y)),
                         how.transform.map(QPointF(sheet.size.width(), y)));
}

void paintGround(const SheetPaths &sheet, const SheetPainting &how, const SheetColours &colours,
                 QPainter &painter)
{
    const QRectF whole(QPointF(), sheet.size);
    QPainterPath edge = how.transform.map(sheet.outline);
    if (sheet.outline.isEmpty())
        edge.addRect(how.transform.mapRect(whole));
    painter.fillPath(edge, colours.ground);
    painter.setBrush(Qt::NoBrush);
    if (how.hasGrain) {
        painter.save();
        painter.setClipPath(edge, Qt::IntersectClip);
        painter.setPen(hairline(colours.grain, 1.0));
        paintGrain(sheet, how, painter);
        painter.restore();
    }
    if (const double m = how.margin; m > 0.0 && sheet.outline.isEmpty()) {
        painter.setPen(hairline(colours.margin, 1.0, Qt::DashLine));
        painter.drawRect(how.transform.mapRect(whole.adjusted(m, m, -m, -m)));
    }
    painter.setPen(hairline(colours.edge, 1.0));
    painter.drawPath(edge);
}

/// What can be put aside for another time.
void paintWhole(const SheetPaths &sheet, const SheetPainting &how, QPainter &painter)
{
    const QRectF strip(0.0, sheet.wholeFrom, sheet.size.width(),
                       sheet.size.height() - sheet.wholeFrom);
    painter.setPen(hairline(kWhole, 1.0, Qt::DashLine));
    painter.drawLine(how.transform.map(strip.topLeft()), how.transform.map(strip.topRight()));
    const QString size = sizeText({strip.width(), strip.height()}, 0, QLocale());
    //: %1 is the size of what is left of a sheet
    const QString text = SheetPaintingTexts::tr("Offcut %1 stays whole").arg(size);
    const QRectF room = how.transform.mapRect(strip).adjusted(kBesideWhole, 0.0, 0.0, 0.0);
    const QFont before = painter.font();
    QFont font = before;
    font.setPixelSize(kMostDigits);
    font.setWeight(headingWeight());
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    if (metrics.height() < room.height() && metrics.horizontalAdvance(text) < room.width())
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, text);
    painter.setFont(before);
}

void paintReference(const SheetPainting &how, QPainter &painter)
{
    const QRectF bar = how.transform.mapRect(referenceBar());
    painter.setPen(hairline(theme().muted, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);
    const QString text = SheetPaintingTexts::tr("%1 mm, to check the size").arg(kBar.width());
    const QFontMetricsF metrics(painter.font());
    painter.setPen(theme().text);
    // In the bar where there is room for it, else beside it.
    if (metrics.horizontalAdvance(text) + 8.0 < bar.width() && metrics.height() < bar.height())
        painter.drawText(bar, Qt::AlignCenter, text);
    else
        painter.drawText(QRectF(bar.right() + 8.0, bar.center().y() - metrics.height(), 2000.0,
                                2.0 * metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, text);
}

} // namespace

QRectF referenceBar()
{
    return {QPointF(0.0, -kGapToBar - kBar.height()), kBar};
}

/// Beside or below the number where there is room; else over a corner of the part's box, so that
/// each pinned part has its pin, however slim it is.
QPointF pinPlace(const PartPaths &part, const SheetPainting &how)
{
    const QPointF middle = how.transform.map(part.roomiest);
    if (part.hasNumber)
        for (const QPointF &off : {QPointF(kBeside, 0.0), QPointF(0.0, kBeside),
                                   QPointF(0.0, -kBeside), QPointF(-kBeside, 0.0)})
            if (hasRoomFor(part, how, middle + off))
                return middle + off;
    return how.transform.map(part.cuts).boundingRect().topRight();
}

int digitsThatFit(const PartPaths &part, const QTransform &transform, const QFont &font)
{
    if (!part.hasNumber)
        return 0;
    const QTransform back = transform.inverted();
    const QPointF middle = transform.map(part.roomiest);
    QFont sized = font;
    sized.setBold(true);
    for (int size = kMostDigits; size >= kLeastDigits; --size) {
        sized.setPixelSize(size);
        const QRectF text = QFontMetricsF(sized).tightBoundingRect(QString::number(part.number));
        QRectF box(QPointF(), text.size() + QSizeF(2.0, 2.0));
        box.moveCenter(middle);
        if (part.cuts.contains(back.mapRect(box)))
            return size;
    }
    return 0;
}

void paintSheet(const SheetPaths &sheet, const SheetPainting &how, QPainter &painter)
{
    SheetColours colours = sheetColours();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (how.isTooLarge) {
        colours.part = theme().problemSoft;
        colours.cut = colours.number = theme().problem;
    } else {
        paintGround(sheet, how, colours, painter);
        if (sheet.wholeFrom > 0.0)
            paintWhole(sheet, how, painter);
    }
    const bool isReadable = scaleOf(how.transform) >= kReadableScale;
    for (std::size_t i = 0; i < sheet.parts.size(); ++i) {
        const PartPaths &part = sheet.parts[i];
        const PartLook look = i < how.looks.size() ? how.looks[i] : PartLook();
        if (look.isLeftOut)
            continue;
        painter.setPen(Qt::NoPen);
        painter.setBrush(look.isPinned ? colours.pinned : colours.part);
        painter.drawPath(how.transform.map(part.cuts));
        painter.setBrush(Qt::NoBrush);
        painter.setPen(hairline(colours.cut, colours.cutWidth));
        painter.drawPath(how.transform.map(cutLines(part)));
        painter.setPen(hairline(colours.engraved, 0.8));
        painter.drawPath(how.transform.map(part.engraved));
        painter.setPen(hairline(colours.scored, 0.8));
        painter.drawPath(how.transform.map(part.scored));
        painter.setPen(hairline(colours.number, 1.0));
        if (isReadable)
            paintLabel(part, how.transform, painter);
        else
            paintNumber(part, how.transform, painter);
    }
    // Over all parts: a pin may reach into the next one.
    for (std::size_t i = 0; i < std::min(sheet.parts.size(), how.looks.size()); ++i)
        if (!how.looks[i].isLeftOut)
            paintLook(sheet.parts[i], how.looks[i], how, painter);
    if (how.hasReference)
        paintReference(how, painter);
    painter.restore();
}

void paintHovered(const PartPaths &part, const SheetPainting &how, QPainter &painter)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor accent = theme().accent;
    accent.setAlphaF(kHoverAlpha);
    painter.setPen(hairline(accent, kHoverWidth));
    accent.setAlphaF(kFillAlpha);
    painter.setBrush(accent);
    painter.drawPath(how.transform.map(part.cuts));
    painter.restore();
}

void paintHeld(const PartPaths &part, const SheetPainting &how, bool isSound, QPainter &painter)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QPainterPath cuts = how.transform.map(part.cuts);
    QColor fill = sheetColours().part;
    if (!isSound)
        fill = theme().problemSoft;
    fill.setAlphaF(kHeldAlpha);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPath(cuts);
    painter.setPen(hairline(isSound ? theme().accent : theme().problem, kHoverWidth));
    painter.setBrush(isSound ? QBrush(Qt::NoBrush) : QBrush(theme().problem, Qt::BDiagPattern));
    painter.drawPath(cuts);
    painter.restore();
}

void paintChosen(const PartPaths &part, const SheetPainting &how, QPainter &painter)
{
    constexpr double kAround = 3.0; // px
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor accent = theme().accent;
    painter.setPen(hairline(accent, kHoverWidth));
    accent.setAlphaF(kFillAlpha);
    painter.setBrush(accent);
    const QPainterPath cuts = how.transform.map(part.cuts);
    painter.drawPath(cuts);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(hairline(theme().accent, 1.0, Qt::DashLine));
    painter.drawRect(cuts.boundingRect().adjusted(-kAround, -kAround, kAround, kAround));
    painter.restore();
}

} // namespace fff::ui
