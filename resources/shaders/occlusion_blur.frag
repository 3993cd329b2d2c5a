#version 330 core
// The mean over the four cells in a row that share their samples, but not over edges.
in vec2 place;
uniform sampler2D image;
uniform sampler2D depths;
uniform float sameDepth; // difference that is still the same surface
uniform vec2 step;
out vec4 colour;

void main()
{
    float depth = textureLod(depths, place, 0.0).r;
    float sum = 0.0, weights = 0.0;
    for (int i = -2; i <= 2; ++i) {
        vec2 there = place + float(i) * step;
        float away = abs(textureLod(depths, there, 0.0).r - depth);
        // All or nothing: only equal weights make the cells' samples cancel out.
        float weight = (abs(i) == 2 ? 0.5 : 1.0) * (away < sameDepth ? 1.0 : 1e-4);
        sum += weight * textureLod(image, there, 0.0).r;
        weights += weight;
    }
    colour = vec4(sum / weights);
}
