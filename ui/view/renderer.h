// Draws a scene with OpenGL 3.3 core into the framebuffer that is bound: background, ground with
// grid and shadow, slabs with crisp edges, outlines of what is hovered and selected. Needs no
// widget. Smooths edges by itself: the framebuffer needs no samples, depth or stencil of its own.
#pragma once

#include "core/interaction/camera.h"
#include "ui/view/render_options.h"
#include "ui/view/scene.h"
#include "ui/view/view_style.h"

#include <QImage>

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

    /// viewport  device-independent pixels; the framebuffer has `pixelRatio` times as many.
    /// What was drawn last is kept: another frame that differs in its outlines only costs little.
    void render(const Scene &scene, const Camera &camera, const Vec2 &viewport, double pixelRatio,
                const ViewStyle &style, const RenderOptions &options = {});

    /// Brings over it what was painted: ARGB32_Premultiplied, as many pixels as the framebuffer
    /// has.
    void drawOver(const QImage &marks);

    /// The picture rests: gives back what only drawing another one needs. What is seen stays, and
    /// so does what outlines are drawn over. With the context current.
    void tidy();

    /// Meshes sent to the graphics card so far, and frames for which slabs were drawn.
    int uploadCount() const;
    int drawCount() const;

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace fff::ui
