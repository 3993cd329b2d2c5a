#version 330 core
// How much of the light from all around reaches a point, from the depths about it.
// M. McGuire, B. Osman, M. Bukowski, P. Hennessy 2011, The Alchemy Screen-Space Ambient
// Obscurance Algorithm, equation 10, with the samples on a spiral.
in vec2 place;
uniform sampler2D depths;
uniform mat4 fromClip; // to view space
uniform float radius;  // mm
uniform vec2 reach;    // of the radius at the target, in texture coordinates
uniform float isPerspective;
uniform float eyeDistance; // mm, of the target
out vec4 colour;

const int count = 12;

vec3 at(ivec2 texel)
{
    // Where that depth was taken: half a texel beside it a slanted plane would be a rough one.
    vec2 middle = (vec2(texel) + 0.5) / vec2(textureSize(depths, 0));
    float depth = texelFetch(depths, texel, 0).r;
    vec4 p = fromClip * vec4(2.0 * middle - 1.0, 2.0 * depth - 1.0, 1.0);
    return p.xyz / p.w;
}

vec3 nearerStep(vec3 p, vec3 before, vec3 after)
{
    return abs(after.z - p.z) < abs(p.z - before.z) ? after - p : p - before;
}

void main()
{
    ivec2 size = textureSize(depths, 0), last = size - 1;
    ivec2 here = min(ivec2(place * vec2(size)), last);
    if (texelFetch(depths, here, 0).r >= 1.0) {
        colour = vec4(1.0);
        return;
    }
    vec3 p = at(here);
    vec3 dx = nearerStep(p, at(max(here - ivec2(1, 0), 0)), at(min(here + ivec2(1, 0), last)));
    vec3 dy = nearerStep(p, at(max(here - ivec2(0, 1), 0)), at(min(here + ivec2(0, 1), last)));
    vec3 normal = normalize(cross(dx, dy));

    vec2 spread = reach * (isPerspective > 0.5 ? eyeDistance / max(-p.z, 1e-3) : 1.0);
    ivec2 cell = ivec2(gl_FragCoord.xy) & 3; // the blur takes a mean over as many
    float turn = 6.2831853 * float((cell.x * 4 + cell.y) * 7 % 16) / 16.0;
    float sum = 0.0;
    for (int i = 0; i < count; ++i) {
        float part = (float(i) + 0.5) / float(count);
        float angle = turn + part * 6.2831853 * 5.0;
        vec2 there = place + part * spread * vec2(cos(angle), sin(angle));
        vec3 v = at(clamp(ivec2(there * vec2(size)), ivec2(0), last)) - p;
        float far2 = dot(v, v);
        float above = max(dot(v, normal) - 0.03 * radius, 0.0);
        float fade = max(1.0 - far2 / (radius * radius), 0.0);
        sum += fade * fade * above / (far2 + 0.004 * radius * radius);
    }
    float open = 1.0 - 1.3 * radius * sum / float(count) * 0.32;
    colour = vec4(clamp(open, 0.0, 1.0));
}
