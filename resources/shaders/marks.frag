#version 330 core
uniform sampler2D marks; // premultiplied, its first row the uppermost
uniform vec2 size;
out vec4 colour;

void main()
{
    colour = texelFetch(marks, ivec2(int(gl_FragCoord.x), int(size.y - gl_FragCoord.y)), 0);
}
