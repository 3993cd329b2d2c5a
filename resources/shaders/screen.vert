#version 330 core
// One triangle that covers the screen, at the far end of the depths; place runs from (0, 0) at the
// lower left to (1, 1).
out vec2 place;

void main()
{
    vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
    place = 0.5 * corner + 0.5;
    gl_Position = vec4(corner, 1.0, 1.0);
}
