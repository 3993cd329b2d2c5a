#include "ui/view/bearing_marks.h"

#include "core/interaction/pick.h"
#include "core/session/message_text.h"
#include "ui/view/stress_marks.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

struct BearingTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::BearingMarks)
};

constexpr double kLeastUse = 0.2;                 // that colours begin at
constexpr double kWidestScale = 1000.0;           // of the least mass
constexpr double kFilm = 0.85, kOlderFilm = 0.3;  // alpha
constexpr double kEdge = 8.0, kTop = 116.0;       // px: the legend stands under the cube
constexpr double kBar = 12.0, kBarLength = 160.0; // px
constexpr int kMarksOnBar = 5;
constexpr double kBesidePlace = 18.0; // px

double mostOnScale(const BearingMap &map)
{
    return map.least > 0.0 ? std::min(map.most, kWidestScale * map.least) : map.most;
}

/// Whether nothing stands before the point.
bool isBearingSeen(const Vec3 &point, double half, int section, const Model &model,
                   const MarkPen &pen, const ViewState &view)
{
    const Camera &camera = pen.camera();
    const Ray ray = camera.rayThrough(camera.toScreen(point, pen.viewport()), pen.viewport());
    const double distance = (point - ray.origin).dot(ray.direction);
    for (const Hit &hit : pick(model, ray, view)) {
        if (hit.section != section && hit.distance < distance - half)
            return false;
        if (hit.distance >= distance)
            break;
    }
    return true;
}

void paintTriangles(MarkPen &pen, const BearingMarks &marks, const ViewState &view)
{
    const BearingMap &map = *marks.map;
    const Model &model = map.analysis->model;
    const int index = model.indexOf(map.section);
    if (index < 0 || view.isHidden(map.section))
        return;
    const auto at = static_cast<std::size_t>(index);
    const Frame &frame = model.section(at)->frame;
    const double half = 0.5 * model.stockOf(at).thickness;
    const double side = frame.normal().dot(pen.camera().backward()) < 0.0 ? -half : half;
    QPainter &painter = pen.painter();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false); // or edges would show
    painter.setPen(Qt::NoPen);
    const double alpha = marks.isOlder ? kOlderFilm : kFilm;
    for (const auto &triangle : map.triangles) {
        QPolygonF outline;
        Vec3 middle = Vec3::Zero();
        double use = 0.0;
        for (const int corner : triangle) {
            const auto i = static_cast<std::size_t>(corner);
            const Vec3 point = frame.toWorld(map.points[i]) + side * frame.normal();
            outline << pen.screen(point);
            middle += point / 3.0;
            use += bearingUse(map, map.bearings[i].mass) / 3.0;
        }
        if (!isBearingSeen(middle, half, index, model, pen, view))
            continue;
        painter.setBrush(faded(stressColour(use, pen.style().isForColourBlind), alpha));
        painter.drawPolygon(outline);
    }
    painter.restore();
}

void paintScale(MarkPen &pen, const BearingMap &map)
{
    QPainter &painter = pen.painter();
    const ViewStyle &style = pen.style();
    QFont font = painter.font();
    font.setPixelSize(12);
    QFont bold = font;
    bold.setWeight(QFont::DemiBold);
    const double right = pen.viewport().x() - kEdge;
    const QRectF ground(right - 108.0, kTop, 108.0, kBarLength + 44.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(style.panel, 0.72));
    painter.drawRoundedRect(ground, 3.0, 3.0);
    painter.setFont(bold);
    painter.setPen(style.text);
    painter.drawText(QRectF(ground.left() + 12.0, ground.top() + 4.0, 90.0, 18.0),
                     Qt::AlignLeft | Qt::AlignVCenter, BearingTexts::tr("Bears"));
    painter.setFont(font);
    const QRectF bar(ground.left() + 12.0, ground.top() + 30.0, kBar, kBarLength);
    const double most = mostOnScale(map);
    // From what is weak, on top as in the legend of stress, to what is strong.
    const auto massAt = [&](double share) {
        return map.least > 0.0 ? map.least * std::pow(most / map.least, share) : share * most;
    };
    QLinearGradient ramp(bar.topLeft(), bar.bottomLeft());
    constexpr int kStops = 16;
    for (int i = 0; i <= kStops; ++i) {
        const double share = static_cast<double>(i) / kStops;
        ramp.setColorAt(share,
                        stressColour(1.0 - share * (1.0 - kLeastUse), style.isForColourBlind));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(ramp);
    painter.drawRect(bar);
    painter.setPen(style.text);
    for (int i = 0; i < kMarksOnBar; ++i) {
        const double share = static_cast<double>(i) / (kMarksOnBar - 1);
        painter.drawText(QRectF(bar.right() + 6.0, bar.top() + share * bar.height() - 9.0,
                                ground.right() - bar.right() - 8.0, 18.0),
                         Qt::AlignLeft | Qt::AlignVCenter, metricUnits().mass(massAt(share)));
    }
}

} // namespace

double bearingUse(const BearingMap &map, double mass)
{
    const double most = mostOnScale(map);
    double share = 1.0;
    if (map.least > 0.0 && most > map.least)
        share = std::log(std::max(mass, map.least) / map.least) / std::log(most / map.least);
    else if (most > map.least)
        share = mass / most;
    else if (!(most > 0.0))
        share = 0.0; // nowhere anything
    return 1.0 - std::clamp(share, 0.0, 1.0) * (1.0 - kLeastUse);
}

void paintBearing(MarkPen &pen, const BearingMarks &marks, const ViewState &view, const QLocale &)
{
    if (marks.map && !marks.map->points.empty()) {
        paintTriangles(pen, marks, view);
        paintScale(pen, *marks.map);
    }
    if (!marks.said.isEmpty())
        pen.chip({pen.viewport().x() - kEdge, kTop - 12.0}, MarkPen::Anchor::Right, marks.said,
                 pen.style().muted);
}

void paintAskedBearing(MarkPen &pen, const BearingMarks &marks)
{
    if (!marks.asked || !marks.map)
        return;
    const QPointF place = pen.screen(marks.place);
    pen.ring(place, 5.0, pen.style().accent);
    pen.chip(place + QPointF(kBesidePlace, -kBesidePlace), MarkPen::Anchor::Left,
             messageText(bearingText(*marks.asked, marks.map->analysis->model)), pen.style().text);
}

} // namespace fff::ui
