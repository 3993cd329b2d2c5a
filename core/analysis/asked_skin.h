// The stage of the model's skin, where a person wants to see it.
#pragma once

#include "core/analysis/stage.h"
#include "core/skin/skin.h"
#include "core/templates/template_mesh.h"

namespace fff {

struct AskedSkin
{
    bool isAsked = false;                 // else the rest is empty
    std::vector<SectionPointer> sections; // that it is over
    Skin skin;
    TemplateMeshPointer shown; // its mesh, ready to be drawn; null where there is none
};

inline constexpr StageOf<AskedSkin> kSkin{"skin"};

/// What no edit has changed keeps its skin.
Result<AskedSkin> askedSkin(const Snapshot &snapshot, const AskedSkin *previous, Progress &progress,
                            std::stop_token stop);

} // namespace fff
