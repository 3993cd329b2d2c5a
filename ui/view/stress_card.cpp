#include "ui/view/stress_card.h"

#include "core/analysis/weak_place.h"
#include "core/session/message_text.h"
#include "ui/view/heading_weight.h"
#include "ui/view/stress_marks.h"

#include <QCoreApplication>
#include <QLineF>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fff::ui {

namespace {

struct CardTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::StressCard)
};

constexpr double kCardWidth = 300.0, kCardPad = 12.0, kCardRow = 20.0; // px
constexpr double kNeckHeight = 92.0;                                   // px
constexpr double kNeckShare = 0.45;  // of that, how long the neck is drawn
constexpr double kBesideLine = 30.0; // px between the place and the card
constexpr double kToEdge = 8.0;      // px between the card and the view's edge
constexpr double kRingRadius = 12.0; // px, of the ring round the place
constexpr double kLeader = 1.4;      // px
/// A px² of what is kept free weighs as so many of what is explained; so does a px of the way.
constexpr double kOnOthers = 4.0, kWay = 20.0;
constexpr double kLeastPart = 0.02; // of the worst stress: less is left out
constexpr double kRoundScale[] = {1.0, 2.0, 5.0};

QString megapascals(double stress, double limit, const QLocale &locale)
{
    //: %1 is a stress in megapascals, %2 a number of percent
    return CardTexts::tr("%1\u202fMPa, %2\u202f%")
        .arg(locale.toString(stress, 'g', 3), locale.toString(100.0 * stress / limit, 'f', 0));
}

QString inNewtons(double force, const QLocale &locale)
{
    return locale.toString(std::abs(force), 'g', 3) + QStringLiteral("\u202fN");
}

QString newtonMillimetres(double moment, const QLocale &locale)
{
    return locale.toString(std::abs(moment), 'g', 3) + QStringLiteral("\u202fN·mm");
}

/// A length that is written easily, no longer than `most` mm.
double roundLength(double most)
{
    double length = std::pow(10.0, std::floor(std::log10(most)));
    double best = length;
    for (const double step : kRoundScale)
        if (step * length <= most)
            best = step * length;
    return best;
}

/// The piece around the neck, flat, the neck upright in the middle.
void paintNeck(MarkPen &pen, const Analysis &analysis, const StressLine &line, const QRectF &box,
               const QLocale &locale)
{
    QPainter &painter = pen.painter();
    painter.save();
    painter.setClipRect(box);
    painter.fillRect(box, pen.style().bottom);
    const NeckStress &neck = line.stress;
    const Vec2 way = neck.end - neck.begin;
    const double scale = kNeckShare * box.height() / std::max(way.norm(), 0.1); // px per mm
    QTransform flat;
    flat.translate(box.center().x(), box.center().y());
    flat.scale(scale, -scale);
    flat.rotateRadians(0.5 * std::numbers::pi - std::atan2(way.y(), way.x()));
    const Vec2 middle = 0.5 * (neck.begin + neck.end);
    flat.translate(-middle.x(), -middle.y());
    const Region &region = analysis.bodies.at(line.body).outline().region;
    QPainterPath piece;
    const auto add = [&piece](const Polygon &ring) {
        QPolygonF points;
        for (const Vec2 &p : ring)
            points << QPointF(p.x(), p.y());
        piece.addPolygon(points);
        piece.closeSubpath();
    };
    add(region.outer);
    for (const Polygon &hole : region.holes)
        add(hole);
    const StockLook look = stockLook(
        analysis.model.stockOf(static_cast<std::size_t>(analysis.bodies.sectionOf(line.body))));
    const QPainterPath seen = flat.map(piece);
    painter.fillPath(seen, look.face);
    painter.strokePath(seen, QPen(pen.style().edge, 1.0));
    QPainterPath cut(flat.map(QPointF(neck.begin.x(), neck.begin.y())));
    cut.lineTo(flat.map(QPointF(neck.end.x(), neck.end.y())));
    pen.cased(cut, roundPen(stressColour(line.use, pen.style().isForColourBlind), 3.0));
    const double bar = roundLength(0.3 * box.width() / scale);
    const QPointF end = box.bottomRight() - QPointF(8.0, 8.0);
    QPainterPath scaleBar(end);
    scaleBar.lineTo(end - QPointF(bar * scale, 0.0));
    pen.cased(scaleBar, QPen(pen.style().text, 1.4));
    const QString length = locale.toString(bar, 'g', 3) + QStringLiteral("\u202fmm");
    const double width = QFontMetricsF(painter.font()).horizontalAdvance(length);
    QPainterPath words; // on the stock or beside it
    words.addText(end - QPointF(width, 6.0), painter.font(), length);
    painter.strokePath(words, roundPen(pen.style().panel, 3.0));
    painter.fillPath(words, pen.style().text);
    painter.restore();
}

