#include "ui/view/force_marks.h"

#include "core/analysis/stress_lines.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff::ui {

namespace {

struct ForceTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ForceMarks)
};

constexpr double kShaft = 2.4, kTip = 7.0;                    // px
constexpr double kLongestArrow = 40.0, kShortestArrow = 12.0; // px
constexpr double kApartOnScreen = 48.0, kWordsApart = 90.0;   // px
constexpr double kLeastForce = 5e-3;                          // N: less is written as nothing
constexpr double kBesideFoot = 6.0;                           // px between an arrow and its number

void paintForce(MarkPen &pen, const QPointF &tip, const QPointF &way, const QColor &colour)
{
    const double length = std::hypot(way.x(), way.y());
    const QPointF along = way / length, across(-along.y(), along.x());
    QPainterPath shaft(tip - way);
    shaft.lineTo(tip - 0.7 * kTip * along);
    pen.cased(shaft, QPen(colour, kShaft, Qt::SolidLine, Qt::FlatCap));
    QPainterPath head(tip);
    head.lineTo(tip - kTip * along + 0.5 * kTip * across);
    head.lineTo(tip - kTip * along - 0.5 * kTip * across);
    head.closeSubpath();
    pen.painter().fillPath(head, colour);
}

/// Of feet that would lie on each other one, where their forces have their middle: what the ground
/// presses with there.
std::vector<ForceMark> toldApart(const MarkPen &pen, const std::vector<ForceMark> &forces)
{
    std::vector<ForceMark> kept;
    for (const ForceMark &mark : forces) {
        const QPointF place = pen.screen(mark.at);
        const auto same = std::find_if(kept.begin(), kept.end(), [&](const ForceMark &other) {
            const QPointF way = pen.screen(other.at) - place;
            return mark.foot >= 0 && other.foot >= 0 &&
                   std::hypot(way.x(), way.y()) < kApartOnScreen;
        });
        if (same == kept.end()) {
            kept.push_back(mark);
            continue;
        }
        const double before = same->force.norm(), more = mark.force.norm();
        same->at = (before * same->at + more * mark.at) / (before + more);
        same->force += mark.force;
    }
    return kept;
}

/// The arrow's other end, px; the same where the force is nothing, or leads along the line of
/// sight.
QPointF paintArrow(MarkPen &pen, const ForceMark &mark, const QPointF &tip, double largest,
                   const QColor &colour)
{
    const double size = mark.force.norm();
    if (!(size > 0.0))
        return tip;
    // One mm of the force's way tells where it points in the view.
    const QPointF step = pen.screen(mark.at + mark.force / size) - tip;
    const double onScreen = std::hypot(step.x(), step.y());
    if (!(onScreen > 0.0))
        return tip;
    const double length = std::max(kShortestArrow, kLongestArrow * size / largest);
    const QPointF way = length / onScreen * step, end = tip - way;
    paintForce(pen, tip, way, colour);
    pen.keepFree(tip, end, 0.5 * kTip);
    return end;
}

/// A force whose number is said, and of how many that are near.
struct Told
{
    const ForceMark *mark;
    QPointF tip, end; // px
    int count = 1;

    double size() const { return mark->isOpen ? mark->pull : mark->force.norm(); }
};

/// What is said of a force out of sight would stick to the view's border, and of one under a badge
/// or a bar beside that.
bool isInSight(const MarkPen &pen, const QPointF &tip, const std::vector<Box2> &covered)
{
    const QRectF view(0.0, 0.0, pen.viewport().x(), pen.viewport().y());
    return view.contains(tip) && std::none_of(covered.begin(), covered.end(), [&](const Box2 &box) {
               return box.contains(Vec2(tip.x(), tip.y()));
           });
}

/// Joints pulled open so near to each other that their words would stand in a heap: the one that is
/// pulled most speaks for them. told: the largest first.
void joinNear(std::vector<Told> &told)
{
    std::vector<Told> kept;
    for (const Told &one : told) {
        const auto same = std::find_if(kept.begin(), kept.end(), [&](const Told &other) {
            const QPointF way = other.tip - one.tip;
            return one.mark->isOpen && other.mark->isOpen &&
                   std::hypot(way.x(), way.y()) < kWordsApart;
        });
        if (same == kept.end())
            kept.push_back(one);
        else
            ++same->count;
    }
    told = std::move(kept);
}

