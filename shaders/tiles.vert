#version 330 core
// A row of square tiles of the image.
layout(location = 0) in vec2 center; // [px], from the top left
layout(location = 2) in float across; // [tiles]

uniform vec2 image_size; // [px]
uniform float tile;      // side [px]

// two triangles
const vec2 CORNERS[6] = vec2[](vec2(-0.5, -0.5), vec2(0.5, -0.5), vec2(-0.5, 0.5), vec2(-0.5, 0.5), vec2(0.5, -0.5),
                               vec2(0.5, 0.5));

void main()
{
    vec2 corner = CORNERS[gl_VertexID % 6] * vec2(across, 1.0);
    gl_Position = vec4((center + corner * tile) / image_size * 2.0 - 1.0, 0.0, 1.0);
}
