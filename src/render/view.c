/* SPDX-License-Identifier: MIT */
/** @file view.c
 *  Fits a rectangle of the plane into an image. */
#include "render/view.h"

#include <math.h>

bool sph2d__view_fit(sph2d__view *view, sph2d_box box, unsigned width, unsigned height, unsigned right, unsigned below)
{
    const double box_width = box.max.x - box.min.x, box_height = box.max.y - box.min.y;
    const double scale = fmin((width - right) / box_width, (height - below) / box_height);
    if (!(box_width > 0.0 && box_height > 0.0 && isfinite(box_width) && isfinite(box_height) && isfinite(scale) &&
          scale > 0.0))
        return false; /* NaN fails the comparisons */
    *view = (sph2d__view){.width = width,
                          .height = height,
                          .middle = {0.5 * (width - right), 0.5 * (height - below)},
                          .center = {box.min.x + 0.5 * box_width, box.min.y + 0.5 * box_height},
                          .scale = scale};
    return true;
}

static double to_right(const sph2d__view *view, double x)
{
    return view->middle.x + (x - view->center.x) * view->scale;
}

static double to_down(const sph2d__view *view, double y)
{
    return view->middle.y - (y - view->center.y) * view->scale;
}

sph2d_vec2 sph2d__view_at(const sph2d__view *view, double x, double y)
{
    return (sph2d_vec2){to_right(view, x), to_down(view, y)};
}

sph2d_vec2 sph2d__view_locate(const sph2d__view *view, double right, double down)
{
    return (sph2d_vec2){view->center.x + (right - view->middle.x) / view->scale,
                        view->center.y - (down - view->middle.y) / view->scale};
}

bool sph2d__view_place(const sph2d__view *view, double x, double y, double margin, float pixel[2])
{
    const double right = to_right(view, x), down = to_down(view, y);
    if (!(right > -margin && right < view->width + margin && down > -margin && down < view->height + margin))
        return false; /* NaN too */
    pixel[0] = (float)right;
    pixel[1] = (float)down;
    return true;
}

/* The nearest whole pixel between 0 and size. */
static int nearest(double at, unsigned size)
{
    return (int)lrint(fmin(fmax(at, 0.0), size));
}

sph2d__pixel_box sph2d__view_cover(const sph2d__view *view, sph2d_box box)
{
    const int left = nearest(to_right(view, box.min.x), view->width);
    const int right = nearest(to_right(view, box.max.x), view->width);
    const int top = nearest(to_down(view, box.max.y), view->height);
    const int bottom = nearest(to_down(view, box.min.y), view->height);
    return (sph2d__pixel_box){left, top, right - left, bottom - top};
}
