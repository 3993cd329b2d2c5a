#include "ui/view/measure_marks.h"

#include "core/interaction/load_marks.h"
#include "core/interaction/pick.h"
#include "core/interaction/snapping.h"
#include "core/model/dimensions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kLabelGap = 62.0;             // px, between labels of a ruler
constexpr double kRulerMargin = 44.0;          // px to the view's edge
constexpr double kLowerMargin = 64.0;          // to its lower one, where the scale bar stands
constexpr double kOverCover = 28.0;            // and over what stands there, with its numbers
/// What stands over the view stands at its lower edge from there on, part of its height.
constexpr double kAtLowerEdge = 0.75;
/// The ground is level in a plane whose upward axis rises by more (no unit).
constexpr double kUpright = 0.1;
constexpr double kTick = 4.0, kLongTick = 8.0; // px
constexpr int kMostTicks = 2000;

/// 1, 2 or 5 times a power of ten, in the unit's own numbers.
double roundStep(double least)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least)
            return factor * power;
    return 10.0 * power;
}

class Rulers
{
public:
    Rulers(MarkPen &pen, const Frame &grid, LengthUnit unit, const QLocale &locale)
        : m_pen(pen), m_grid(grid), m_unit(unit), m_locale(locale)
    {
    }

    void paint()
    {
        const std::optional<Box2> seen = visible();
        if (!seen)
            return;
        QFont font = m_pen.painter().font();
        font.setPixelSize(11);
        m_pen.painter().setFont(font);
        for (const int axis : {0, 1})
            ruler(axis, *seen);
    }

private:
    double lowerMargin() const
    {
        const Vec2 &viewport = m_pen.viewport();
        double margin = kLowerMargin;
        for (const Box2 &box : m_pen.room().taken())
            if (box.min.y() > kAtLowerEdge * viewport.y() && box.size().x() > box.size().y())
                margin = std::max(margin, viewport.y() - box.min.y() + kOverCover);
        return margin;
    }

    /// Where the ground is along the grid's y; nothing where that does not lead up.
    std::optional<double> ground() const
    {
        if (std::abs(m_grid.y.y()) < kUpright)
            return std::nullopt;
        return -m_grid.origin.y() / m_grid.y.y();
    }

