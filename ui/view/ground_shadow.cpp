#include "ui/view/ground_shadow.h"

#include <Eigen/Geometry>

namespace fff::ui {

namespace {

constexpr int kPixels = 320; // a side: the blur hides the steps, and software rendering stays fast
constexpr double kSharpBlur = 1.6, kSoftBlur = 9.0; // mm, standard deviation on the ground
constexpr double kTapSpread = 2.65; // standard deviation of the shader's taps, in taps

bool looksTheSame(const std::vector<SceneSection> &a, const std::vector<SceneSection> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const SceneSection &p, const SceneSection &q) {
                          return p.meshKey() == q.meshKey() && p.frame == q.frame &&
                                 p.thickness == q.thickness && p.isGhost == q.isGhost;
                      });
}

} // namespace

Eigen::Matrix4d slabMatrix(const SceneSection &section)
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.block<3, 1>(0, 0) = section.frame.x;
    matrix.block<3, 1>(0, 1) = section.frame.y;
    matrix.block<3, 1>(0, 2) = 0.5 * section.thickness * section.frame.normal();
    matrix.block<3, 1>(0, 3) = section.frame.origin;
    return matrix;
}

GroundShadow::GroundShadow(Gl &gl)
    : m_gl(gl), m_slab(loadProgram("slab", "shadow")), m_blur(loadProgram("screen", "blur"))
{
    QOpenGLFramebufferObjectFormat format;
    format.setInternalTextureFormat(GL_RG8);
    m_image = std::make_unique<QOpenGLFramebufferObject>(kPixels, kPixels, format);
    m_other = std::make_unique<QOpenGLFramebufferObject>(kPixels, kPixels, format);
    for (const auto &image : {m_image.get(), m_other.get()}) {
        m_gl.glBindTexture(GL_TEXTURE_2D, image->texture());
        m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }
}

void GroundShadow::update(const Scene &scene, const SlabBuffers &slabs, GLuint emptyArray)
{
    if (looksTheSame(m_drawn, scene.sections))
        return;
    m_drawn = scene.sections;
    if (scene.bounds.isEmpty())
        return;

    GLint target = 0, viewport[4];
    m_gl.glGetIntegerv(GL_FRAMEBUFFER_BINDING, &target);
    m_gl.glGetIntegerv(GL_VIEWPORT, viewport);

    const double margin = 4.0 * kSoftBlur;
    const Vec3 size = scene.bounds.size(), middle = scene.bounds.center();
    m_size = std::max(size.x(), size.z()) + 2.0 * margin;
    m_corner = Vec2(middle.x(), middle.z()) - Vec2::Constant(0.5 * m_size);

    // From above: x to the right, z up the picture; heights do not matter, nothing is hidden.
    Eigen::Matrix4d toPicture = Eigen::Matrix4d::Zero();
    toPicture(0, 0) = toPicture(1, 2) = 2.0 / m_size;
    toPicture(0, 3) = -2.0 * m_corner.x() / m_size - 1.0;
    toPicture(1, 3) = -2.0 * m_corner.y() / m_size - 1.0;
    toPicture(3, 3) = 1.0;

    m_image->bind();
    m_gl.glViewport(0, 0, kPixels, kPixels);
    m_gl.glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    m_gl.glClear(GL_COLOR_BUFFER_BIT);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendEquation(GL_MAX);
    m_slab->bind();
    for (const SceneSection &section : scene.sections) {
        if (section.isGhost)
            continue;
        const SlabBuffers::Slab &slab = slabs.slab(section);
        const Eigen::Matrix4d place = slabMatrix(section);
        setTransform(*m_slab, "toClip", toPicture * place);
        setRotation(*m_slab, "normalToView", Eigen::Matrix3d::Identity());
        const Eigen::Vector4f row = place.row(1).cast<float>();
        m_slab->setUniformValue("heightRow", row.x(), row.y(), row.z(), row.w());
        m_gl.glBindVertexArray(slab.fillArray);
        m_gl.glDrawElements(GL_TRIANGLES, slab.indexCount, GL_UNSIGNED_INT, nullptr);
    }
    m_gl.glBlendEquation(GL_FUNC_ADD);
    m_gl.glDisable(GL_BLEND);

    m_gl.glBindVertexArray(emptyArray);
    blur(*m_image, *m_other, Vec2::UnitX());
    blur(*m_other, *m_image, Vec2::UnitY());
    m_gl.glBindVertexArray(0);

    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target));
    m_gl.glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

void GroundShadow::blur(QOpenGLFramebufferObject &from, QOpenGLFramebufferObject &to,
                        const Vec2 &direction)
{
    to.bind();
    m_blur->bind();
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_2D, from.texture());
    m_blur->setUniformValue("image", 0);
    const Vec2 sharp = kSharpBlur / kTapSpread / m_size * direction;
    const Vec2 soft = kSoftBlur / kTapSpread / m_size * direction;
    m_blur->setUniformValue("sharp", static_cast<float>(sharp.x()), static_cast<float>(sharp.y()));
    m_blur->setUniformValue("soft", static_cast<float>(soft.x()), static_cast<float>(soft.y()));
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
}

void GroundShadow::use(QOpenGLShaderProgram &program)
{
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_image->texture());
    program.setUniformValue("shadow", 0);
    // Nothing was drawn yet, or nothing is there to throw a shadow: a box beside everything.
    const bool empty = m_drawn.empty();
    program.setUniformValue("shadowBox", static_cast<float>(empty ? 1e9 : m_corner.x()),
                            static_cast<float>(m_corner.y()), static_cast<float>(m_size),
                            static_cast<float>(m_size));
}

} // namespace fff::ui
