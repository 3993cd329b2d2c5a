#include "ui/view/field_painter.h"

#include "ui/view/field_mesh.h"
#include "ui/view/slab_painter.h"
#include "ui/view/stress_colours.h"

#include <array>
#include <utility>

namespace fff::ui {

namespace {

constexpr GLuint kShare = kFirstMotion + 3; // attribute

} // namespace

FieldPainter::FieldPainter(Gl &gl) : m_gl(gl), m_program(loadProgram("field", "field")) {}

FieldPainter::~FieldPainter()
{
    for (const auto &[key, buffers] : m_fields)
        free(buffers);
}

void FieldPainter::update(const Scene &scene, double least)
{
    if (std::exchange(m_least, least) != least) {
        for (const auto &[key, buffers] : m_fields)
            free(buffers);
        m_fields.clear();
    }
    for (auto &[key, buffers] : m_fields)
        buffers.isUsed = false;
    for (const SceneSection &section : scene.sections) {
        for (const StressFieldPointer &field : section.fields) {
            const Key key = keyOf(field, section);
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

FieldPainter::Key FieldPainter::keyOf(const StressFieldPointer &field, const SceneSection &section)
{
    const void *slab = section.bent  ? static_cast<const void *>(section.bent.get())
                       : section.cut ? static_cast<const void *>(section.cut.get())
                                     : static_cast<const void *>(section.shape.get());
    return {field.get(), slab};
}

FieldPainter::Buffers FieldPainter::upload(const StressFieldPointer &field,
                                           const SceneSection &section)
{
    const FieldMesh mesh = fieldMesh(section, *field, m_least);
    Buffers buffers;
    buffers.field = field;
    buffers.bent = section.bent;
    buffers.cut = section.cut;
    buffers.shape = section.shape;
    buffers.count = static_cast<GLsizei>(mesh.triangles.size());
    m_gl.glGenVertexArrays(1, &buffers.array);
    m_gl.glBindVertexArray(buffers.array);
    fillBuffer(m_gl, GL_ELEMENT_ARRAY_BUFFER, buffers.triangles, mesh.triangles);
    fillBuffer(m_gl, GL_ARRAY_BUFFER, buffers.vertices, mesh.vertices);
    setSlabVertices(m_gl);
    if (!mesh.motions.empty()) {
        fillBuffer(m_gl, GL_ARRAY_BUFFER, buffers.motions, mesh.motions);
        setMotions(m_gl);
    }
    fillBuffer(m_gl, GL_ARRAY_BUFFER, buffers.shares, mesh.shares);
    m_gl.glVertexAttribPointer(kShare, 1, GL_FLOAT, GL_FALSE, sizeof(float), nullptr);
    m_gl.glEnableVertexAttribArray(kShare);
    m_gl.glBindVertexArray(0);
    return buffers;
}

void FieldPainter::free(const Buffers &buffers)
{
    m_gl.glDeleteVertexArrays(1, &buffers.array);
    const GLuint ids[] = {buffers.vertices, buffers.motions, buffers.shares, buffers.triangles};
    m_gl.glDeleteBuffers(4, ids);
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
    p.setUniformValue("times", static_cast<float>(section.bentTimes));
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
        const Buffers &buffers = m_fields.at(keyOf(field, section));
        if (buffers.count == 0)
            continue;
        m_gl.glBindVertexArray(buffers.array);
        m_gl.glDrawElements(GL_TRIANGLES, buffers.count, GL_UNSIGNED_INT, nullptr);
    }
}

} // namespace fff::ui
