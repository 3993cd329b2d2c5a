#include "core/analysis/findings/turning_square.h"

#include "core/base/tolerances.h"
#include "core/model/moving.h"

#include <numbers>

namespace fff {

namespace {

//: %1 is the name of a section
constexpr Text kTurnSquareStep = FFF_TEXT("Step", "Turn %1 to 90°");

Message turnSquareWords(const FindingAction &action, const Finding &, const Model &model)
{
    //: %1 is the name of a section
    return {FFF_TEXT("Checks", "Turn %1 to 90°"), {nameOf(model, action.section)}};
}

/// A point that both planes have in common, nearest to the middle of the two sections.
Vec3 commonPoint(const Section &a, const Section &b)
{
    const Vec3 n = a.frame.normal(), m = b.frame.normal();
    const Vec3 middle =
        0.5 * (a.frame.toWorld(a.shape->centroid()) + b.frame.toWorld(b.shape->centroid()));
    Eigen::Matrix3d planes;
    planes << n.transpose(), m.transpose(), n.cross(m).transpose();
    return planes.inverse() *
           Vec3(n.dot(a.frame.origin), m.dot(b.frame.origin), n.cross(m).dot(middle));
}

std::optional<FindingEdit> turnedSquare(const FindingAction &action, const Finding &finding,
                                        const Analysis &analysis, const Flips *)
{
    const Model &model = analysis.model;
    const SectionRef &other = finding.sections[finding.sections[0] == action.section ? 1 : 0];
    const int own = model.indexOf(action.section), mate = model.indexOf(other);
    if (own < 0 || mate < 0 || !action.section.drawn.isValid())
        return {};
    const Section &section = *model.section(static_cast<std::size_t>(own));
    const Section &to = *model.section(static_cast<std::size_t>(mate));
    const Vec3 n = section.frame.normal(), m = to.frame.normal();
    const Vec3 axis = n.cross(m);
    if (axis.norm() < kSameDirection)
        return {}; // parallel: there is no line to turn about
    // By how much its normal has to go on, away from the other's.
    const double angle = std::atan2(axis.norm(), n.dot(m));
    const double by = angle - 0.5 * std::numbers::pi;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(by, axis.normalized()).toRotationMatrix();
    const SectionMove move{section.id, Similarity::turned(turn, commonPoint(section, to)), true};
    Result<Document> next = movedSections(model.document, std::span(&move, 1));
    if (!next)
        return {};
    return FindingEdit{Step(kTurnSquareStep, {nameOf(model, action.section)}), *std::move(next)};
}

} // namespace

const ActionKind kTurnSquare{turnSquareWords, turnedSquare};

std::vector<FindingAction> turnEither(const Finding &finding, const Analysis &analysis)
{
    if (finding.sections.size() != 2)
        return {};
    const auto isDrawnOn = [&](const SectionRef &one, const SectionRef &on) {
        const int index = analysis.model.indexOf(one);
        if (index < 0)
            return false;
        const auto &parent = analysis.model.section(static_cast<std::size_t>(index))->parent;
        return parent && parent->section == on;
    };
    std::vector<FindingAction> all;
    // The child first; a parent that is turned takes all with it that was drawn on it.
    const bool isFirst = isDrawnOn(finding.sections[0], finding.sections[1]);
    all.push_back({&kTurnSquare, finding.sections[isFirst ? 0 : 1]});
    if (!isFirst && !isDrawnOn(finding.sections[1], finding.sections[0]))
        all.push_back({&kTurnSquare, finding.sections[0]});
    return all;
}

} // namespace fff
