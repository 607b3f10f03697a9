#version 330 core
// From the summed field of the wide balls to what light follows: how much it rises over two squares to the right and down,
// and its mean, from the four squares around each, in units of the depth of a large body of water.
uniform sampler2D sums; // of two by two squares each
uniform float part;     // 1 over the sum inside a large body
uniform ivec2 last;     // column and row

layout(location = 0) out vec4 depth;

float at(ivec2 square)
{
    square = clamp(square, ivec2(0), last);
    return part * texelFetch(sums, square >> 1, 0)[(square.x & 1) + 2 * (square.y & 1)];
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    float left = at(here - ivec2(1, 0)), right = at(here + ivec2(1, 0));
    float above = at(here - ivec2(0, 1)), below = at(here + ivec2(0, 1));
    depth = vec4(right - left, below - above, 0.25 * (left + right + above + below), 1.0);
}
