// The caps of a view that is cut open, on the graphics card; made anew when plane or slabs changed.
#pragma once

#include "ui/view/edge_array.h"
#include "ui/view/frame_view.h"
#include "ui/view/gl.h"
#include "ui/view/scene.h"

namespace fff::ui {

struct ViewStyle;

class CapBuffers
{
public:
    explicit CapBuffers(Gl &gl);
    ~CapBuffers(); // context current
    CapBuffers(const CapBuffers &) = delete;
    CapBuffers &operator=(const CapBuffers &) = delete;

    bool isReady() const { return m_program != nullptr; }
    /// Ghosts and hidden sections have none.
    void update(const Scene &scene, const ClipPlane &plane, const ViewStyle &style);
    void fill(const FrameView &view);
    const EdgeArray &edges() const { return m_edges; }

private:
    Gl &m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    GLuint m_fillArray = 0, m_vertices = 0;
    EdgeArray m_edges;
    int m_vertexCount = 0;
};

} // namespace fff::ui
