// What a scene shows of how a model gives under what holds and loads it.
#pragma once

#include "core/analysis/bent_model.h"
#include "ui/view/scene.h"

namespace fff::ui {

/// Puts the fields of stress of its bodies on the sections of a scene of this model, which may be
/// another one than the bent one: what is known of a section moves with it. null: takes them off.
void showStress(Scene &scene, const Model &model, const BentModel *bent);

} // namespace fff::ui
