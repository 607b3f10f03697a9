/* SPDX-License-Identifier: MIT */
/** @file lines_find.c
 *  Arrows and isolines as straight pieces; streamlines are in a file of their own. */
#include <math.h>
#include <stdlib.h>

#include "render/legend.h"
#include "render/lines.h"

/* Parts of the places around a node that particles must have: a straight surface has a half. */
static const double part_for_arrows = 0.25, part_for_isolines = 0.4;

/* Arrows: lattice squares along the larger side of a view, and pixels of one at least; its head over its length. */
static const double squares = 32.0, smallest_square = 6.0, head = 0.3;

/* The longest arrow in a caption, over the image's width. */
static const double longest_reference = 0.15;

/* Isolines: pixels of a square of the lattice at least; about so many lines, and at most. */
static const double smallest_cell = 3.0, lines_wanted = 10.0, lines_most = 200.0;

static void add_piece(sph2d__lines *lines, sph2d_vec2 from, sph2d_vec2 to)
{
    sph2d__lines_add(lines, &(sph2d__piece){.from = from, .to = to});
}

/* ---- arrows ------------------------------------------------------------------------------------------------------ */

static double largest_speed(const sph2d_picture *p)
{
    double largest = 0.0;
    for (size_t i = 0; i < p->count; ++i)
        largest = fmax(largest, hypot(p->vx[i], p->vy[i])); /* NaN is left out */
    return isfinite(largest) ? largest : 0.0;
}

/* An arrow whose middle is at a place; y downwards. */
static void add_arrow(sph2d__lines *lines, sph2d_vec2 at, double right, double down)
{
    const sph2d_vec2 tail = {at.x - 0.5 * right, at.y - 0.5 * down}, tip = {at.x + 0.5 * right, at.y + 0.5 * down};
    add_piece(lines, tail, tip);
    add_piece(lines, tip, (sph2d_vec2){tip.x - head * (right + 0.5 * down), tip.y - head * (down - 0.5 * right)});
    add_piece(lines, tip, (sph2d_vec2){tip.x - head * (right - 0.5 * down), tip.y - head * (down + 0.5 * right)});
}

static void find_arrows(sph2d__lines *lines, const sph2d__view *view, const sph2d_picture *p, sph2d__scales *scales)
{
    const double side = fmax(p->view.max.x - p->view.min.x, p->view.max.y - p->view.min.y);
    const double wanted = p->arrow_spacing > 0.0 ? p->arrow_spacing : side / squares;
    const double speed = p->arrow_speed > 0.0 ? p->arrow_speed : largest_speed(p);
    const sph2d__samples samples = {p->count, p->x, p->y, p->vx, p->vy, p->spacing};
    sph2d__sampled *s = &lines->sampled;
    if (!(speed > 0.0))
        return;
    lines->failed |=
        !sph2d__sampled_take(s, sph2d__lines_box(view), fmax(wanted, smallest_square / view->scale), &samples);
    if (lines->failed)
        return;
    const double pixels = 2.0 * s->step * view->scale / speed; /* for 1 m/s */
    for (int row = 0; row < s->rows; ++row)
        for (int column = 0; column < s->columns; ++column) {
            double v[2];
            if (!sph2d__sampled_at(s, column, row, part_for_arrows, v) || pixels * hypot(v[0], v[1]) < 1.0)
                continue;
            const sph2d_vec2 at = sph2d__sampled_place(s, column, row);
            const double fits = fmin(1.0, (view->width + view->height) / (pixels * hypot(v[0], v[1])));
            add_arrow(lines, sph2d__view_at(view, at.x, at.y), fits * pixels * v[0], -fits * pixels * v[1]);
        }
    const double most = longest_reference * view->width / pixels;
    const sph2d__round_number round = sph2d__round_nearest(fmin(0.5 * speed, most));
    scales->arrow_speed = round.factor * pow(10.0, round.exponent);
    scales->arrow_pixels = pixels * scales->arrow_speed;
}

/* ---- paths ------------------------------------------------------------------------------------------------------- */

static void find_paths(sph2d__lines *lines, const sph2d__view *view, const sph2d_picture *p)
{
    const double beyond = view->width + view->height; /* [px] */
    for (size_t k = 1; k < p->path_count; ++k) {
        float from[2], to[2];
        if (p->path_id[k] == p->path_id[k - 1] &&
            sph2d__view_place(view, p->path_x[k - 1], p->path_y[k - 1], beyond, from) &&
            sph2d__view_place(view, p->path_x[k], p->path_y[k], beyond, to))
            add_piece(lines, (sph2d_vec2){from[0], from[1]}, (sph2d_vec2){to[0], to[1]});
    }
}

/* ---- isolines ---------------------------------------------------------------------------------------------------- */

/* A square of the lattice: its corners anticlockwise from the lower left one. */
typedef struct cell {
    sph2d_vec2 corner[4]; /* [px] */
    double value[4];
} cell;

