// Draws a scene with OpenGL 3.3 core into the framebuffer that is bound: background, ground with
// grid and shadow, slabs with crisp edges, outlines of what is hovered and selected. Needs no
// widget.
#pragma once

#include "core/interaction/camera.h"
#include "ui/view/scene.h"
#include "ui/view/view_style.h"

#include <memory>

namespace fff::ui {

class Renderer
{
public:
    Renderer();
    ~Renderer(); // release() first when something was drawn

    /// With the context current. False when it offers no OpenGL 3.3 or refuses the shaders.
    bool initialize();
    /// Frees everything; with the context current. May be initialized again after.
    void release();

    /// viewport  device-independent pixels; the framebuffer has `pixelRatio` times as many
    void render(const Scene &scene, const Camera &camera, const Vec2 &viewport, double pixelRatio,
                const ViewStyle &style);

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace fff::ui
