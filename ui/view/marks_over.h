// Brings what QPainter has painted over the picture onto it, only where there is any: most of a
// view has no marks, and with software rendering each of its points that are blended costs time.
#pragma once

#include "ui/view/gl.h"

#include <QImage>
#include <QRect>

#include <memory>
#include <vector>

namespace fff::ui {

/// Boxes, apart from each other, that hold all of the image that is not transparent; rows of tiles
/// from above. image: of 32 bits a pixel, premultiplied.
std::vector<QRect> paintedParts(const QImage &image);

class MarksOver
{
public:
    explicit MarksOver(Gl &gl);
    ~MarksOver(); // context current
    MarksOver(const MarksOver &) = delete;
    MarksOver &operator=(const MarksOver &) = delete;

    bool isReady() const { return m_program != nullptr; }
    /// Onto what is bound, which has as many pixels. marks: ARGB32_Premultiplied.
    void draw(const QImage &marks);

private:
    void upload(const QImage &marks, const std::vector<QRect> &parts);

    Gl &m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    GLuint m_array = 0, m_corners = 0, m_texture = 0;
    QSize m_size; // of the texture
};

} // namespace fff::ui
