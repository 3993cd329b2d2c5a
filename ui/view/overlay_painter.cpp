#include "ui/view/overlay_painter.h"

#include "core/interaction/clip_gesture.h"
#include "core/interaction/view_cube.h"
#include "core/io/full_stop.h"
#include "ui/view/problem_marks.h"
#include "ui/view/scale_bar.h"
#include "ui/view/sign_painter.h"
#include "ui/view/view_cube_painter.h"

#include <QCoreApplication>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff::ui {

namespace {

struct OverlayTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::OverlayPainter)
};

constexpr double kLongestLine = 300.0; // px: longer ones are hard to read, and in the way
constexpr double kRoundPlace = 16.0;   // px

class Drawing
{
public:
    Drawing(QPainter &painter, const OverlayScene &scene, const ViewStyle &style,
            const QLocale &locale)
        : m_pen(painter, scene.camera, scene.viewport, style), m_painter(painter), m_scene(scene),
          m_style(style), m_locale(locale)
    {
        if (const std::optional<Vec2> cube = cubeCentre(scene.viewport))
            m_pen.keepFree(QRectF(cube->x() - 0.5 * kCubeRoom, cube->y() - 0.5 * kCubeRoom,
                                  kCubeRoom, kCubeRoom));
        for (const QRectF &box : scene.covered)
            m_pen.keepFree(box);
    }

    void ground();
    void scaleBar();
    void invitation();
    void signs();
    void ghosts();
    void cutHandle();
    void hoveredName();
    void progress();
    void problems() { paintProblems(m_pen, m_scene.problems, m_scene.unit, m_locale); }
    void stress()
    {
        if (m_scene.timesMoved > 0.0)
            paintMovedKey(m_pen, m_scene.stress, m_scene.timesMoved, m_locale);
        else if (m_scene.bearing)
            paintBearing(m_pen, *m_scene.bearing, m_locale);
        else if (m_scene.stress)
            paintStress(m_pen, *m_scene.stress, m_scene.view, m_locale);
    }
    void askedLine()
    {
        if (m_scene.timesMoved > 0.0)
            return;
        if (m_scene.bearing)
            paintAskedBearing(m_pen, *m_scene.bearing);
        else if (m_scene.stress)
            paintAskedLine(m_pen, *m_scene.stress, m_locale);
    }
    void marks();
    void mark(const PlacedMark &mark, bool isLit);
    void dot(const PlacedMark &mark);
    void hoveredMark();
    void words()
    {
        std::vector<QRectF> boxes = m_pen.paintChips();
        if (m_scene.words)
            *m_scene.words = std::move(boxes);
    }
    void steps()
    {
        if (m_scene.steps)
            paintSteps(m_pen, *m_scene.steps, m_locale);
    }
    void cube()
    {
        paintViewCube(m_painter, m_scene.camera.orientation, m_scene.viewport,
                      m_scene.hovered.cubePart, m_style);
    }

private:
    QPointF screen(const Vec3 &world) const { return m_pen.screen(world); }
    void cased(const QPainterPath &path, const QPen &pen) { m_pen.cased(path, pen); }
    bool isGroundALine() const;
    const QColor &colourOf(const PlacedMark &mark) const
    {
        return mark.isError ? m_style.problem : m_style.warning;
    }
    bool isLit(const PlacedMark &mark) const
    {
        return std::any_of(mark.marks.begin(), mark.marks.end(), [this](std::size_t i) {
            return m_scene.problemMarks[i].number == m_scene.litMark;
        });
    }

    MarkPen m_pen;
    QPainter &m_painter;
    const OverlayScene &m_scene;
    const ViewStyle &m_style;
    const QLocale &m_locale;
};

/// Of gestures and tools, and of what is selected.
void Drawing::signs()
{
    const SignScene scene{isGroundALine(), m_scene.edited, m_scene.operation,
                          m_scene.unit,    m_scene.offer,  m_scene.isOfferLit};
    paintSigns(m_pen,
               {&m_scene.selected, &m_scene.overlay.drawn, &m_scene.dimensions,
                &m_scene.overlay.held, &m_scene.overlay.offered},
               scene, m_locale);
}

/// Seen from the side the ground is a line.
bool Drawing::isGroundALine() const
{
    // In perspective it is one only from the height of the ground itself.
    const double rise = m_scene.camera.isPerspective()
                            ? m_scene.camera.eye(m_scene.viewport).y() /
                                  m_scene.camera.eyeDistance(m_scene.viewport)
                            : m_scene.camera.forward().y();
    return m_scene.view.hasGround && std::abs(rise) <= 0.01 && m_scene.camera.up().y() >= 0.5;
}

