// Draws the ground: a grid that fades out around the model, and the model's shadow on it.
#pragma once

#include "ui/view/frame_view.h"
#include "ui/view/ground_shadow.h"

namespace fff::ui {

struct ViewStyle;

class GroundPainter
{
public:
    GroundPainter(Gl &gl, ScreenPass &pass);
    bool isReady() const { return m_program && m_shadow.isReady(); }

    /// The grid lies around what has these bounds.
    void place(const Box3 &bounds);
    double radius() const { return m_radius; } // mm
    void updateShadow(const Scene &scene, const SlabBuffers &slabs);
    /// Where the picture has no nearer depths; leaves the depths as they are.
    void draw(const FrameView &view, const ViewStyle &style);

private:
    Gl &m_gl;
    ScreenPass &m_pass;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    GroundShadow m_shadow;
    Vec2 m_centre = Vec2::Zero(); // x and z, mm
    double m_radius = 0.0;
};

} // namespace fff::ui
