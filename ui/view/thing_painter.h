// Draws what weights stand for, as glass: seen through, behind what is before it.
#pragma once

#include "ui/view/frame_view.h"
#include "ui/view/gl.h"
#include "ui/view/thing.h"

namespace fff::ui {

class ThingPainter
{
public:
    explicit ThingPainter(Gl &gl);
    ~ThingPainter(); // context current
    ThingPainter(const ThingPainter &) = delete;
    ThingPainter &operator=(const ThingPainter &) = delete;

    bool isReady() const { return m_program != nullptr; }
    /// Uploads them, where they are others than the last time.
    void update(const std::vector<SceneThing> &things);
    /// Something of them is to be seen.
    bool isAny() const { return m_count > 0; }
    /// Onto what is bound, with the depths of what is opaque.
    void draw(const FrameView &view);

private:
    Gl &m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    GLuint m_array = 0, m_vertices = 0;
    std::vector<SceneThing> m_things; // that are uploaded
    int m_count = 0;                  // vertices
};

} // namespace fff::ui