/// What is under the line of the ground is hatched.
void Drawing::ground()
{
    if (!isGroundALine())
        return;
    const Vec3 &target = m_scene.camera.target;
    const double y = std::round(screen({target.x(), 0.0, target.z()}).y());
    const double width = m_scene.viewport.x(), height = m_scene.viewport.y();
    if (y < 0.0 || y > height)
        return;

    m_painter.save();
    m_painter.setClipRect(QRectF(0.0, y, width, height - y));
    m_painter.fillRect(QRectF(0.0, y, width, height - y), faded(m_style.muted, 0.05));
    m_painter.setPen(QPen(faded(m_style.muted, 0.22), 1.0));
    constexpr double kStep = 9.0;
    const double depth = height - y;
    for (double x = -depth; x < width; x += kStep)
        m_painter.drawLine(QPointF(x, height), QPointF(x + depth, y));
    m_painter.restore();
    m_painter.setPen(QPen(m_style.text, 1.5));
    m_painter.drawLine(QPointF(0.0, y), QPointF(width, y));
}

void Drawing::scaleBar()
{
    constexpr double kLongest = 150.0, kLeft = 14.5, kUpright = 5.0;
    const double perPixel = m_scene.camera.millimetresPerPixel;
    const ScaleBar scale = fff::ui::scaleBar(kLongest * perPixel, m_scene.unit, m_locale);
    const double width = scale.length / perPixel, bottom = m_scene.viewport.y() - 30.5;

    QFont font = m_painter.font();
    font.setPixelSize(12);
    m_painter.setFont(font);
    QPainterPath bar({kLeft, bottom - kUpright});
    for (const QPointF &to : {QPointF(kLeft, bottom), QPointF(kLeft + width, bottom),
                              QPointF(kLeft + width, bottom - kUpright)})
        bar.lineTo(to);
    cased(bar, QPen(m_style.muted, 1.2));
    // Sections may lie under it, in any colour.
    QPainterPath words;
    words.addText(QPointF(kLeft - 0.5, bottom + 16.0), font, scale.text);
    m_painter.strokePath(words, roundPen(faded(m_style.panel, 0.85), 3.0));
    m_painter.setPen(m_style.muted);
    m_painter.drawText(QPointF(kLeft - 0.5, bottom + 16.0), scale.text);
    m_pen.keepFree(words.boundingRect().united(bar.boundingRect()));
}

void Drawing::invitation()
{
    if (!m_scene.isEmpty || !m_scene.isIdle)
        return;
    m_painter.setPen(m_style.muted);
    m_painter.drawText(
        QRectF(0.0, 0.0, m_scene.viewport.x(), m_scene.viewport.y()), Qt::AlignCenter,
        QCoreApplication::translate("fff::ui::OverlayPainter",
                                    "Draw a shape here with the left button held down."));
}

/// What a step of the history took away or would bring back; of a trial, thinner and paler than
/// what comes in its place, as it was.
void Drawing::ghosts()
{
    const bool isOld = m_scene.areGhostsOld;
    QPen dashed = roundPen(isOld ? m_style.muted : m_style.accent, isOld ? 1.2 : 1.6);
    dashed.setCapStyle(Qt::FlatCap);
    dashed.setDashPattern({5.0, 3.0});
    for (const SectionPointer &section : m_scene.ghosts) {
        QPainterPath shape = m_pen.path(section->shape->contour(), section->frame);
        for (const Contour &hole : section->shape->holes())
            shape.addPath(m_pen.path(hole, section->frame));
        if (!isOld)
            m_painter.fillPath(shape, faded(m_style.accent, 0.10));
        m_painter.strokePath(shape, roundPen(faded(m_style.panel, 0.8), 3.6));
        m_painter.strokePath(shape, dashed);
    }
}

