#include "core/analysis/outlined_sections.h"

#include "core/base/tolerances.h"
#include "core/fabrication/summary.h"

#include <algorithm>
#include <limits>

namespace fff {

std::vector<SectionRef> outlinedSections(const Finding &finding, const Model &model)
{
    if (finding.subject() != Subject::Stability)
        return finding.sections;
    std::vector<SectionRef> group = finding.sections;
    for (std::size_t i = 0; finding.sections.empty() && i < model.sectionCount(); ++i)
        group.push_back(model.ref(i));
    std::vector<std::pair<SectionRef, double>> lowest; // Y, mm
    double ofAll = std::numeric_limits<double>::infinity();
    for (const SectionRef &ref : group) {
        const int index = model.indexOf(ref);
        if (index < 0)
            continue;
        const auto at = static_cast<std::size_t>(index);
        lowest.emplace_back(ref, slabBounds(*model.section(at), model.stockOf(at)).min.y());
        ofAll = std::min(ofAll, lowest.back().second);
    }
    std::vector<SectionRef> feet;
    for (const auto &[ref, y] : lowest)
        if (y <= std::max(ofAll, 0.0) + kGroundSunk)
            feet.push_back(ref);
    return feet;
}

} // namespace fff
