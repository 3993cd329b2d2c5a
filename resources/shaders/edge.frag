#version 330 core
noperspective in float across;
flat in float halfWidth;
uniform vec4 line; // premultiplied
#ifdef LAYER
uniform sampler2D opaqueDepth;
uniform sampler2D layerDepth;
uniform float isFirst;
#endif
out vec4 colour;

void main()
{
    // A line thinner than a pixel is a paler one.
    float cover = clamp(halfWidth + 0.5 - abs(across), 0.0, 1.0) * min(1.0, 2.0 * halfWidth);
#ifdef LAYER
    ivec2 here = ivec2(gl_FragCoord.xy);
    if (cover < 0.004 || gl_FragCoord.z >= texelFetch(opaqueDepth, here, 0).r)
        discard;
    if (isFirst < 0.5 && gl_FragCoord.z <= texelFetch(layerDepth, here, 0).r)
        discard;
    gl_FragDepth = gl_FragCoord.z;
#endif
    colour = line * cover;
}
