#version 330 core
// A field of stress over the two faces of a slab.
layout(location = 0) in vec3 position; // as in a slab's mesh
layout(location = 1) in vec2 use;      // of what the sheet bears; the face: 1 or -1
uniform mat4 toClip;
uniform mat3 normalToView;
uniform vec4 cutRow; // gives the height over the plane that cuts the view open, mm
out float share;
out vec3 viewNormal;

void main()
{
    gl_Position = toClip * vec4(position, 1.0);
    gl_ClipDistance[0] = -dot(cutRow, vec4(position, 1.0));
    share = use.x;
    viewNormal = normalToView * vec3(0.0, 0.0, use.y);
}
