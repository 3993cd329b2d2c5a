#include "ui/view/stroke_marks.h"

#include "core/session/message_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

struct StrokeMarksTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::OverlayPainter)
};

/// What words keep off a slit, px to both sides.
constexpr double kSlitRoom = 5.0;

/// As long as any view, from a point both ways.
QPainterPath endless(const MarkPen &pen, const Vec3 &point, const Vec3 &direction)
{
    const double scale = pen.camera().scaleAt(point, pen.viewport());
    const QPointF at = pen.screen(point);
    QPointF way = pen.screen(point + scale * direction) - at;
    const double length = std::hypot(way.x(), way.y());
    if (length < 1e-3)
        return {};
    way *= 2.0 * pen.viewport().norm() / length;
    QPainterPath line(at - way);
    line.lineTo(at + way);
    return line;
}

/// Of what is drawn so far and what a release adds, px; a curve by its control points.
QRectF boxOf(const MarkPen &pen, const sign::Stroke &stroke)
{
    QRectF box;
    const auto add = [&](const Vec2 &p) {
        const QPointF at = pen.screen(stroke.canvas.toWorld(p));
        const QRectF point(at, QSizeF(1.0, 1.0)); // an empty one would not count
        box = box.isNull() ? point : box.united(point);
    };
    const auto addCurve = [&add](const CubicBezier &curve) {
        for (const Vec2 &p : {curve.p0, curve.p1, curve.p2, curve.p3})
            add(p);
    };
    for (const Vec2 &sample : stroke.samples)
        add(sample);
    for (const CubicBezier &curve : stroke.mirrored)
        addCurve(curve);
    for (const std::optional<CubicBezier> &curve : {stroke.opening, stroke.closing})
        if (curve)
            addCurve(*curve);
    return box;
}

/// The axis with what it means.
void paintAxis(MarkPen &pen, const sign::Stroke &stroke, bool isSlit)
{
    const Vec3 point = stroke.canvas.toWorld(stroke.axis->point);
    const Vec3 direction = stroke.canvas.directionToWorld(stroke.axis->direction);
    const QPainterPath line = endless(pen, point, direction);
    if (line.isEmpty())
        return;
    pen.painter().strokePath(line, axisPen(pen.style()));
    // Above what is drawn, or below it where that leaves no room.
    constexpr double kBeside = 30.0, kLeast = 70.0; // px, of what is drawn and of the view's edges
    const QRectF box = boxOf(pen, stroke);
    const double most = std::max(kLeast, pen.viewport().y() - kLeast);
    const double above = box.top() - kBeside, below = box.bottom() + kBeside;
    const QPointF from = line.elementAt(0), to = line.elementAt(1);
    const double y = std::clamp(above < kLeast && below <= most ? below : above, kLeast, most);
    const double along =
        std::abs(to.y() - from.y()) > 1.0 ? (y - from.y()) / (to.y() - from.y()) : 0.5;
    const QPointF place = from + along * (to - from);
    pen.chip(place + QPointF(8.0, 0.0), MarkPen::Anchor::Left,
             isSlit ? StrokeMarksTexts::tr("Mirrored across the slit")
                    : StrokeMarksTexts::tr("Mirrored across the vertical"),
             pen.style().symmetry, MarkPen::Rank::InHand);
}

void paintMirroredHalf(MarkPen &pen, const sign::Stroke &stroke)
{
    const QPainterPath half = pen.path(stroke.mirrored, stroke.canvas);
    QPen dashed = roundPen(pen.style().accent, 2.0);
    dashed.setCapStyle(Qt::FlatCap);
    dashed.setDashPattern({4.0, 3.0});
    // A wide casing, so that the solid edge under it does not show through the gaps.
    pen.painter().strokePath(half, roundPen(faded(pen.style().panel, 0.85), 4.0));
    pen.painter().strokePath(half, dashed);
}

void paintSamples(MarkPen &pen, const sign::Stroke &stroke)
{
    QPainter &painter = pen.painter();
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(pen.style().text, 0.35));
    for (const Vec2 &sample : stroke.samples)
        painter.drawEllipse(pen.screen(stroke.canvas.toWorld(sample)), 1.0, 1.0);
}

