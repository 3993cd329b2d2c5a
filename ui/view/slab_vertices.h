// The vertices of slabs on the graphics card: buffers, and where their attributes are in them.
#pragma once

#include "ui/view/gl.h"

namespace fff::ui {

/// Attributes from here on say how a vertex moves; those of what stays are off, and 0.
inline constexpr GLuint kFirstMotion = 2;

// Of the buffer that is bound, to the array that is.

void setSlabVertices(Gl &gl); // SlabVertex after SlabVertex: 0 its position, 1 its normal
void setMotions(Gl &gl);      // VertexMotion after VertexMotion

/// Makes the buffer and binds it. data: a vector.
template <class Data>
void fillBuffer(Gl &gl, GLenum target, GLuint &buffer, const Data &data)
{
    gl.glGenBuffers(1, &buffer);
    gl.glBindBuffer(target, buffer);
    gl.glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(data[0])), data.data(),
                    GL_STATIC_DRAW);
}

} // namespace fff::ui
