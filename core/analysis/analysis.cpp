#include "core/analysis/analysis.h"

#include "core/analysis/captives.h"
#include "core/model/changes.h"

#include <algorithm>

namespace fff {

namespace {

/// As those of the last one where section and slits are.
CutList cutsOf(const Analysis &analysis, const Analysis &last,
               const std::optional<std::vector<int>> &places, CutCache &cache)
{
    const std::vector<SectionPointer> &sections = analysis.model.sections(),
                                      &sectionsBefore = last.model.sections();
    const SharedRows<Slit> &slits = analysis.assembly.slits, &slitsBefore = last.assembly.slits;
    CutList cuts = last.cuts;
    cuts.resize(sections.size());
    CutList::Editor editor(cuts);
    const auto renew = [&](std::size_t i) {
        const std::size_t place = places ? static_cast<std::size_t>((*places)[i]) : i;
        const bool isKnown = place < last.cuts.size();
        const ShapePointer &shape = sections[i]->shape;
        const bool hasSameShape = isKnown && (sections[i] == sectionsBefore[place] ||
                                              shape == sectionsBefore[place]->shape);
        const CutSectionPointer known = hasSameShape ? last.cuts[place] : nullptr;
        CutSectionPointer cut = known && slits.pointer(i) == slitsBefore.pointer(place)
                                    ? known
                                    : cutSection(shape, slits[i], cache, known.get());
        if (cut != cuts[i])
            editor.set(i, std::move(cut));
    };
    for (std::size_t first = 0; first < sections.size(); first += CutList::kInBlock) {
        const std::size_t block = first / CutList::kInBlock, end = cuts.endOf(block);
        const bool isSame =
            !places && cuts.shares(last.cuts, block) &&
            slits.pointers().shares(slitsBefore.pointers(), block) &&
            std::equal(&sections[first], &sections[first] + (end - first), &sectionsBefore[first]);
        for (std::size_t i = first; !isSame && i < end; ++i)
            renew(i);
    }
    return cuts;
}

} // namespace

AnalysisPointer analyseNext(const Model &model, AnalysisCaches &caches)
{
    static const Analysis nothing;
    const Analysis &last = caches.last ? *caches.last : nothing;
    Analysis analysis;
    analysis.model = model;
    analysis.assembly = assemble(model, last.model, last.assembly);
    const std::optional<std::vector<int>> places = placesBefore(model, last.model);
    analysis.cuts = cutsOf(analysis, last, places, caches.cuts);
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

void prepareDrawing(const Analysis &analysis, const Analysis *prepared)
{
    const CutList &cuts = analysis.cuts;
    for (std::size_t block = 0; block < cuts.blockCount(); ++block)
        if (!prepared || !cuts.shares(prepared->cuts, block))
            for (std::size_t i = block * CutList::kInBlock; i < cuts.endOf(block); ++i)
                cuts[i]->triangulations();
}

} // namespace fff
