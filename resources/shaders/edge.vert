#version 330 core
// One edge an instance, widened to a ribbon of pixels: four vertices of a strip.
layout(location = 0) in vec3 flatFrom;
layout(location = 1) in vec3 flatTo;
layout(location = 2) in vec4 flatNormalA; // w: 1 when always drawn, 0 when only as a silhouette
layout(location = 3) in vec4 normalB;
layout(location = 4) in vec3 fromBy; // how far both ends move, as it really bends; else 0
layout(location = 5) in vec3 toBy;
layout(location = 6) in vec3 turn; // what comes to the first normal then
layout(location = 7) in vec3 turnMore;
uniform mat4 toClip;
uniform float halfThickness; // mm: of z = 1
uniform vec4 eye;      // towards it (w 0) or where it is (w 1), in the slab's own axes, mm
uniform vec2 viewport; // drawn pixels
uniform float width;   // drawn pixels
uniform float silhouetteWidth;
uniform float nearer;  // towards the eye, mm
uniform float overhang; // of half the width, over both ends
uniform vec4 cutRow;   // gives the height over the plane that cuts the view open, mm
uniform float times;   // as it really bends
noperspective out float across; // drawn pixels from the middle
flat out float halfWidth;

const float nearestW = 1e-4;

void main()
{
    vec3 from = flatFrom + times * fromBy;
    vec3 to = flatTo + times * toBy;
    vec3 normalA = flatNormalA.xyz + times * (turn + times * turnMore);
    vec3 scale = vec3(1.0, 1.0, halfThickness);
    vec3 middle = 0.5 * (from + to) * scale;
    vec3 toEye = normalize(eye.xyz - eye.w * middle);
    bool seenA = dot(normalA, toEye) > 0.0;
    bool seenB = dot(normalB.xyz, toEye) > 0.0;
    bool silhouette = seenA != seenB;
    across = 0.0;
    halfWidth = 0.5 * (silhouette ? silhouetteWidth : width);
    gl_ClipDistance[0] = 1.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside: not drawn
    if (!(seenA || seenB) || !(silhouette || flatNormalA.w > 0.5))
        return;
    vec4 a = toClip * vec4(from, 1.0);
    vec4 b = toClip * vec4(to, 1.0);
    float atA = 0.0, atB = 1.0;
    if (a.w < nearestW && b.w < nearestW)
        return;
    if (a.w < nearestW)
        atA = (nearestW - a.w) / (b.w - a.w);
    if (b.w < nearestW)
        atB = (nearestW - a.w) / (b.w - a.w);
    vec4 start = mix(a, b, atA);
    vec4 stop = mix(a, b, atB);
    vec2 along = (stop.xy / stop.w - start.xy / start.w) * viewport;
    float length2 = dot(along, along);
    along = length2 > 1e-12 ? along * inversesqrt(length2) : vec2(1.0, 0.0);
    float end = float(gl_VertexID >> 1), turn = float(gl_VertexID & 1) * 2.0 - 1.0;
    float reach = halfWidth + 0.5; // the last half pixel fades out
    // A little over the ends, so that neighbouring edges leave no gap on the outside of a turn.
    vec2 offset = reach * turn * vec2(-along.y, along.x) +
                  overhang * halfWidth * (2.0 * end - 1.0) * along;
    vec3 place = mix(from, to, mix(atA, atB, end));
    vec4 at = mix(start, stop, end);
    vec4 before = toClip * vec4(place + nearer * toEye / scale, 1.0);
    gl_Position = at;
    gl_Position.xy += 2.0 * offset / viewport * at.w;
    gl_Position.z = before.z / max(before.w, nearestW) * at.w;
    gl_ClipDistance[0] = 0.02 - dot(cutRow, vec4(place, 1.0));
    across = reach * turn;
}
