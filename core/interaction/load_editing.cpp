#include "core/interaction/load_editing.h"

#include "core/geometry/polygon.h"
#include "core/interaction/load_words.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kMilligrams = 1e6; // of a kg
constexpr double kMillinewtons = 1e3;
/// Forces that differ by no more than this share are one that was turned.
constexpr double kSameForce = 1e-9;
/// Fewer N nobody sets by keys.
constexpr double kLeastPush = 0.1;

SectionEdit edited(Result<Document> next, Step step)
{
    if (!next)
        return refused(hints::kEditFailed);
    return EditedSections{*std::move(next), std::move(step)};
}

/// A key that is pressed again goes on with the same step.
SectionEdit merging(SectionEdit edit, const char *what, LoadId id)
{
    if (edit)
        edit->step.merges = std::string(what) + " " + std::to_string(id.value);
    return edit;
}

Step stepTo(const Load &before, const Load &after, const Section &section)
{
    const Named on{section.name};
    const bool isPush = after.isPush();
    if (isPush && before.push != after.push) {
        const double force = after.push.norm();
        if (std::abs(force - before.push.norm()) > kSameForce * force)
            return {steps::kSetPush, {forceOf(force)}};
        return {steps::kTurnPush, {on}};
    }
    if (!isPush && before.mass != after.mass)
        return {steps::kSetWeight, {massOf(after.mass)}};
    if (before.isRepeated != after.isRepeated)
        return {after.isRepeated ? steps::kRepeatLoad : steps::kLoadAlone, {on}};
    if (before.name != after.name) {
        if (!before.name.empty())
            return {steps::kRename, {Named{before.name}}};
        return {isPush ? steps::kNamePush : steps::kNameWeight, {Named{after.name}}};
    }
    if (before.position != after.position || !(before.section == after.section))
        return {isPush ? steps::kMovePush : steps::kMoveWeight, {on}};
    return {steps::kSpreadLoad, {on}};
}

} // namespace

SectionEdit changedLoad(const Model &model, const Load &load)
{
    const Load *before = model.document.find(load.id);
    const Section *section = before ? model.find(load.section) : nullptr;
    if (!section || !load.position.allFinite())
        return refused(hints::kEditFailed);
    if (load.position != before->position) {
        if (section->isLocked)
            return refused(hints::kLocked, {Named{section->name}});
        if (locate(load.position, section->shape->region()) == Side::Outside)
            return refused(load.isPush() ? hints::kPushBeside : hints::kWeightBeside,
                           {Named{section->name}});
    }
    return edited(setLoad(model.document, load), stepTo(*before, load, *section));
}

SectionEdit movedLoad(const Model &model, LoadId id, const Vec2 &by)
{
    const Load *before = model.document.find(id);
    if (!before)
        return refused(hints::kEditFailed);
    Load load = *before;
    load.position += by;
    return merging(changedLoad(model, load), "load", id);
}

SectionEdit withMore(const Model &model, LoadId id, double more)
{
    const Load *before = model.document.find(id);
    if (!before)
        return refused(hints::kEditFailed);
    Load load = *before;
    if (load.isPush()) {
        const double force = load.push.norm();
        const double next = std::round((force + more) * kMillinewtons) / kMillinewtons;
        load.push *= std::max(next, kLeastPush) / force;
    } else {
        load.mass = std::round((load.mass + more) * kMilligrams) / kMilligrams;
        load.filled = std::min(load.filled, load.mass);
    }
    return merging(changedLoad(model, load), "more", id);
}

SectionEdit removedLoad(const Model &model, LoadId id)
{
    const Load *load = model.document.find(id);
    return edited(removeLoad(model.document, id),
                  load && load->isPush() ? steps::kRemovePush : steps::kRemoveWeight);
}

} // namespace fff