QString openWords(const Told &open, const QLocale &locale)
{
    const QString pull = locale.toString(open.mark->pull, 'f', 1);
    if (open.count == 1)
        //: %1 is a force in newtons
        return ForceTexts::tr("pulled open, %1\u202fN").arg(pull);
    //: %1 is a force in newtons
    return ForceTexts::tr("%n joints pulled open, up to %1\u202fN", nullptr, open.count).arg(pull);
}

} // namespace

std::vector<ForceMark> footForces(const Strength &strength)
{
    std::vector<ForceMark> marks;
    if (!areStressesKnown(strength))
        return marks;
    const auto &feet = strength.made.structure.feet;
    for (std::size_t i = 0; i < feet.size(); ++i) {
        const Vec3 &force = strength.equilibrium().feet[i].force;
        if (force.norm() > kLeastForce)
            marks.push_back({feet[i].point, force, feet[i].member});
    }
    return marks;
}

std::vector<ForceMark> jointForces(const Analysis &analysis, const Strength &strength,
                                   std::optional<int> section)
{
    std::vector<ForceMark> marks;
    if (!areStressesKnown(strength))
        return marks;
    const auto &links = strength.made.structure.links;
    for (std::size_t i = 0; i < links.size(); ++i) {
        const bool isA = !section || analysis.bodies.sectionOf(links[i].a) == *section;
        if (!isA && analysis.bodies.sectionOf(links[i].b) != *section)
            continue;
        const LinkForce &force = strength.equilibrium().links[i];
        const Vec3 own = isA ? force.onA.force : Vec3(-force.onA.force);
        // Fingers are two links at one place, and what a person sees there is one joint.
        if (links[i].kind == LinkKind::Fingers && !marks.empty() &&
            marks.back().at == links[i].point) {
            ForceMark &same = marks.back();
            same.force += own;
            same.isOpen = same.isOpen || force.isOpen;
            same.pull = std::max(same.pull, force.asked);
            continue;
        }
        if (force.onA.force.norm() > kLeastForce || force.isOpen)
            marks.push_back({links[i].point, own, -1, force.isOpen, force.asked});
    }
    return marks;
}

void paintForces(MarkPen &pen, const std::vector<ForceMark> &all, bool isOlder,
                 const QLocale &locale, int most)
{
    const std::vector<Box2> covered = pen.room().taken(); // before any arrow is
    // Forces are known of what holds: a joint that is pulled open there carries nothing, and is no
    // fault that is to be red.
    const auto colourOf = [&](const ForceMark &mark) {
        return mark.isOpen || isOlder ? pen.style().muted : pen.style().text;
    };
    std::vector<Told> told;
    const std::vector<ForceMark> forces = toldApart(pen, all);
    double largest = 0.0;
    for (const ForceMark &mark : forces)
        largest = std::max(largest, mark.force.norm());
    for (const ForceMark &mark : forces) {
        const QPointF tip = pen.screen(mark.at);
        const QPointF end = paintArrow(pen, mark, tip, largest, colourOf(mark));
        if ((mark.isOpen || mark.foot >= 0) && isInSight(pen, tip, covered))
            told.push_back({&mark, tip, end});
    }
    std::stable_sort(told.begin(), told.end(), [](const Told &a, const Told &b) {
        return std::pair(a.mark->isOpen, a.size()) > std::pair(b.mark->isOpen, b.size());
    });
    joinNear(told);
    if (told.size() > static_cast<std::size_t>(std::max(most, 0)))
        told.resize(static_cast<std::size_t>(std::max(most, 0)));
    for (const Told &one : told) {
        if (one.mark->isOpen)
            pen.chip(one.end + QPointF(kBesideFoot, 0.0), MarkPen::Anchor::Left,
                     openWords(one, locale), colourOf(*one.mark));
        else
            pen.chip({.place = one.end + QPointF(0.0, kBesideFoot + 8.0),
                      .text = locale.toString(one.size(), 'f', one.size() < 1.0 ? 2 : 1) +
                              QStringLiteral("\u202fN"),
                      .colour = colourOf(*one.mark),
                      .rank = MarkPen::Rank::OfModel,
                      .isFramed = false});
    }
}

} // namespace fff::ui
