#version 330 core
in float share;
in vec3 viewNormal;
uniform vec3 palette[5]; // at `first`, evenly on to 1
uniform float first;
uniform float least; // less is not shown: there the section has its own colour
uniform float alpha;
uniform float pixel; // drawn pixels a device-independent one
out vec4 colour;

const vec3 light = vec3(-0.46, 0.66, 0.59); // as on slabs

void main()
{
    float change = max(fwidth(share), 1e-6);
    float cover = clamp((share - least) / change + 0.5, 0.0, 1.0);
    if (cover <= 0.0)
        discard;
    float at = clamp((share - first) / (1.0 - first), 0.0, 1.0) * 4.0;
    int i = min(int(at), 3);
    vec3 tone = mix(palette[i], palette[i + 1], at - float(i));
    // More than all that it bears is hatched, too: not told by the colour alone.
    float across = (gl_FragCoord.x + gl_FragCoord.y) * 0.70710678 / pixel;
    float line = clamp((0.75 - abs(mod(across, 6.0) - 3.0)) * pixel + 0.5, 0.0, 1.0);
    tone = mix(tone, vec3(1.0), 0.7 * line * clamp((share - 1.0) / change + 0.5, 0.0, 1.0));
    // Less of light and shade than a slab has: the colour is to be read.
    float lit = 0.5 + 0.5 * dot(normalize(viewNormal), light);
    colour = vec4(tone * mix(0.84, 1.02, lit), 1.0) * (alpha * cover);
}
