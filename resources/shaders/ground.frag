#version 330 core
in vec2 ground;
uniform vec2 centre;
uniform float radius;
uniform float spacing; // of the fine lines, mm; every fifth is a strong one
uniform float lineWidth; // device pixels
uniform vec3 fine;
uniform vec3 strong;
uniform sampler2D shadow;
uniform vec4 shadowBox; // x, z of its corner, and size in mm
uniform vec4 shadowColour; // not premultiplied
out vec4 colour;

float lines(float step)
{
    vec2 perPixel = vec2(length(vec2(dFdx(ground.x), dFdy(ground.x))),
                         length(vec2(dFdx(ground.y), dFdy(ground.y))));
    vec2 distance = abs(fract(ground / step + 0.5) - 0.5) * step / max(perPixel, vec2(1e-9));
    vec2 cover = clamp(0.5 * lineWidth + 0.5 - distance, 0.0, 1.0);
    // Where lines come closer than a few pixels they would become a tone of their own: let them go.
    cover *= smoothstep(3.0, 9.0, step / max(perPixel, vec2(1e-9)));
    return max(cover.x, cover.y);
}

void main()
{
    float fade = 1.0 - smoothstep(0.08, 0.92, length(ground - centre) / radius);
    float fineCover = lines(spacing) * 0.62 * fade;
    float strongCover = lines(5.0 * spacing) * 0.72 * fade;
    vec2 place = (ground - shadowBox.xy) / shadowBox.zw;
    vec4 taken = all(greaterThan(place, vec2(0.0))) && all(lessThan(place, vec2(1.0)))
                     ? texture(shadow, place) : vec4(0.0);
    // Plates on edge take little light each, but from many directions; most where they stand on the
    // ground, or they would seem to hang.
    float dark = shadowColour.a * (1.0 - exp(-dot(taken, vec4(4.2, 2.6, 3.2, 3.6))));

    colour = vec4(fine, 1.0) * fineCover;
    colour = vec4(strong, 1.0) * strongCover + colour * (1.0 - strongCover);
    colour = vec4(shadowColour.rgb, 1.0) * dark + colour * (1.0 - dark);
}
