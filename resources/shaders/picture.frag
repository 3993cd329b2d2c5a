#version 330 core
// A picture that lies in the world, as paper does: the same from both sides.
in vec2 at;
uniform sampler2D image;
uniform float opacity;
out vec4 colour;

void main()
{
    vec4 own = texture(image, at);
    colour = vec4(own.rgb, 1.0) * own.a * opacity;
}
