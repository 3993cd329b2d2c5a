#version 330 core
in vec2 place;
uniform sampler2D image;
uniform vec2 direction;
uniform vec4 spread; // of red, green, blue and alpha: step between taps in texture coordinates
out vec4 colour;

/// Steps of several pixels are taken over what lies between them.
float tap(float spread, int i, vec4 channel)
{
    float pixels = spread * float(textureSize(image, 0).x);
    return dot(channel, textureLod(image, place + float(i) * spread * direction,
                                   max(log2(max(pixels, 1e-6)), 0.0)));
}

void main()
{
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int i = -4; i <= 4; ++i) {
        float weight = exp(-float(i * i) / 7.0);
        sum.r += weight * tap(spread.r, i, vec4(1.0, 0.0, 0.0, 0.0));
        sum.g += weight * tap(spread.g, i, vec4(0.0, 1.0, 0.0, 0.0));
        sum.b += weight * tap(spread.b, i, vec4(0.0, 0.0, 1.0, 0.0));
        sum.a += weight * tap(spread.a, i, vec4(0.0, 0.0, 0.0, 1.0));
        weights += weight;
    }
    colour = sum / weights;
}