void paintCursor(MarkPen &pen, const sign::Stroke &stroke, LengthUnit unit, const QLocale &locale)
{
    if (stroke.samples.empty())
        return;
    const QPointF at = pen.screen(stroke.canvas.toWorld(stroke.samples.back()));
    QPainter &painter = pen.painter();
    painter.setBrush(pen.style().accent);
    painter.setPen(QPen(pen.style().panel, 1.0));
    painter.drawEllipse(at, 4.0, 4.0);
    if (!stroke.size)
        return;
    // Beside what is drawn, at the height of the cursor: never on its line.
    constexpr double kAside = 14.0; // px
    const QRectF box = boxOf(pen, stroke);
    const bool isRight = at.x() >= box.center().x();
    const Vec2 &size = *stroke.size;
    pen.chip({isRight ? box.right() + kAside : box.left() - kAside, at.y()},
             isRight ? MarkPen::Anchor::Left : MarkPen::Anchor::Right,
             QStringLiteral("%1 × %2").arg(lengthNumber(size.x(), unit, 1, 1, locale),
                                           lengthText(size.y(), unit, 1, 1, locale)),
             pen.style().muted, MarkPen::Rank::InHand);
}

/// Where the contour goes through the ground, px: to a chord of its curves.
std::vector<QPointF> cutEnds(const MarkPen &pen, const Contour &contour, const Frame &canvas)
{
    constexpr int kChords = 16; // of a curve
    std::vector<QPointF> ends;
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier curve = contour.segment(i);
        Vec3 before = canvas.toWorld(curve.p0);
        for (int k = 1; k <= kChords; ++k) {
            const Vec3 at = canvas.toWorld(curve.at(static_cast<double>(k) / kChords));
            if ((before.y() < 0.0) != (at.y() < 0.0))
                ends.push_back(
                    pen.screen(before + before.y() / (before.y() - at.y()) * (at - before)));
            before = at;
        }
    }
    return ends;
}

/// px from the lower edge of the view to where the line is under the middle of that; 0 where it is
/// in sight there, or is not level.
double belowTheView(const MarkPen &pen, const QPainterPath &line)
{
    const QPointF from = line.elementAt(0), to = line.elementAt(1), way = to - from;
    if (!(std::abs(way.x()) > std::abs(way.y())))
        return 0.0;
    const double y = from.y() + way.y() * (0.5 * pen.viewport().x() - from.x()) / way.x();
    return std::max(0.0, y - pen.viewport().y());
}

} // namespace

void paintCutOff(MarkPen &pen, const Contour &contour, const Frame &canvas)
{
    QPen dashed = roundPen(pen.style().muted, 1.6);
    dashed.setDashPattern({0.5, 2.5});
    pen.painter().strokePath(pen.path(contour, canvas), dashed);
}

void paintCutChip(MarkPen &pen, const Contour &contour, const Frame &canvas, const Vec2 &cursor)
{
    const std::vector<QPointF> ends = cutEnds(pen, contour, canvas);
    if (ends.empty())
        return;
    const auto isLeft = [](const QPointF &a, const QPointF &b) { return a.x() < b.x(); };
    const auto [left, right] = std::minmax_element(ends.begin(), ends.end(), isLeft);
    // Where the cursor is there are words already.
    const double x = pen.screen(canvas.toWorld(cursor)).x();
    const bool isRight = x - left->x() < right->x() - x;
    constexpr double kBeside = 12.0, kUnder = 17.0; // px, of where the cut ends
    pen.chip(isRight ? *right + QPointF(kBeside, kUnder) : *left + QPointF(-kBeside, kUnder),
             isRight ? MarkPen::Anchor::Left : MarkPen::Anchor::Right,
             StrokeMarksTexts::tr("Cut flat at the ground"), pen.style().muted,
             MarkPen::Rank::InHand);
}

