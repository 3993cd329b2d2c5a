// Draws slabs and their edges, one call each. What state is set around that (depth, blending) is
// the caller's matter.
#pragma once

#include "ui/view/frame_view.h"
#include "ui/view/slab_buffers.h"

namespace fff::ui {

/// Places a slab's mesh (ui/view/slab_mesh.h) in the world.
Eigen::Matrix4d slabMatrix(const SceneSection &section);

/// The plane's height as a row for places that `place` puts into the world; 0 without a plane.
QVector4D cutRow(const std::optional<ClipPlane> &plane, const Eigen::Matrix4d &place);

QVector3D rgb(const QColor &colour);
QVector4D premultiplied(const QColor &colour, double alpha = 1.0);

struct SlabLook
{
    QColor face, side;
    double alpha = 1.0;
    QColor hatch; // invalid: none
};

struct EdgeLook
{
    QVector4D colour;                          // premultiplied
    double width = 1.0, silhouetteWidth = 1.4; // device-independent pixels
    double nearer = 0.02;                      // mm towards the eye, to lie on its own surface
};

/// Which layer of what lets light through is drawn: see Layers.
struct LayerDepths
{
    GLuint opaque = 0, before = 0; // depth textures
    bool isFirst = true;
};

class SlabPainter
{
public:
    SlabPainter(Gl &gl, const SlabBuffers &slabs);
    bool isReady() const;

    /// What is drawn next is seen like this; the scene is that of the buffers.
    void begin(const FrameView &view, const Scene &scene);
    /// Draw only what lies between these depths from now on; null: everything.
    void setLayer(const LayerDepths *layer);

    /// Without the walls that other slabs hide.
    void fill(std::size_t section, const SlabLook &look);
    void edges(std::size_t section, const EdgeLook &look);
    /// Other lines on a section.
    void edges(std::size_t section, const EdgeArray &edges, const EdgeLook &look);
    /// Lines in the world.
    void edges(const EdgeArray &edges, const EdgeLook &look);

    /// Seen at all: not hidden, and not beyond the picture's border.
    bool isSeen(std::size_t section) const { return m_isSeen[section]; }

private:
    struct FillProgram
    {
        std::unique_ptr<QOpenGLShaderProgram> program;
        int toClip, normalToView, heightRow, cutRow, times, face, side, alpha, hatch, hatchPixel;
        int opaqueDepth, layerDepth, isFirst, setBack;
    };
    struct EdgeProgram
    {
        std::unique_ptr<QOpenGLShaderProgram> program;
        int toClip, halfThickness, eye, viewport, width, silhouetteWidth, nearer, overhang, cutRow,
            times, line;
        int opaqueDepth, layerDepth, isFirst;
    };
    static FillProgram fillProgram(const char *define);
    static EdgeProgram edgeProgram(const char *define);
    template <class Program>
    void use(Program &program);
    void drawEdges(const EdgeLook &look, const Eigen::Matrix4d &place, double halfThickness,
                   double times, const Frame &frame, const EdgeArray &edges);
    bool hidesWalls(int guest) const;

    Gl &m_gl;
    const SlabBuffers &m_slabs;
    FillProgram m_fill[2]; // plain, of a layer
    EdgeProgram m_edge[2];
    FrameView m_view;
    const Scene *m_scene = nullptr;
    std::vector<bool> m_isSeen;
    std::optional<LayerDepths> m_layer;
};

} // namespace fff::ui
