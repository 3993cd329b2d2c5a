#include "ui/view/stress_marks.h"

#include "core/interaction/pick.h"
#include "ui/view/legend.h"
#include "ui/view/stress_card.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

struct StressTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::StressMarks)
};

constexpr double kThinnest = 1.5, kThickest = 4.0; // px
constexpr double kReach = 6.0;                     // px from a line: it is meant
constexpr double kRing = 24.0;                     // px across
constexpr double kChipGap = 8.0;                   // px between legend and chip
constexpr double kReadable = 9.0, kFading = 3.0;   // px: so wide a band of colours can be read

double widthOf(double use)
{
    const double share =
        std::clamp((use - kFirstStressColour) / (1.0 - kFirstStressColour), 0.0, 1.0);
    return kThinnest + share * (kThickest - kThinnest);
}

/// On the face towards the eye.
Vec3 onFace(const Vec3 &point, const StressLine &line, const Camera &camera)
{
    const double side = line.normal.dot(camera.backward()) < 0.0 ? -1.0 : 1.0;
    return point + side * line.half * line.normal;
}

/// Whether no other section stands before a place of one, by more than its half thickness.
bool isSeen(const Vec3 &place, int section, double half, const Model &model, const ViewState &view,
            const Camera &camera, const Vec2 &viewport)
{
    if (view.isHidden(model.ref(static_cast<std::size_t>(section))))
        return false;
    const Ray ray = camera.rayThrough(camera.toScreen(place, viewport), viewport);
    const double distance = (place - ray.origin).dot(ray.direction);
    for (const Hit &hit : pick(model, ray, view)) {
        if (hit.section != section && hit.distance < distance - half)
            return false;
        if (hit.distance >= distance)
            break;
    }
    return true;
}

bool isSeen(const StressLine &line, const StressMarks &marks, const ViewState &view,
            const Camera &camera, const Vec2 &viewport)
{
    return isSeen(0.5 * (line.from + line.to), line.section, line.half, marks.analysis->model, view,
                  camera, viewport);
}

/// Of feet that are seen, and all that act at joints.
std::vector<ForceMark> seenForces(const MarkPen &pen, const StressMarks &marks,
                                  const ViewState &view)
{
    std::vector<ForceMark> seen;
    const Model &model = marks.analysis->model;
    for (const ForceMark &mark : marks.forces) {
        const int section = mark.foot < 0 ? -1 : marks.analysis->bodies.sectionOf(mark.foot);
        const double half =
            section < 0 ? 0.0 : 0.5 * model.stockOf(static_cast<std::size_t>(section)).thickness;
        if (section < 0 ||
            isSeen(mark.at, section, half, model, view, pen.camera(), pen.viewport()))
            seen.push_back(mark);
    }
    return seen;
}

/// isOnColours  the stress is drawn all over the place: no more than that in a width to be seen
void paintLine(MarkPen &pen, const StressLine &line, double alpha, bool isOnColours)
{
    const QPointF from = pen.screen(onFace(line.from, line, pen.camera()));
    const QPointF to = pen.screen(onFace(line.to, line, pen.camera()));
    QPainterPath path(from);
    path.lineTo(to);
    QPainter &painter = pen.painter();
    const double width = widthOf(line.use);
    const QColor colour = stressColour(line.use, pen.style().isForColourBlind);
    const QColor casing = pen.style().casing.isValid() ? pen.style().casing : QColor(Qt::white);
    const bool isOver = line.use > 1.0 && !isOnColours;
    if (!isOnColours)
        painter.strokePath(path,
                           roundPen(faded(casing, alpha), width + 2.0 + (isOver ? 3.0 : 0.0)));
    if (!isOver) {
        painter.strokePath(path, roundPen(faded(colour, alpha), width));
        return;
    }
    const QPointF way = to - from;
    const double length = std::max(1e-9, std::hypot(way.x(), way.y()));
    const QPointF across = 2.2 / length * QPointF(-way.y(), way.x());
    for (const double side : {-1.0, 1.0}) {
        QPainterPath one(from + side * across);
        one.lineTo(to + side * across);
        painter.strokePath(one, roundPen(faded(colour, alpha), 2.0));
    }
}

