#include "ui/view/sign_painter.h"

#include "core/session/message_text.h"
#include "ui/view/gizmo_marks.h"
#include "ui/view/guide_marks.h"
#include "ui/view/joint_marks.h"
#include "ui/view/measure_marks.h"
#include "ui/view/operation_marks.h"
#include "ui/view/pen_marks.h"
#include "ui/view/point_marks.h"
#include "ui/view/sign_looks.h"
#include "ui/view/stroke_marks.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff::ui {

namespace {

struct MeasureMarksTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::MeasureMarks)
};

constexpr double kTickReach = 6.0;                    // px, half of the tick at a line's end
constexpr double kFreeOfWords = 4.0;                  // px, words off a line with its length
constexpr double kArrowHead = 8.0, kArrowWidth = 2.4; // px
constexpr double kAhead = 20.0;     // px, to see where a direction leads on the screen
constexpr double kTowardsEye = 0.2; // of its length that a direction must keep on the screen

/// What is under what.
enum class Layer {
    Points,
    Joints,
    Operation,
    Rulers,
    Ground,
    DeadZone,
    Guides,
    Contour,
    Slit,
    End, // of a stroke
    Plane,
    Path,
    Lengths, // and all else that has no place of its own
    Gizmo,
    Band,
};
constexpr int kLayers = static_cast<int>(Layer::Band) + 1;

QPainterPath polyline(const MarkPen &pen, const std::vector<Vec3> &points)
{
    QPainterPath path;
    for (const Vec3 &point : points) {
        if (path.elementCount() == 0)
            path.moveTo(pen.screen(point));
        else
            path.lineTo(pen.screen(point));
    }
    return path;
}

void stroke(MarkPen &pen, const QPainterPath &path, SignRole role)
{
    const SignLook &look = lookOf(role);
    if (look.isCased)
        pen.cased(path, penOf(look, pen.style()));
    else
        pen.painter().strokePath(path, penOf(look, pen.style()));
}

UnitWords unitWords(LengthUnit unit, const QLocale &locale)
{
    UnitWords words = metricUnits();
    words.length = [unit, &locale](double mm) { return lengthText(mm, unit, 1, 1, locale); };
    words.width = [unit, &locale](double mm) { return lengthText(mm, unit, 1, 2, locale); };
    words.size = [unit, &locale](const Vec2 &mm) {
        return QStringLiteral("%1 × %2").arg(lengthNumber(mm.x(), unit, 1, 1, locale),
                                             lengthText(mm.y(), unit, 1, 1, locale));
    };
    return words;
}

/// Of what is always there; all else is of what the hand does.
MarkPen::Rank rankOf(SignRole role)
{
    return role == SignRole::Dimension || role == SignRole::Load ? MarkPen::Rank::OfModel
                                                                 : MarkPen::Rank::InHand;
}

/// The length, and how far it goes along each axis where it goes along several.
QString wayText(const sign::Way &way, LengthUnit unit, const QLocale &locale)
{
    constexpr double kNothing = 0.005; // mm, of what is shown
    const QString length = lengthText(way.by.norm(), unit, 1, 2, locale);
    const Vec3 along = way.by.cwiseAbs();
    if (way.isLengthAlone || (along.array() > kNothing).count() < 2)
        return length;
    const auto number = [&](int axis) { return lengthNumber(along[axis], unit, 1, 2, locale); };
    //: a length, and how far it goes along X, Y and Z
    return MeasureMarksTexts::tr("%1   X %2  Y %3  Z %4")
        .arg(length, number(0), number(1), number(2));
}

/// Those of a layer.
class LayerPainter
{
public:
    LayerPainter(MarkPen &pen, Layer layer, const SignScene &scene, bool hasSlit,
                 const QLocale &locale)
        : m_pen(pen), m_layer(layer), m_scene(scene), m_hasSlit(hasSlit), m_locale(locale)
    {
    }

