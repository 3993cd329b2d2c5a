#version 330 core
in vec2 place;
uniform sampler2D image;
uniform vec2 sharp; // step between taps in texture coordinates: red
uniform vec2 soft;  // and green
out vec4 colour;

void main()
{
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int i = -6; i <= 6; ++i) {
        float weight = exp(-float(i * i) / 14.0);
        sum.r += weight * texture(image, place + float(i) * sharp).r;
        sum.g += weight * texture(image, place + float(i) * soft).g;
        weights += weight;
    }
    colour = vec4(sum / weights, 0.0, 1.0);
}
