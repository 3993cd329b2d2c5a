// Lines on the graphics card that the slab painter draws (ui/view/slab_mesh.h, SlabEdge).
#pragma once

#include "ui/view/bent_slab.h"
#include "ui/view/gl.h"

#include <span>

namespace fff::ui {

struct EdgeArray
{
    GLuint array = 0, buffer = 0; // vertex array object, and what it is of
    GLuint motions = 0;           // of what is bent; else none
    int count = 0;
};

/// An empty one, to be filled.
EdgeArray makeEdgeArray(Gl &gl);
/// usage  GL_STATIC_DRAW, or GL_STREAM_DRAW for what is another one with every picture
void fillEdgeArray(Gl &gl, EdgeArray &edges, std::span<const SlabEdge> data, GLenum usage);
/// One for each line that it has.
void fillEdgeMotions(Gl &gl, EdgeArray &edges, std::span<const EdgeMotion> motions);
void freeEdgeArray(Gl &gl, const EdgeArray &edges);

} // namespace fff::ui
