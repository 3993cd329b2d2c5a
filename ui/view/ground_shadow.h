// The soft shadow that the model throws straight down on the ground: a small picture of it from
// above, blurred, sharper where it touches. Made again only when the model changed.
#pragma once

#include "ui/view/slab_buffers.h"

#include <QOpenGLFramebufferObject>

namespace fff::ui {

/// Places a slab's mesh (ui/view/slab_mesh.h) in the world.
Eigen::Matrix4d slabMatrix(const SceneSection &section);

class GroundShadow
{
public:
    explicit GroundShadow(Gl &gl);

    bool isReady() const { return m_slab && m_blur; }
    /// Leaves the framebuffer and viewport as they were.
    void update(const Scene &scene, const SlabBuffers &slabs, GLuint emptyArray);
    /// Binds the texture and sets the uniforms `shadow` and `shadowBox`.
    void use(QOpenGLShaderProgram &program);

private:
    void blur(QOpenGLFramebufferObject &from, QOpenGLFramebufferObject &to, const Vec2 &direction);

    Gl &m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_slab, m_blur;
    std::unique_ptr<QOpenGLFramebufferObject> m_image, m_other;
    std::vector<SceneSection> m_drawn; // what the image shows
    Vec2 m_corner = Vec2::Zero();      // x and z, mm
    double m_size = 1.0;               // mm
};

} // namespace fff::ui
