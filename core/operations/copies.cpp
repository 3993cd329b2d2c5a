#include "core/operations/copies.h"

#include "core/model/moving.h"
#include "core/operations/evaluate.h"
#include "core/operations/excerpt.h"
#include "core/operations/insertion.h"

namespace fff {

Copies copied(const Model &model, const std::vector<SectionRef> &sections, int count)
{
    Copies copies;
    copies.document = model.document;
    const Document part = attachedExcerpt(model, sections);
    for (int k = 0; k < count; ++k) {
        const std::size_t before = copies.document.sections.size();
        Insertion insertion = insertedAttached(std::move(copies.document), part);
        copies.document = std::move(insertion.document);
        copies.sections = std::move(insertion.sections);
        copies.drawn.emplace_back();
        for (std::size_t i = before; i < copies.document.sections.size(); ++i)
            copies.drawn.back().push_back(copies.document.sections[i]->id);
    }
    return copies;
}

Result<Document> placedCopies(const Copies &copies,
                              const std::function<Similarity(int)> &placementOf)
{
    std::vector<SectionMove> moves;
    for (std::size_t k = 0; k < copies.drawn.size(); ++k) {
        const Similarity placement = placementOf(static_cast<int>(k) + 1);
        for (const SectionId id : copies.drawn[k])
            moves.push_back({id, placement});
    }
    const Model model = copies.document.operations.empty() ? Model{} : evaluate(copies.document);
    MovingRules rules{.takesChildren = false};
    rules.framesOf = [&model](const SectionRef &ref) -> std::optional<MovingRules::Frames> {
        const Section *section = model.find(ref);
        return section ? std::optional(MovingRules::Frames{section->frame, section->frame})
                       : std::nullopt;
    };
    return movedSections(copies.document, moves, rules);
}

} // namespace fff
