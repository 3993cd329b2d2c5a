#include "ui/view/edge_array.h"

#include <cstddef>

namespace fff::ui {

namespace {

constexpr GLuint kFirstEdgeMotion = 4; // attributes; those of what stays are off, and 0

const void *offset(std::size_t bytes)
{
    return reinterpret_cast<const void *>(bytes);
}

} // namespace

EdgeArray makeEdgeArray(Gl &gl)
{
    EdgeArray edges;
    gl.glGenVertexArrays(1, &edges.array);
    gl.glGenBuffers(1, &edges.buffer);
    gl.glBindVertexArray(edges.array);
    gl.glBindBuffer(GL_ARRAY_BUFFER, edges.buffer);
    const std::size_t floats[] = {offsetof(SlabEdge, from), offsetof(SlabEdge, to)};
    const std::size_t normals[] = {offsetof(SlabEdge, normalA), offsetof(SlabEdge, normalB)};
    for (GLuint i = 0; i < 2; ++i) {
        gl.glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(SlabEdge), offset(floats[i]));
        gl.glVertexAttribPointer(2 + i, 4, GL_BYTE, GL_TRUE, sizeof(SlabEdge), offset(normals[i]));
    }
    for (GLuint i = 0; i < 4; ++i) {
        gl.glEnableVertexAttribArray(i);
        gl.glVertexAttribDivisor(i, 1);
    }
    gl.glBindVertexArray(0);
    return edges;
}

void fillEdgeArray(Gl &gl, EdgeArray &edges, std::span<const SlabEdge> data, GLenum usage)
{
    edges.count = static_cast<int>(data.size());
    gl.glBindBuffer(GL_ARRAY_BUFFER, edges.buffer);
    gl.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size_bytes()), data.data(),
                    usage);
}

void fillEdgeMotions(Gl &gl, EdgeArray &edges, std::span<const EdgeMotion> motions)
{
    gl.glGenBuffers(1, &edges.motions);
    gl.glBindVertexArray(edges.array);
    gl.glBindBuffer(GL_ARRAY_BUFFER, edges.motions);
    gl.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(motions.size_bytes()), motions.data(),
                    GL_STATIC_DRAW);
    const std::size_t at[] = {offsetof(EdgeMotion, from), offsetof(EdgeMotion, to),
                              offsetof(EdgeMotion, turn), offsetof(EdgeMotion, turnMore)};
    for (GLuint i = 0; i < 4; ++i) {
        gl.glVertexAttribPointer(kFirstEdgeMotion + i, 3, GL_FLOAT, GL_FALSE, sizeof(EdgeMotion),
                                 offset(at[i]));
        gl.glEnableVertexAttribArray(kFirstEdgeMotion + i);
        gl.glVertexAttribDivisor(kFirstEdgeMotion + i, 1);
    }
    gl.glBindVertexArray(0);
}

void freeEdgeArray(Gl &gl, const EdgeArray &edges)
{
    gl.glDeleteVertexArrays(1, &edges.array);
    const GLuint buffers[] = {edges.buffer, edges.motions};
    gl.glDeleteBuffers(2, buffers);
}

} // namespace fff::ui
