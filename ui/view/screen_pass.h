// Draws one triangle over all of the picture: for shaders that look at every pixel.
#pragma once

#include "ui/view/gl.h"

namespace fff::ui {

class ScreenPass
{
public:
    explicit ScreenPass(Gl &gl) : m_gl(gl) { m_gl.glGenVertexArrays(1, &m_array); }
    ~ScreenPass() { m_gl.glDeleteVertexArrays(1, &m_array); } // context current
    ScreenPass(const ScreenPass &) = delete;
    ScreenPass &operator=(const ScreenPass &) = delete;

    /// With the bound program, whose vertices are those of screen.vert.
    void draw()
    {
        m_gl.glBindVertexArray(m_array);
        m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    /// Has no vertices: for shaders that make them themselves.
    GLuint array() const { return m_array; }
    /// Binds a texture for the sampler of this name.
    void setTexture(QOpenGLShaderProgram &program, const char *name, int unit, GLuint texture)
    {
        m_gl.glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        m_gl.glBindTexture(GL_TEXTURE_2D, texture);
        m_gl.glActiveTexture(GL_TEXTURE0);
        program.setUniformValue(name, unit);
    }

private:
    Gl &m_gl;
    GLuint m_array = 0;
};

} // namespace fff::ui