    template <class Kind>
    void operator()(const Kind &sign)
    {
        if (m_layer == Layer::Lengths)
            paintSign(m_pen, sign);
    }
    void operator()(const sign::Label &label)
    {
        if (m_layer != Layer::Lengths)
            return;
        const bool isOffer = label.role == SignRole::Offer;
        paintSign(m_pen, label, m_scene.unit, m_locale, isOffer ? m_scene.offer : nullptr,
                  isOffer && m_scene.isOfferLit);
    }
    void operator()(const sign::Region &region)
    {
        if (m_layer == (region.role == SignRole::Plane ? Layer::Plane : Layer::Lengths))
            paintSign(m_pen, region);
    }
    void operator()(const sign::Capsule &capsule)
    {
        if (m_layer == Layer::DeadZone)
            paintSign(m_pen, capsule);
    }
    void operator()(const sign::Band &band)
    {
        if (m_layer == Layer::Band)
            paintSign(m_pen, band);
    }
    void operator()(const sign::Slit &slit)
    {
        if (m_layer == Layer::Slit)
            paintSlit(m_pen, slit, m_scene.unit, m_locale);
    }
    void operator()(const sign::Stroke &drawn)
    {
        if (m_layer == Layer::Contour)
            paintContour(m_pen, drawn, m_hasSlit);
        if (m_layer == Layer::End)
            paintEnd(m_pen, drawn, m_scene.unit, m_locale);
    }
    void operator()(const sign::Ground &ground)
    {
        if (m_layer == Layer::Ground)
            paintGround(m_pen, ground, m_scene.isGroundHatched, m_scene.unit, m_locale);
    }
    void operator()(const sign::Guides &guides)
    {
        if (m_layer == Layer::Guides)
            paintGuides(m_pen, guides);
    }
    void operator()(const sign::Rulers &rulers)
    {
        if (m_layer == Layer::Rulers)
            paintRulers(m_pen, rulers.grid, m_scene.unit, m_locale);
    }
    void operator()(const sign::Points &points)
    {
        if (m_layer == Layer::Points && m_scene.edited)
            paintPoints(m_pen, *m_scene.edited, points);
    }
    void operator()(const sign::Joints &joints)
    {
        if (m_layer == Layer::Joints)
            paintJoints(m_pen, joints, m_locale);
    }
    void operator()(const PenMarks &path)
    {
        if (m_layer == Layer::Path)
            paintPath(m_pen, path, m_scene.unit, m_locale);
    }
    void operator()(const GizmoMarks &gizmo)
    {
        if (m_layer == Layer::Gizmo)
            paintGizmo(m_pen, gizmo, m_scene.unit, m_locale);
    }
    void operator()(const OperationMarks &marks)
    {
        if (m_layer == Layer::Operation && m_scene.operation)
            paintOperation(m_pen, marks, *m_scene.operation);
    }

private:
    MarkPen &m_pen;
    const Layer m_layer;
    const SignScene &m_scene;
    const bool m_hasSlit;
    const QLocale &m_locale;
};

} // namespace

void paintSign(MarkPen &pen, const sign::Line &line)
{
    QPainterPath path = polyline(pen, line.points);
    if (line.hasTicks && path.elementCount() > 1) {
        const QPointF from = path.elementAt(0), to = path.elementAt(path.elementCount() - 1);
        const QPointF way = to - from;
        const double length = std::hypot(way.x(), way.y());
        if (length >= 1.0) {
            const QPointF across = kTickReach / length * QPointF(-way.y(), way.x());
            for (const QPointF &end : {from, to}) {
                path.moveTo(end - across);
                path.lineTo(end + across);
            }
            pen.keepFree(from, to, kFreeOfWords); // its length stands beside it
        }
    }
    stroke(pen, path, line.role);
}

/// Together, so that none of them is cased over another one.
void paintSign(MarkPen &pen, const sign::Outlines &outlines)
{
    QPainterPath path;
    for (const Polygon &line : *outlines.lines) {
        const auto at = [&](const Vec2 &p) {
            return pen.screen(outlines.placement({p.x(), p.y(), 0.0}));
        };
        path.moveTo(at(line.front()));
        for (std::size_t i = 1; i < line.size(); ++i)
            path.lineTo(at(line[i]));
        path.closeSubpath();
    }
    stroke(pen, path, outlines.role);
}

void paintSign(MarkPen &pen, const sign::Curve &curve)
{
    stroke(pen, pen.path(curve.contour, curve.frame), curve.role);
}

void paintSign(MarkPen &pen, const sign::Handle &handle)
{
    const SignLook &look = lookOf(handle.role);
    const QPointF at = pen.screen(handle.at);
    pen.ring(at, look.radius, pen.style().*look.colour);
    pen.keepFree(
        QRectF(at, QSizeF()).adjusted(-look.radius, -look.radius, look.radius, look.radius));
}

