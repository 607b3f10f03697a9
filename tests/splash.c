/* SPDX-License-Identifier: MIT */
/** @file splash.c
 *  The renderers and the water of splash.h. */
#include "splash.h"

#include <stdlib.h>
#include <string.h>

#include "sph2d/render.h" /* by which the build knows what draws */

sph2d_renderer *make_renderer(const char *gl, unsigned width, unsigned height, sph2d_style style)
{
    sph2d_render_options options = sph2d_render_options_default();
    options.gl = gl;
    options.width = width;
    options.height = height;
    options.style = style;
    sph2d_report report = {0};
    sph2d_renderer *renderer = NULL;
    sph2d_status status = sph2d_renderer_create(&options, &renderer, &report);
    if (gl != NULL && status == SPH2D_RENDER && test_report_has(&report, SPH2D_CODE_GL_MISSING, NULL))
        return NULL;
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    ck_assert_ptr_nonnull(renderer);
    return renderer;
}

const unsigned char *draw(sph2d_renderer *renderer, const sph2d_picture *picture)
{
    sph2d_report report = {0};
    ck_assert_msg(sph2d_renderer_draw(renderer, picture, &report) == SPH2D_OK, "%s", test_report_text(&report));
    const unsigned char *pixels = sph2d_renderer_pixels(renderer);
    ck_assert_ptr_nonnull(pixels);
    return pixels;
}

unsigned char *draw_alone(const char *gl, unsigned width, unsigned height, sph2d_style style,
                          const sph2d_picture *picture)
{
    sph2d_renderer *renderer = make_renderer(gl, width, height, style);
    if (renderer == NULL)
        return NULL;
    const size_t size = (size_t)width * height * 4;
    unsigned char *copy = malloc(size);
    ck_assert_ptr_nonnull(copy);
    memcpy(copy, draw(renderer, picture), size);
    sph2d_renderer_destroy(renderer);
    return copy;
}

bool not_forked(void)
{
    const char *mode = getenv("CK_FORK");
    return mode != NULL && strcmp(mode, "no") == 0;
}

splash *make_splash(double offset)
{
    splash *s = calloc(1, sizeof *s);
    ck_assert_ptr_nonnull(s);
    uint64_t seed = 7;
    for (int i = 0; i < FLUID - 1; ++i) {
        const int row = i / SIDE;
        s->x[i] = offset + (i % SIDE + 0.5 + test_random(&seed, -0.3, 0.3)) * spacing;
        s->y[i] = offset + (row + 0.5 + test_random(&seed, -0.3, 0.3)) * spacing;
        s->values[i] = i;
    }
    s->x[FLUID - 1] = offset + 0.8;
    s->y[FLUID - 1] = offset + 0.5;
    s->values[FLUID - 1] = -3.0;
    static const double corners[CORNERS][2] = {{0.7, 0.2}, {0.85, 0.2}, {0.9, 0.1}, {0.95, 0.6}};
    for (uint64_t i = 0; i < CORNERS; ++i) {
        s->wall_x[i] = offset + corners[i][0];
        s->wall_y[i] = offset + corners[i][1];
        s->outline[i] = i / 2;
    }
    s->picture = (sph2d_picture){.view = {{offset, offset}, {offset + 1.28, offset + 0.72}},
                                 .radius = 2.0 * spacing,
                                 .count = FLUID,
                                 .x = s->x,
                                 .y = s->y,
                                 .values = s->values,
                                 .value_label = "speed [m/s]",
                                 .outline_count = CORNERS,
                                 .outline_x = s->wall_x,
                                 .outline_y = s->wall_y,
                                 .outline_id = s->outline,
                                 .outline_liquid = s->liquid,
                                 .wall_thickness = spacing};
    return s;
}

bool is_water(const unsigned char *pixels, unsigned width, unsigned x, unsigned y)
{
    return pixels[4 * ((size_t)y * width + x)] < 160;
}

size_t count_water(const unsigned char *pixels, unsigned width, unsigned height)
{
    size_t count = 0;
    for (unsigned y = 0; y < height; ++y)
        for (unsigned x = 0; x < width; ++x)
            count += is_water(pixels, width, x, y);
    return count;
}
