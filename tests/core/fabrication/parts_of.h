// Parts for tests: of a model as it is, and by hand.
#pragma once

#include "core/assembly/assembly.h"
#include "core/fabrication/part.h"

namespace fff::test {

inline std::vector<CutSectionPointer> cutsOf(const Model &model, const Assembly &assembly)
{
    CutCache cache;
    std::vector<CutSectionPointer> cuts;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        cuts.push_back(cutSection(model.section(i)->shape, assembly.slits[i], cache));
    return cuts;
}

inline std::vector<Part> partsOf(const Model &model)
{
    const Assembly assembly = assemble(model);
    return makeParts(model, assembly, bodiesOf(model, cutsOf(model, assembly)));
}

inline CurvedRegion regionOf(const Contour &contour, const std::vector<Contour> &holes = {},
                             const std::vector<Polygon> &cuts = {})
{
    return subtract(contour, holes, cuts, 0.01)->at(0);
}

} // namespace fff::test
