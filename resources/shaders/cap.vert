#version 330 core
// The face of a cut, in the world.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 tone;
uniform mat4 toClip;
flat out vec3 filling;

void main()
{
    gl_Position = toClip * vec4(position, 1.0);
    filling = tone;
}
