#version 330 core
// As glass: clear where it faces the eye, filled where it turns away.
in vec3 worldNormal;
in vec3 viewNormal;
in vec3 toEye;
in vec4 filling;
out vec4 colour;

const vec3 light = vec3(-0.46, 0.66, 0.59); // from the upper left, towards the eye

void main()
{
    float facing = abs(dot(normalize(worldNormal), normalize(toEye)));
    float rim = pow(1.0 - facing, 3.0);
    float lit = 0.5 + 0.5 * dot(normalize(viewNormal), light);
    vec3 base = mix(filling.rgb * mix(0.72, 1.05, lit), filling.rgb * 0.45, rim);
    float alpha = mix(filling.a, 0.75, rim);
    colour = vec4(base, 1.0) * alpha;
}
