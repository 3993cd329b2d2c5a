#include "ui/view/cap_buffers.h"

#include "ui/view/cut_caps.h"
#include "ui/view/view_style.h"

#include <cmath>
#include <cstddef>

namespace fff::ui {

namespace {

struct CapVertex
{
    std::array<float, 3> position;
    std::array<float, 3> colour;
};

void addCapOf(CutCaps &caps, const SceneSection &section, const ClipPlane &plane)
{
    const Vec3 middle = section.bounds.center(), half = 0.5 * section.bounds.size();
    if (std::abs(plane.height(middle)) > plane.normal.cwiseAbs().dot(half))
        return;
    if (!section.cut) {
        addCap(caps, {&section.shape->region(), 1}, trianglesOf(*section.shape), section.frame,
               section.thickness, plane);
        return;
    }
    std::vector<Region> regions;
    for (const CurvedRegion &part : section.cut->parts())
        regions.push_back(part.region);
    addCap(caps, regions, trianglesOf(*section.cut), section.frame, section.thickness, plane);
}

const void *offset(std::size_t bytes)
{
    return reinterpret_cast<const void *>(bytes);
}

} // namespace

CapBuffers::CapBuffers(Gl &gl)
    : m_gl(gl), m_program(loadProgram("cap", "cap")), m_edges(makeEdgeArray(gl))
{
    m_gl.glGenVertexArrays(1, &m_fillArray);
    m_gl.glGenBuffers(1, &m_vertices);

    m_gl.glBindVertexArray(m_fillArray);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_vertices);
    m_gl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(CapVertex),
                               offset(offsetof(CapVertex, position)));
    m_gl.glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(CapVertex),
                               offset(offsetof(CapVertex, colour)));
    m_gl.glEnableVertexAttribArray(0);
    m_gl.glEnableVertexAttribArray(1);

    m_gl.glBindVertexArray(0);
}

CapBuffers::~CapBuffers()
{
    m_gl.glDeleteVertexArrays(1, &m_fillArray);
    m_gl.glDeleteBuffers(1, &m_vertices);
    freeEdgeArray(m_gl, m_edges);
}

void CapBuffers::update(const Scene &scene, const ClipPlane &plane, const ViewStyle &style)
{
    CutCaps caps;
    std::vector<CapVertex> vertices;
    for (const SceneSection &section : scene.sections) {
        if (section.isHidden || section.isGhost || section.bent) // what is bent stays open
            continue;
        addCapOf(caps, section, plane);
        const QColor &problem = section.isDoubtful ? style.warningSide : style.problemSide;
        const QColor &c = section.isProblem ? problem
                          : section.isMade  ? style.madeSide
                                            : section.look.side;
        for (std::size_t i = vertices.size(); i < caps.triangles.size(); ++i)
            vertices.push_back({caps.triangles[i],
                                {static_cast<float>(c.redF()), static_cast<float>(c.greenF()),
                                 static_cast<float>(c.blueF())}});
    }
    m_vertexCount = static_cast<int>(vertices.size());
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_vertices);
    m_gl.glBufferData(GL_ARRAY_BUFFER,
                      static_cast<GLsizeiptr>(vertices.size() * sizeof(vertices[0])),
                      vertices.data(), GL_STREAM_DRAW);
    fillEdgeArray(m_gl, m_edges, caps.edges, GL_STREAM_DRAW);
}

void CapBuffers::fill(const FrameView &view)
{
    m_program->bind();
    m_program->setUniformValue("toClip", toFloat(view.toClip));
    m_gl.glBindVertexArray(m_fillArray);
    m_gl.glDrawArrays(GL_TRIANGLES, 0, m_vertexCount);
}

} // namespace fff::ui
