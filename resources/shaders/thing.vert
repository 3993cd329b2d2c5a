#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tone;
uniform mat4 toClip;
uniform vec4 eye; // towards it (w = 0), or where it is (w = 1)
uniform mat3 normalToView;
out vec3 worldNormal;
out vec3 viewNormal;
out vec3 toEye;
out vec4 filling;

void main()
{
    gl_Position = toClip * vec4(position, 1.0);
    worldNormal = normal;
    viewNormal = normalToView * normal;
    toEye = eye.xyz - eye.w * position;
    filling = tone;
}
