#include "ui/view/bearing_marks.h"

#include "core/session/message_text.h"
#include "ui/view/legend.h"
#include "ui/view/stress_colours.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

struct BearingTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::BearingMarks)
};

constexpr double kLeastUse = 0.2;                // that colours begin at
constexpr double kWidestScale = 1000.0;          // of the least mass
constexpr double kFilm = 0.92, kOlderFilm = 0.3; // alpha
constexpr double kNotOver = 0.999;               // more than all is hatched
constexpr double kAboveLegend = 12.0;            // px
constexpr int kMarksOnBar = 5;
constexpr double kBesidePlace = 18.0; // px

double mostOnScale(const BearingMap &map)
{
    return map.least > 0.0 ? std::min(map.most, kWidestScale * map.least) : map.most;
}

/// To three figures: a scale needs no more.
QString massOnScale(double kg, const QLocale &locale)
{
    constexpr double kGrams = 1000.0;
    const bool isSmall = kg < 1.0;
    const double number = isSmall ? kGrams * kg : kg;
    const int decimals = number < 10.0 ? 2 : number < 100.0 ? 1 : 0;
    return QStringLiteral("%1\u202f%2")
        .arg(locale.toString(number, 'f', decimals),
             isSmall ? QStringLiteral("g") : QStringLiteral("kg"));
}

void paintBearingLegend(MarkPen &pen, const BearingMarks &marks, const QLocale &locale)
{
    const BearingMap &map = *marks.map;
    const double most = mostOnScale(map);
    // From what is weak, on top as in the legend of stress, to what is strong.
    const auto massAt = [&](double share) {
        return map.least > 0.0 ? map.least * std::pow(most / map.least, share) : share * most;
    };
    Legend legend{BearingTexts::tr("Holds")};
    legend.bottom = kLeastUse;
    for (int i = 0; i < kMarksOnBar; ++i) {
        const double share = static_cast<double>(i) / (kMarksOnBar - 1);
        legend.ticks.push_back({1.0 - share, {massOnScale(massAt(share), locale)}});
    }
    if (marks.saysRigid)
        legend.note = BearingTexts::tr("Without bending");
    paintLegend(pen, legend);
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

StressFieldPointer bearingField(const BearingMap &map)
{
    StressField field;
    field.points = map.points;
    field.triangles = map.triangles;
    field.moved.assign(map.points.size(), Eigen::Vector3f::Zero());
    for (const Bearing &bearing : map.bearings)
        field.use[0].push_back(
            static_cast<float>(std::min(bearingUse(map, bearing.mass), kNotOver)));
    field.use[1] = field.use[0];
    field.most = 1.0f;
    return std::make_shared<const StressField>(std::move(field));
}

double bearingAlpha(const BearingMarks &marks)
{
    return marks.isOlder ? kOlderFilm : kFilm;
}

void paintBearing(MarkPen &pen, const BearingMarks &marks, const QLocale &locale)
{
    if (marks.map && !marks.map->points.empty())
        paintBearingLegend(pen, marks, locale);
    if (!marks.said.isEmpty())
        pen.chip(underCube(pen.viewport()) - QPointF(0.0, kAboveLegend), MarkPen::Anchor::Right,
                 marks.said, pen.style().muted, MarkPen::Rank::InHand);
}

void paintAskedBearing(MarkPen &pen, const BearingMarks &marks)
{
    if (!marks.asked || !marks.map)
        return;
    const QPointF place = pen.screen(marks.place);
    pen.ring(place, 5.0, pen.style().accent);
    pen.chip(place + QPointF(kBesidePlace, -kBesidePlace), MarkPen::Anchor::Left,
             messageText(bearingText(*marks.asked, marks.map->analysis->model)), pen.style().text,
             MarkPen::Rank::InHand);
}

} // namespace fff::ui
