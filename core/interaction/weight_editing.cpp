#include "core/interaction/weight_editing.h"

#include "core/geometry/polygon.h"
#include "core/interaction/weight_words.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"

#include <cmath>

namespace fff {

namespace {

constexpr double kMilligrams = 1e6; // of a kg

SectionEdit edited(Result<Document> next, Step step)
{
    if (!next)
        return refused(hints::kEditFailed);
    return EditedSections{*std::move(next), std::move(step)};
}

/// A key that is pressed again goes on with the same step.
SectionEdit merging(SectionEdit edit, const char *what, WeightId id)
{
    if (edit)
        edit->step.merges = std::string(what) + " " + std::to_string(id.value);
    return edit;
}

Step stepTo(const Weight &before, const Weight &after, const Section &section)
{
    if (before.mass != after.mass)
        return {steps::kSetWeight, {massOf(after.mass)}};
    if (before.name == after.name)
        return {steps::kMoveWeight, {Named{section.name}}};
    if (before.name.empty())
        return {steps::kNameWeight, {Named{after.name}}};
    return {steps::kRename, {Named{before.name}}};
}

} // namespace

SectionEdit changedWeight(const Model &model, const Weight &weight)
{
    const Weight *before = model.document.find(weight.id);
    const Section *section = before ? model.find(weight.section) : nullptr;
    if (!section || !weight.position.allFinite())
        return refused(hints::kEditFailed);
    if (weight.position != before->position) {
        if (section->isLocked)
            return refused(hints::kLocked, {Named{section->name}});
        if (locate(weight.position, section->shape->region()) == Side::Outside)
            return refused(hints::kWeightBeside, {Named{section->name}});
    }
    return edited(setWeight(model.document, weight), stepTo(*before, weight, *section));
}

SectionEdit movedWeight(const Model &model, WeightId id, const Vec2 &by)
{
    const Weight *before = model.document.find(id);
    if (!before)
        return refused(hints::kEditFailed);
    Weight weight = *before;
    weight.position += by;
    return merging(changedWeight(model, weight), "weight", id);
}

SectionEdit withMassAdded(const Model &model, WeightId id, double mass)
{
    const Weight *before = model.document.find(id);
    if (!before)
        return refused(hints::kEditFailed);
    Weight weight = *before;
    weight.mass = std::round((weight.mass + mass) * kMilligrams) / kMilligrams;
    return merging(changedWeight(model, weight), "mass", id);
}

SectionEdit removedWeight(const Model &model, WeightId id)
{
    return edited(removeWeight(model.document, id), steps::kRemoveWeight);
}

} // namespace fff
