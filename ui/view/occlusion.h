// Darkens corners: what of the light from all around is kept from a point by what stands near it.
#pragma once

#include "ui/view/frame_view.h"
#include "ui/view/render_target.h"
#include "ui/view/screen_pass.h"

namespace fff::ui {

class Occlusion
{
public:
    Occlusion(Gl &gl, ScreenPass &pass);
    bool isReady() const { return m_sample && m_blur && m_apply; }

    /// Multiplies the picture, where it has depths. `radius`: mm, how near a thing must stand.
    void darken(RenderTarget &picture, const FrameView &view, double radius);

private:
    void blur(RenderTarget &from, RenderTarget &to, const RenderTarget &picture,
              const Vec2 &direction, double sameDepth);

    Gl &m_gl;
    ScreenPass &m_pass;
    std::unique_ptr<QOpenGLShaderProgram> m_sample, m_blur, m_apply;
    RenderTarget m_image, m_other;
};

} // namespace fff::ui
