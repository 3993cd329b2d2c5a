#include "ui/view/legend.h"

#include "core/interaction/view_cube.h"
#include "ui/view/heading_weight.h"
#include "ui/view/stress_colours.h"

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kBelowCube = 12.0, kBeside = 8.0; // px, to the cube and the view's border
constexpr double kLegendWidth = 108.0, kMarginInside = 12.0;
constexpr double kTitleRow = 32.0, kHeadRow = 22.0, kNoteRow = 20.0; // px
constexpr double kBarWidth = 12.0, kBarHeight = 160.0;
constexpr double kFirstColumn = 34.0, kNextColumn = 42.0; // px, from the bar to the end of numbers
constexpr double kGroundAlpha = 0.72;
constexpr int kRampStops = 16;

} // namespace

QPointF underCube(const Vec2 &viewport)
{
    const auto cube = cubeCentre(viewport);
    return {viewport.x() - kBeside, (cube ? cube->y() + 0.5 * kCubeRoom : 0.0) + kBelowCube};
}

QRectF legendRoom(const Vec2 &viewport)
{
    const QPointF corner = underCube(viewport);
    return {corner.x() - kLegendWidth, corner.y(), kLegendWidth,
            kTitleRow + kHeadRow + kBarHeight + kMarginInside + kNoteRow};
}

double paintLegend(MarkPen &pen, const Legend &legend)
{
    QPainter &painter = pen.painter();
    const ViewStyle &style = pen.style();
    QFont font = painter.font();
    font.setPixelSize(12);
    QFont bold = font;
    bold.setWeight(headingWeight());

    const QPointF corner = underCube(pen.viewport());
    const double head = kTitleRow + (legend.heads.isEmpty() ? 0.0 : kHeadRow);
    const double foot = kMarginInside + (legend.note.isEmpty() ? 0.0 : kNoteRow);
    const double words = std::max(QFontMetricsF(bold).horizontalAdvance(legend.title),
                                  QFontMetricsF(font).horizontalAdvance(legend.note));
    const double width = std::max(kLegendWidth, std::ceil(words) + 2.0 * kMarginInside);
    const QRectF ground(corner.x() - width, corner.y(), width, head + kBarHeight + foot);
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(style.panel, kGroundAlpha));
    painter.drawRoundedRect(ground, 3.0, 3.0);
    pen.keepFree(ground);

    const double left = ground.left() + kMarginInside;
    const QRectF bar(left, ground.top() + head, kBarWidth, kBarHeight);
    QLinearGradient ramp(bar.bottomLeft(), bar.topLeft());
    for (int i = 0; i <= kRampStops; ++i) {
        const double share = static_cast<double>(i) / kRampStops;
        ramp.setColorAt(share, stressColour(legend.bottom + share * (legend.top - legend.bottom),
                                            style.isForColourBlind));
    }
    painter.setBrush(ramp);
    painter.drawRect(bar);

    painter.setFont(bold);
    painter.setPen(style.text);
    painter.drawText(QRectF(left, ground.top() + 4.0, ground.right() - left, 18.0),
                     Qt::AlignLeft | Qt::AlignVCenter, legend.title);
    painter.setFont(font);
    const auto write = [&](int column, double y, const QString &text, const QColor &colour) {
        const double end = bar.right() + kFirstColumn + column * kNextColumn;
        const double room = column == 0 ? kFirstColumn : kNextColumn;
        painter.setPen(colour);
        painter.drawText(QRectF(end - room, y - 9.0, room, 18.0), Qt::AlignRight | Qt::AlignVCenter,
                         text);
    };
    for (int i = 0; i < legend.heads.size(); ++i)
        write(i, bar.top() - 0.5 * kHeadRow - 3.0, legend.heads[i], style.muted);
    for (const Legend::Tick &tick : legend.ticks) {
        const double y = bar.bottom() - tick.at * bar.height();
        // One column needs no other's place.
        if (tick.columns.size() == 1) {
            painter.setPen(style.text);
            painter.drawText(
                QRectF(bar.right() + 6.0, y - 9.0, ground.right() - bar.right() - 8.0, 18.0),
                Qt::AlignLeft | Qt::AlignVCenter, tick.columns.front());
            continue;
        }
        for (int i = 0; i < tick.columns.size(); ++i)
            write(i, y, tick.columns[i], i == 0 ? style.text : style.muted);
    }
    painter.setPen(style.muted);
    painter.drawText(QRectF(left, bar.bottom() + 11.0, ground.right() - left - 2.0, 18.0),
                     Qt::AlignLeft | Qt::AlignVCenter, legend.note);
    return ground.bottom();
}

} // namespace fff::ui
