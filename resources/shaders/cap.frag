#version 330 core
flat in vec3 filling;
out vec4 colour;

void main()
{
    colour = vec4(filling, 1.0);
}
