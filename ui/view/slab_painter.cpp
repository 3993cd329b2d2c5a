#include "ui/view/slab_painter.h"

namespace fff::ui {

namespace {

/// Whether a box may be seen: not all of it lies beyond one border of the picture.
bool mayBeSeen(const Box3 &box, const Eigen::Matrix4d &toClip)
{
    int beyond[5] = {};
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector4d p =
            toClip * Eigen::Vector4d(corner & 1 ? box.min.x() : box.max.x(),
                                     corner & 2 ? box.min.y() : box.max.y(),
                                     corner & 4 ? box.min.z() : box.max.z(), 1.0);
        beyond[0] += p.x() < -p.w();
        beyond[1] += p.x() > p.w();
        beyond[2] += p.y() < -p.w();
        beyond[3] += p.y() > p.w();
        beyond[4] += p.z() < -p.w();
    }
    for (const int count : beyond) {
        if (count == 8)
            return false;
    }
    return true;
}

} // namespace

QVector4D cutRow(const std::optional<ClipPlane> &plane, const Eigen::Matrix4d &place)
{
    if (!plane)
        return {0.0f, 0.0f, 0.0f, -1.0f};
    Eigen::RowVector4d row;
    row << plane->normal.transpose(), -plane->normal.dot(plane->point);
    return toFloat(Eigen::Vector4d((row * place).transpose()));
}

Eigen::Matrix4d slabMatrix(const SceneSection &section)
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.block<3, 1>(0, 0) = section.frame.x;
    matrix.block<3, 1>(0, 1) = section.frame.y;
    matrix.block<3, 1>(0, 2) = 0.5 * section.thickness * section.frame.normal();
    matrix.block<3, 1>(0, 3) = section.frame.origin;
    return matrix;
}

QVector3D rgb(const QColor &c)
{
    return {static_cast<float>(c.redF()), static_cast<float>(c.greenF()),
            static_cast<float>(c.blueF())};
}

QVector4D premultiplied(const QColor &c, double alpha)
{
    return QVector4D(rgb(c) * static_cast<float>(alpha), static_cast<float>(alpha));
}

SlabPainter::SlabPainter(Gl &gl, const SlabBuffers &slabs)
    : m_gl(gl),
      m_slabs(slabs), m_fill{fillProgram(""), fillProgram("LAYER")}, m_edge{edgeProgram(""),
                                                                            edgeProgram("LAYER")}
{
}

bool SlabPainter::isReady() const
{
    return m_fill[0].program && m_fill[1].program && m_edge[0].program && m_edge[1].program;
}

SlabPainter::FillProgram SlabPainter::fillProgram(const char *define)
{
    FillProgram p{};
    p.program = loadProgram("slab", "slab", define);
    if (!p.program)
        return p;
    const auto at = [&](const char *name) { return p.program->uniformLocation(name); };
    p.toClip = at("toClip");
    p.normalToView = at("normalToView");
    p.heightRow = at("heightRow");
    p.cutRow = at("cutRow");
    p.times = at("times");
    p.face = at("face");
    p.side = at("side");
    p.alpha = at("alpha");
    p.hatch = at("hatch");
    p.hatchPixel = at("hatchPixel");
    p.opaqueDepth = at("opaqueDepth");
    p.layerDepth = at("layerDepth");
    p.isFirst = at("isFirst");
    p.setBack = at("setBack");
    return p;
}

SlabPainter::EdgeProgram SlabPainter::edgeProgram(const char *define)
{
    EdgeProgram p{};
    p.program = loadProgram("edge", "edge", define);
    if (!p.program)
        return p;
    const auto at = [&](const char *name) { return p.program->uniformLocation(name); };
    p.toClip = at("toClip");
    p.halfThickness = at("halfThickness");
    p.eye = at("eye");
    p.viewport = at("viewport");
    p.width = at("width");
    p.silhouetteWidth = at("silhouetteWidth");
    p.nearer = at("nearer");
    p.overhang = at("overhang");
    p.cutRow = at("cutRow");
    p.times = at("times");
    p.line = at("line");
    p.opaqueDepth = at("opaqueDepth");
    p.layerDepth = at("layerDepth");
    p.isFirst = at("isFirst");
    return p;
}

void SlabPainter::begin(const FrameView &view, const Scene &scene)
{
    m_view = view;
    m_scene = &scene;
    m_isSeen.assign(scene.sections.size(), false);
    for (std::size_t i = 0; i < scene.sections.size(); ++i)
        m_isSeen[i] =
            !scene.sections[i].isHidden && mayBeSeen(scene.sections[i].bounds, view.toClip);
    m_layer.reset();
}

void SlabPainter::setLayer(const LayerDepths *layer)
{
    m_layer = layer ? std::optional(*layer) : std::nullopt;
}

template <class Program>
void SlabPainter::use(Program &program)
{
    program.program->bind();
    if (!m_layer)
        return;
    m_gl.glActiveTexture(GL_TEXTURE1);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_layer->before);
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_layer->opaque);
    program.program->setUniformValue(program.opaqueDepth, 0);
    program.program->setUniformValue(program.layerDepth, 1);
    program.program->setUniformValue(program.isFirst, m_layer->isFirst ? 1.0f : 0.0f);
}

