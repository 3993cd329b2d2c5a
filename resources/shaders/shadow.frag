#version 330 core
// What of the light from above a slab takes, apart by how high it hangs: the higher, the softer its
// shadow will be drawn.
in vec3 viewNormal;
in float wall;
in float height;
uniform float unit; // mm: heights grow with the model
out vec4 colour;

void main()
{
    float h = max(height, 0.0) / unit;
    float below = height < -0.1 ? 0.0 : 1.0;
    vec3 past = smoothstep(vec3(2.0, 12.0, 45.0), vec3(9.0, 38.0, 120.0), vec3(h));
    // Each band takes over from the one below it; together they are one shadow.
    colour = vec4(1.0 - past.x, past.x * (1.0 - past.y), past.y * (1.0 - past.z), past.z) * below;
}
