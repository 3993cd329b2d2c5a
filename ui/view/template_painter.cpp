#include "ui/view/template_painter.h"

#include <algorithm>
#include <cstddef>

namespace fff::ui {

namespace {

const QVector3D kClayDark(0x5c / 255.0F, 0x6e / 255.0F, 0x86 / 255.0F);
const QVector3D kClayBright(0xf4 / 255.0F, 0xf7 / 255.0F, 0xfa / 255.0F);
/// Of a skin, which is drawn over sheets that let light through, before a bright background.
const QVector3D kSkinDark(0x2c / 255.0F, 0x3b / 255.0F, 0x52 / 255.0F);
const QVector3D kSkinBright(0xb4 / 255.0F, 0xc1 / 255.0F, 0xd4 / 255.0F);
/// A background that is darker than this leaves clay bright enough, HSL.
constexpr double kDarkBackground = 0.5;
/// Of the accent, what a selected one has of it.
constexpr float kSelectedTint = 0.35F;

QVector3D tinted(const QVector3D &clay, const QColor &accent, bool isSelected)
{
    const QVector3D colour(static_cast<float>(accent.redF()), static_cast<float>(accent.greenF()),
                           static_cast<float>(accent.blueF()));
    return isSelected ? (1.0F - kSelectedTint) * clay + kSelectedTint * colour : clay;
}

Eigen::Matrix4d matrixOf(const Similarity &placement)
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = placement.scale * placement.turn;
    matrix.topRightCorner<3, 1>() = placement.shift;
    return matrix;
}

} // namespace

std::vector<SceneTemplate> templatesOf(const Document &document, const PulledTemplates *pulled)
{
    std::vector<SceneTemplate> seen;
    for (const TemplatePointer &one : document.templates) {
        if (one->isHidden || !one->mesh)
            continue;
        const TemplateMeshPointer &mesh = pulled ? pulled->meshOf(*one) : one->mesh;
        const Box3 &own = mesh->mesh->bounds(); // about whose middle it is drawn
        SceneTemplate shown{mesh,
                            worldPlacement(*one, *one->mesh) * Similarity::moved(own.center()),
                            {},
                            one->opacity,
                            false};
        const Vec3 half = 0.5 * own.size();
        for (int corner = 0; corner < 8; ++corner)
            shown.bounds.extend(shown.placement(half.cwiseProduct(
                Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1))));
        seen.push_back(std::move(shown));
    }
    return seen;
}

TemplatePainter::TemplatePainter(Gl &gl) : m_gl(gl), m_program(loadProgram("template", "template"))
{
}

TemplatePainter::~TemplatePainter()
{
    for (Uploaded &one : m_uploaded) {
        remove(one.fine);
        remove(one.coarse);
    }
}

TemplatePainter::Buffers TemplatePainter::upload(const MeshSurface &surface)
{
    Buffers buffers;
    buffers.count = static_cast<GLsizei>(surface.indices.size());
    if (buffers.count == 0)
        return buffers;
    m_gl.glGenVertexArrays(1, &buffers.array);
    m_gl.glGenBuffers(1, &buffers.vertices);
    m_gl.glGenBuffers(1, &buffers.indices);
    m_gl.glBindVertexArray(buffers.array);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, buffers.vertices);
    m_gl.glBufferData(GL_ARRAY_BUFFER,
                      static_cast<GLsizeiptr>(surface.corners.size() * sizeof(MeshSurface::Corner)),
                      surface.corners.data(), GL_STATIC_DRAW);
    const std::array<std::size_t, 2> offsets{offsetof(MeshSurface::Corner, position),
                                             offsetof(MeshSurface::Corner, normal)};
    for (GLuint i = 0; i < offsets.size(); ++i) {
        m_gl.glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(MeshSurface::Corner),
                                   reinterpret_cast<const void *>(offsets[i]));
        m_gl.glEnableVertexAttribArray(i);
    }
    m_gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.indices);
    m_gl.glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                      static_cast<GLsizeiptr>(surface.indices.size() * sizeof(std::uint32_t)),
                      surface.indices.data(), GL_STATIC_DRAW);
    m_gl.glBindVertexArray(0);
    return buffers;
}

