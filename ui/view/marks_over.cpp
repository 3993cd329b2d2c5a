#include "ui/view/marks_over.h"

#include <algorithm>
#include <array>

namespace fff::ui {

namespace {

constexpr int kTile = 32; // px

bool isPainted(const QImage &image, const QRect &tile)
{
    for (int y = tile.top(); y <= tile.bottom(); ++y) {
        const auto *row = reinterpret_cast<const QRgb *>(image.constScanLine(y));
        if (std::any_of(row + tile.left(), row + tile.right() + 1,
                        [](QRgb pixel) { return pixel != 0; }))
            return true;
    }
    return false;
}

} // namespace

std::vector<QRect> paintedParts(const QImage &image)
{
    std::vector<QRect> parts;
    for (int y = 0; y < image.height(); y += kTile) {
        bool goesOn = false; // the tile to the left is one of them
        for (int x = 0; x < image.width(); x += kTile) {
            const QRect tile = QRect(x, y, kTile, kTile) & image.rect();
            const bool isOne = isPainted(image, tile);
            if (isOne && goesOn)
                parts.back() |= tile;
            else if (isOne)
                parts.push_back(tile);
            goesOn = isOne;
        }
    }
    return parts;
}

MarksOver::MarksOver(Gl &gl) : m_gl(gl), m_program(loadProgram("marks", "marks"))
{
    m_gl.glGenVertexArrays(1, &m_array);
    m_gl.glBindVertexArray(m_array);
    m_gl.glGenBuffers(1, &m_corners);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_corners);
    m_gl.glEnableVertexAttribArray(0);
    m_gl.glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    m_gl.glBindVertexArray(0);
}

MarksOver::~MarksOver()
{
    m_gl.glDeleteTextures(1, &m_texture);
    m_gl.glDeleteBuffers(1, &m_corners);
    m_gl.glDeleteVertexArrays(1, &m_array);
}

/// What else is in the texture is not looked at.
void MarksOver::upload(const QImage &marks, const std::vector<QRect> &parts)
{
    if (m_size != marks.size()) {
        m_gl.glDeleteTextures(1, &m_texture);
        m_gl.glGenTextures(1, &m_texture);
        m_gl.glBindTexture(GL_TEXTURE_2D, m_texture);
        m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, marks.width(), marks.height(), 0, GL_BGRA,
                          GL_UNSIGNED_INT_8_8_8_8_REV, nullptr);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            m_gl.glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
        m_size = marks.size();
    }
    m_gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    m_gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(marks.bytesPerLine() / 4));
    for (const QRect &part : parts)
        m_gl.glTexSubImage2D(GL_TEXTURE_2D, 0, part.x(), part.y(), part.width(), part.height(),
                             GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                             reinterpret_cast<const QRgb *>(marks.constScanLine(part.y())) +
                                 part.x());
    m_gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void MarksOver::draw(const QImage &marks)
{
    const std::vector<QRect> parts = paintedParts(marks);
    if (parts.empty())
        return;
    m_gl.glActiveTexture(GL_TEXTURE0);
    upload(marks, parts);
    std::vector<std::array<float, 2>> corners;
    for (const QRect &part : parts) {
        const auto left = static_cast<float>(part.x()), top = static_cast<float>(part.y());
        const float right = left + static_cast<float>(part.width());
        const float bottom = top + static_cast<float>(part.height());
        for (const std::array<float, 2> &corner :
             {std::array{left, top}, std::array{left, bottom}, std::array{right, top},
              std::array{right, top}, std::array{left, bottom}, std::array{right, bottom}})
            corners.push_back(corner);
    }
    m_gl.glBindVertexArray(m_array);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_corners);
    m_gl.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof corners[0]),
                      corners.data(), GL_STREAM_DRAW);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.glViewport(0, 0, marks.width(), marks.height());
    m_program->bind();
    m_program->setUniformValue("marks", 0);
    m_program->setUniformValue("size", static_cast<float>(marks.width()),
                               static_cast<float>(marks.height()));
    m_gl.glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
    m_gl.glDisable(GL_BLEND);
    m_gl.glBindVertexArray(0);
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    m_gl.glUseProgram(0);
}

} // namespace fff::ui
