// Draws what lets light through, in whatever order it comes: layer by layer from the eye, each the
// nearest of what lies behind the one before.
//
// Source  C. Everitt 2001, Interactive Order-Independent Transparency (depth peeling).
#pragma once

#include "ui/view/render_target.h"
#include "ui/view/screen_pass.h"
#include "ui/view/slab_painter.h"

#include <functional>

namespace fff::ui {

class Layers
{
public:
    Layers(Gl &gl, ScreenPass &pass);
    bool isReady() const { return m_copy != nullptr; }

    /// Over the picture: at most `most` layers of what `drawAll` draws with the painter, where it
    /// is nearer than the picture's depths.
    void draw(RenderTarget &picture, SlabPainter &painter, int most,
              const std::function<void()> &drawAll);
    /// Gives back what it draws into, until it draws again.
    void free();

private:
    Gl &m_gl;
    ScreenPass &m_pass;
    std::unique_ptr<QOpenGLShaderProgram> m_copy;
    RenderTarget m_layers[2], m_sum;
};

} // namespace fff::ui