/// Where the plane that cuts the view open is taken hold of, with arrows the way it goes.
void Drawing::cutHandle()
{
    if (!m_scene.view.clip)
        return;
    const ClipPlane &plane = *m_scene.view.clip;
    const Vec3 at = clipHandle(plane, m_scene.bounds);
    const QPointF centre = screen(at);
    const double scale = m_scene.camera.scaleAt(at, m_scene.viewport);
    QPointF way = (screen(at + 20.0 * scale * plane.normal) - centre) / 20.0;
    const double length = std::hypot(way.x(), way.y());
    way = length > 0.3 ? way / length : QPointF(0.0, 1.0);
    const QPointF across(-way.y(), way.x());

    const bool isLit = m_scene.hovered.isCutHandle;
    const double radius = isLit ? 8.0 : 6.5;
    QPainterPath arrows;
    for (const double side : {1.0, -1.0}) {
        const QPointF tip = centre + side * (radius + 11.0) * way;
        arrows.moveTo(tip - side * 6.0 * way + 5.0 * across);
        arrows.lineTo(tip);
        arrows.lineTo(tip - side * 6.0 * way - 5.0 * across);
    }
    cased(arrows, roundPen(m_style.accent, 2.0));
    m_painter.setPen(QPen(m_style.panel, 1.5));
    m_painter.setBrush(m_style.accent);
    m_painter.drawEllipse(centre, radius, radius);
}

/// The name of the section that the cursor rests on.
void Drawing::hoveredName()
{
    const auto &place = m_scene.hovered.namePlace;
    if (!place || m_scene.hoveredName.isEmpty())
        return;
    constexpr double kRight = 16.0, kBelow = 29.0; // px, off the cursor
    m_pen.chip({.place = QPointF(place->x() + kRight, place->y() + kBelow),
                .anchor = MarkPen::Anchor::Left,
                .text = m_scene.hoveredName,
                .colour = m_style.text,
                .rank = MarkPen::Rank::InHand,
                .frame = m_style.strong,
                .longest = kLongestLine});
}

/// What the mark under the cursor is, of several the first, and how many there are besides.
void Drawing::hoveredMark()
{
    const Hovered &over = m_scene.hovered;
    for (const PlacedMark &mark : m_scene.marks) {
        const ProblemMark &first = m_scene.problemMarks[mark.marks.front()];
        if (over.problem == 0 || first.number != over.problem || first.place != over.problemPlace)
            continue;
        const int others = static_cast<int>(mark.marks.size()) - 1;
        //: a problem: its number in the list, and what it is: "3  Sections overlap"
        QString text = OverlayTexts::tr("%1  %2").arg(m_locale.toString(first.number),
                                                      QString::fromStdString(first.words));
        if (others > 0) // the sentence goes on
            text = OverlayTexts::tr("%1, and %n more here", nullptr, others)
                       .arg(withoutFullStop(text));
        const double reach = mark.isDot ? kDotsRadius : kMarkRadius;
        // What it is about stays in sight: its place, and what is next to that.
        m_pen.keepFree(QRectF(mark.anchor.x(), mark.anchor.y(), 0.0, 0.0)
                           .adjusted(-kRoundPlace, -kRoundPlace, kRoundPlace, kRoundPlace));
        m_pen.chip({.place = QPointF(mark.centre.x() + std::max(reach + 6.0, kRoundPlace),
                                     mark.centre.y()),
                    .anchor = MarkPen::Anchor::Left,
                    .text = text,
                    .colour = m_style.text,
                    .rank = MarkPen::Rank::InHand,
                    .frame = first.isError ? m_style.problem : m_style.warning,
                    .longest = kLongestLine});
    }
}

/// Something about the model is still being worked out.
void Drawing::progress()
{
    if (!m_scene.busy)
        return;
    m_painter.save();
    QFont font = m_painter.font();
    font.setPixelSize(12);
    m_painter.setFont(font);
    const QString text =
        QCoreApplication::translate("fff::ui::OverlayPainter", "Working out the slits…");
    const double width = QFontMetricsF(font).horizontalAdvance(text);
    const QPointF right(m_scene.viewport.x() - 14.5, m_scene.viewport.y() - 20.0);
    m_painter.setPen(m_style.muted);
    m_painter.drawText(QRectF(right.x() - width, right.y() - 10.0, width + 2.0, 20.0),
                       Qt::AlignVCenter | Qt::AlignLeft, text);
    const QRectF ring(right.x() - width - 24.0, right.y() - 7.0, 14.0, 14.0);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(faded(m_style.muted, 0.3), 2.0));
    m_painter.drawEllipse(ring);
    m_painter.setPen(roundPen(m_style.accent, 2.0));
    m_painter.drawArc(ring, static_cast<int>(-*m_scene.busy * 360.0 * 16.0), 100 * 16);
    m_painter.restore();
}

