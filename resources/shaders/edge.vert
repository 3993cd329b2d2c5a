#version 330 core
// One edge an instance, widened to a ribbon of pixels: four vertices of a strip.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 normalA; // w: 1 when always drawn, 0 when only as a silhouette
layout(location = 3) in vec4 normalB;
uniform mat4 toClip;
uniform vec3 eye;      // direction towards the eye, in the slab's own axes
uniform vec2 viewport; // device pixels
uniform float width;   // device pixels
uniform float silhouetteWidth;
uniform float nearer; // towards the eye, in clip units

void main()
{
    bool seenA = dot(normalA.xyz, eye) > 0.0;
    bool seenB = dot(normalB.xyz, eye) > 0.0;
    bool silhouette = seenA != seenB;
    if (!(seenA || seenB) || !(silhouette || normalA.w > 0.5)) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside: not drawn
        return;
    }
    vec4 a = toClip * vec4(from, 1.0);
    vec4 b = toClip * vec4(to, 1.0);
    vec2 along = (b.xy - a.xy) * viewport;
    float length2 = dot(along, along);
    along = length2 > 1e-12 ? along * inversesqrt(length2) : vec2(1.0, 0.0);
    float halfWidth = 0.5 * (silhouette ? silhouetteWidth : width);
    float end = float(gl_VertexID >> 1), turn = float(gl_VertexID & 1) * 2.0 - 1.0;
    // A little over the ends, so that neighbouring edges leave no gap on the outside of a turn.
    vec2 offset = halfWidth * (turn * vec2(-along.y, along.x) + (2.0 * end - 1.0) * 0.5 * along);
    gl_Position = mix(a, b, end);
    gl_Position.xy += 2.0 * offset / viewport;
    gl_Position.z -= nearer;
}