/* Where a level crosses the side from corner k on. */
static sph2d_vec2 crossing(const cell *c, int k, double level)
{
    const int next = (k + 1) % 4;
    const double t = (level - c->value[k]) / (c->value[next] - c->value[k]);
    return (sph2d_vec2){c->corner[k].x + t * (c->corner[next].x - c->corner[k].x),
                        c->corner[k].y + t * (c->corner[next].y - c->corner[k].y)};
}

/* Marching squares: a level crosses two sides, or all four; of the two ways to join these the mean decides. */
static void add_level(sph2d__lines *lines, const cell *c, double level)
{
    sph2d_vec2 at[4];
    int count = 0;
    for (int k = 0; k < 4; ++k)
        if ((c->value[k] >= level) != (c->value[(k + 1) % 4] >= level))
            at[count++] = crossing(c, k, level);
    if (count == 2)
        add_piece(lines, at[0], at[1]);
    if (count < 4)
        return;
    const double mean = 0.25 * (c->value[0] + c->value[1] + c->value[2] + c->value[3]);
    const int first = (mean >= level) == (c->value[0] >= level) ? 0 : 1; /* whether corners 1 and 3 are cut off */
    add_piece(lines, at[first], at[first + 1]);
    add_piece(lines, at[first + 2], at[(first + 3) % 4]);
}

static bool get_cell(const sph2d__sampled *s, const sph2d__view *view, int column, int row, cell *c)
{
    for (int k = 0; k < 4; ++k) {
        const int i = column + (k == 1 || k == 2), j = row + (k >= 2);
        double values[2];
        if (!sph2d__sampled_at(s, i, j, part_for_isolines, values))
            return false;
        const sph2d_vec2 at = sph2d__sampled_place(s, i, j);
        c->corner[k] = sph2d__view_at(view, at.x, at.y);
        c->value[k] = values[0];
    }
    return true;
}

/* The step between lines: the one that is wanted, but not for hundreds of lines; 0 where all is the same. */
static double step_of(const sph2d__sampled *s, double wanted)
{
    double low = HUGE_VAL, high = -HUGE_VAL, values[2];
    for (int row = 0; row < s->rows; ++row)
        for (int column = 0; column < s->columns; ++column)
            if (sph2d__sampled_at(s, column, row, part_for_isolines, values)) {
                low = fmin(low, values[0]);
                high = fmax(high, values[0]);
            }
    const double range = high - low;
    if (!(range > 1.0e-9 * fmax(fabs(low), fabs(high))) || !isfinite(range))
        return 0.0;
    if (wanted > range / lines_most)
        return wanted;
    const sph2d__round_number round = sph2d__round_nearest(range / (wanted > 0.0 ? lines_most : lines_wanted));
    return round.factor * pow(10.0, round.exponent);
}

static void find_isolines(sph2d__lines *lines, const sph2d__view *view, const sph2d_picture *p, sph2d__scales *scales)
{
    const sph2d__samples samples = {p->count, p->x, p->y, p->level_values, NULL, p->spacing};
    sph2d__sampled *s = &lines->sampled;
    lines->failed |=
        !sph2d__sampled_take(s, sph2d__lines_box(view), fmax(p->spacing, smallest_cell / view->scale), &samples);
    const double step = lines->failed ? 0.0 : step_of(s, p->level_step);
    for (int row = 0; row + 1 < s->rows && step > 0.0; ++row)
        for (int column = 0; column + 1 < s->columns; ++column) {
            cell c;
            if (!get_cell(s, view, column, row, &c))
                continue;
            const double low = fmin(fmin(c.value[0], c.value[1]), fmin(c.value[2], c.value[3]));
            const double high = fmax(fmax(c.value[0], c.value[1]), fmax(c.value[2], c.value[3]));
            for (double k = floor(low / step) + 1.0; k * step <= high; k += 1.0)
                add_level(lines, &c, k * step);
        }
    scales->level_step = step;
}

sph2d_status sph2d__lines_find(sph2d__lines *lines, const sph2d__view *view, const sph2d_picture *picture,
                               const sph2d__cover *walls, sph2d__scales *scales, sph2d_report *report)
{
    *scales = (sph2d__scales){0};
    lines->count = 0;
    lines->failed = false;
    if (picture->level_values && picture->count > 0)
        find_isolines(lines, view, picture, scales);
#ifdef SPH2D__SMALL /* a page has no room for streamlines */
    (void)walls;
#else
    if (picture->stream_vx && picture->count > 0 && !lines->failed)
        sph2d__streamlines_find(lines, view, picture, walls);
#endif
    if (picture->vx && picture->count > 0 && !lines->failed)
        find_arrows(lines, view, picture, scales);
    find_paths(lines, view, picture);
    if (!lines->failed)
        return SPH2D_OK;
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for drawing lines");
    return SPH2D_NOMEM;
}
