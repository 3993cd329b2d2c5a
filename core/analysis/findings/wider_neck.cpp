#include "core/analysis/findings/wider_neck.h"

#include "core/analysis/findings/drawn_source.h"
#include "core/analysis/findings/neck_growth.h"
#include "core/analysis/findings/strength_judge.h"
#include "core/analysis/findings/thin_necks.h"
#include "core/assembly/joint_editing.h"
#include "core/model/edits.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

//: %1 is the name of a section
constexpr Text kWidenNeckStep = FFF_TEXT("Step", "Make %1 wider where it is weak");
constexpr Text kWidenNeckText = FFF_TEXT("Checks", "Make it wider there");

/// So many weak places, one after the other, are made wider.
constexpr int kMostPlaces = 6;
/// By how much a neck may grow: times its own length, or times the thickness of its sheet.
constexpr double kMostOfLength = 3.0, kMostOfThickness = 12.0;
constexpr double kLeastWider = 0.2; // mm
/// Growths that are tried on the way up, and of the last step between two of them.
constexpr int kGrowths = 7, kHalvings = 4;
/// A place is strong enough by this much more than it has to be: its numbers are refined anew.
constexpr double kSparing = 0.99;
/// Lines that are strained by more, of what they may be, belong to the weak place.
constexpr double kWeakToo = 0.95;

Vec2 middleOf(const std::pair<Vec2, Vec2> &line)
{
    return 0.5 * (line.first + line.second);
}

/// Of these lines those that are no farther than the place is large from the weakest, or from one
/// that is.
void addBeside(std::vector<std::pair<Vec2, Vec2>> lines, WeakNeck &weak)
{
    for (std::size_t next = 0; next < weak.lines.size(); ++next) {
        const Vec2 middle = middleOf(weak.lines[next]);
        const auto near = std::partition(lines.begin(), lines.end(), [&](const auto &line) {
            return (middleOf(line) - middle).norm() >= weak.size();
        });
        weak.lines.insert(weak.lines.end(), near, lines.end());
        lines.erase(near, lines.end());
    }
}

using Use = double NeckStress::*;

std::optional<WeakNeck> weakestOf(const StrengthJudge::Judged &judged, double safety, Use use)
{
    const bool isNeck = use == &NeckStress::neckUse;
    const int body = isNeck ? judged.strength.worstNeck : judged.strength.worst;
    if (body < 0)
        return {};
    const BodyStrength &strained = judged.strength.bodies[static_cast<std::size_t>(body)];
    const auto &worst = isNeck ? strained.neck : strained.corner;
    if (!worst || (*worst).*use * safety <= 1.0)
        return {};
    const Model &model = judged.analysis->model;
    const auto index = static_cast<std::size_t>(judged.analysis->bodies.sectionOf(body));
    const std::optional<DrawnSource> source = drawnSourceOf(model, index);
    if (!source)
        return {};
    WeakNeck weak;
    weak.section = source->section->id;
    weak.thickness = model.stockOf(index).thickness;
    weak.use = (*worst).*use * safety;
    weak.from = source->placeOf(worst->begin);
    weak.to = source->placeOf(worst->end);
    weak.length = (weak.to - weak.from).norm();
    weak.lines.emplace_back(weak.from, weak.to);
    std::vector<std::pair<Vec2, Vec2>> others;
    for (const NeckStress &line : strained.lines)
        if (line.counts() && line.*use * safety > kWeakToo)
            others.emplace_back(source->placeOf(line.begin), source->placeOf(line.end));
    addBeside(std::move(others), weak);
    return weak;
}

/// Where the ends of slits would move, since a section reaches farther now, they go back to where
/// they were.
Document withSlitsKept(const Analysis &before, const StrengthJudge::Judged &after,
                       Document document)
{
    const Model &model = after.analysis->model;
    for (const Joint &joint : before.assembly.joints) {
        const Joint *now = after.analysis->assembly.joints.find(joint.a, joint.b);
        if (!now || now->crossing == joint.crossing || joint.crossing->overlaps.size() != 1)
            continue;
        const Axis &axis = now->crossing->axis;
        const Vec3 was = joint.crossing->axis.at(joint.crossing->overlaps[0].meet);
        const double by = (was - axis.at(now->crossing->overlaps[0].meet)).dot(axis.direction);
        if (std::abs(by) < kEqualEnds)
            continue;
        Model current = evaluate(document, model);
        const JointRef ref(model.ref(static_cast<std::size_t>(joint.a)),
                           model.ref(static_cast<std::size_t>(joint.b)));
        if (JointEdit edit = nudgeMeetingPoints(current, ref, by))
            document = std::move(edit->document);
    }
    return document;
}

