#version 330 core
uniform vec4 line; // premultiplied
out vec4 colour;

void main()
{
    colour = line;
}
