#include "ui/view/pen_marks.h"

#include "ui/view/stroke_marks.h"

#include <QCoreApplication>

#include <cmath>

namespace fff::ui {

namespace {

struct PenMarksTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::OverlayPainter)
};

class PathDrawing
{
public:
    PathDrawing(MarkPen &pen, const PenMarks &marks) : m_pen(pen), m_marks(marks) {}

    void grid();
    void pieces();
    void guides();
    void handles();
    void points();
    void next();
    void numbers(LengthUnit unit, const QLocale &locale);

private:
    QPointF screen(const Vec2 &point) const { return m_pen.screen(m_marks.canvas.toWorld(point)); }
    bool isLit(std::size_t index) const { return m_marks.litPoint == static_cast<int>(index); }
    void handle(const PathPoint &point, const Vec2 &way, bool lit);

    MarkPen &m_pen;
    const PenMarks &m_marks;
};

/// The grid round the cursor, so that one sees where a point can go.
void PathDrawing::grid()
{
    if (!(m_marks.gridStep > 0.0) || !m_marks.snap)
        return;
    constexpr int kReach = 5; // steps
    const Vec2 middle = m_marks.grid.toLocal(m_marks.canvas.toWorld(m_marks.snap->point));
    const Vec2 nearest(std::round(middle.x() / m_marks.gridStep),
                       std::round(middle.y() / m_marks.gridStep));
    m_pen.painter().setPen(Qt::NoPen);
    for (int i = -kReach; i <= kReach; ++i) {
        for (int j = -kReach; j <= kReach; ++j) {
            const double away = std::hypot(i, j) / (kReach + 0.5);
            if (away > 1.0)
                continue;
            const Vec2 at = (nearest + Vec2(i, j)) * m_marks.gridStep;
            m_pen.painter().setBrush(faded(m_pen.style().text, 0.55 * (1.0 - away)));
            m_pen.painter().drawEllipse(m_pen.screen(m_marks.grid.toWorld(at)), 1.1, 1.1);
        }
    }
}

void PathDrawing::pieces()
{
    const std::vector<PathPoint> &points = m_marks.points;
    if (m_marks.cut)
        paintCutOff(m_pen, *m_marks.cut, m_marks.canvas);
    if (points.size() > 1 && !(points.back().at == points.front().at)) {
        QPen dotted = roundPen(m_pen.style().accent, 2.0);
        dotted.setDashPattern({0.1, 2.6});
        m_pen.cased(m_pen.path({pathPiece(points.back(), points.front())}, m_marks.canvas), dotted);
    }
    std::vector<CubicBezier> drawn;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        drawn.push_back(pathPiece(points[i], points[i + 1]));
    if (!drawn.empty())
        m_pen.cased(m_pen.path(drawn, m_marks.canvas), roundPen(m_pen.style().accent, 2.8));
    if (m_marks.next && !points.empty()) {
        const CubicBezier piece = pathPiece(points.back(), {*m_marks.next, {}, {}});
        m_pen.cased(m_pen.path({piece}, m_marks.canvas),
                    roundPen(faded(m_pen.style().accent, 0.75), 1.6));
    }
}

/// From what the point is level or upright with, a little further than to it.
void PathDrawing::guides()
{
    if (!m_marks.snap)
        return;
    constexpr double kFurther = 40.0; // px
    QPen dashed(m_pen.style().guide, 1.4);
    dashed.setDashPattern({5.0, 3.0});
    const auto line = [&](const QPointF &from, const QPointF &to) {
        const QPointF way = to - from;
        const double length = std::hypot(way.x(), way.y());
        if (length < 1.0)
            return;
        QPainterPath path(from);
        path.lineTo(to + way * (kFurther / length));
        m_pen.painter().strokePath(path, roundPen(m_pen.style().panel, 3.0));
        m_pen.painter().strokePath(path, dashed);
    };
    const QPointF at = screen(m_marks.snap->point);
    for (const Vec2 &anchor : m_marks.snap->anchors)
        line(screen(anchor), at);
    if (m_marks.snap->isOnGround) {
        const Vec3 along =
            m_marks.grid.x *
            m_pen.camera().scaleAt(m_marks.canvas.toWorld(m_marks.snap->point), m_pen.viewport());
        const QPointF way = m_pen.screen(m_marks.canvas.toWorld(m_marks.snap->point) + along) - at;
        line(at - kFurther * way, at);
    }
}

