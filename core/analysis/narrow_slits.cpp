#include "core/analysis/narrow_slits.h"

#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

namespace {

/// A tool that is wider than the slit by rounding goes in.
constexpr double kSameWidth = kTouchingDepth;

/// About the slits of the stock that are below `least` mm wide; without sections if none is.
Check below(double least, const Analysis &analysis, const Stock &stock)
{
    const Model &model = analysis.model;
    Check check;
    check.code = CheckCode::NarrowSlit;
    check.distance = least;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        if (model.section(i)->stock != stock.id)
            continue;
        bool isNarrow = false;
        for (const Slit &slit : analysis.assembly.slits[i]) {
            if (slit.role != SlitRole::Slit)
                continue;
            const double width = narrowest(slit);
            isNarrow = isNarrow || width < least;
            if (width >= check.distance)
                continue;
            check.distance = width;
            check.at = model.section(i)->frame.toWorld(slit.inner);
        }
        if (isNarrow)
            check.sections.push_back(model.ref(i));
    }
    return check;
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

std::vector<Check> narrowSlits(const Analysis &analysis)
{
    std::vector<Check> all;
    for (const auto &stock : analysis.model.document.stocks) {
        Check check = below(stock->kerf + kTouchingDepth, analysis, *stock);
        check.severity = CheckSeverity::Error;
        check.tool = stock->kerf;
        if (check.sections.empty() && stock->slitEnd != SlitEnd::Square) {
            check = below(stock->toolDiameter - kSameWidth, analysis, *stock);
            check.severity = CheckSeverity::Warning;
            check.tool = stock->toolDiameter;
        }
        if (!check.sections.empty())
            all.push_back(std::move(check));
    }
    return all;
}

} // namespace fff