void paintSign(MarkPen &pen, const sign::Label &label, LengthUnit unit, const QLocale &locale,
               QRectF *told, bool isLit)
{
    QPointF middle;
    for (const Vec3 &place : label.places)
        middle += pen.screen(place);
    middle /= static_cast<double>(label.places.size());
    const auto *way = std::get_if<sign::Way>(&label.words);
    const QString text = way ? wayText(*way, unit, locale)
                             : messageText(std::get<Message>(label.words), unitWords(unit, locale));
    const QPointF wanted = middle + QPointF(label.offset.x(), label.offset.y());
    const QColor &colour = pen.style().*lookOf(label.role).colour;
    // A length stands beside its line.
    const bool isOfLine = way && label.places.size() == 2;
    pen.chip({.place = wanted,
              .text = text,
              .colour = colour,
              .rank = rankOf(label.role),
              .names = middle,
              .along = isOfLine ? pen.screen(label.places.back()) - pen.screen(label.places.front())
                                : QPointF(),
              .isButton = label.role == SignRole::Offer,
              .isLit = isLit,
              .told = told});
}

void paintSign(MarkPen &pen, const sign::Region &region)
{
    QPainterPath path = polyline(pen, region.outline);
    path.closeSubpath();
    const SignLook &look = lookOf(region.role);
    pen.painter().fillPath(path, faded(pen.style().*look.colour, look.fill));
    stroke(pen, path, region.role);
}

void paintSign(MarkPen &pen, const sign::Capsule &capsule)
{
    constexpr int kChords = 32; // of each of its two half circles
    sign::Region region{capsule.role, {}};
    for (const double end : {capsule.length, 0.0}) {
        for (int i = 0; i <= kChords; ++i) {
            const double angle = std::numbers::pi * (static_cast<double>(i) / kChords - 0.5) +
                                 (end > 0.0 ? 0.0 : std::numbers::pi);
            region.outline.push_back(capsule.canvas.toWorld(
                Vec2(end, 0.0) + capsule.radius * Vec2(std::cos(angle), std::sin(angle))));
        }
    }
    paintSign(pen, region);
}

void paintSign(MarkPen &pen, const sign::Arrow &arrow)
{
    const QPointF from = pen.screen(arrow.from);
    const double scale = pen.camera().scaleAt(arrow.from, pen.viewport());
    const QPointF way = (pen.screen(arrow.from + kAhead * scale * arrow.direction) - from) / kAhead;
    const double length = std::hypot(way.x(), way.y());
    if (length < kTowardsEye)
        return; // one looks along it
    const QPointF along = way / length, across(-along.y(), along.x());
    const QPointF tip = from + arrow.length * along;
    QPainterPath path(from);
    path.lineTo(tip);
    path.moveTo(tip - kArrowHead * along + 0.7 * kArrowHead * across);
    path.lineTo(tip);
    path.lineTo(tip - kArrowHead * along - 0.7 * kArrowHead * across);
    pen.keepFree(from, tip, 0.7 * kArrowHead);
    pen.cased(path, roundPen(pen.style().*lookOf(arrow.role).colour, kArrowWidth));
}

void paintSign(MarkPen &pen, const sign::Band &band)
{
    QPainter &painter = pen.painter();
    const QColor &accent = pen.style().accent;
    const QRectF box(QPointF(band.box.min.x(), band.box.min.y()),
                     QPointF(band.box.max.x(), band.box.max.y()));
    painter.fillRect(box, faded(accent, 0.10));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(accent, 1.0));
    painter.drawRect(QRectF(box.toAlignedRect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void paintSigns(MarkPen &pen, const std::vector<const Signs *> &all, const SignScene &scene,
                const QLocale &locale)
{
    const bool hasSlit = std::any_of(all.begin(), all.end(), [](const Signs *signs) {
        return signs->find<sign::Slit>() != nullptr;
    });
    for (int layer = 0; layer < kLayers; ++layer) {
        LayerPainter painter(pen, static_cast<Layer>(layer), scene, hasSlit, locale);
        for (const Signs *signs : all)
            for (const Sign &sign : *signs)
                std::visit(painter, sign);
    }
}

} // namespace fff::ui
