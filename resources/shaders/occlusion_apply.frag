#version 330 core
in vec2 place;
uniform sampler2D image;
uniform float strength;
out vec4 colour;

void main()
{
    colour = vec4(vec3(mix(1.0, texture(image, place).r, strength)), 1.0);
}
