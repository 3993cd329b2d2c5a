#version 330 core
uniform mat4 toClip;
uniform vec2 centre; // on the ground, mm
uniform float radius;
out vec2 ground; // x and z, mm

void main()
{
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    ground = centre + radius * corner;
    gl_Position = toClip * vec4(ground.x, 0.0, ground.y, 1.0);
}
