#include "ui/view/layers.h"

namespace fff::ui {

namespace {

/// A layer with no more than this part of the picture's points is the last that is looked for.
constexpr double kFewest = 2e-4;

} // namespace

Layers::Layers(Gl &gl, ScreenPass &pass)
    : m_gl(gl), m_pass(pass),
      m_copy(loadProgram("screen", "copy")), m_layers{{gl, GL_RGBA8, true}, {gl, GL_RGBA8, true}},
      m_sum(gl, GL_RGBA8, false)
{
}

void Layers::draw(RenderTarget &picture, SlabPainter &painter, int most,
                  const std::function<void()> &drawAll)
{
    const auto compose = [&](RenderTarget &to, GLuint from, GLenum source, GLenum destination) {
        to.bind();
        m_gl.glDisable(GL_DEPTH_TEST);
        m_gl.glEnable(GL_BLEND);
        m_gl.glBlendFunc(source, destination);
        m_copy->bind();
        m_pass.setTexture(*m_copy, "image", 0, from);
        m_pass.draw();
        m_gl.glDisable(GL_BLEND);
    };
    m_gl.glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    for (RenderTarget *target : {&m_layers[0], &m_layers[1], &m_sum})
        target->resize(picture.size());
    m_sum.bind();
    m_gl.glClear(GL_COLOR_BUFFER_BIT);

    GLuint query = 0;
    m_gl.glGenQueries(1, &query);
    for (int i = 0; i < most; ++i) {
        RenderTarget &layer = m_layers[i % 2];
        layer.bind();
        m_gl.glEnable(GL_DEPTH_TEST);
        m_gl.glDepthFunc(GL_LESS);
        m_gl.glDepthMask(GL_TRUE);
        m_gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const LayerDepths depths{picture.depth(), m_layers[(i + 1) % 2].depth(), i == 0};
        painter.setLayer(&depths);
        m_gl.glBeginQuery(GL_SAMPLES_PASSED, query);
        drawAll();
        m_gl.glEndQuery(GL_SAMPLES_PASSED);
        painter.setLayer(nullptr);
        // Under what is there already: from the front to the back.
        compose(m_sum, layer.colour(), GL_ONE_MINUS_DST_ALPHA, GL_ONE);
        GLuint points = 0;
        m_gl.glGetQueryObjectuiv(query, GL_QUERY_RESULT, &points);
        if (points < kFewest * picture.size().width() * picture.size().height())
            break;
    }
    m_gl.glDeleteQueries(1, &query);
    compose(picture, m_sum.colour(), GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.glDepthFunc(GL_LEQUAL);
}

void Layers::free()
{
    for (RenderTarget *target : {&m_layers[0], &m_layers[1], &m_sum})
        target->free();
}

} // namespace fff::ui
