#version 330 core
// As clay that one sees through: clear where it faces the eye, denser where it turns away, so that
// its outline never vanishes.
in vec3 worldNormal;
in vec3 viewNormal;
in vec3 toEye;
uniform vec3 dark;
uniform vec3 bright;
uniform float opacity;
out vec4 colour;

const vec3 light = vec3(-0.46, 0.66, 0.59); // from the upper left, towards the eye
const float rimAlpha = 0.46;

void main()
{
    // Faces without area have no normal: they are seen as if they faced the eye.
    float size = length(worldNormal);
    vec3 normal = size > 0.0 ? worldNormal / size : normalize(toEye);
    float facing = clamp(dot(normal, normalize(toEye)), 0.0, 1.0);
    float rim = pow(1.0 - facing, 2.5);
    float lit = size > 0.0 ? 0.5 + 0.5 * dot(viewNormal / size, light) : 0.5;
    float alpha = min(1.0, opacity + rimAlpha * rim * (1.0 - opacity));
    colour = vec4(mix(dark, bright, lit * (1.0 - 0.5 * rim)), 1.0) * alpha;
}
