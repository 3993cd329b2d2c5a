#include "core/analysis/findings/strengthening.h"

#include "core/analysis/findings/moving_slits.h"
#include "core/analysis/findings/second_foot.h"
#include "core/analysis/findings/strength_judge.h"
#include "core/analysis/findings/wider_neck.h"
#include "core/model/edits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

//: %1 is the name of a stock, %2 a length
constexpr Text kThickenStep = FFF_TEXT("Step", "Make %1 %2 thick");
//: %1 is the thickness, the least one that is sold and that holds
constexpr Text kThisThickText = FFF_TEXT("Checks", "Use stock %1 thick");

/// mm: sheets that are sold.
constexpr std::array kUsual{1.0, 1.5, 2.0,  2.5,  3.0,  4.0,  5.0, 6.0,
                            8.0, 9.0, 10.0, 12.0, 15.0, 18.0, 21.0};
/// Nobody makes the same thing of a sheet so many times as thick.
constexpr double kMostThicker = 4.0;
/// What is left of a slit's depth, tried in this order.
constexpr std::array kLeftOfDepth{0.85, 0.7, 0.55, 0.4};

std::optional<FindingEdit> thickened(const FindingAction &, const Finding &finding,
                                     const Analysis &analysis, const Flips *)
{
    const int section = analysis.model.indexOf(finding.sections.front());
    if (section < 0)
        return {};
    const Stock stock = analysis.model.stockOf(static_cast<std::size_t>(section));
    std::vector<double> thicker;
    for (const double thickness : kUsual)
        if (thickness > stock.thickness && thickness <= kMostThicker * stock.thickness)
            thicker.push_back(thickness);
    StrengthJudge judge(analysis, finding);
    return firstThatHolds(thicker, judge, [&](double thickness) -> std::optional<FindingEdit> {
        Stock changed = stock;
        changed.thickness = thickness;
        Result<Document> next = setStock(analysis.model.document, changed);
        if (!next)
            return {};
        return FindingEdit{Step(kThickenStep, {Named{stock.name}, lengthOf(thickness)}),
                           *std::move(next),
                           {},
                           {kThisThickText, {lengthOf(thickness)}}};
    });
}

/// The slit that the weakest place ends at.
const Slit *weakeningSlit(const WeakPlace &place, const Analysis &analysis)
{
    const int host = analysis.model.indexOf(place.section);
    const int guest = place.guest ? analysis.model.indexOf(*place.guest) : -1;
    if (host < 0 || guest < 0)
        return nullptr;
    const auto index = static_cast<std::size_t>(host);
    const Frame &frame = analysis.model.section(index)->frame;
    const Vec2 from = frame.toLocal(place.from), to = frame.toLocal(place.to);
    const auto distance = [&](const Slit &slit) {
        return std::min((slit.inner - from).norm(), (slit.inner - to).norm());
    };
    const Slit *nearest = nullptr;
    for (const Slit &slit : analysis.assembly.slits[index])
        if (slit.guest == guest && slit.role == SlitRole::Slit &&
            (!nearest || distance(slit) < distance(*nearest)))
            nearest = &slit;
    return nearest;
}

std::optional<FindingEdit> cutShallower(const FindingAction &, const Finding &finding,
                                        const Analysis &analysis, const Flips *)
{
    const WeakPlace &place = *finding.details<Held>()->weakest;
    const Slit *slit = weakeningSlit(place, analysis);
    if (!slit)
        return {};
    const double depth = (slit->mouth - slit->inner).norm();
    StrengthJudge judge(analysis, finding);
    return firstThatHolds(kLeftOfDepth, judge, [&](double left) {
        return cutLessDeepBy((1.0 - left) * depth, *slit, place.section, *place.guest, analysis);
    });
}

constexpr Text kThickerText = FFF_TEXT("Checks", "Use thicker stock");
constexpr Text kEnterText = FFF_TEXT("Checks", "Enter its strength");

} // namespace

const ActionKind kThickerStock{plainWords<kThickerText>, thickened};
const ActionKind kEnterStrength{plainWords<kEnterText>};
const ActionKind kShallowerSlit{plainWords<kLessDeepText>, cutShallower};

std::vector<FindingAction> enterStrength(const Finding &, const Analysis &)
{
    return {{&kEnterStrength}};
}

std::vector<FindingAction> strengthen(const Finding &finding, const Analysis &)
{
    const Held *held = finding.details<Held>();
    std::vector<FindingAction> all;
    if (!held || !held->weakest || finding.sections.empty())
        return all;
    if (held->weakest->guest)
        all.push_back({&kShallowerSlit});
    all.push_back({&kWiderNeck});
    all.push_back({&kSecondFoot});
    all.push_back({&kThickerStock});
    return all;
}

} // namespace fff
