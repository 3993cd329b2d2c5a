#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal; // w: 1 on a side wall
uniform mat4 toClip;
uniform mat3 normalToView;
uniform vec4 heightRow; // gives the height over the ground, mm
uniform vec4 cutRow;    // gives the height over the plane that cuts the view open, mm
out vec3 viewNormal;
out float wall;
out float height;

void main()
{
    gl_Position = toClip * vec4(position, 1.0);
    gl_ClipDistance[0] = -dot(cutRow, vec4(position, 1.0));
    viewNormal = normalToView * normal.xyz;
    wall = normal.w;
    height = dot(heightRow, vec4(position, 1.0));
}
