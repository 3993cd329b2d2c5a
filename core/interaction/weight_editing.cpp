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

/// Of an arrow key, or of + and −, pressed again.
std::string mergesAs(const char *what, WeightId id)
{
    return std::string(what) + " " + std::to_string(id.value);
}

SectionEdit placed(const Model &model, WeightId id, const Vec2 &position, const char *merges)
{
    const Weight *found = model.document.find(id);
    const Section *section = found ? model.find(found->section) : nullptr;
    if (!section || !position.allFinite())
        return refused(hints::kEditFailed);
    if (section->isLocked)
        return refused(hints::kLocked, {Named{section->name}});
    if (locate(position, section->shape->region()) == Side::Outside)
        return refused(hints::kWeightBeside, {Named{section->name}});
    Weight weight = *found;
    weight.position = position;
    Step step(steps::kMoveWeight, {Named{section->name}});
    if (merges)
        step.merges = mergesAs(merges, id);
    return edited(setWeight(model.document, weight), std::move(step));
}

} // namespace

SectionEdit movedWeight(const Model &model, WeightId id, const Vec2 &by)
{
    const Weight *weight = model.document.find(id);
    if (!weight)
        return refused(hints::kEditFailed);
    return placed(model, id, weight->position + by, "weight");
}

SectionEdit placedWeight(const Model &model, WeightId id, const Vec2 &position)
{
    return placed(model, id, position, nullptr);
}

SectionEdit withMass(const Model &model, WeightId id, double mass)
{
    const Weight *found = model.document.find(id);
    if (!found)
        return refused(hints::kEditFailed);
    Weight weight = *found;
    weight.mass = mass;
    return edited(setWeight(model.document, weight), Step(steps::kSetWeight, {massOf(mass)}));
}

SectionEdit withMassAdded(const Model &model, WeightId id, double mass)
{
    const Weight *weight = model.document.find(id);
    if (!weight)
        return refused(hints::kEditFailed);
    SectionEdit edit =
        withMass(model, id, std::round((weight->mass + mass) * kMilligrams) / kMilligrams);
    if (edit)
        edit->step.merges = mergesAs("mass", id);
    return edit;
}

SectionEdit renamedWeight(const Model &model, WeightId id, const std::string &name)
{
    const Weight *found = model.document.find(id);
    if (!found)
        return refused(hints::kEditFailed);
    Weight weight = *found;
    weight.name = name;
    return edited(setWeight(model.document, weight), nameStep(*found, name));
}

Step nameStep(const Weight &weight, const std::string &name)
{
    return weight.name.empty() ? Step(steps::kNameWeight, {Named{name}})
                               : Step(steps::kRename, {Named{weight.name}});
}

SectionEdit removedWeight(const Model &model, WeightId id)
{
    return edited(removeWeight(model.document, id), steps::kRemoveWeight);
}

} // namespace fff
