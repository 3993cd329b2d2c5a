#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal; // w: 1 on a side wall
layout(location = 2) in vec3 by;     // how far it moves, as it really bends; else 0
layout(location = 3) in vec3 turn;   // what comes to its normal then
layout(location = 4) in vec3 turnMore;
uniform mat4 toClip;
uniform mat3 normalToView;
uniform vec4 heightRow; // gives the height over the ground, mm
uniform vec4 cutRow;    // gives the height over the plane that cuts the view open, mm
uniform float times;    // as it really bends
out vec3 viewNormal;
out float wall;
out float height;

void main()
{
    vec4 place = vec4(position + times * by, 1.0);
    gl_Position = toClip * place;
    gl_ClipDistance[0] = -dot(cutRow, place);
    viewNormal = normalToView * (normal.xyz + times * (turn + times * turnMore));
    wall = normal.w;
    height = dot(heightRow, place);
}
