#include "core/analysis/analysis.h"

#include "core/analysis/captives.h"
#include "core/model/changes.h"

#include <algorithm>

namespace fff {

AnalysisPointer analyseNext(const Model &model, AnalysisCaches &caches)
{
    static const Analysis nothing;
    const Analysis &last = caches.last ? *caches.last : nothing;
    Analysis analysis;
    analysis.model = model;
    analysis.assembly = assemble(model, last.model, last.assembly);
    analysis.cuts.resize(model.sectionCount());
    const std::optional<std::vector<int>> places = placesBefore(model, last.model);
    const SharedRows<Slit> &slits = analysis.assembly.slits, &before = last.assembly.slits;
    for (std::size_t i = 0; i < analysis.cuts.size(); ++i) {
        const std::size_t place = places ? static_cast<std::size_t>((*places)[i]) : i;
        const ShapePointer &shape = model.section(i)->shape;
        const bool hasSameShape =
            place < last.cuts.size() && (model.section(i) == last.model.section(place) ||
                                         shape == last.model.section(place)->shape);
        const CutSectionPointer known = hasSameShape ? last.cuts[place] : nullptr;
        analysis.cuts[i] = known && slits.pointer(i) == before.pointer(place)
                               ? known
                               : cutSection(shape, slits[i], caches.cuts, known.get());
    }
    analysis.bodies = bodiesOf(model, analysis.cuts, last.bodies, places);
    analysis.grips = Grips::find(model, analysis.assembly, analysis.cuts,
                                 {last.model, last.assembly, last.cuts, last.grips}, places);
    caches.cuts.trim(analysis.cuts.size());
    caches.last = std::make_shared<const Analysis>(std::move(analysis));
    return caches.last;
}

Analysis analyse(const Model &model, AnalysisCaches &caches)
{
    return *analyseNext(model, caches);
}

std::vector<std::vector<int>> heldGroups(const Analysis &analysis)
{
    CaptiveCache cache;
    return heldGroups(analysis, cache);
}

std::vector<std::vector<int>> heldGroups(const Analysis &analysis, CaptiveCache &cache)
{
    return withCaptives(
        analysis, heldGroups(analysis.bodies, analysis.assembly.joints, analysis.grips), cache);
}

std::vector<int> groupOf(const Analysis &analysis, int section)
{
    const int body = analysis.bodies.firstOf(section);
    for (std::vector<int> &group : heldGroups(analysis))
        if (std::binary_search(group.begin(), group.end(), body))
            return std::move(group);
    return {};
}

void prepareDrawing(const Analysis &analysis)
{
    for (const CutSectionPointer &cut : analysis.cuts)
        cut->triangulations();
}

} // namespace fff
