#include "ui/view/slab_vertices.h"

#include "ui/view/bent_slab.h"

#include <cstddef>

namespace fff::ui {

namespace {

const void *inVertex(std::size_t bytes)
{
    return reinterpret_cast<const void *>(bytes);
}

} // namespace

void setSlabVertices(Gl &gl)
{
    gl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(SlabVertex),
                             inVertex(offsetof(SlabVertex, position)));
    gl.glVertexAttribPointer(1, 4, GL_BYTE, GL_TRUE, sizeof(SlabVertex),
                             inVertex(offsetof(SlabVertex, normal)));
    gl.glEnableVertexAttribArray(0);
    gl.glEnableVertexAttribArray(1);
}

void setMotions(Gl &gl)
{
    const std::size_t at[] = {offsetof(VertexMotion, by), offsetof(VertexMotion, turn),
                              offsetof(VertexMotion, turnMore)};
    for (GLuint i = 0; i < 3; ++i) {
        gl.glVertexAttribPointer(kFirstMotion + i, 3, GL_FLOAT, GL_FALSE, sizeof(VertexMotion),
                                 inVertex(at[i]));
        gl.glEnableVertexAttribArray(kFirstMotion + i);
    }
}

} // namespace fff::ui
