#version 330 core
in vec3 viewNormal;
in float wall;
in float height;
uniform vec3 face;
uniform vec3 side;
uniform float alpha;
uniform vec4 hatch;       // colour, not premultiplied; alpha 0: none
uniform float hatchPixel; // drawn pixels a device-independent one
#ifdef LAYER
uniform sampler2D opaqueDepth;
uniform sampler2D layerDepth; // of the layer before this one
uniform float isFirst;        // 1: there is none
uniform float setBack;        // in slopes
#endif
out vec4 colour;

const vec3 light = vec3(-0.46, 0.66, 0.59); // from the upper left, towards the eye

void main()
{
#ifdef LAYER
    // As far back as polygon offset would put it: faces give way to the lines on them.
    float slope = max(abs(dFdx(gl_FragCoord.z)), abs(dFdy(gl_FragCoord.z)));
    float depth = gl_FragCoord.z + min(setBack * slope, 1e-3) + 1e-7;
    ivec2 here = ivec2(gl_FragCoord.xy);
    if (depth >= texelFetch(opaqueDepth, here, 0).r)
        discard;
    if (isFirst < 0.5 && depth <= texelFetch(layerDepth, here, 0).r)
        discard;
    gl_FragDepth = depth;
#endif
    float lit = 0.5 + 0.5 * dot(normalize(viewNormal), light);
    // Near the ground and below it less of the sky is seen.
    float sky = mix(0.94, 1.0, smoothstep(-5.0, 70.0, height));
    vec3 base = wall > 0.5 ? side : face;
    if (hatch.a > 0.0 && wall < 0.5) {
        // 45 degrees, 2 px of 8.
        float across = (gl_FragCoord.x + gl_FragCoord.y) * 0.70710678 / hatchPixel;
        float distance = abs(mod(across, 8.0) - 4.0);
        base = mix(base, hatch.rgb,
                   hatch.a * clamp((1.0 - distance) * hatchPixel + 0.5, 0.0, 1.0));
    }
    colour = vec4(base * mix(0.64, 1.03, lit) * sky, 1.0) * alpha;
}
