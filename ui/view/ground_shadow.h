// The soft shadow that the model throws straight down on the ground: a small picture of it from
// above, the more blurred the higher a thing hangs. Made again only when the model changed.
#pragma once

#include "ui/view/render_target.h"
#include "ui/view/screen_pass.h"
#include "ui/view/slab_buffers.h"

namespace fff::ui {

class GroundShadow
{
public:
    GroundShadow(Gl &gl, ScreenPass &pass);

    bool isReady() const { return m_slab && m_blur; }
    void update(const Scene &scene, const SlabBuffers &slabs);
    /// Binds the texture and sets the uniforms `shadow` and `shadowBox`.
    void use(QOpenGLShaderProgram &program);

private:
    void blur(RenderTarget &from, RenderTarget &to, const Vec2 &direction, double unit);

    Gl &m_gl;
    ScreenPass &m_pass;
    std::unique_ptr<QOpenGLShaderProgram> m_slab, m_blur;
    RenderTarget m_image, m_other;
    std::vector<SceneSection> m_drawn; // what the image shows
    Vec2 m_corner = Vec2::Zero();      // x and z, mm
    double m_size = 1.0;               // mm
};

} // namespace fff::ui