/// A ghost lets one see into the slit, and a hidden slab or one that went does so, too.
bool SlabPainter::hidesWalls(int guest) const
{
    if (guest < 0)
        return false;
    const SceneSection &section = m_scene->sections[static_cast<std::size_t>(guest)];
    return !section.isHidden && !section.isGhost;
}

void SlabPainter::fill(std::size_t index, const SlabLook &look)
{
    if (!m_isSeen[index])
        return;
    const SceneSection &section = m_scene->sections[index];
    const Eigen::Matrix4d place = slabMatrix(section);
    Eigen::Matrix3d turned;
    turned << section.frame.x, section.frame.y, section.frame.normal();
    FillProgram &p = m_fill[m_layer ? 1 : 0];
    use(p);
    p.program->setUniformValue(p.toClip, toFloat(Eigen::Matrix4d(m_view.toClip * place)));
    p.program->setUniformValue(
        p.normalToView, toFloat(Eigen::Matrix3d(
                            m_view.camera.orientation.conjugate().toRotationMatrix() * turned)));
    p.program->setUniformValue(p.heightRow, toFloat(Eigen::Vector4d(place.row(1).transpose())));
    p.program->setUniformValue(p.cutRow, cutRow(m_view.clip, place));
    p.program->setUniformValue(p.times, static_cast<float>(section.bentTimes));
    p.program->setUniformValue(p.face, rgb(look.face));
    p.program->setUniformValue(p.side, rgb(look.side));
    p.program->setUniformValue(p.alpha, static_cast<float>(look.alpha));
    p.program->setUniformValue(p.hatch, look.hatch.isValid() ? QVector4D(rgb(look.hatch), 1.0f)
                                                             : QVector4D());
    p.program->setUniformValue(p.setBack, static_cast<float>(0.7 * m_view.ratio() + 0.5));
    p.program->setUniformValue(p.hatchPixel, static_cast<float>(m_view.ratio()));

    const SlabBuffers::Slab &slab = m_slabs.slab(index);
    m_gl.glBindVertexArray(slab.fillArray);
    const auto draw = [&](std::size_t from, std::size_t to) {
        if (to > from)
            m_gl.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(to - from), GL_UNSIGNED_INT,
                                reinterpret_cast<const void *>(from * sizeof(std::uint32_t)));
    };
    const std::vector<std::size_t> &starts = slab.coverStarts;
    draw(0, starts.front());
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
        if (!hidesWalls(section.guests[i]))
            draw(starts[i], starts[i + 1]);
    }
}

void SlabPainter::edges(std::size_t index, const EdgeLook &look)
{
    edges(index, m_slabs.slab(index).edges, look);
}

void SlabPainter::edges(std::size_t index, const EdgeArray &edges, const EdgeLook &look)
{
    if (!m_isSeen[index] || edges.count == 0)
        return;
    const SceneSection &section = m_scene->sections[index];
    drawEdges(look, slabMatrix(section), 0.5 * section.thickness, section.bentTimes, section.frame,
              edges);
}

void SlabPainter::edges(const EdgeArray &edges, const EdgeLook &look)
{
    if (edges.count > 0)
        drawEdges(look, Eigen::Matrix4d::Identity(), 1.0, 0.0, Frame(), edges);
}

void SlabPainter::drawEdges(const EdgeLook &look, const Eigen::Matrix4d &place,
                            double halfThickness, double times, const Frame &frame,
                            const EdgeArray &edges)
{
    EdgeProgram &p = m_edge[m_layer ? 1 : 0];
    use(p);
    p.program->setUniformValue(p.toClip, toFloat(Eigen::Matrix4d(m_view.toClip * place)));
    p.program->setUniformValue(p.halfThickness, static_cast<float>(halfThickness));
    const Eigen::Vector4d eye = m_view.eye();
    const Vec3 from = eye.head<3>() - eye.w() * frame.origin;
    p.program->setUniformValue(p.eye, toFloat(Eigen::Vector4d(frame.x.dot(from), frame.y.dot(from),
                                                              frame.normal().dot(from), eye.w())));
    p.program->setUniformValue(p.viewport, static_cast<float>(m_view.pixels.x()),
                               static_cast<float>(m_view.pixels.y()));
    p.program->setUniformValue(p.width, static_cast<float>(look.width * m_view.ratio()));
    p.program->setUniformValue(p.silhouetteWidth,
                               static_cast<float>(look.silhouetteWidth * m_view.ratio()));
    p.program->setUniformValue(p.nearer, static_cast<float>(look.nearer));
    // Where lines let something through, their overlaps would be dark dots.
    p.program->setUniformValue(p.overhang, look.colour.w() < 1.0f ? 0.0f : 0.5f);
    p.program->setUniformValue(p.cutRow, cutRow(m_view.clip, place));
    p.program->setUniformValue(p.times, static_cast<float>(times));
    p.program->setUniformValue(p.line, look.colour);
    m_gl.glBindVertexArray(edges.array);
    m_gl.glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, edges.count);
}

} // namespace fff::ui