/// The stress is drawn all over it.
bool hasField(const StressMarks &marks, int body)
{
    return marks.bent && marks.bent->fields[static_cast<std::size_t>(body)];
}

/// How much of a line is drawn: all of it, but where the colours at its place can be read. They are
/// on the face and on the wall at its end, so that both make a band as wide as both are seen.
double shareOfLine(const StressLine &line, const StressMarks &marks, const MarkPen &pen)
{
    if (!hasField(marks, line.body))
        return 1.0;
    const auto seen = [&](const Vec3 &from, const Vec3 &to) {
        const QPointF way = pen.screen(to) - pen.screen(from);
        return std::hypot(way.x(), way.y());
    };
    const double band = seen(line.from, line.to) + seen(line.from - line.half * line.normal,
                                                        line.from + line.half * line.normal);
    return std::clamp((kReadable - band) / kFading, 0.0, 1.0);
}

double paintStressLegend(MarkPen &pen, const StressMarks &marks, const QLocale &locale)
{
    const double limit = marks.lines.empty() ? marks.limit : marks.lines.back().limit;
    Legend legend{StressTexts::tr("Stress"), {QStringLiteral("%"), QStringLiteral("MPa")}};
    legend.bottom = marks.least;
    for (const double use : {0.2, 0.4, 0.6, 0.8, 1.0})
        if (use >= marks.least)
            legend.ticks.push_back(
                {(use - marks.least) / (1.0 - marks.least),
                 {locale.toString(100.0 * use, 'f', 0),
                  limit > 0.0 ? locale.toString(limit * use, 'g', 3) : QString()}});
    if (marks.safety > 0.0)
        //: in the legend of stress: %1 is the safety factor, such as 2
        legend.note =
            StressTexts::tr("Safety factor %1").arg(locale.toString(marks.safety, 'g', 3));
    return paintLegend(pen, legend);
}

/// So far below what stands under the cube, px; says where its own lower end is.
double chipUnderCube(MarkPen &pen, double below, const QString &text)
{
    constexpr double kHalfChip = 11.0; // px
    const QPointF at = underCube(pen.viewport()) + QPointF(0.0, below + kHalfChip);
    pen.chip(at, MarkPen::Anchor::Right, text, pen.style().muted, MarkPen::Rank::InHand);
    return at.y() + kHalfChip;
}

} // namespace

StressMarks stressMarksOf(AnalysisPointer analysis, const Strength &strength, double least)
{
    StressMarks marks;
    marks.least = least;
    marks.lines = stressLines(*analysis, strength, marks.least);
    marks.verdict = strength.verdict;
    marks.isRated = std::all_of(strength.bodies.begin(), strength.bodies.end(),
                                [](const BodyStrength &body) { return body.strength.has_value(); });
    if (strength.worst >= 0)
        marks.limit =
            strength.bodies[static_cast<std::size_t>(strength.worst)].strength.value_or(0.0);
    marks.analysis = std::move(analysis);
    return marks;
}

double worstShown(const StressMarks &marks)
{
    const bool hasLines = !marks.lines.empty() && marks.lines.back().use >= marks.least;
    double worst = hasLines ? marks.lines.back().use : 0.0;
    for (std::size_t i = 0; marks.bent && i < marks.bent->fields.size(); ++i)
        if (marks.bent->fields[i] && marks.bent->fields[i]->most >= marks.least)
            worst = std::max(worst, static_cast<double>(marks.bent->fields[i]->most));
    return worst;
}

QString withoutLines(const StressMarks &marks, const QLocale &locale)
{
    if (marks.verdict == HoldVerdict::Unstable)
        return StressTexts::tr("It does not stand; no stress is shown.");
    if (marks.verdict == HoldVerdict::PullsOut)
        return StressTexts::tr("A joint is pulled open; no stress is shown.");
    if (marks.verdict == HoldVerdict::NotWorkedOut)
        return StressTexts::tr("Whether it holds could not be worked out.");
    if (!marks.isRated)
        return StressTexts::tr("Strength unknown");
    //: %1 is a number of percent
    return StressTexts::tr("Nothing above %1\u202f%")
        .arg(locale.toString(100.0 * marks.least, 'f', 0));
}

