#include "ui/view/ground_painter.h"

#include "ui/view/slab_painter.h"
#include "ui/view/view_style.h"

#include <algorithm>

namespace fff::ui {

namespace {

constexpr double kLeastRadius = 320.0; // mm

} // namespace

GroundPainter::GroundPainter(Gl &gl, ScreenPass &pass)
    : m_gl(gl), m_pass(pass), m_program(loadProgram("ground", "ground")), m_shadow(gl, pass)
{
}

void GroundPainter::place(const Box3 &bounds)
{
    const bool isEmpty = bounds.isEmpty();
    m_centre = isEmpty ? Vec2::Zero() : Vec2(bounds.center().x(), bounds.center().z());
    m_radius = std::max(kLeastRadius, isEmpty ? 0.0 : 1.3 * bounds.size().norm());
}

void GroundPainter::updateShadow(const Scene &scene, const SlabBuffers &slabs)
{
    m_shadow.update(scene, slabs);
}

void GroundPainter::draw(const FrameView &view, const ViewStyle &style)
{
    // 10 and 50 mm; far away 100 and 500, and so on.
    double spacing = 10.0;
    while (spacing / view.camera.millimetresPerPixel < 2.2)
        spacing *= 10.0;

    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glEnable(GL_BLEND);
    m_gl.glDepthMask(GL_FALSE);
    m_program->bind();
    m_program->setUniformValue("toClip", toFloat(view.toClip));
    m_program->setUniformValue("centre", static_cast<float>(m_centre.x()),
                               static_cast<float>(m_centre.y()));
    m_program->setUniformValue("radius", static_cast<float>(m_radius));
    m_program->setUniformValue("spacing", static_cast<float>(spacing));
    m_program->setUniformValue("lineWidth", static_cast<float>(view.ratio()));
    m_program->setUniformValue("fine", rgb(style.gridFine));
    m_program->setUniformValue("strong", rgb(style.gridStrong));
    m_program->setUniformValue(
        "shadowColour", QVector4D(rgb(style.shadow), static_cast<float>(style.shadow.alphaF())));
    m_shadow.use(*m_program);
    m_gl.glBindVertexArray(m_pass.array());
    m_gl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDisable(GL_BLEND);
}

} // namespace fff::ui