    /// What is seen of the canvas' plane for certain, grid coordinates; nothing where it is seen
    /// on edge.
    std::optional<Box2> visible() const
    {
        const Vec2 &viewport = m_pen.viewport();
        std::array<double, 4> x{}, y{};
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec2 corner((i & 1U) != 0 ? viewport.x() - kRulerMargin : kRulerMargin,
                              (i & 2U) != 0 ? viewport.y() - lowerMargin() : kRulerMargin);
            const auto at = pointOnPlane(m_pen.camera(), viewport, m_grid, corner);
            if (!at)
                return std::nullopt;
            x[i] = at->x();
            y[i] = at->y();
        }
        std::sort(x.begin(), x.end());
        std::sort(y.begin(), y.end());
        Box2 box;
        box.extend(Vec2(x[1], y[1]));
        box.extend(Vec2(x[2], y[2]));
        return box;
    }

    void ruler(int axis, const Box2 &seen)
    {
        const int other = 1 - axis;
        Vec2 at = Vec2::Zero();
        // Both below and left of what is drawn, as it is seen: one that crosses it is in the way.
        const bool isUpright =
            std::abs(m_pen.camera().up().dot(axis == 0 ? m_grid.x : m_grid.y)) >
            std::abs(m_pen.camera().right().dot(axis == 0 ? m_grid.x : m_grid.y));
        const Vec3 &across = other == 0 ? m_grid.x : m_grid.y;
        const Vec3 ahead = isUpright ? m_pen.camera().right() : m_pen.camera().up();
        at[other] = ahead.dot(across) < 0.0 ? seen.max[other] : seen.min[other];
        if (const std::optional<double> level = ground(); level && axis == 0 && !isUpright)
            at[other] = std::clamp(*level, seen.min[other], seen.max[other]);
        at[axis] = 0.5 * (seen.min[axis] + seen.max[axis]);
        const double pixel = m_pen.camera().scaleAt(m_grid.toWorld(at), m_pen.viewport());
        const double perUnit = millimetresPer(m_unit);
        const double labels = roundStep(kLabelGap * pixel / perUnit) * perUnit;
        const double step =
            labels / 10.0 >= kGridPixels * 0.5 * pixel ? labels / 10.0 : labels / 5.0;
        const auto first = static_cast<long long>(std::ceil(seen.min[axis] / step));
        const auto last = static_cast<long long>(std::floor(seen.max[axis] / step));
        if (!(step > 0.0) || last - first > kMostTicks)
            return;
        const auto place = [&](double along, double ticks) {
            Vec2 p = at;
            p[axis] = along;
            p[other] -= ticks * pixel;
            return m_pen.screen(m_grid.toWorld(p));
        };
        QPainterPath lines(place(seen.min[axis], 0.0));
        lines.lineTo(place(seen.max[axis], 0.0));
        const long long perLabel = std::llround(labels / step);
        std::vector<std::pair<QPointF, QString>> texts;
        for (long long i = first; i <= last; ++i) {
            const bool isLong = i % perLabel == 0;
            const double along = static_cast<double>(i) * step;
            lines.moveTo(place(along, 0.0));
            lines.lineTo(place(along, isLong ? kLongTick : kTick));
            if (isLong)
                texts.emplace_back(place(along, kLongTick + 8.0),
                                   lengthNumber(along, m_unit, 0, 2, m_locale));
        }
        QPainter &painter = m_pen.painter();
        painter.setBrush(Qt::NoBrush);
        painter.strokePath(lines, roundPen(faded(m_pen.style().panel, 0.7), 2.6));
        painter.strokePath(lines, QPen(m_pen.style().muted, 1.0));
        for (const auto &[centre, text] : texts)
            label(centre, text);
    }

    void label(const QPointF &centre, const QString &text)
    {
        QPainter &painter = m_pen.painter();
        const QFontMetricsF metrics(painter.font());
        QPainterPath words;
        words.addText(centre.x() - 0.5 * metrics.horizontalAdvance(text),
                      centre.y() + 0.36 * metrics.ascent(), painter.font(), text);
        painter.strokePath(words, roundPen(faded(m_pen.style().panel, 0.85), 3.0));
        painter.fillPath(words, m_pen.style().muted);
        m_pen.keepFree(words.boundingRect());
    }

    MarkPen &m_pen;
    const Frame &m_grid;
    LengthUnit m_unit;
    const QLocale &m_locale;
};

} // namespace

Signs dimensionSigns(const Model &model, DimensionId lit)
{
    Signs signs;
    for (const Dimension &dimension : model.document.dimensions) {
        const auto from = placeOf(model, dimension.from), to = placeOf(model, dimension.to);
        if (!from || !to)
            continue;
        const bool isLit = lit.isValid() && dimension.id == lit;
        const SignRole role = isLit ? SignRole::Measured : SignRole::Dimension;
        signs.add(sign::Line{role, {*from, *to}, true});
        signs.add(sign::Label{role, {*from, *to}, sign::Way{*to - *from, true}});
    }
    return signs;
}

Signs loadSigns(const Model &model, const ViewState &view, LoadId hovered, LoadId selected)
{
    Signs signs;
    const std::vector<PlacedLoad> all = placedLoads(model);
    for (const auto add : {addLoadMark, addLoadWords})
        for (const PlacedLoad &placed : all) {
            const Load &load = model.document.loads[static_cast<std::size_t>(placed.load)];
            if (view.isHidden(model.ref(static_cast<std::size_t>(placed.section))))
                continue;
            const bool isLit = load.id == hovered || load.id == selected;
            add(load, placed, model, isLit ? SignRole::LoadInHand : SignRole::Load, signs);
        }
    return signs;
}

void dropWordsOfOthers(Signs &signs, bool keepsLoads)
{
    Signs kept;
    for (const Sign &sign : signs) {
        const auto *label = std::get_if<sign::Label>(&sign);
        const bool isOfOthers = label && (label->role == SignRole::Dimension ||
                                          (label->role == SignRole::Load && !keepsLoads));
        if (!isOfOthers)
            kept.add(sign);
    }
    signs = std::move(kept);
}

void paintRulers(MarkPen &pen, const Frame &grid, LengthUnit unit, const QLocale &locale)
{
    Rulers(pen, grid, unit, locale).paint();
}

} // namespace fff::ui
