#version 330 core
layout(location = 0) in vec2 corner; // pixels from the upper left
uniform vec2 size;

void main()
{
    vec2 share = corner / size;
    gl_Position = vec4(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y, 0.0, 1.0);
}
