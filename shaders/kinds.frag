#version 330 core
// What is in a tile of 2 x 2 cells: nothing to draw (0), something (1), or a field that is full and even in it and around
// it (2), as target.h counts them.
uniform sampler2D limits; // of the field in cells: the least, the greatest
uniform float lowest;     // a tile is not empty if the field is as large somewhere
uniform float full;       // it is inside if the field is as large everywhere ...
uniform float range;      // ... and between its limits so far ...
uniform int around;       // ... in the tile and so many cells around it

layout(location = 0) out vec4 kind;

void main()
{
    ivec2 first = 2 * ivec2(gl_FragCoord.xy), last = textureSize(limits, 0) - 1;
    float low = 1.0e9, high = 0.0, own = 0.0;
    for (int y = -around; y < 2 + around; ++y)
        for (int x = -around; x < 2 + around; ++x) {
            vec2 cell = texelFetch(limits, clamp(first + ivec2(x, y), ivec2(0), last), 0).rg;
            low = min(low, cell.x);
            high = max(high, cell.y);
            if (min(x, y) >= 0 && max(x, y) < 2) own = max(own, cell.y);
        }
    bool inside = low >= full && high - low <= range;
    kind = vec4((own < lowest ? 0.0 : inside ? 2.0 : 1.0) / 255.0);
}
