// A word beside the cursor: what the hand may do now. Where the eyes are, since nobody reads the
// status line in the middle of a stroke.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/sign.h"

namespace fff {

inline sign::Label cueAt(Text words, const Vec2 &cursor, const Camera &camera, const Vec2 &viewport)
{
    const Vec2 aside(44.0, 30.0); // px, clear of the cursor and of a slit that is level or upright
    return {SignRole::Cue, {camera.pointAt(cursor, viewport)}, Message{words, {}}, aside};
}

} // namespace fff
