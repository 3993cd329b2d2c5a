#include "core/fabrication/kerf.h"

#include "core/geometry/offset.h"

namespace fff {

CurvedRegion compensateKerf(const CurvedRegion &region, double kerf)
{
    return kerf > 0.0 ? grow(region, 0.5 * kerf) : region;
}

std::vector<Part> compensateKerf(std::vector<Part> parts, const Model &model)
{
    for (Part &part : parts) {
        const double kerf = model.stockOf(static_cast<std::size_t>(part.section)).kerf;
        if (kerf > 0.0)
            part.outline = compensateKerf(part.outline, kerf);
    }
    return parts;
}

} // namespace fff
