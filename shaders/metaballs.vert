#version 330 core
// A square tile of the image.
layout(location = 0) in vec2 center; // [px], from the top left

uniform vec2 image_size; // [px]
uniform float tile;      // side [px]

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) - 0.5;
    gl_Position = vec4((center + corner * tile) / image_size * 2.0 - 1.0, 0.0, 1.0);
}
