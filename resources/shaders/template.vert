#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 toWorld;
uniform mat4 toClip;
uniform mat3 normalToWorld;
uniform mat3 normalToView;
uniform vec4 eye; // towards it (w = 0), or where it is (w = 1)
out vec3 worldNormal;
out vec3 viewNormal;
out vec3 toEye;

void main()
{
    vec4 world = toWorld * vec4(position, 1.0);
    gl_Position = toClip * world;
    worldNormal = normalToWorld * normal;
    viewNormal = normalToView * worldNormal;
    toEye = eye.xyz - eye.w * world.xyz;
}
