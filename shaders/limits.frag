#version 330 core
// The least and the greatest field in a cell of 8 x 8 pixels.
uniform sampler2D field; // of two by two pixels each

layout(location = 0) out vec4 limits;

const int CELL = 4; // [texels]

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * CELL, last = textureSize(field, 0) - 1;
    vec4 low = vec4(1.0e9), high = vec4(0.0);
    for (int y = 0; y < CELL; ++y)
        for (int x = 0; x < CELL; ++x) {
            vec4 f = texelFetch(field, min(first + ivec2(x, y), last), 0);
            low = min(low, f);
            high = max(high, f);
        }
    limits = vec4(min(min(low.x, low.y), min(low.z, low.w)), max(max(high.x, high.y), max(high.z, high.w)), 0.0, 1.0);
}
