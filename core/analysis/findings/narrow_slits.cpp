#include "core/analysis/findings/narrow_slits.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// A tool that is wider than the slit by rounding goes in.
constexpr double kSameWidth = kTouchingDepth;

Message narrowSentence(const Finding &finding, const Model &)
{
    const NarrowSlit &slit = *finding.details<NarrowSlit>();
    return {slit.isClosed
                ? FFF_TEXT("Checks", "Slit %1 is closed by the kerf of %2. Give the stock's slits "
                                     "more clearance, or less kerf.")
                : FFF_TEXT("Checks", "Slit %1 is narrower than the %2 tool. Give the stock's slits "
                                     "more clearance, or choose a thinner tool."),
            {widthOf(slit.width), widthOf(slit.tool)}};
}

Message tightSentence(const Finding &finding, const Model &)
{
    const TightSlits &slits = *finding.details<TightSlits>();
    return {slits.bumps > 0.0
                ? FFF_TEXT("Checks", "Between their bumps slits are %1 narrower than what goes "
                                     "into them. That is too tight for any material: make the "
                                     "bumps smaller.")
                : FFF_TEXT("Checks", "Slits are %1 narrower than what goes into them. That is too "
                                     "tight for any material."),
            {widthOf(slits.by)}};
}

Message wideSentence(const Finding &finding, const Model &)
{
    return {FFF_TEXT("Checks", "Slits are %1 wider than what goes into them, so it sits loosely."),
            {widthOf(finding.details<NarrowSlit>()->tool)}};
}

constexpr Text kWidenText = FFF_TEXT("Checks", "Set the clearance");

std::vector<FindingAction> widen(const Finding &, const Analysis &)
{
    return {{&kWidenSlits}};
}

/// About the slits of the stock that are below `least` mm wide, for a tool of that diameter;
/// without sections if none is.
Finding below(double least, double tool, bool isClosed, const Analysis &analysis,
              const Stock &stock)
{
    const Model &model = analysis.model;
    Finding finding = makeFinding(kNarrowSlit, Severity::Error);
    NarrowSlit narrow{least, tool, isClosed};
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        if (model.section(i)->stock != stock.id)
            continue;
        bool isNarrow = false;
        visitOpenings(analysis.assembly.slits[i], [&](double width, const Vec2 &at) {
            isNarrow = isNarrow || width < least;
            if (width >= narrow.width)
                return;
            narrow.width = width;
            finding.at = model.section(i)->frame.toWorld(at);
        });
        if (isNarrow)
            finding.sections.push_back(model.ref(i));
    }
    finding.setDetails(narrow);
    return finding;
}

/// Of the stock's slits, mm: the height of the largest bump.
double bumpsOf(const Analysis &analysis, const Stock &stock)
{
    double most = 0.0;
    for (std::size_t i = 0; i < analysis.model.sectionCount(); ++i)
        if (analysis.model.section(i)->stock == stock.id)
            for (const Slit &slit : analysis.assembly.slits[i])
                if (slit.role == SlitRole::Slit && slit.form)
                    most = std::max(most, slit.form->bumps);
    return most;
}

/// Nothing where none of its sections has a slit.
template <class Details>
std::optional<Finding> misfitOf(const FindingKind &kind, Severity severity,
                                const Analysis &analysis, const Stock &stock, Details details)
{
    Finding finding = makeFinding(kind, severity, details);
    for (std::size_t i = 0; i < analysis.model.sectionCount(); ++i)
        if (analysis.model.section(i)->stock == stock.id && !analysis.assembly.slits[i].empty())
            finding.sections.push_back(analysis.model.ref(i));
    return finding.sections.empty() ? std::nullopt : std::optional(finding);
}

} // namespace

double narrowest(const Slit &slit)
{
    const double width = slit.width - (slit.form ? 2.0 * slit.form->bumps : 0.0);
    return slit.isOpen ? width : std::min(width, (slit.mouth - slit.inner).norm());
}

bool isClosedBy(double kerf, double width)
{
    return width <= kerf + kTouchingDepth;
}

const ActionKind kWidenSlits{plainWords<kWidenText>};

const FindingKind kTightSlits{"tightSlits", Subject::Joints, FFF_TEXT("Checks", "Slits too tight"),
                              tightSentence, widen};
const FindingKind kWideSlits{"wideSlits", Subject::Joints, FFF_TEXT("Checks", "Slits too wide"),
                             wideSentence, widen};
const FindingKind kNarrowSlit{"narrowSlit", Subject::Joints,
                              FFF_TEXT("Checks", "Slit narrower than the tool"), narrowSentence,
                              widen};

void findNarrowSlits(const Looked &at, std::vector<Finding> &found)
{
    for (const auto &stock : at.analysis.model.document.stocks) {
        const double bumps = bumpsOf(at.analysis, *stock);
        const double tight = 2.0 * bumps - stock->clearance;
        Finding finding =
            below(stock->kerf + kTouchingDepth, stock->kerf, true, at.analysis, *stock);
        if (finding.sections.empty() && stock->slitEnd != SlitEnd::Square)
            finding = below(stock->toolDiameter - kSameWidth, stock->toolDiameter, false,
                            at.analysis, *stock);
        if (!finding.sections.empty())
            found.push_back(std::move(finding));
        else if (tight > kTightest + kTouchingDepth)
            if (auto slits = misfitOf(kTightSlits, Severity::Error, at.analysis, *stock,
                                      TightSlits{tight, bumps}))
                found.push_back(*std::move(slits));
        // Where there is room for a second sheet nothing is held at all.
        const Severity severity =
            stock->clearance >= stock->thickness ? Severity::Error : Severity::Warning;
        if (stock->clearance > kWidest)
            if (auto wide = misfitOf(kWideSlits, severity, at.analysis, *stock,
                                     NarrowSlit{0.0, std::abs(stock->clearance)}))
                found.push_back(*std::move(wide));
    }
}

} // namespace fff
