#include "core/session/analysis.h"

namespace fff {

Analysis analyse(const Model &model, AnalysisCaches &caches)
{
    Analysis analysis;
    analysis.model = model;
    analysis.assembly = assemble(model, caches.crossings);
    analysis.cuts.reserve(model.sectionCount());
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        analysis.cuts.push_back(
            cutSection(model.section(i)->shape, analysis.assembly.slits[i], caches.cuts));
    return analysis;
}

void prepareDrawing(const Analysis &analysis)
{
    for (const CutSectionPointer &cut : analysis.cuts)
        cut->triangulations();
}

} // namespace fff
