// A picture to draw into: colours and depths, both to be read by shaders afterwards.
#pragma once

#include "ui/view/gl.h"

#include <QSize>

namespace fff::ui {

class RenderTarget
{
public:
    /// `filter` of the colours when they are read at another size.
    RenderTarget(Gl &gl, GLenum colourFormat, bool hasDepth, GLenum filter = GL_NEAREST)
        : m_gl(gl), m_format(colourFormat), m_hasDepth(hasDepth), m_filter(filter)
    {
    }
    ~RenderTarget() { free(); } // context current
    RenderTarget(const RenderTarget &) = delete;
    RenderTarget &operator=(const RenderTarget &) = delete;

    /// Made anew when the size is another; what was in it is lost then.
    void resize(const QSize &size);
    void free();
    /// Draws go here from now on, over all of it.
    void bind();
    /// The colours (smoothed when the sizes differ) and depths of another one.
    void copyFrom(const RenderTarget &other);
    void copyDepthFrom(const RenderTarget &other);

    const QSize &size() const { return m_size; }
    bool isEmpty() const { return m_frame == 0; }
    GLuint colour() const { return m_colour; }
    GLuint depth() const { return m_depth; }

private:
    void copy(const RenderTarget &other, GLbitfield what, GLenum filter);

    Gl &m_gl;
    GLenum m_format;
    bool m_hasDepth;
    GLenum m_filter;
    QSize m_size;
    GLuint m_frame = 0, m_colour = 0, m_depth = 0;
};

/// What is bound for drawing now, to come back to.
class BoundTarget
{
public:
    explicit BoundTarget(Gl &gl);
    void restore() const;

private:
    Gl &m_gl;
    GLint m_frame = 0, m_viewport[4] = {};
};

} // namespace fff::ui
