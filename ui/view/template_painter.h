// Draws meshes that sections are drawn after: seen through, over what is opaque.
#pragma once

#include "core/geometry/similarity.h"
#include "core/model/document.h"
#include "core/templates/pulled_templates.h"
#include "ui/view/frame_quality.h"
#include "ui/view/frame_view.h"
#include "ui/view/gl.h"
#include "ui/view/view_style.h"

#include <vector>

namespace fff::ui {

/// A mesh that is to be seen.
struct SceneTemplate
{
    TemplateMeshPointer mesh; // never null
    Similarity placement;     // from about its middle to the world
    Box3 bounds;              // in the world, mm: contains it
    double opacity = kMeshOpacity;
    bool isSelected = false;
    bool isSkin = false; // over sections, which it must be seen against

    bool operator==(const SceneTemplate &other) const
    {
        return mesh == other.mesh && placement.turn == other.placement.turn &&
               placement.scale == other.placement.scale &&
               placement.shift == other.placement.shift && opacity == other.opacity &&
               isSelected == other.isSelected && isSkin == other.isSkin;
    }
};

/// Those that are not hidden and whose bytes are known, as magnets pull them.
/// pulled  may be null
std::vector<SceneTemplate> templatesOf(const Document &document, const PulledTemplates *pulled);

class TemplatePainter
{
public:
    explicit TemplatePainter(Gl &gl);
    ~TemplatePainter(); // context current
    TemplatePainter(const TemplatePainter &) = delete;
    TemplatePainter &operator=(const TemplatePainter &) = delete;

    bool isReady() const { return m_program != nullptr; }
    /// Uploads meshes that are new, forgets those that are gone.
    void update(const std::vector<SceneTemplate> &templates);
    bool isAny() const { return !m_templates.empty(); }
    /// Onto what is bound, with the depths of what is opaque, to which their own are added. In
    /// motion with fewer triangles.
    void draw(const FrameView &view, const ViewStyle &style, FrameQuality quality);

private:
    struct Buffers
    {
        GLuint array = 0, vertices = 0, indices = 0;
        GLsizei count = 0;
    };
    struct Uploaded
    {
        TemplateMeshPointer mesh;
        Buffers fine, coarse; // coarse: without a count, as fine
    };
    Buffers upload(const MeshSurface &surface);
    void remove(Buffers &buffers);
    void draw(const SceneTemplate &one, const ViewStyle &style, FrameQuality quality);

    Gl &m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    std::vector<SceneTemplate> m_templates;
    std::vector<Uploaded> m_uploaded;
};

} // namespace fff::ui
