// Draws the sections of a scene, pass by pass: what is opaque, what lets light through, ghosts, and
// the outlines of what is hovered and selected.
#pragma once

#include "ui/view/cap_buffers.h"
#include "ui/view/field_painter.h"
#include "ui/view/layers.h"
#include "ui/view/mark_buffers.h"

namespace fff::ui {

struct RenderOptions;

class SectionPasses
{
public:
    SectionPasses(Gl &gl, ScreenPass &pass, const SlabBuffers &slabs);
    bool isReady() const;

    /// What is drawn next is this, into the target that is bound. All but the view must stay until
    /// it is drawn; the scene is that of the buffers.
    void begin(const Scene &scene, const FrameView &view, const ViewStyle &style,
               const RenderOptions &options);
    /// Slabs and, in a view that is cut open, caps; with depths, without edges.
    void drawOpaque();
    void drawOpaqueEdges();
    /// Something lets light through.
    bool hasLayers() const;
    /// Onto `image`, a copy of `opaque`, which is what the other passes made.
    void drawLayers(RenderTarget &image, const RenderTarget &opaque);
    void drawOutlines();
    /// Gives back what only layers need; the next ones have it again.
    void tidy() { m_layers.free(); }

private:
    /// How a section is drawn.
    enum class Kind { None, Opaque, Translucent, Ghost };
    Kind kindOf(std::size_t section) const;
    std::vector<std::size_t> sectionsOf(Kind kind) const;
    bool isFrosted() const;
    SlabLook lookOf(std::size_t section, double alpha) const;
    EdgeLook edgesOf(std::size_t section, double alpha) const;
    void drawEdges(std::size_t section, double alpha);
    float setBack() const;
    void setClipped(bool on);
    void drawFields();
    void drawTranslucent(RenderTarget &image);
    void drawGhosts(RenderTarget &image);
    void drawDepths(const std::vector<std::size_t> &sections);

    Gl &m_gl;
    SlabPainter m_painter;
    Layers m_layers;
    CapBuffers m_caps;
    MarkBuffers m_marks;
    FieldPainter m_fields;

    const Scene *m_scene = nullptr;
    const ViewStyle *m_style = nullptr;
    const RenderOptions *m_options = nullptr;
    FrameView m_view;
};

} // namespace fff::ui
