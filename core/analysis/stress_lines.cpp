#include "core/analysis/stress_lines.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kApart = 3.0;       // mm between lines across one neck
constexpr double kAlike = 0.94;      // cosine: lines that lean less than 20° are across the same
constexpr double kSameCorner = 0.25; // mm
constexpr int kMostAtCorner = 4;

/// Whether the line says something that those kept do not.
bool isNew(const NeckStress &line, const std::vector<const NeckStress *> &kept)
{
    const Vec2 middle = 0.5 * (line.begin + line.end);
    const Vec2 way = (line.end - line.begin).normalized();
    int atBegin = 0, atEnd = 0;
    for (const NeckStress *other : kept) {
        const Vec2 otherWay = (other->end - other->begin).normalized();
        const bool isAlike = std::abs(way.dot(otherWay)) > kAlike;
        if (isAlike && (middle - 0.5 * (other->begin + other->end)).norm() < kApart)
            return false;
        for (const Vec2 &end : {other->begin, other->end}) {
            atBegin += (end - line.begin).norm() < kSameCorner ? 1 : 0;
            atEnd += (end - line.end).norm() < kSameCorner ? 1 : 0;
        }
    }
    return atBegin < kMostAtCorner && atEnd < kMostAtCorner;
}

} // namespace

bool areStressesKnown(const Strength &strength)
{
    return strength.verdict != HoldVerdict::NotWorkedOut &&
           strength.verdict != HoldVerdict::Unstable && strength.verdict != HoldVerdict::PullsOut;
}

std::vector<StressLine> stressLines(const Analysis &analysis, const Strength &strength,
                                    double least)
{
    std::vector<StressLine> lines;
    if (!areStressesKnown(strength))
        return lines;
    for (std::size_t i = 0; i < strength.bodies.size(); ++i) {
        const BodyStrength &body = strength.bodies[i];
        std::vector<const NeckStress *> all, kept;
        for (const NeckStress &line : body.lines)
            if (line.cornerUse >= least)
                all.push_back(&line);
        std::stable_sort(all.begin(), all.end(), [](const NeckStress *a, const NeckStress *b) {
            return a->cornerUse > b->cornerUse;
        });
        for (const NeckStress *line : all)
            if (isNew(*line, kept))
                kept.push_back(line);
        const int index = static_cast<int>(i);
        const Frame &frame = analysis.bodies.at(index).frame();
        for (const NeckStress *line : kept)
            lines.push_back({index, analysis.bodies.sectionOf(index), frame.toWorld(line->begin),
                             frame.toWorld(line->end), frame.normal(),
                             0.5 * analysis.bodies.at(index).thickness(), line->cornerUse,
                             body.strength.value_or(0.0), *line});
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const StressLine &a, const StressLine &b) { return a.use < b.use; });
    return lines;
}

} // namespace fff
