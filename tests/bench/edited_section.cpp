#include "tests/bench/edited_section.h"

#include "core/model/edits.h"

#include <algorithm>

namespace fff::bench {

std::vector<int> jointCounts(const Analysis &analysis)
{
    std::vector<int> counts(analysis.model.sectionCount());
    for (const Joint &joint : analysis.assembly.joints) {
        ++counts[static_cast<std::size_t>(joint.a)];
        ++counts[static_cast<std::size_t>(joint.b)];
    }
    return counts;
}

int middleSection(const Analysis &analysis, const std::vector<int> &counts)
{
    std::vector<int> sorted = counts;
    std::sort(sorted.begin(), sorted.end());
    const int middle = sorted[sorted.size() / 2];
    const auto first = std::find(counts.begin(), counts.end(), middle) - counts.begin();
    return std::min(static_cast<int>(first), static_cast<int>(analysis.model.drawnCount()) - 1);
}

Document moved(const Document &document, SectionId id, double by)
{
    const Section &section = *document.find(id);
    Frame frame = section.frame;
    frame.origin += by * (frame.x + frame.normal());
    return *moveSection(document, id, frame);
}

} // namespace fff::bench
