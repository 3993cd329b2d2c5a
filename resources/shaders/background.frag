#version 330 core
in vec2 place;
uniform vec3 top;
uniform vec3 bottom;
out vec4 colour;

void main()
{
    // Half a step of noise keeps the gradient from showing bands on dark displays.
    float noise = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453) - 0.5;
    colour = vec4(mix(bottom, top, place.y) + noise / 255.0, 1.0);
}
