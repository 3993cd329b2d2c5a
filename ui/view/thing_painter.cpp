#include "ui/view/thing_painter.h"

#include <cstddef>

namespace fff::ui {

ThingPainter::ThingPainter(Gl &gl) : m_gl(gl), m_program(loadProgram("thing", "thing"))
{
    m_gl.glGenVertexArrays(1, &m_array);
    m_gl.glGenBuffers(1, &m_vertices);
    m_gl.glBindVertexArray(m_array);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_vertices);
    const std::array<std::size_t, 3> offsets{offsetof(ThingVertex, position),
                                             offsetof(ThingVertex, normal),
                                             offsetof(ThingVertex, colour)};
    for (GLuint i = 0; i < offsets.size(); ++i) {
        m_gl.glVertexAttribPointer(i, i == 2 ? 4 : 3, GL_FLOAT, GL_FALSE, sizeof(ThingVertex),
                                   reinterpret_cast<const void *>(offsets[i]));
        m_gl.glEnableVertexAttribArray(i);
    }
    m_gl.glBindVertexArray(0);
}

ThingPainter::~ThingPainter()
{
    m_gl.glDeleteVertexArrays(1, &m_array);
    m_gl.glDeleteBuffers(1, &m_vertices);
}

void ThingPainter::update(const std::vector<SceneThing> &things)
{
    if (things == m_things)
        return;
    m_things = things;
    std::vector<ThingVertex> vertices;
    for (const SceneThing &thing : things)
        if (!thing.isHidden)
            addTriangles(thing, vertices);
    m_count = static_cast<int>(vertices.size());
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_vertices);
    m_gl.glBufferData(GL_ARRAY_BUFFER,
                      static_cast<GLsizeiptr>(vertices.size() * sizeof(ThingVertex)),
                      vertices.data(), GL_DYNAMIC_DRAW);
}

void ThingPainter::draw(const FrameView &view)
{
    m_program->bind();
    m_program->setUniformValue("toClip", toFloat(view.toClip));
    m_program->setUniformValue("eye", toFloat(view.eye()));
    m_program->setUniformValue(
        "normalToView",
        toFloat(Eigen::Matrix3d(view.camera.orientation.conjugate().toRotationMatrix())));
    m_gl.glBindVertexArray(m_array);
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDepthMask(GL_FALSE);
    m_gl.glEnable(GL_BLEND);
    m_gl.glEnable(GL_CULL_FACE);
    // The far side shines through the near one.
    for (const GLenum away : {GL_FRONT, GL_BACK}) {
        m_gl.glCullFace(away);
        m_gl.glDrawArrays(GL_TRIANGLES, 0, m_count);
    }
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glDisable(GL_BLEND);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glBindVertexArray(0);
}

} // namespace fff::ui