/// Marks of problems: dots, then lines of numbers to their places, so that none runs over a number.
void Drawing::marks()
{
    for (const PlacedMark &mark : m_scene.marks)
        if (mark.isDot)
            dot(mark);
    for (const PlacedMark &mark : m_scene.marks) {
        if (mark.isDot)
            continue;
        const QPointF anchor(mark.anchor.x(), mark.anchor.y());
        QPainterPath line(anchor);
        line.lineTo(mark.centre.x(), mark.centre.y());
        const QColor &colour = colourOf(mark);
        m_painter.setBrush(Qt::NoBrush);
        cased(line, roundPen(colour, 1.5));
        m_painter.setPen(QPen(m_style.panel, 1.0));
        m_painter.setBrush(colour);
        m_painter.drawEllipse(anchor, 3.0, 3.0);
    }
    const PlacedMark *lit = nullptr;
    for (const PlacedMark &mark : m_scene.marks) {
        const double half = mark.isDot ? kDotsRadius : kMarkRadius;
        m_pen.keepFree(QRectF(mark.centre.x() - half, mark.centre.y() - half, 2 * half, 2 * half));
        if (mark.isDot)
            continue;
        if (isLit(mark))
            lit = &mark;
        else
            this->mark(mark, false);
    }
    if (lit)
        mark(*lit, true);
}

/// How many it stands for is said when the cursor is on it.
void Drawing::dot(const PlacedMark &mark)
{
    const QPointF centre(mark.centre.x(), mark.centre.y());
    const bool isLit = this->isLit(mark);
    const double radius = kDotRadius + (isLit ? 1.5 : 0.0);
    m_painter.setPen(QPen(m_style.panel, 1.5));
    m_painter.setBrush(colourOf(mark));
    if (mark.isError) {
        m_painter.drawEllipse(centre, radius, radius);
    } else { // told apart without colours
        const double half = 0.88 * radius;
        m_painter.drawRect(QRectF(centre.x() - half, centre.y() - half, 2 * half, 2 * half));
    }
    if (!isLit)
        return;
    m_painter.setBrush(Qt::NoBrush);
    QPainterPath ring;
    ring.addEllipse(centre, radius + 2.5, radius + 2.5);
    cased(ring, QPen(m_style.accent, 2.0));
}

/// An octagon for an error, a square with round corners for a warning: told apart without colours.
void Drawing::mark(const PlacedMark &mark, bool isLit)
{
    const QPointF centre(mark.centre.x(), mark.centre.y());
    const double radius = kMarkRadius + (isLit ? 2.5 : -0.5);
    QPainterPath shape;
    if (mark.isError) {
        constexpr double kCut = 0.4142; // tan 22.5°: all eight sides are equal
        const double corners[][2] = {{1, kCut},   {kCut, 1},   {-kCut, 1}, {-1, kCut},
                                     {-1, -kCut}, {-kCut, -1}, {kCut, -1}, {1, -kCut}};
        QPolygonF octagon;
        for (const auto &corner : corners)
            octagon += centre + radius * QPointF(corner[0], corner[1]);
        shape.addPolygon(octagon);
        shape.closeSubpath();
    } else {
        const double half = 0.88 * radius;
        shape.addRoundedRect(QRectF(centre.x() - half, centre.y() - half, 2 * half, 2 * half), 4.0,
                             4.0);
    }
    const QColor &colour = colourOf(mark);
    if (isLit)
        m_painter.strokePath(shape, roundPen(m_style.accent, 6.0));
    m_painter.strokePath(shape, roundPen(m_style.panel, 3.0));
    m_painter.fillPath(shape, colour);
    m_painter.save();
    QFont font = m_painter.font();
    font.setPixelSize(mark.number < 10 ? 13 : 11);
    font.setWeight(QFont::Bold);
    m_painter.setFont(font);
    m_painter.setPen(m_style.panel);
    m_painter.drawText(QRectF(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius),
                       Qt::AlignCenter, m_locale.toString(mark.number));
    m_painter.restore();
}

} // namespace

void paintOverlay(QPainter &painter, const OverlayScene &scene, const ViewStyle &style,
                  const QLocale &locale)
{
    painter.setRenderHint(QPainter::Antialiasing);
    Drawing drawing(painter, scene, style, locale);
    drawing.ground();
    drawing.ghosts();
    drawing.stress();
    drawing.problems();
    drawing.signs();
    drawing.steps();
    drawing.cutHandle();
    drawing.marks();
    drawing.invitation();
    if (!scene.steps) // their bar stands there
        drawing.scaleBar();
    drawing.cube();
    drawing.progress();
    const bool hasCard =
        scene.bearing ? scene.bearing->asked.has_value() : scene.stress && scene.stress->hasCard;
    if (!hasCard) // which has it
        drawing.hoveredName();
    drawing.hoveredMark();
    drawing.askedLine();
    drawing.words();
}

} // namespace fff::ui
