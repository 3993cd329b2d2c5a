#include "ui/view/scene.h"

#include "ui/view/bent_slab.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace fff::ui {

bool SceneSection::looksTheSame(const SceneSection &other) const
{
    return cut == other.cut && shape == other.shape && bent == other.bent &&
           bentTimes == other.bentTimes && marks == other.marks && frame == other.frame &&
           thickness == other.thickness && look.face == other.look.face &&
           look.side == other.look.side && look.alpha == other.look.alpha &&
           covers == other.covers && guests == other.guests && isGhost == other.isGhost &&
           isHidden == other.isHidden && isProblem == other.isProblem &&
           isFaulty == other.isFaulty && isDoubtful == other.isDoubtful && isMade == other.isMade &&
           fields == other.fields;
}

std::span<const Triangulation> trianglesOf(const Shape &shape)
{
    const Result<Triangulation> &known = shape.triangulation();
    return known ? std::span(&*known, 1) : std::span<const Triangulation>();
}

std::span<const Triangulation> trianglesOf(const CutSection &cut)
{
    const Result<std::vector<Triangulation>> &known = cut.triangulations();
    return known ? std::span<const Triangulation>(*known) : std::span<const Triangulation>();
}

SlabMesh meshOf(const SceneSection &section)
{
    if (section.bent)
        return section.bent->flat;
    if (!section.cut)
        return buildSlab({&section.shape->region(), 1}, trianglesOf(*section.shape));
    std::vector<Region> regions;
    for (const CurvedRegion &part : section.cut->parts())
        regions.push_back(part.region);
    return buildSlab(regions, trianglesOf(*section.cut),
                     section.covers ? std::span<const SlitCover>(*section.covers)
                                    : std::span<const SlitCover>());
}