/// Makes one place after the other wider.
class Widening
{
public:
    Widening(const Analysis &analysis, const Finding &finding)
        : m_judge(analysis, finding), m_start(analysis.model.document)
    {
    }

    /// Nothing where it does not help.
    std::optional<Document> until(Use use)
    {
        Document document = m_start;
        for (int place = 0; place < kMostPlaces; ++place) {
            const StrengthJudge::Judged judged = m_judge.on(document); // others come in between
            const auto weak = weakestOf(judged, m_judge.safety(), use);
            if (!weak)
                break;
            std::optional<Document> next;
            for (const NeckSides sides : {NeckSides::Both, NeckSides::First, NeckSides::Last})
                if ((next = widened(judged, document, *weak, sides, use)))
                    break;
            if (!next)
                break;
            document = *std::move(next);
        }
        if (document.isSame(m_start) || !m_judge.isBetter(m_judge.verdictOn(document)))
            return {};
        return document;
    }

private:
    /// Nothing where it cannot be had.
    std::optional<Document> grown(const StrengthJudge::Judged &before, const Document &document,
                                  const WeakNeck &weak, NeckSides sides, double growth)
    {
        const Section &section = *document.find(weak.section);
        std::optional<ShapePointer> shape = grownShape(section, weak, sides, growth);
        if (!shape)
            return {};
        Result<Document> next = setShape(document, section.id, *std::move(shape));
        if (!next)
            return {};
        const StrengthJudge::Judged &after = m_judge.on(*next);
        if (!meetAsBefore(*before.analysis, *after.analysis))
            return {};
        return withSlitsKept(*before.analysis, after, *std::move(next));
    }

    /// Whether what was weak there is not any more; what else may be is another matter.
    bool bears(const Document &document, const WeakNeck &weak, Use use)
    {
        const auto now = weakestOf(m_judge.on(document), m_judge.safety() / kSparing, use);
        if (!now || now->section != weak.section)
            return true;
        const double far = 0.5 * weak.size();
        const Vec2 middle = 0.5 * (now->from + now->to);
        return std::none_of(weak.lines.begin(), weak.lines.end(), [&](const auto &line) {
            return (middleOf(line) - middle).norm() < far;
        });
    }

    std::optional<Document> widened(const StrengthJudge::Judged &before, const Document &document,
                                    const WeakNeck &weak, NeckSides sides, Use use)
    {
        // In the plane a neck bears as the square of its length, across it as its length; it takes
        // no less than the cube root of what is missing, and more where it goes on being weak.
        const double most =
            std::max(kMostOfLength * weak.length, kMostOfThickness * weak.thickness);
        const double first = std::clamp(weak.length * (std::cbrt(weak.use) - 1.0),
                                        std::max(kLeastWider, kLeastNeck - weak.length), most);
        // Nor does it stay what another check calls too thin.
        double fails = std::max(0.0, kLeastNeck - weak.length), holds = 0.0;
        std::optional<Document> best;
        for (int i = 0; i < kGrowths && !best; ++i) {
            const double growth = first * std::pow(most / first, i / (kGrowths - 1.0));
            auto next = grown(before, document, weak, sides, growth);
            if (!next)
                return {}; // it would cross something, and more so when it is wider
            (bears(*next, weak, use) ? holds : fails) = growth;
            if (holds > 0.0)
                best = std::move(next);
        }
        for (int i = 0; i < kHalvings && best && holds - fails > kLeastWider; ++i) {
            const double growth = 0.5 * (fails + holds);
            auto next = grown(before, document, weak, sides, growth);
            if (next && bears(*next, weak, use)) {
                best = std::move(next);
                holds = growth;
            } else {
                fails = growth;
            }
        }
        return best;
    }

    StrengthJudge m_judge;
    const Document &m_start;
};

std::optional<FindingEdit> neckWidened(const FindingAction &, const Finding &finding,
                                       const Analysis &analysis, const Flips *)
{
    const int index = analysis.model.indexOf(finding.sections.front());
    if (index < 0)
        return {};
    const auto source = drawnSourceOf(analysis.model, static_cast<std::size_t>(index));
    if (!source)
        return {};
    Widening widening(analysis, finding);
    std::optional<Document> next = widening.until(&NeckStress::cornerUse);
    if (!next)
        next = widening.until(&NeckStress::neckUse);
    if (!next)
        return {};
    return FindingEdit{Step(kWidenNeckStep, {Named{source->section->name}}), *std::move(next)};
}

} // namespace

const ActionKind kWiderNeck{plainWords<kWidenNeckText>, neckWidened};

} // namespace fff