double areaOf(const QRectF &box)
{
    return box.isValid() ? box.width() * box.height() : 0.0;
}

} // namespace

QRectF cardPlace(const QSizeF &size, const QPointF &place, const QRectF &around, const MarkPen &pen)
{
    const QRectF view = QRectF(0.0, 0.0, pen.viewport().x(), pen.viewport().y())
                            .adjusted(kToEdge, kToEdge, -kToEdge, -kToEdge);
    const QRectF ring =
        QRectF(place, QSizeF()).adjusted(-kBesideLine, -kBesideLine, kBesideLine, kBesideLine);
    const auto inView = [&view](QRectF card) {
        card.moveLeft(std::max(view.left(), std::min(card.left(), view.right() - card.width())));
        card.moveTop(std::max(view.top(), std::min(card.top(), view.bottom() - card.height())));
        return card;
    };
    QRectF best;
    double least = std::numeric_limits<double>::infinity();
    // Beside all of it, else beside the place alone.
    for (const QRectF &beside : {around.united(ring), ring}) {
        const QPointF middles[] = {{beside.right() + 0.5 * size.width(), place.y()},
                                   {beside.left() - 0.5 * size.width(), place.y()},
                                   {place.x(), beside.bottom() + 0.5 * size.height()},
                                   {place.x(), beside.top() - 0.5 * size.height()}};
        for (const QPointF &middle : middles) {
            QRectF card(QPointF(), size);
            card.moveCenter(middle);
            card = inView(card);
            double cost = areaOf(card & around) + kOnOthers * areaOf(card & ring) * kWay +
                          kWay * QLineF(place, card.center()).length();
            for (const Box2 &box : pen.room().taken())
                cost += kOnOthers * areaOf(card & QRectF(QPointF(box.min.x(), box.min.y()),
                                                         QPointF(box.max.x(), box.max.y())));
            if (cost < least) {
                least = cost;
                best = card;
            }
        }
    }
    return best;
}

std::vector<StressRow> stressRows(const StressLine &line, const QLocale &locale)
{
    const NeckStress &neck = line.stress;
    const NominalStress &stress = neck.stress;
    const CutForces &forces = neck.forces;
    std::vector<StressRow> rows;
    rows.push_back({CardTexts::tr("In the neck"), megapascals(stress.neck, line.limit, locale)});
    if (stress.notch > 1.0)
        rows.push_back(
            {CardTexts::tr("At its corner"), megapascals(stress.corner, line.limit, locale)});
    struct Part
    {
        double stress;
        StressRow row;
    };
    std::vector<Part> parts;
    const auto add = [&](double part, const QString &what, const QString &value) {
        if (part >= kLeastPart * stress.neck && part > 0.0)
            parts.push_back({part, {what, value}});
    };
    add(stress.inPlane, CardTexts::tr("Bent in its plane"),
        newtonMillimetres(forces.inPlane, locale));
    add(stress.plate, CardTexts::tr("Bent across the sheet"),
        newtonMillimetres(forces.bending, locale));
    add(stress.axial,
        forces.axial < 0.0 ? CardTexts::tr("Pressed along") : CardTexts::tr("Pulled along"),
        inNewtons(forces.axial, locale));
    const double shear = std::hypot(forces.shear, forces.plate);
    const double area = neck.length * 2.0 * line.half;
    const double sheared = 1.5 * std::max(std::abs(forces.shear), std::abs(forces.plate)) / area;
    add(std::min(sheared, stress.shear), CardTexts::tr("Sheared"), inNewtons(shear, locale));
    add(stress.shear - sheared, CardTexts::tr("Twisted"),
        newtonMillimetres(forces.torsion, locale));
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part &a, const Part &b) { return a.stress > b.stress; });
    for (Part &part : parts)
        rows.push_back(std::move(part.row));
    return rows;
}

