#version 330 core
in vec3 viewNormal;
in float wall;
in float height;
uniform vec3 face;
uniform vec3 side;
uniform float alpha;
out vec4 colour;

const vec3 light = vec3(-0.46, 0.66, 0.59); // from the upper left, towards the eye

void main()
{
    float lit = 0.5 + 0.5 * dot(normalize(viewNormal), light);
    // Near the ground and below it less of the sky is seen.
    float sky = mix(0.93, 1.0, smoothstep(-5.0, 70.0, height));
    vec3 base = wall > 0.5 ? side : face;
    colour = vec4(base * mix(0.66, 1.03, lit) * sky, 1.0) * alpha;
}
