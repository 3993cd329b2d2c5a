#version 330 core
// What of the light from above a slab takes: red for what touches the ground nearly (drawn sharper),
// green for all of it (drawn softer).
in vec3 viewNormal;
in float wall;
in float height;
out vec4 colour;

void main()
{
    float above = max(height, 0.0);
    float below = height < -0.1 ? 0.0 : 1.0;
    colour = vec4(exp(-above / 12.0), exp(-above / 150.0), 0.0, 1.0) * below;
}