void paintGround(MarkPen &pen, const sign::Ground &ground, bool isHatched, LengthUnit unit,
                 const QLocale &locale)
{
    const QPainterPath line = endless(pen, ground.point, ground.direction);
    if (line.isEmpty())
        return;
    if (const double beyond = belowTheView(pen, line); beyond > 0.0) {
        constexpr double kAbove = 22.0; // px, of the lower edge
        const double scale = pen.camera().scaleAt(ground.point, pen.viewport());
        pen.chip({0.5 * pen.viewport().x(), pen.viewport().y() - kAbove}, MarkPen::Anchor::Middle,
                 //: %1 is a length
                 StrokeMarksTexts::tr("Ground %1 below this edge")
                     .arg(lengthText(beyond * scale, unit, 0, 1, locale)),
                 pen.style().muted, MarkPen::Rank::InHand);
    }
    if (!isHatched) {
        const QPointF from = line.elementAt(0), to = line.elementAt(1);
        // Down on the screen from the line: the halfplane below the ground.
        const Vec3 below = ground.point - Vec3::UnitY();
        const QPointF down = pen.screen(below) - pen.screen(ground.point);
        const double length = std::hypot(down.x(), down.y());
        if (length > 1e-6) {
            const QPointF far = down * (2.0 * pen.viewport().norm() / length);
            QPainterPath half(from);
            half.lineTo(to);
            half.lineTo(to + far);
            half.lineTo(from + far);
            half.closeSubpath();
            QPainter &painter = pen.painter();
            painter.fillPath(half, faded(pen.style().muted, 0.05));
            painter.fillPath(half, QBrush(faded(pen.style().muted, 0.18), Qt::BDiagPattern));
        }
    }
    pen.painter().strokePath(line, QPen(pen.style().text, 2.0));
}

void paintContour(MarkPen &pen, const sign::Stroke &stroke, bool isSlitAxis)
{
    if (stroke.cut)
        paintCutOff(pen, *stroke.cut, stroke.canvas);
    if (stroke.isMirrored)
        paintMirroredHalf(pen, stroke);
    for (const std::optional<CubicBezier> &join : {stroke.opening, stroke.closing}) {
        if (!join)
            continue;
        QPen dotted = roundPen(pen.style().accent, 2.0);
        dotted.setDashPattern({0.1, 2.6});
        pen.cased(pen.path({*join}, stroke.canvas), dotted);
    }
    pen.cased(pen.path(stroke.fitted, stroke.canvas), roundPen(pen.style().accent, 2.8));
    if (stroke.isMirrored && stroke.axis)
        paintAxis(pen, stroke, isSlitAxis);
    paintSamples(pen, stroke);
}

void paintSlit(MarkPen &pen, const sign::Slit &slit, LengthUnit unit, const QLocale &locale)
{
    const QPointF from = pen.screen(slit.from), to = pen.screen(slit.to);
    QPainterPath line(from);
    line.lineTo(to);
    pen.painter().strokePath(line, roundPen(pen.style().panel, 7.0));
    pen.painter().strokePath(line, roundPen(pen.style().slit, 4.0));
    pen.ring(from, 4.5, pen.style().slit);
    if (slit.hasLeft)
        pen.ring(to, 4.5, pen.style().slit);

    pen.keepFree(from, to, kSlitRoom);
    if (!slit.hasWords)
        return;
    const double length = (slit.to - slit.from).norm();
    double reach = 22.0; // px, from the slit to its chip
    if (slit.clearance > 0.0)
        reach = slit.clearance / pen.camera().scaleAt(slit.to, pen.viewport()) + 14.0;
    const QString text = lengthText(length, unit, 1, 1, locale);
    const QString words =
        slit.guide == Text()
            //: %1 is its length, with a unit
            ? StrokeMarksTexts::tr("Slit %1").arg(text)
            //: %1 is its length, with a unit; %2 says what it goes along: "level"
            : StrokeMarksTexts::tr("Slit %1, %2").arg(text, messageText(slit.guide));
    const QPointF middle = 0.5 * (from + to), way = to - from;
    if (std::abs(way.x()) > std::abs(way.y()))
        pen.chip(middle - QPointF(0.0, reach), MarkPen::Anchor::Middle, words, pen.style().slit,
                 MarkPen::Rank::InHand);
    else
        pen.chip(middle - QPointF(reach, 0.0), MarkPen::Anchor::Right, words, pen.style().slit,
                 MarkPen::Rank::InHand);
}

void paintEnd(MarkPen &pen, const sign::Stroke &stroke, LengthUnit unit, const QLocale &locale)
{
    if (stroke.cut)
        paintCutChip(pen, *stroke.cut, stroke.canvas, stroke.samples.back());
    paintCursor(pen, stroke, unit, locale);
}

} // namespace fff::ui