void PathDrawing::handle(const PathPoint &point, const Vec2 &way, bool lit)
{
    QPainterPath line(screen(point.at));
    const QPointF tip = screen(point.at + way);
    line.lineTo(tip);
    m_pen.painter().strokePath(line, roundPen(m_pen.style().panel, 3.0));
    m_pen.painter().strokePath(line, roundPen(m_pen.style().accent, 1.2));
    m_pen.painter().setPen(QPen(m_pen.style().panel, 1.2));
    m_pen.painter().setBrush(m_pen.style().accent);
    const double radius = lit ? 4.5 : 3.5;
    m_pen.painter().drawEllipse(tip, radius, radius);
}

void PathDrawing::handles()
{
    for (std::size_t i = 0; i < m_marks.points.size(); ++i) {
        const PathPoint &point = m_marks.points[i];
        if (point.in)
            handle(point, *point.in, isLit(i) && m_marks.litEnd == PenPath::End::In);
        if (point.out)
            handle(point, *point.out, isLit(i) && m_marks.litEnd == PenPath::End::Out);
    }
}

/// Corners are square, smooth points round; the first one has a ring when a click there closes.
void PathDrawing::points()
{
    QPainter &painter = m_pen.painter();
    for (std::size_t i = 0; i < m_marks.points.size(); ++i) {
        const PathPoint &point = m_marks.points[i];
        const QPointF at = screen(point.at);
        const bool lit = isLit(i) && !m_marks.litEnd;
        const double half = lit ? 4.5 : 3.5;
        if (i == 0 && m_marks.isClosing && lit)
            m_pen.ring(at, 9.0, m_pen.style().accent);
        const bool isLast = i + 1 == m_marks.points.size();
        painter.setPen(QPen(m_pen.style().accent, 1.8));
        painter.setBrush(isLast || lit ? m_pen.style().accent : m_pen.style().panel);
        if (point.isCorner())
            painter.drawRect(QRectF(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half));
        else
            painter.drawEllipse(at, half + 0.5, half + 0.5);
    }
}

/// A dot on what has caught the point; a smaller one on the grid.
void PathDrawing::next()
{
    if (!m_marks.snap)
        return;
    const QPointF at = screen(m_marks.snap->point);
    QPainter &painter = m_pen.painter();
    const bool isCaught = m_marks.snap->kind > Snap::Kind::Grid;
    painter.setPen(QPen(m_pen.style().panel, 1.2));
    painter.setBrush(m_marks.snap->kind == Snap::Kind::None ? m_pen.style().accent
                                                            : m_pen.style().guide);
    const double radius = isCaught ? 5.0 : 3.5;
    painter.drawEllipse(at, radius, radius);
}

void PathDrawing::numbers(LengthUnit unit, const QLocale &locale)
{
    if (!m_marks.snap || !m_marks.place)
        return;
    constexpr double kBeside = 20.0, kBelow = 26.0, kRow = 26.0; // px
    constexpr double kRoom = 260.0;                              // px that the chips need
    const bool snaps = m_marks.snap->kind != Snap::Kind::None;
    const QColor &colour = snaps ? m_pen.style().guide : m_pen.style().muted;
    const QPointF at = screen(m_marks.snap->point);
    const bool isRight = at.x() + kRoom < m_pen.viewport().x();
    const MarkPen::Anchor anchor = isRight ? MarkPen::Anchor::Left : MarkPen::Anchor::Right;
    const QPointF place = at + QPointF(isRight ? kBeside : -kBeside, kBelow);
    const auto number = [&](double value) { return lengthNumber(value, unit, 1, 3, locale); };
    m_pen.chip(
        place, anchor,
        //: place of a point: %1 and %2 are numbers, the second has a unit
        PenMarksTexts::tr("X %1   Y %2")
            .arg(number(m_marks.place->x()), lengthText(m_marks.place->y(), unit, 1, 3, locale)),
        colour, MarkPen::Rank::InHand);
    if (!m_marks.way)
        return;
    const Vec2 way = m_marks.way->cwiseAbs();
    m_pen.chip(place + QPointF(0.0, kRow), anchor,
               //: how far it is to the side (%1) and up or down (%2, with a unit)
               PenMarksTexts::tr("%1 × %2 from the last point")
                   .arg(number(way.x()), lengthText(way.y(), unit, 1, 3, locale)),
               m_pen.style().muted, MarkPen::Rank::InHand);
}

} // namespace

void paintPath(MarkPen &pen, const PenMarks &marks, LengthUnit unit, const QLocale &locale)
{
    PathDrawing drawing(pen, marks);
    drawing.grid();
    drawing.guides();
    drawing.pieces();
    drawing.handles();
    drawing.points();
    drawing.next();
    if (marks.cut)
        paintCutChip(pen, *marks.cut, marks.canvas, marks.next.value_or(marks.points.back().at));
    drawing.numbers(unit, locale);
}

} // namespace fff::ui
