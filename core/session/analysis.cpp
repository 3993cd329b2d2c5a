#include "core/session/analysis.h"

namespace fff {

AnalysisPointer analyseNext(const Model &model, AnalysisCaches &caches)
{
    static const Analysis nothing;
    const Analysis &last = caches.last ? *caches.last : nothing;
    Analysis analysis;
    analysis.model = model;
    analysis.assembly = assemble(model, last.model, last.assembly);
    analysis.cuts = last.cuts;
    analysis.cuts.resize(model.sectionCount());
    const SharedRows<Slit> &slits = analysis.assembly.slits, &before = last.assembly.slits;
    for (std::size_t i = 0; i < analysis.cuts.size(); ++i) {
        const ShapePointer &shape = model.section(i)->shape;
        const bool hasSameShape =
            i < last.cuts.size() &&
            (model.section(i) == last.model.section(i) || shape == last.model.section(i)->shape);
        if (!hasSameShape || slits.pointer(i) != before.pointer(i))
            analysis.cuts[i] = cutSection(shape, slits[i], caches.cuts,
                                          hasSameShape ? last.cuts[i].get() : nullptr);
    }
    caches.last = std::make_shared<const Analysis>(std::move(analysis));
    return caches.last;
}

Analysis analyse(const Model &model, AnalysisCaches &caches)
{
    return *analyseNext(model, caches);
}

void prepareDrawing(const Analysis &analysis)
{
    for (const CutSectionPointer &cut : analysis.cuts)
        cut->triangulations();
}

} // namespace fff
