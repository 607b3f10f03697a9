#version 330 core
// A tile of the image as a point sprite; those that are of another kind are moved out of sight. The viewport has whole
// tiles, so that all their centres are in it.
uniform sampler2D kinds; // one texel a tile
uniform int kind;
uniform float tile;      // side [px]

void main()
{
    ivec2 size = textureSize(kinds, 0), at = ivec2(gl_VertexID % size.x, gl_VertexID / size.x);
    bool wanted = int(255.0 * texelFetch(kinds, at, 0).r + 0.5) == kind;
    gl_PointSize = tile;
    gl_Position = vec4(wanted ? (vec2(at) + 0.5) / vec2(size) * 2.0 - 1.0 : vec2(2.0), 0.0, 1.0);
}
