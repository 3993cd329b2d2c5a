// Slab meshes on the graphics card, one for every cut section (or bare shape) that is drawn, shared
// by all sections that look alike.
#pragma once

#include "ui/view/gl.h"
#include "ui/view/scene.h"

#include <unordered_map>

namespace fff::ui {

class SlabBuffers
{
public:
    struct Slab
    {
        GLuint fillArray = 0, edgeArray = 0; // vertex array objects
        GLuint vertices = 0, triangles = 0, edges = 0;
        int indexCount = 0, edgeCount = 0;
        CutSectionPointer cut; // keep the key's address from being used again
        ShapePointer shape;
        bool isUsed = false;
    };

    explicit SlabBuffers(Gl &gl) : m_gl(gl) {}
    ~SlabBuffers(); // context current
    SlabBuffers(const SlabBuffers &) = delete;
    SlabBuffers &operator=(const SlabBuffers &) = delete;

    /// Uploads what is new in the scene and frees what is no longer in it.
    void update(const Scene &scene);
    /// Of a section of the scene that update() has seen last.
    const Slab &slab(const SceneSection &section) const { return m_slabs.at(section.meshKey()); }

private:
    Slab upload(const SceneSection &section);
    void free(const Slab &slab);

    Gl &m_gl;
    std::unordered_map<const void *, Slab> m_slabs;
};

} // namespace fff::ui