int lineAt(const QPointF &point, const StressMarks &marks, const Camera &camera,
           const Vec2 &viewport, const ViewState &view)
{
    const Vec2 at(point.x(), point.y());
    const auto distanceTo = [&](const StressLine &line) {
        const Vec2 from = camera.toScreen(onFace(line.from, line, camera), viewport);
        const Vec2 way = camera.toScreen(onFace(line.to, line, camera), viewport) - from;
        const double square = way.squaredNorm();
        const double share = square > 0.0 ? std::clamp(way.dot(at - from) / square, 0.0, 1.0) : 0.0;
        return (from + share * way - at).norm();
    };
    int best = -1;
    double least = kReach;
    for (int i = static_cast<int>(marks.lines.size()) - 1; i >= 0; --i) { // what is on top first
        const StressLine &line = marks.lines[static_cast<std::size_t>(i)];
        const double distance = distanceTo(line);
        if (distance < least && isSeen(line, marks, view, camera, viewport)) {
            least = distance;
            best = i;
        }
    }
    return best;
}

void paintStress(MarkPen &pen, const StressMarks &marks, const ViewState &view,
                 const QLocale &locale)
{
    for (std::size_t i = 0; i < marks.lines.size(); ++i) {
        const StressLine &line = marks.lines[i];
        const bool isAsked = static_cast<int>(i) == marks.lit;
        const double share = isAsked ? 1.0 : shareOfLine(line, marks, pen);
        if (share > 0.0 && isSeen(line, marks, view, pen.camera(), pen.viewport()))
            paintLine(pen, line, share * (marks.isOlder ? kOlderStress : 1.0),
                      !isAsked && hasField(marks, line.body));
    }
    const bool hasWorst = !marks.lines.empty() && marks.lines.back().use > 1.0;
    if (hasWorst) {
        const StressLine &worst = marks.lines.back();
        constexpr double kBeside = 24.0; // px
        pen.chip(pen.screen(0.5 * (worst.from + worst.to)) + QPointF(kBeside, -kBeside),
                 MarkPen::Anchor::Left,
                 //: %1 is a number of percent
                 StressTexts::tr("%1\u202f%").arg(locale.toString(100.0 * worst.use, 'f', 0)),
                 pen.style().problem); // as text the colours of stress are too dark in the dark
    }
    paintForces(pen, seenForces(pen, marks, view), marks.isOlder, locale,
                kMostForceNumbers - (hasWorst ? 1 : 0));
    paintStressKey(pen, marks, locale);
}

double paintStressKey(MarkPen &pen, const StressMarks &marks, const QLocale &locale)
{
    if (worstShown(marks) > 0.0)
        return paintStressLegend(pen, marks, locale);
    return chipUnderCube(pen, 0.0, withoutLines(marks, locale));
}

void paintMovedKey(MarkPen &pen, const StressMarks *marks, double times, const QLocale &locale)
{
    double below = 0.0;
    if (marks)
        below = paintStressKey(pen, *marks, locale) - underCube(pen.viewport()).y() + kChipGap;
    chipUnderCube(pen, below,
                  //: %1 is a number of times
                  StressTexts::tr("Movement %1\u202f×")
                      .arg(locale.toString(times, 'g', times < 10.0 ? 2 : 3)));
}

void paintAskedLine(MarkPen &pen, const StressMarks &marks, const QLocale &locale)
{
    if (marks.lit < 0 || marks.lit >= static_cast<int>(marks.lines.size()))
        return;
    const StressLine &lit = marks.lines[static_cast<std::size_t>(marks.lit)];
    const QPointF middle = pen.screen(onFace(0.5 * (lit.from + lit.to), lit, pen.camera()));
    QPainterPath ring;
    ring.addEllipse(middle, 0.5 * kRing, 0.5 * kRing);
    pen.cased(ring, QPen(pen.style().accent, 2.0));
    if (marks.hasCard)
        paintStressCard(pen, *marks.analysis, lit, middle, locale);
}

} // namespace fff::ui
