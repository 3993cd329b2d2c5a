#include "core/operations/moving_model.h"

#include "core/model/origin.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <functional>
#include <map>

namespace fff {

namespace {

/// Sections on sections that are made of others on such sections, so deep.
constexpr int kMostRounds = 8;

tl::unexpected<Error> madeInItsOwnWay(const Model &model, const SectionRef &ref)
{
    const std::string name = model.nameOf(ref);
    return failure(ErrorCode::UnknownReference, name, {name});
}

/// From the drawn section to what is shown for it.
Similarity toImage(const Origin &origin, const Section &shown)
{
    return {.turn = origin.turn,
            .shift = shown.frame.origin - origin.turn * origin.section->frame.origin};
}

/// The edit, done again until what was drawn on generated sections is where those have gone to.
Result<Document> carried(const Model &model, bool takesChildren,
                         const std::function<Result<Document>(const MovingRules &)> &edit)
{
    std::map<SectionRef, MovingRules::Frames> frames; // of what things are drawn on
    for (const SectionPointer &section : model.document.sections) {
        const SectionRef on = section->parent ? section->parent->section : SectionRef();
        const Section *parent = on.operation.isValid() ? model.find(on) : nullptr;
        if (parent)
            frames.insert_or_assign(on, MovingRules::Frames{parent->frame, parent->frame});
    }
    MovingRules rules{.takesChildren = takesChildren};
    rules.framesOf = [&frames](const SectionRef &ref) {
        const auto found = frames.find(ref);
        return found == frames.end() ? std::nullopt : std::optional(found->second);
    };
    Result<Document> next = edit(rules);
    Model after = model;
    for (int round = 0; next && !frames.empty() && round < kMostRounds; ++round) {
        after = evaluate(*next, after);
        bool isSettled = true;
        for (auto &[ref, known] : frames) {
            const Section *section = after.find(ref);
            if (!section || section->frame == known.after)
                continue;
            known.after = section->frame;
            isSettled = false;
        }
        if (isSettled)
            break;
        next = edit(rules);
    }
    return next;
}

} // namespace

Result<Document> movedSections(const Model &model, std::span<const RefMove> moves,
                               bool takesChildren)
{
    std::vector<SectionMove> drawn;
    for (const RefMove &move : moves) {
        const std::optional<Origin> origin = originOf(model, move.section);
        if (!origin)
            return madeInItsOwnWay(model, move.section);
        const SectionId id = origin->section->id;
        if (std::any_of(drawn.begin(), drawn.end(),
                        [id](const SectionMove &other) { return other.section == id; }))
            continue;
        const Similarity image = toImage(*origin, *model.find(move.section));
        const bool isImage = !(move.section == SectionRef(id));
        drawn.push_back({id, isImage ? image.inverse() * move.placement * image : move.placement,
                         move.breaksAngle});
    }
    return carried(model, takesChildren, [&](const MovingRules &rules) {
        return movedSections(model.document, drawn, rules);
    });
}

Result<Document> stretchedSection(const Model &model, const SectionRef &section,
                                  const Eigen::Matrix2d &matrix, const Vec2 &about,
                                  bool takesChildren)
{
    const std::optional<Origin> origin = originOf(model, section);
    if (!origin)
        return madeInItsOwnWay(model, section);
    return carried(model, takesChildren, [&](const MovingRules &rules) {
        return stretchedSection(model.document, origin->section->id,
                                {.matrix = matrix, .about = about}, rules);
    });
}

std::set<SectionRef> movingWith(const Model &model, std::span<const SectionRef> sections,
                                bool takesChildren)
{
    // Found by moving them: nothing else knows what operations make of it.
    std::vector<RefMove> moves;
    for (const SectionRef &ref : sections)
        if (originOf(model, ref))
            moves.push_back({ref, Similarity::moved(Vec3::Ones())});
    std::set<SectionRef> moving;
    const Result<Document> moved = movedSections(model, moves, takesChildren);
    if (!moved)
        return moving;
    const Model after = evaluate(*moved, model);
    for (const SectionPointer &section : model.sections()) {
        const Section *now = after.find(section->ref());
        if (!now || !(now->frame == section->frame))
            moving.insert(section->ref());
    }
    return moving;
}

const Section *holderOf(const Model &model, const Section &section)
{
    return section.parent && !section.parent->isFree ? model.find(section.parent->section)
                                                     : nullptr;
}

} // namespace fff
