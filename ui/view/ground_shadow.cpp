#include "ui/view/ground_shadow.h"

#include "ui/view/slab_painter.h"

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kPixels = 256; // a side: the blur hides the steps, and software rendering stays fast
/// Standard deviations on the ground of the four bands of heights, mm for a model of kModelSize.
constexpr double kBlurs[] = {1.6, 4.0, 10.0, 20.0};
constexpr double kModelSize = 300.0; // mm
constexpr double kTapSpread = 1.8;   // standard deviation of the shader's taps, in taps

bool looksTheSame(const std::vector<SceneSection> &a, const std::vector<SceneSection> &b)
{
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(),
        [](const SceneSection &p, const SceneSection &q) { return p.looksTheSame(q); });
}

} // namespace

GroundShadow::GroundShadow(Gl &gl, ScreenPass &pass)
    : m_gl(gl), m_pass(pass), m_slab(loadProgram("slab", "shadow")),
      m_blur(loadProgram("screen", "blur")), m_image(gl, GL_RGBA8, false, GL_LINEAR),
      m_other(gl, GL_RGBA8, false, GL_LINEAR)
{
    m_image.resize({kPixels, kPixels});
    m_other.resize({kPixels, kPixels});
}

void GroundShadow::update(const Scene &scene, const SlabBuffers &slabs)
{
    if (looksTheSame(m_drawn, scene.sections))
        return;
    m_drawn = scene.sections;
    if (scene.bounds.isEmpty())
        return;

    const Vec3 size = scene.bounds.size(), middle = scene.bounds.center();
    const double unit = std::max(1.0, size.norm() / kModelSize);
    const double margin = 3.0 * unit * kBlurs[3];
    m_size = std::max(size.x(), size.z()) + 2.0 * margin;
    m_corner = Vec2(middle.x(), middle.z()) - Vec2::Constant(0.5 * m_size);

    // From above: x to the right, z up the picture; heights do not matter, nothing is hidden.
    Eigen::Matrix4d toPicture = Eigen::Matrix4d::Zero();
    toPicture(0, 0) = toPicture(1, 2) = 2.0 / m_size;
    toPicture(0, 3) = -2.0 * m_corner.x() / m_size - 1.0;
    toPicture(1, 3) = -2.0 * m_corner.y() / m_size - 1.0;
    toPicture(3, 3) = 1.0;

    m_image.bind();
    m_gl.glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    m_gl.glClear(GL_COLOR_BUFFER_BIT);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFunc(GL_ONE, GL_ONE);
    m_gl.glBlendEquation(GL_MAX);
    m_slab->bind();
    m_slab->setUniformValue("unit", static_cast<float>(unit));
    const int toClip = m_slab->uniformLocation("toClip");
    const int heightRow = m_slab->uniformLocation("heightRow");
    const int times = m_slab->uniformLocation("times");
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        const SceneSection &section = scene.sections[i];
        if (section.isGhost || section.isHidden)
            continue;
        const SlabBuffers::Slab &slab = slabs.slab(i);
        const Eigen::Matrix4d place = slabMatrix(section);
        m_slab->setUniformValue(toClip, toFloat(Eigen::Matrix4d(toPicture * place)));
        m_slab->setUniformValue(heightRow, toFloat(Eigen::Vector4d(place.row(1).transpose())));
        m_slab->setUniformValue(times, static_cast<float>(section.bentTimes));
        m_gl.glBindVertexArray(slab.fillArray);
        // Walls that others hide throw no shadow that those do not.
        m_gl.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(slab.coverStarts.front()),
                            GL_UNSIGNED_INT, nullptr);
    }
    m_gl.glBlendEquation(GL_FUNC_ADD);
    m_gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.glDisable(GL_BLEND);
    blur(m_image, m_other, Vec2::UnitX(), unit);
    blur(m_other, m_image, Vec2::UnitY(), unit);
}

void GroundShadow::blur(RenderTarget &from, RenderTarget &to, const Vec2 &direction, double unit)
{
    to.bind();
    m_blur->bind();
    m_pass.setTexture(*m_blur, "image", 0, from.colour());
    m_gl.glGenerateMipmap(GL_TEXTURE_2D);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    m_blur->setUniformValue("direction", static_cast<float>(direction.x()),
                            static_cast<float>(direction.y()));
    Eigen::Vector4d spread;
    for (int i = 0; i < 4; ++i)
        spread[i] = unit * kBlurs[i] / kTapSpread / m_size;
    m_blur->setUniformValue("spread", toFloat(spread));
    m_pass.draw();
}

void GroundShadow::use(QOpenGLShaderProgram &program)
{
    m_pass.setTexture(program, "shadow", 0, m_image.colour());
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    // Nothing was drawn yet, or nothing is there to throw a shadow: a box beside everything.
    const bool empty = m_drawn.empty();
    program.setUniformValue("shadowBox", static_cast<float>(empty ? 1e9 : m_corner.x()),
                            static_cast<float>(m_corner.y()), static_cast<float>(m_size),
                            static_cast<float>(m_size));
}

} // namespace fff::ui
