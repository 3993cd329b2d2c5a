// All kinds of findings.
#pragma once

#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/in_each_other.h"
#include "core/analysis/findings/joining.h"
#include "core/analysis/findings/narrow_slits.h"
#include "core/analysis/findings/not_worked_out.h"
#include "core/analysis/findings/order.h"
#include "core/analysis/findings/rings.h"
#include "core/analysis/findings/sheet_fit.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/thin_webs.h"
#include "core/analysis/findings/total_mass.h"
#include "core/analysis/findings/wholeness.h"

#include "core/session/finding_text.h"

#include <algorithm>

namespace fff::test {

/// The first of the kind; null without one.
inline const Finding *find(const std::vector<Finding> &all, const FindingKind &kind)
{
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&kind](const Finding &finding) { return finding.is(kind); });
    return found == all.end() ? nullptr : &*found;
}

/// In words, with the numbers behind them to the last digit.
inline QString exactly(const Finding &finding, const Model &model)
{
    UnitWords units = metricUnits();
    units.length = units.width =
        units.mass = [](double value) { return QString::number(value, 'g', 17); };
    QString text = QString::fromLatin1(finding.kind->name) + findingText(finding, model, units);
    if (finding.at)
        text += QString::number(finding.at->sum(), 'g', 17);
    if (const auto *footing = finding.details<Footing>())
        for (const Vec2 &corner : footing->support)
            text += QString::number(corner.sum(), 'g', 17);
    if (const auto *use = finding.details<SheetUse>())
        text += QString::number(use->share, 'g', 17);
    return text;
}

} // namespace fff::test