/// What is known of a section of another model, or null. Mostly it stands where it stood.
const SceneBuilder::Known *SceneBuilder::knownOf(const Model &model, std::size_t index) const
{
    const bool isThere =
        index < m_known.size() && (m_analysis->model.section(index) == model.section(index) ||
                                   m_analysis->model.ref(index) == model.ref(index));
    const int at = isThere ? static_cast<int>(index) : m_analysis->model.indexOf(model.ref(index));
    return at >= 0 && at < static_cast<int>(m_known.size())
               ? m_known[static_cast<std::size_t>(at)].get()
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

/// Whether all sections are where they were in the list, however they may look.
bool SceneBuilder::hasSameSections(const Analysis &analysis) const
{
    const Model &now = analysis.model, &before = m_analysis->model;
    if (now.sectionCount() != before.sectionCount() || m_known.size() != now.sectionCount() ||
        analysis.cuts.size() != m_known.size())
        return false;
    for (std::size_t i = 0; i < now.sectionCount(); ++i)
        if (now.section(i) != before.section(i) && !(now.ref(i) == before.ref(i)))
            return false;
    return true;
}

/// Covers that are there already, by the cut that they are of.
class SceneBuilder::SharedCovers
{
public:
    explicit SharedCovers(const std::vector<KnownPointer> &known) : m_known(known) {}

    CoversPointer of(const CutSectionPointer &cut, std::vector<SlitCover> covers)
    {
        if (m_byHash.empty()) // nobody has asked before
            addKnown();
        const std::size_t hash = hashOf(*cut, covers);
        for (auto it = m_byHash.find(hash); it != m_byHash.end() && it->first == hash; ++it)
            if (it->second.first == cut && *it->second.second == covers)
                return it->second.second;
        auto made = std::make_shared<const std::vector<SlitCover>>(std::move(covers));
        m_byHash.emplace(hash, std::pair(cut, made));
        return made;
    }

private:
    void addKnown()
    {
        std::unordered_set<const void *> seen; // thousands of ribs may look alike
        for (const KnownPointer &known : m_known)
            if (seen.insert(known->covers.get()).second)
                m_byHash.emplace(hashOf(*known->cut, *known->covers),
                                 std::pair(known->cut, known->covers));
    }
    static std::size_t hashOf(const CutSection &cut, const std::vector<SlitCover> &covers)
    {
        constexpr std::size_t kMixer = 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio
        std::size_t hash = std::hash<const void *>()(&cut);
        for (const SlitCover &cover : covers)
            hash = (hash ^ std::hash<double>()(cover.length)) * kMixer;
        return hash;
    }

    const std::vector<KnownPointer> &m_known;
    std::unordered_multimap<std::size_t, std::pair<CutSectionPointer, CoversPointer>> m_byHash;
};

SceneBuilder::GuestsPointer SceneBuilder::guestsAt(const Model &model, std::vector<int> at)
{
    Guests guests;
    guests.sections.reserve(at.size());
    for (const int guest : at)
        guests.sections.push_back(model.ref(static_cast<std::size_t>(guest)));
    guests.at = std::move(at);
    return std::make_shared<const Guests>(std::move(guests));
}

void SceneBuilder::setAnalysis(AnalysisPointer newest)
{
    const Analysis &analysis = *newest;
    std::vector<KnownPointer> next;
    SharedCovers shared(m_known);
    const std::size_t count = std::min(analysis.model.sectionCount(), analysis.cuts.size());
    next.reserve(count);
    std::optional<CoverUpdate> update;
    if (hasSameSections(analysis))
        update.emplace(analysis, *m_analysis);
    for (std::size_t i = 0; i < count; ++i) {
        const bool isSame = update ? m_known[i]->cut == analysis.cuts[i] && update->isKept(i)
                                   : isAsBefore(analysis, i);
        if (isSame && update) {
            next.push_back(m_known[i]);
            continue;
        }
        auto known = std::make_shared<Known>();
        known->shape = analysis.model.section(i)->shape;
        known->frame = analysis.model.section(i)->frame;
        known->cut = analysis.cuts[i];
        if (isSame) {
            const Known &before = *knownOf(analysis.model, i);
            known->covers = before.covers;
            Guests guests;
            guests.sections = before.guests->sections;
            for (const SectionRef &guest : guests.sections)
                guests.at.push_back(analysis.model.indexOf(guest));
            known->guests = std::make_shared<const Guests>(std::move(guests));
        } else {
            SectionCovers covers = update
                                       ? update->of(i, *m_known[i]->covers, m_known[i]->guests->at)
                                       : slitCovers(analysis, i);
            known->covers = shared.of(known->cut, std::move(covers.covers));
            known->guests = update && m_known[i]->guests->at == covers.guests
                                ? m_known[i]->guests
                                : guestsAt(analysis.model, std::move(covers.guests));
        }
        next.push_back(std::move(known));
    }
    m_analysis = std::move(newest);
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
        item.marks = section.marks;
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
            item.guests = known->guests->at;
            for (std::size_t k = 0; k < item.guests.size(); ++k) {
                const auto at = static_cast<std::size_t>(item.guests[k]);
                if (at >= model.sectionCount() || !(model.ref(at) == known->guests->sections[k]))
                    item.guests[k] = model.indexOf(known->guests->sections[k]);
            }
        }
        item.bounds = worldBounds(*section.shape, section.frame);
        const Vec3 reach = 0.5 * stock.thickness * section.frame.normal().cwiseAbs();
        item.bounds.min -= reach;
        item.bounds.max += reach;
        scene.bounds.extend(item.bounds);
        scene.sections.push_back(std::move(item));
    }
    scene.things = thingsOf(model);
    scene.flats = flatsOf(model);
    scene.templates = templatesOf(model.document, m_pulled.get());
    return scene;
}

Box3 Scene::allBounds() const
{
    Box3 all = bounds;
    for (const SceneTemplate &one : templates) {
        all.extend(one.bounds.min);
        all.extend(one.bounds.max);
    }
    for (const SceneFlat &flat : flats)
        for (const Vec3 &corner : flat.corners)
            all.extend(corner);
    return all;
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
        section.isFaulty = view.faulty.count(ref) > 0;
        section.isDoubtful = view.doubtful.count(ref) > 0;
    }
    for (SceneThing &thing : scene.things) {
        const auto at = static_cast<std::size_t>(thing.section);
        thing.isHidden = at < count && (scene.sections[at].isHidden || scene.sections[at].isGhost);
    }
}

} // namespace fff::ui