QString breaksFirst(const StressLine &line)
{
    const NeckDoubts &doubts = line.stress.doubts;
    if (doubts.mayBuckle)
        return CardTexts::tr("So slender that it may buckle before it breaks.");
    if (doubts.isRedundant)
        return CardTexts::tr("Uncertain: forces act beside the holes that it crosses.");
    if (doubts.isStubby || doubts.isNearForce)
        return CardTexts::tr("A rough figure: the neck is too short, or too near a force.");
    return line.stress.stress.notch > 1.0 ? CardTexts::tr("It would crack at its corner first.")
                                          : CardTexts::tr("It would break straight across.");
}

void paintStressCard(MarkPen &pen, const Analysis &analysis, const StressLine &line,
                     const QPointF &place, const QLocale &locale)
{
    QPainter &painter = pen.painter();
    const ViewStyle &style = pen.style();
    QFont font = painter.font();
    font.setPixelSize(12);
    QFont bold = font;
    bold.setWeight(headingWeight());
    const std::vector<StressRow> rows = stressRows(line, locale);
    const QString last = breaksFirst(line);
    const double lastHeight =
        QFontMetricsF(font)
            .boundingRect(QRectF(0.0, 0.0, kCardWidth - 2.0 * kCardPad, 100.0), Qt::TextWordWrap,
                          last)
            .height();
    const double height = 2.0 * kCardPad + kNeckHeight + 10.0 + lastHeight +
                          kCardRow * static_cast<double>(rows.size() + 2);
    const Section &section = *analysis.model.section(static_cast<std::size_t>(line.section));
    QRectF around(place, QSizeF());
    for (const Vec2 &p : section.shape->region().outer) {
        const QPointF seen = pen.screen(section.frame.toWorld(p));
        around |= QRectF(seen, QSizeF(0.1, 0.1));
    }
    const QRectF card = cardPlace({kCardWidth, height}, place, around, pen);
    const QPointF beside(std::clamp(place.x(), card.left(), card.right()),
                         std::clamp(place.y(), card.top(), card.bottom()));
    if (const double far = QLineF(place, beside).length(); far > kRingRadius) {
        QPainterPath leader(place + kRingRadius / far * (beside - place));
        leader.lineTo(beside);
        pen.cased(leader, roundPen(style.accent, kLeader));
    }
    painter.setPen(Qt::NoPen);
    QColor shade(Qt::black);
    for (int i = 3; i >= 1; --i) {
        shade.setAlphaF(0.07F);
        painter.setBrush(shade);
        painter.drawRoundedRect(card.adjusted(-i, 2 - i, i, 2 + i), 3.0 + i, 3.0 + i);
    }
    painter.setBrush(style.panel);
    painter.setPen(QPen(style.strong, 1.0));
    painter.drawRoundedRect(card, 3.0, 3.0);
    pen.keepFree(card);
    const QRectF inside = card.adjusted(kCardPad, kCardPad, -kCardPad, -kCardPad);
    double top = inside.top();
    const auto write = [&](const QString &left, const QString &right, const QFont &face,
                           const QColor &colour, const QColor &rightColour) {
        painter.setFont(face);
        const QRectF row(inside.left(), top, inside.width(), kCardRow);
        const QFontMetricsF metrics(face);
        const double taken = right.isEmpty() ? 0.0 : metrics.horizontalAdvance(right) + 8.0;
        painter.setPen(colour);
        painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(left, Qt::ElideRight, row.width() - taken));
        painter.setPen(rightColour);
        painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, right);
        top += kCardRow;
    };
    const WeakPlace weak = weakPlaceOf(analysis, line.body, line.stress);
    write(QString::fromStdString(section.name),
          //: %1 is a number of percent
          CardTexts::tr("%1\u202f%").arg(locale.toString(100.0 * line.use, 'f', 0)), bold,
          style.text, style.text);
    write(messageText(spotText(weak, analysis.model)), {}, font, style.muted, style.muted);
    top += 4.0;
    paintNeck(pen, analysis, line, {inside.left(), top, inside.width(), kNeckHeight}, locale);
    top += kNeckHeight + 4.0;
    for (const StressRow &row : rows)
        write(row.what, row.value, font, style.muted, style.text);
    painter.setFont(font);
    painter.setPen(style.text);
    painter.drawText(QRectF(inside.left(), top + 2.0, inside.width(), lastHeight),
                     Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, last);
}

} // namespace fff::ui
