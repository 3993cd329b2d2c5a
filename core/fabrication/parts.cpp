#include "core/fabrication/part.h"

#include "core/base/tolerances.h"

#include <limits>

namespace fff {

namespace {

/// Which part the slit's bottom touches. Just beyond the bottom is material of one part only,
/// unless another slit took that too; then the nearest part gets the mark.
std::size_t partAtBottom(std::span<const BodyPointer> bodies, const Vec2 &inner,
                         const Vec2 &direction)
{
    if (bodies.size() == 1)
        return 0;
    const Vec2 beyond = inner + kMinOverlap * direction;
    std::size_t best = 0;
    double bestDistance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const double distance = distanceTo(beyond, bodies[i]->outline().region);
        if (distance < bestDistance) {
            best = i;
            bestDistance = distance;
        }
    }
    return best;
}

/// One mark where the two hold each other; what meets beside the axis has one only where there is
/// nothing else, a shoulder none, since its tabs are marked.
bool isMarked(const Slit &slit, const std::vector<Slit> &slits)
{
    if (slit.role == SlitRole::Shoulder)
        return false;
    return slit.overlap >= 0 || std::none_of(slits.begin(), slits.end(), [&](const Slit &other) {
               return other.joint == slit.joint && other.overlap >= 0;
           });
}

} // namespace

std::vector<Part> makeParts(const Model &model, const Assembly &assembly, const Bodies &bodies)
{
    std::vector<Part> parts;
    for (std::size_t section = 0; section < bodies.sectionCount(); ++section) {
        const std::span<const BodyPointer> pieces = bodies.of(static_cast<int>(section));
        const std::size_t first = parts.size();
        for (const BodyPointer &body : pieces) {
            Part part;
            part.number = static_cast<int>(parts.size()) + 1;
            part.section = static_cast<int>(section);
            part.stock = model.section(section)->stock;
            part.outline = body->outline();
            parts.push_back(std::move(part));
        }
        if (pieces.empty() || section >= assembly.slits.size())
            continue;
        for (const Slit &slit : assembly.slits[section]) {
            if (!isMarked(slit, assembly.slits[section]))
                continue;
            const Vec2 direction = (slit.inner - slit.mouth).normalized();
            const Vec2 bottom = slit.bottom();
            const std::size_t part = partAtBottom(pieces, bottom, direction);
            parts[first + part].joints.push_back({slit.joint, bottom, direction, slit.width});
        }
    }
    return parts;
}

} // namespace fff
