#include "ui/view/slab_buffers.h"

#include "ui/view/bent_slab.h"

namespace fff::ui {

SlabBuffers::~SlabBuffers()
{
    for (const auto &[key, slab] : m_slabs)
        free(slab);
}

void SlabBuffers::update(const Scene &scene)
{
    for (auto &[key, slab] : m_slabs)
        slab.isUsed = false;
    m_ofSection.clear();
    for (const SceneSection &section : scene.sections) {
        const Key key(section.bent  ? static_cast<const void *>(section.bent.get())
                      : section.cut ? static_cast<const void *>(section.cut.get())
                                    : static_cast<const void *>(section.shape.get()),
                      section.cut ? section.covers.get() : nullptr);
        auto found = m_slabs.find(key);
        if (found == m_slabs.end())
            found = m_slabs.emplace(key, upload(section)).first;
        found->second.isUsed = true;
        m_ofSection.push_back(&found->second);
    }
    for (auto it = m_slabs.begin(); it != m_slabs.end();) {
        if (it->second.isUsed) {
            ++it;
        } else {
            free(it->second);
            it = m_slabs.erase(it);
        }
    }
}

SlabBuffers::Slab SlabBuffers::upload(const SceneSection &section)
{
    const SlabMesh mesh = meshOf(section);
    Slab slab;
    slab.cut = section.cut;
    slab.shape = section.shape;
    slab.covers = section.covers;
    slab.bent = section.bent;
    slab.coverStarts = mesh.coverStarts;
    ++m_uploadCount;
    m_gl.glGenVertexArrays(1, &slab.fillArray);
    m_gl.glBindVertexArray(slab.fillArray);
    fillBuffer(m_gl, GL_ELEMENT_ARRAY_BUFFER, slab.triangles, mesh.triangles);
    fillBuffer(m_gl, GL_ARRAY_BUFFER, slab.vertices, mesh.vertices);
    setSlabVertices(m_gl);
    if (section.bent) {
        fillBuffer(m_gl, GL_ARRAY_BUFFER, slab.motions, section.bent->motions);
        setMotions(m_gl);
    }

    m_gl.glBindVertexArray(0);
    slab.edges = makeEdgeArray(m_gl);
    fillEdgeArray(m_gl, slab.edges, mesh.edges, GL_STATIC_DRAW);
    if (section.bent)
        fillEdgeMotions(m_gl, slab.edges, section.bent->edgeMotions);
    return slab;
}

void SlabBuffers::free(const Slab &slab)
{
    m_gl.glDeleteVertexArrays(1, &slab.fillArray);
    const GLuint buffers[] = {slab.vertices, slab.motions, slab.triangles};
    m_gl.glDeleteBuffers(3, buffers);
    freeEdgeArray(m_gl, slab.edges);
}

} // namespace fff::ui