void TemplatePainter::remove(Buffers &buffers)
{
    m_gl.glDeleteVertexArrays(1, &buffers.array);
    m_gl.glDeleteBuffers(1, &buffers.vertices);
    m_gl.glDeleteBuffers(1, &buffers.indices);
}

void TemplatePainter::update(const std::vector<SceneTemplate> &templates)
{
    m_templates = templates;
    const auto isSeen = [&](const TemplateMeshPointer &mesh) {
        return std::any_of(templates.begin(), templates.end(),
                           [&](const SceneTemplate &one) { return one.mesh == mesh; });
    };
    for (Uploaded &one : m_uploaded)
        if (!isSeen(one.mesh)) {
            remove(one.fine);
            remove(one.coarse);
            one.mesh = nullptr;
        }
    std::erase_if(m_uploaded, [](const Uploaded &one) { return !one.mesh; });
    for (const SceneTemplate &wanted : templates)
        if (std::none_of(m_uploaded.begin(), m_uploaded.end(),
                         [&](const Uploaded &one) { return one.mesh == wanted.mesh; }))
            m_uploaded.push_back(
                {wanted.mesh, upload(wanted.mesh->surface), upload(wanted.mesh->coarse)});
}

void TemplatePainter::draw(const FrameView &view, const ViewStyle &style, FrameQuality quality)
{
    m_program->bind();
    m_program->setUniformValue("toClip", toFloat(view.toClip));
    m_program->setUniformValue("eye", toFloat(view.eye()));
    m_program->setUniformValue(
        "normalToView",
        toFloat(Eigen::Matrix3d(view.camera.orientation.conjugate().toRotationMatrix())));
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glEnable(GL_CULL_FACE);
    m_gl.glCullFace(GL_BACK);
    // First how deep they are, then what is nearest alone: else an ear shines through a head.
    for (const bool isColour : {false, true}) {
        const GLboolean mask = isColour ? GL_TRUE : GL_FALSE;
        m_gl.glColorMask(mask, mask, mask, mask);
        if (isColour)
            m_gl.glEnable(GL_BLEND);
        for (const SceneTemplate &one : m_templates)
            draw(one, style, quality);
    }
    m_gl.glDisable(GL_BLEND);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glFrontFace(GL_CCW);
    m_gl.glBindVertexArray(0);
}

void TemplatePainter::draw(const SceneTemplate &one, const ViewStyle &style, FrameQuality quality)
{
    const auto uploaded = std::find_if(m_uploaded.begin(), m_uploaded.end(),
                                       [&](const Uploaded &u) { return u.mesh == one.mesh; });
    const bool isCoarse = quality != FrameQuality::Full && uploaded->coarse.count > 0;
    const Buffers &buffers = isCoarse ? uploaded->coarse : uploaded->fine;
    m_program->setUniformValue("toWorld", toFloat(matrixOf(one.placement)));
    m_program->setUniformValue("normalToWorld", toFloat(one.placement.turn));
    m_program->setUniformValue("opacity", static_cast<float>(one.opacity));
    const bool isInk = one.isSkin && style.top.lightnessF() > kDarkBackground;
    m_program->setUniformValue("dark",
                               tinted(isInk ? kSkinDark : kClayDark, style.accent, one.isSelected));
    m_program->setUniformValue(
        "bright", tinted(isInk ? kSkinBright : kClayBright, style.accent, one.isSelected));
    m_gl.glFrontFace(one.placement.turn.determinant() < 0.0 ? GL_CW : GL_CCW);
    m_gl.glBindVertexArray(buffers.array);
    m_gl.glDrawElements(GL_TRIANGLES, buffers.count, GL_UNSIGNED_INT, nullptr);
}

} // namespace fff::ui
