#include "core/session/narrow_slits.h"

#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

namespace {

/// A tool that is wider than the slit by rounding goes in.
constexpr double kSameWidth = kTouchingDepth;

} // namespace

double narrowest(const Slit &slit)
{
    const double width = slit.width - (slit.form ? 2.0 * slit.form->bumps : 0.0);
    return slit.isOpen ? width : std::min(width, (slit.mouth - slit.inner).norm());
}

std::vector<Check> narrowSlits(const Analysis &analysis)
{
    const Model &model = analysis.model;
    std::vector<Check> all;
    for (const auto &stock : model.document.stocks) {
        if (stock->slitEnd == SlitEnd::Square)
            continue; // no mill's
        Check check;
        check.code = CheckCode::NarrowSlit;
        check.severity = CheckSeverity::Warning;
        check.tool = stock->toolDiameter;
        check.distance = stock->toolDiameter - kSameWidth;
        for (std::size_t i = 0; i < model.sectionCount(); ++i) {
            if (model.section(i)->stock != stock->id)
                continue;
            bool isNarrow = false;
            for (const Slit &slit : analysis.assembly.slits[i]) {
                if (slit.role != SlitRole::Slit)
                    continue;
                const double width = narrowest(slit);
                isNarrow = isNarrow || width < stock->toolDiameter - kSameWidth;
                if (width >= check.distance)
                    continue;
                check.distance = width;
                check.at = model.section(i)->frame.toWorld(slit.inner);
            }
            if (isNarrow)
                check.sections.push_back(model.ref(i));
        }
        if (!check.sections.empty())
            all.push_back(std::move(check));
    }
    return all;
}

} // namespace fff
