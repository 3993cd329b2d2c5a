#version 330 core
layout(location = 0) in vec3 position; // world, mm
layout(location = 1) in vec2 place;    // in the picture, from its upper left
uniform mat4 toClip;
out vec2 at;

void main()
{
    gl_Position = toClip * vec4(position, 1.0);
    at = place;
}
