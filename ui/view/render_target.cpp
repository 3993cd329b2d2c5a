#include "ui/view/render_target.h"

namespace fff::ui {

void RenderTarget::resize(const QSize &size)
{
    if (size == m_size && m_frame)
        return;
    free();
    m_size = size;
    const auto texture = [&](GLenum internal, GLenum format, GLenum type, GLenum filter) {
        GLuint id = 0;
        m_gl.glGenTextures(1, &id);
        m_gl.glBindTexture(GL_TEXTURE_2D, id);
        m_gl.glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), size.width(),
                          size.height(), 0, format, type, nullptr);
        const auto set = [&](GLenum name, GLenum value) {
            m_gl.glTexParameteri(GL_TEXTURE_2D, name, static_cast<GLint>(value));
        };
        set(GL_TEXTURE_MIN_FILTER, filter);
        set(GL_TEXTURE_MAG_FILTER, filter);
        set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        return id;
    };
    m_colour = texture(m_format, GL_RGBA, GL_UNSIGNED_BYTE, m_filter);
    // Floats, so that a depth that was written is read as it was.
    if (m_hasDepth)
        m_depth = texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, GL_NEAREST);
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    m_gl.glGenFramebuffers(1, &m_frame);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_frame);
    m_gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_colour, 0);
    if (m_hasDepth)
        m_gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_depth, 0);
}

void RenderTarget::free()
{
    if (!m_frame)
        return;
    const GLuint textures[] = {m_colour, m_depth};
    m_gl.glDeleteTextures(m_hasDepth ? 2 : 1, textures);
    m_gl.glDeleteFramebuffers(1, &m_frame);
    m_frame = m_colour = m_depth = 0;
}

void RenderTarget::bind()
{
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_frame);
    m_gl.glViewport(0, 0, m_size.width(), m_size.height());
}

void RenderTarget::copy(const RenderTarget &other, GLbitfield what, GLenum filter)
{
    m_gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, other.m_frame);
    m_gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_frame);
    m_gl.glBlitFramebuffer(0, 0, other.m_size.width(), other.m_size.height(), 0, 0, m_size.width(),
                           m_size.height(), what, filter);
}

void RenderTarget::copyFrom(const RenderTarget &other)
{
    copy(other, GL_COLOR_BUFFER_BIT, m_size == other.m_size ? GL_NEAREST : GL_LINEAR);
    copyDepthFrom(other);
}

void RenderTarget::copyDepthFrom(const RenderTarget &other)
{
    if (m_hasDepth && other.m_hasDepth)
        copy(other, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    bind();
}

BoundTarget::BoundTarget(Gl &gl) : m_gl(gl)
{
    m_gl.glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_frame);
    m_gl.glGetIntegerv(GL_VIEWPORT, m_viewport);
}

void BoundTarget::restore() const
{
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(m_frame));
    m_gl.glViewport(m_viewport[0], m_viewport[1], m_viewport[2], m_viewport[3]);
}

} // namespace fff::ui
