// Slab meshes on the graphics card, one for every cut section (or bare shape) that is drawn, shared
// by all sections that look alike. Only what changed is uploaded.
#pragma once

#include "ui/view/edge_array.h"
#include "ui/view/scene.h"
#include "ui/view/slab_vertices.h"

#include <map>
#include <utility>

namespace fff::ui {

class SlabBuffers
{
public:
    struct Slab
    {
        GLuint fillArray = 0;                            // vertex array object
        GLuint vertices = 0, motions = 0, triangles = 0; // no motions: it is not bent
        EdgeArray edges;
        std::vector<std::size_t> coverStarts; // indices, see SlabMesh
        CutSectionPointer cut;                // keep the key's addresses from being used again
        ShapePointer shape;
        CoversPointer covers;
        std::shared_ptr<const BentSlab> bent;
        bool isUsed = false;
    };

    explicit SlabBuffers(Gl &gl) : m_gl(gl) {}
    ~SlabBuffers(); // context current
    SlabBuffers(const SlabBuffers &) = delete;
    SlabBuffers &operator=(const SlabBuffers &) = delete;

    /// Uploads what is new in the scene and frees what is no longer in it.
    void update(const Scene &scene);
    /// Of a section of the scene that update() has seen last, by its index there.
    const Slab &slab(std::size_t section) const { return *m_ofSection[section]; }
    /// Meshes uploaded so far: a test sees that an edit uploads no more than what it touches.
    int uploadCount() const { return m_uploadCount; }

private:
    using Key = std::pair<const void *, const void *>; // cut or shape, covers
    Slab upload(const SceneSection &section);
    void free(const Slab &slab);

    Gl &m_gl;
    std::map<Key, Slab> m_slabs;
    std::vector<const Slab *> m_ofSection;
    int m_uploadCount = 0;
};

} // namespace fff::ui
