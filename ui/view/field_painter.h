// Draws how strained bodies are, as colours over their slabs, which
// give way to it, and below all lines on them.
#pragma once

#include "core/physics/stress_field.h"
#include "ui/view/frame_view.h"
#include "ui/view/gl.h"
#include "ui/view/scene.h"

#include <map>
#include <utility>

namespace fff::ui {

struct FieldLook
{
    bool isForColourBlind = false;
    double least = 0.2; // of what the sheet bears: less is not shown
    double alpha = 1.0;
};

class FieldPainter
{
public:
    explicit FieldPainter(Gl &gl);
    ~FieldPainter(); // context current
    FieldPainter(const FieldPainter &) = delete;
    FieldPainter &operator=(const FieldPainter &) = delete;

    bool isReady() const { return m_program != nullptr; }
    /// Uploads what is new in the scene and frees what is no longer in it. Of what is strained less
    /// than `least` next to nothing is uploaded.
    void update(const Scene &scene, double least);
    /// Of a section of the scene that update() has seen last. Depth and blending are the caller's
    /// matter.
    void draw(const SceneSection &section, const FrameView &view, const FieldLook &look);

private:
    struct Buffers
    {
        GLuint array = 0, vertices = 0, motions = 0, shares = 0, triangles = 0;
        GLsizei count = 0;        // of indices
        StressFieldPointer field; // keep the key's addresses from being used again
        std::shared_ptr<const BentSlab> bent;
        CutSectionPointer cut;
        ShapePointer shape;
        bool isUsed = false;
    };
    using Key = std::pair<const StressField *, const void *>; // and the slab that it is over
    static Key keyOf(const StressFieldPointer &field, const SceneSection &section);
    Buffers upload(const StressFieldPointer &field, const SceneSection &section);
    void free(const Buffers &buffers);

    Gl &m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    std::map<Key, Buffers> m_fields;
    double m_least = 0.0; // that they are uploaded for
};

} // namespace fff::ui
