#include "ui/view/field_painter.h"

#include "ui/view/slab_mesh.h"
#include "ui/view/slab_painter.h"
#include "ui/view/stress_colours.h"

#include <array>
#include <cstddef>

namespace fff::ui {

namespace {

struct FieldVertex
{
    std::array<float, 3> position;
    std::array<float, 2> use; // of what the sheet bears; the face: 1 or −1
};

const void *inVertex(std::size_t bytes)
{
    return reinterpret_cast<const void *>(bytes);
}

} // namespace

FieldPainter::FieldPainter(Gl &gl) : m_gl(gl), m_program(loadProgram("field", "field")) {}

FieldPainter::~FieldPainter()
{
    for (const auto &[key, buffers] : m_fields)
        free(buffers);
}

void FieldPainter::update(const Scene &scene)
{
    for (auto &[key, buffers] : m_fields)
        buffers.isUsed = false;
    for (const SceneSection &section : scene.sections) {
        for (const StressFieldPointer &field : section.fields) {
            const Key key(field.get(), section.mesh.get());
            auto found = m_fields.find(key);
            if (found == m_fields.end())
                found = m_fields.emplace(key, upload(field, section)).first;
            found->second.isUsed = true;
        }
    }
    for (auto it = m_fields.begin(); it != m_fields.end();) {
        if (it->second.isUsed) {
            ++it;
        } else {
            free(it->second);
            it = m_fields.erase(it);
        }
    }
}

FieldPainter::Buffers FieldPainter::upload(const StressFieldPointer &field,
                                           const SceneSection &section)
{
    std::vector<FieldVertex> vertices;
    std::vector<std::uint32_t> triangles;
    const auto count = static_cast<std::uint32_t>(field->points.size());
    vertices.reserve(2 * count);
    triangles.reserve(6 * field->triangles.size());
    for (const std::size_t face : {0u, 1u}) {
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2 &at = field->points[i];
            const std::array<float, 3> flat{static_cast<float>(at.x()), static_cast<float>(at.y()),
                                            face == 0 ? 1.0f : -1.0f};
            vertices.push_back(
                {section.mesh ? section.mesh->vertices[face * count + i].position : flat,
                 {field->use[face][i], flat[2]}});
        }
    }
    for (const auto &t : field->triangles) {
        for (const int i : t)
            triangles.push_back(static_cast<std::uint32_t>(i));
        for (const int i : {t[0], t[2], t[1]})
            triangles.push_back(count + static_cast<std::uint32_t>(i));
    }
    Buffers buffers;
    buffers.field = field;
    buffers.mesh = section.mesh;
    buffers.count = static_cast<GLsizei>(triangles.size());
    const auto fill = [this](GLenum target, GLuint &buffer, const auto &data) {
        m_gl.glGenBuffers(1, &buffer);
        m_gl.glBindBuffer(target, buffer);
        m_gl.glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(data[0])),
                          data.data(), GL_STATIC_DRAW);
    };
    m_gl.glGenVertexArrays(1, &buffers.array);
    m_gl.glBindVertexArray(buffers.array);
    fill(GL_ARRAY_BUFFER, buffers.vertices, vertices);
    fill(GL_ELEMENT_ARRAY_BUFFER, buffers.triangles, triangles);
    m_gl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(FieldVertex),
                               inVertex(offsetof(FieldVertex, position)));
    m_gl.glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(FieldVertex),
                               inVertex(offsetof(FieldVertex, use)));
    m_gl.glEnableVertexAttribArray(0);
    m_gl.glEnableVertexAttribArray(1);
    m_gl.glBindVertexArray(0);
    return buffers;
}

void FieldPainter::free(const Buffers &buffers)
{
    m_gl.glDeleteVertexArrays(1, &buffers.array);
    const GLuint ids[] = {buffers.vertices, buffers.triangles};
    m_gl.glDeleteBuffers(2, ids);
}

void FieldPainter::draw(const SceneSection &section, const FrameView &view, const FieldLook &look)
{
    if (section.fields.empty())
        return;
    const Eigen::Matrix4d place = slabMatrix(section);
    Eigen::Matrix3d turned;
    turned << section.frame.x, section.frame.y, section.frame.normal();
    QOpenGLShaderProgram &p = *m_program;
    p.bind();
    p.setUniformValue("toClip", toFloat(Eigen::Matrix4d(view.toClip * place)));
    p.setUniformValue(
        "normalToView",
        toFloat(Eigen::Matrix3d(view.camera.orientation.conjugate().toRotationMatrix() * turned)));
    p.setUniformValue("cutRow", cutRow(view.clip, place));
    std::array<QVector3D, kStressColours> palette;
    for (std::size_t i = 0; i < palette.size(); ++i)
        palette[i] = rgb(
            stressColour(kFirstStressColour + (1.0 - kFirstStressColour) * static_cast<double>(i) /
                                                  (kStressColours - 1.0),
                         look.isForColourBlind));
    p.setUniformValueArray("palette", palette.data(), static_cast<int>(palette.size()));
    p.setUniformValue("first", static_cast<float>(kFirstStressColour));
    p.setUniformValue("least", static_cast<float>(look.least));
    p.setUniformValue("alpha", static_cast<float>(look.alpha));
    p.setUniformValue("pixel", static_cast<float>(view.ratio()));
    for (const StressFieldPointer &field : section.fields) {
        const Buffers &buffers = m_fields.at({field.get(), section.mesh.get()});
        m_gl.glBindVertexArray(buffers.array);
        m_gl.glDrawElements(GL_TRIANGLES, buffers.count, GL_UNSIGNED_INT, nullptr);
    }
}

} // namespace fff::ui
