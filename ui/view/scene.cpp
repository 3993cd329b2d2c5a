#include "ui/view/scene.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace fff::ui {

bool SceneSection::looksTheSame(const SceneSection &other) const
{
    return cut == other.cut && shape == other.shape && frame == other.frame &&
           thickness == other.thickness && look.face == other.look.face &&
           look.side == other.look.side && look.alpha == other.look.alpha &&
           covers == other.covers && guests == other.guests && isGhost == other.isGhost &&
           isHidden == other.isHidden && isProblem == other.isProblem;
}

/// What is known of a section of another model, or null. Mostly it stands where it stood.
const SceneBuilder::Known *SceneBuilder::knownOf(const Model &model, std::size_t index) const
{
    const bool isThere =
        index < m_known.size() &&
        (m_model.section(index) == model.section(index) || m_model.ref(index) == model.ref(index));
    const int at = isThere ? static_cast<int>(index) : m_model.indexOf(model.ref(index));
    return at >= 0 && at < static_cast<int>(m_known.size()) ? &m_known[static_cast<std::size_t>(at)]
                                                            : nullptr;
}

/// Whether neither the section nor what fills its slits has changed, so that its covers stay.
bool SceneBuilder::isAsBefore(const Analysis &analysis, std::size_t index) const
{
    const auto isSame = [&](std::size_t i) {
        const Known *known = knownOf(analysis.model, i);
        return known && known->cut == analysis.cuts[i] &&
               known->frame == analysis.model.section(i)->frame;
    };
    if (!isSame(index))
        return false;
    const auto &slits = analysis.assembly.slits[index];
    return std::all_of(slits.begin(), slits.end(), [&](const Slit &slit) {
        return isSame(static_cast<std::size_t>(slit.guest));
    });
}

void SceneBuilder::setAnalysis(const Analysis &analysis)
{
    std::vector<Known> next;
    std::unordered_multimap<const CutSection *, CoversPointer> shared;
    for (const Known &known : m_known)
        shared.emplace(known.cut.get(), known.covers);
    const auto sharedCovers = [&](const CutSection *cut, std::vector<SlitCover> covers) {
        const auto [begin, end] = shared.equal_range(cut);
        for (auto it = begin; it != end; ++it) {
            if (*it->second == covers)
                return it->second;
        }
        return shared
            .emplace(cut, std::make_shared<const std::vector<SlitCover>>(std::move(covers)))
            ->second;
    };
    const std::size_t count = std::min(analysis.model.sectionCount(), analysis.cuts.size());
    next.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        Known known{analysis.model.section(i)->shape,
                    analysis.model.section(i)->frame,
                    analysis.cuts[i],
                    nullptr,
                    {}};
        if (isAsBefore(analysis, i)) {
            const Known &before = *knownOf(analysis.model, i);
            known.covers = before.covers;
            known.guests = before.guests;
        } else {
            SectionCovers covers = slitCovers(analysis, i);
            known.covers = sharedCovers(known.cut.get(), std::move(covers.covers));
            for (const int guest : covers.guests)
                known.guests.push_back(analysis.model.ref(static_cast<std::size_t>(guest)));
        }
        next.push_back(std::move(known));
    }
    m_model = analysis.model;
    m_known = std::move(next);
}

Scene SceneBuilder::build(const Model &model) const
{
    Scene scene;
    scene.sections.reserve(model.sectionCount());
    std::map<const Stock *, StockLook> looks;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const Section &section = *model.section(i);
        const Stock &stock = model.stockOf(i);
        SceneSection item;
        item.shape = section.shape;
        item.frame = section.frame;
        item.thickness = stock.thickness;
        auto look = looks.find(&stock);
        if (look == looks.end())
            look = looks.emplace(&stock, stockLook(stock)).first;
        item.look = look->second;
        // A section that is being drawn has a new shape with every move: its last cut stays until
        // the next one is there, or its slits would flicker.
        const Known *known = knownOf(model, i);
        if (known && (known->shape == section.shape || known->frame == section.frame)) {
            item.cut = known->cut;
            item.covers = known->covers;
            for (const SectionRef &guest : known->guests)
                item.guests.push_back(model.indexOf(guest));
        }
        item.bounds = worldBounds(*section.shape, section.frame);
        const Vec3 reach = 0.5 * stock.thickness * section.frame.normal().cwiseAbs();
        item.bounds.min -= reach;
        item.bounds.max += reach;
        scene.bounds.extend(item.bounds);
        scene.sections.push_back(std::move(item));
    }
    return scene;
}

void applyView(Scene &scene, const Model &model, const ViewState &view)
{
    const std::size_t count = std::min(scene.sections.size(), model.sectionCount());
    for (std::size_t i = 0; i < count; ++i) {
        SceneSection &section = scene.sections[i];
        const SectionRef ref = model.ref(i);
        section.isHidden = view.isHidden(ref);
        section.isGhost = view.isGhost(ref);
        section.isProblem = view.problems.count(ref) > 0;
    }
}

} // namespace fff::ui
