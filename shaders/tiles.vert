#version 330 core
// A square tile of the image.
layout(location = 0) in vec2 center; // [px], from the top left

uniform vec2 image_size; // [px]
uniform float tile;      // side [px]

// two triangles
const vec2 CORNERS[6] = vec2[](vec2(-0.5, -0.5), vec2(0.5, -0.5), vec2(-0.5, 0.5), vec2(-0.5, 0.5), vec2(0.5, -0.5),
                               vec2(0.5, 0.5));

void main()
{
    gl_Position = vec4((center + CORNERS[gl_VertexID % 6] * tile) / image_size * 2.0 - 1.0, 0.0, 1.0);
}
