#include "core/fabrication/kerf.h"

#include "core/geometry/offset.h"

namespace fff {

CurvedRegion compensateKerf(const CurvedRegion &region, double kerf)
{
    return kerf > 0.0 ? grow(region, 0.5 * kerf) : region;
}

std::vector<Part> compensateKerf(std::vector<Part> parts, const Model &model,
                                 const std::vector<CutSectionPointer> &cuts)
{
    std::size_t ofSection = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto section = static_cast<std::size_t>(parts[i].section);
        ofSection = i > 0 && parts[i - 1].section == parts[i].section ? ofSection + 1 : 0;
        if (const double kerf = model.stockOf(section).kerf; kerf > 0.0)
            parts[i].outline = (*cuts[section]->compensated(kerf))[ofSection];
    }
    return parts;
}

} // namespace fff
