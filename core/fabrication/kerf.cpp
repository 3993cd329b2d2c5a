#include "core/fabrication/kerf.h"

#include "core/geometry/offset.h"

#include <array>
#include <charconv>

namespace fff {

Result<CurvedRegion> compensateKerf(const CurvedRegion &region, double kerf)
{
    return kerf > 0.0 ? grow(region, 0.5 * kerf) : region;
}

Result<std::vector<Part>> compensateKerf(std::vector<Part> parts, const Model &model,
                                         const Bodies &bodies)
{
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto section = static_cast<std::size_t>(parts[i].section);
        const double kerf = model.stockOf(section).kerf;
        if (!(kerf > 0.0))
            continue;
        const auto outlines = bodies[i].cut()->compensated(kerf);
        if (!outlines)
            return failure(ErrorCode::CannotOffset, {},
                           {model.section(section)->name, millimetres(kerf)});
        parts[i].outline = (**outlines)[bodies[i].piece()];
    }
    return parts;
}

std::string millimetres(double length)
{
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), length, std::chars_format::fixed, 2);
    return std::string(text.data(), end.ptr);
}

} // namespace fff
