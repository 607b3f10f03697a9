/* SPDX-License-Identifier: MIT */
/** @file streamlines.c
 *  The method of B. Jobard and W. Lefer, Creating evenly-spaced streamlines of arbitrary density, Visualization in
 *  Scientific Computing 1997: each line goes on in both directions until it comes near another one, and the next lines
 *  begin beside it. The velocities are those of a lattice, linear between its nodes. */
#include "render/lines.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "render/canvas.h"

/* Part of the places around a node that particles must have: a straight surface has a half. */
static const double part_for_lines = 0.4;

/* Distances: of lines, in a square view; pixels of one at least; pixels of the lattice's squares at least. */
static const double distances = 40.0, smallest_distance = 6.0, smallest_cell = 3.0;

/* In these distances: how near a line comes to another one before it ends, and how long it is at least; from where on a line
 * is another one to itself, along it; a step; from head to head. */
static const double nearest = 0.5, shortest = 1.5, own = 1.0, step_part = 1.0 / 6.0, head_to_head = 7.0;

/* How far a seed is moved off walls and surfaces. */
static const double most_moved = 0.25;

/* How far beside its beginning a line that went round passes to be joined with it: the liquid hardly changes its volume, so
 * that its lines are closed, but for what velocities at particles lack. */
static const double joined = 0.25;

/* Speeds without lines: of the largest, and of that of arrows, which may be far from it. */
static const double slow = 0.005, slow_for_arrows = 0.001;

/* Length of a head: of the distance of lines, and in units of text at most; its width over that. */
static const double head_part = 0.4, head_units = 5.5, head_wide = 0.75;

enum { MOST_BINS = 100000 };

/* A point of a line, in the list of its bin. */
typedef struct point {
    sph2d_vec2 at; /* [m] */
    double along;  /* the line, from where it began; negative against the stream [m] */
    uint32_t line;
    int32_t next; /* in the bin; -1: none */
} point;

typedef struct tracer {
    const sph2d__view *view;
    const sph2d__cover *walls;
    int columns, rows; /* of the lattice */
    double cell;       /* its step [m] */
    sph2d_vec2 origin;
    double *velocities; /* of its nodes [m/s]; NaN where there is no liquid */
    double slowest;     /* [m/s] */
    double distance, step;
    sph2d_vec2 corner; /* of the first bin; their sides are `distance` long */
    int bins_across, bins_up;
    int32_t *bins; /* the last point of each; -1: none */
    point *points; /* line by line, each from where it began, along the stream and then against it */
    size_t count, capacity;
    uint32_t line; /* the one that is drawn now */
    bool failed;
} tracer;

/* ---- velocity ---------------------------------------------------------------------------------------------------- */

/* The direction of the velocity at a place; false outside the liquid and where it is slow. */
static bool direction_at(const tracer *t, sph2d_vec2 at, sph2d_vec2 *direction)
{
    const double x = (at.x - t->origin.x) / t->cell, y = (at.y - t->origin.y) / t->cell;
    if (!(x >= 0.0 && y >= 0.0 && x < t->columns - 1 && y < t->rows - 1)) /* nor NaN */
        return false;
    const size_t column = (size_t)x, row = (size_t)y, across = (size_t)t->columns;
    const double right = x - (double)column, up = y - (double)row;
    const double *lower = t->velocities + 2 * (row * across + column), *upper = lower + 2 * across;
    double v[2];
    for (int k = 0; k < 2; ++k)
        v[k] = (1.0 - up) * ((1.0 - right) * lower[k] + right * lower[k + 2]) +
               up * ((1.0 - right) * upper[k] + right * upper[k + 2]);
    const double speed = sqrt(v[0] * v[0] + v[1] * v[1]);
    *direction = (sph2d_vec2){v[0] / speed, v[1] / speed};
    return speed > t->slowest && isfinite(speed);
}

static sph2d_vec2 moved(sph2d_vec2 at, double by, sph2d_vec2 direction)
{
    return (sph2d_vec2){at.x + by * direction.x, at.y + by * direction.y};
}

/* Whether no wall is at a place of the image. */
static bool is_clear(const tracer *t, sph2d_vec2 at)
{
    const sph2d_vec2 pixel = sph2d__view_at(t->view, at.x, at.y);
    if (!(pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < t->walls->width && pixel.y < t->walls->height))
        return false;
    return t->walls->pixels[(size_t)pixel.y * (size_t)t->walls->width + (size_t)pixel.x] < 128;
}

/* The place a step further, by the classical Runge-Kutta method; false where the line ends before. */
static bool advance(const tracer *t, sph2d_vec2 from, double step, sph2d_vec2 *to)
{
    sph2d_vec2 k[4];
    if (!direction_at(t, from, &k[0]) || !direction_at(t, moved(from, step / 2, k[0]), &k[1]) ||
        !direction_at(t, moved(from, step / 2, k[1]), &k[2]) || !direction_at(t, moved(from, step, k[2]), &k[3]))
        return false;
    const sph2d_vec2 mean = {(k[0].x + 2 * (k[1].x + k[2].x) + k[3].x) / 6,
                             (k[0].y + 2 * (k[1].y + k[2].y) + k[3].y) / 6};
    const double pixels = ceil(fabs(step) * t->view->scale);
    for (double n = 1; n <= pixels; ++n) /* thin walls, too */
        if (!is_clear(t, moved(from, n / pixels * step, mean)))
            return false;
    *to = moved(from, step, mean);
    return true;
}

/* ---- points in bins ---------------------------------------------------------------------------------------------- */

static int bin_of(double at, double corner, double side, int count)
{
    return (int)fmin(fmax(floor((at - corner) / side), 0.0), count - 1);
}

static int32_t *bin_at(const tracer *t, sph2d_vec2 at)
{
    return t->bins + (size_t)bin_of(at.y, t->corner.y, t->distance, t->bins_up) * (size_t)t->bins_across +
           bin_of(at.x, t->corner.x, t->distance, t->bins_across);
}

static void add_point(tracer *t, sph2d_vec2 at, double along)
{
    if (t->count == t->capacity) {
        const size_t capacity = t->capacity ? 2 * t->capacity : 4096;
        point *grown = capacity < INT32_MAX ? realloc(t->points, capacity * sizeof *grown) : NULL;
        t->failed |= !grown;
        if (!grown)
            return;
        t->points = grown;
        t->capacity = capacity;
    }
    int32_t *bin = bin_at(t, at);
    t->points[t->count] = (point){at, along, t->line, *bin};
    *bin = (int32_t)t->count++;
}

/* Takes the last points away, those from `first` on. */
static void take_back(tracer *t, size_t first)
{
    while (t->count > first) {
        const point *last = &t->points[--t->count];
        *bin_at(t, last->at) = last->next;
    }
}

/* What is nearer to a place than a distance: 0 nothing, 1 the same line, 2 another one. */
enum { NOTHING, ITSELF, ANOTHER };

static int find_near(const tracer *t, sph2d_vec2 at, double distance, double along)
{
    const int column = bin_of(at.x, t->corner.x, t->distance, t->bins_across);
    const int row = bin_of(at.y, t->corner.y, t->distance, t->bins_up);
    int found = NOTHING;
    for (int j = row > 0 ? row - 1 : 0; j <= row + 1 && j < t->bins_up; ++j)
        for (int i = column > 0 ? column - 1 : 0; i <= column + 1 && i < t->bins_across; ++i)
            /* NOLINTBEGIN(clang-analyzer-core.*): bins hold -1, or a point there is */
            for (int32_t k = t->bins[(size_t)j * (size_t)t->bins_across + (size_t)i]; k >= 0; k = t->points[k].next) {
                const point *p = &t->points[k];
                const double right = p->at.x - at.x, up = p->at.y - at.y;
                if (!(right * right + up * up < distance * distance))
                    continue;
                if (p->line != t->line)
                    return ANOTHER;
                if (fabs(p->along - along) > own * t->distance)
                    found = ITSELF;
            }
    /* NOLINTEND(clang-analyzer-core.*) */
    return found;
}

/* ---- lines ------------------------------------------------------------------------------------------------------- */

/* Whether a place is before one that moves, near it. */
static bool is_before(sph2d_vec2 place, sph2d_vec2 from, sph2d_vec2 to, double within)
{
    const double x = place.x - to.x, y = place.y - to.y;
    return x * (to.x - from.x) + y * (to.y - from.y) > 0.0 && hypot(x, y) < within;
}

/* The way to a place from a straight line. */
static sph2d_vec2 aside(sph2d_vec2 place, sph2d_vec2 from, sph2d_vec2 to)
{
    const double x = to.x - from.x, y = to.y - from.y;
    const double by = ((place.x - from.x) * y - (place.y - from.y) * x) / (x * x + y * y);
    return (sph2d_vec2){by * y, -by * x};
}

/* Joins a line, its points from `first` on, with its beginning by moving each in proportion to the way from there. */
static void join(tracer *t, size_t first, sph2d_vec2 seed, sph2d_vec2 by, double length)
{
    const size_t end = t->count;
    take_back(t, first);
    for (size_t k = first; k < end; ++k) { /* they are still there */
        const point p = t->points[k];
        add_point(t, moved(p.at, p.along / length, by), p.along);
    }
    add_point(t, seed, length);
}

/* Follows the stream, or with a negative step goes against it, from a seed on. A line that comes near itself ends, unless
 * it went round and meets its beginning. Returns whether it does. */
static bool follow(tracer *t, sph2d_vec2 seed, double step)
{
    const double test = nearest * t->distance;
    const size_t first = t->count;
    size_t closing = 0; /* the number of points from which on it may do so; 0: not yet */
    sph2d_vec2 at = seed, next;
    for (double along = step; !t->failed && advance(t, at, step, &next); along += step) {
        const int near = find_near(t, next, test, along);
        const bool before = is_before(seed, at, next, 2 * test);
        const sph2d_vec2 by = aside(seed, at, next);
        if (closing > 0 && near != ANOTHER && !before && hypot(by.x, by.y) < joined * t->distance) {
            join(t, first, seed, by, along);
            return true;
        }
        if (near == ANOTHER || (near == ITSELF && !before))
            break;
        if (near == ITSELF && closing == 0)
            closing = t->count;
        add_point(t, next, along);
        at = next;
    }
    if (closing > 0)
        take_back(t, closing);
    return false;
}

/* How much liquid is on one side of a place, up to twice as much as a seed is moved. */
static double room_beside(const tracer *t, sph2d_vec2 at, sph2d_vec2 side)
{
    enum { PARTS = 4 };
    const double part = 2.0 * most_moved * t->distance / PARTS;
    sph2d_vec2 direction;
    int k = 0;
    while (k < PARTS && direction_at(t, moved(at, (k + 1) * part, side), &direction) &&
           is_clear(t, moved(at, (k + 1) * part, side)))
        ++k;
    return k * part;
}

/* Draws a line through a place that is far enough from all others, moved off walls and surfaces and into the middle of
 * thin jets; false if it were too short. */
static bool draw_line(tracer *t, sph2d_vec2 seed)
{
    sph2d_vec2 direction;
    if (find_near(t, seed, (0.99 - most_moved) * t->distance, 0.0) != NOTHING || !is_clear(t, seed) ||
        !direction_at(t, seed, &direction))
        return false;
    const sph2d_vec2 left = {-direction.y, direction.x}, right = {direction.y, -direction.x};
    const double on_left = room_beside(t, seed, left), on_right = room_beside(t, seed, right);
    if (on_left + on_right < most_moved * t->distance) /* of creeping liquid at a wall the fit is not sure */
        return false;
    seed = moved(seed, 0.5 * (on_left - on_right), left);
    if (find_near(t, seed, 0.99 * t->distance, 0.0) != NOTHING)
        return false;
    const size_t first = t->count;
    add_point(t, seed, 0.0);
    if (!follow(t, seed, t->step))
        follow(t, seed, -t->step);
    if ((double)(t->count - first) * t->step < shortest * t->distance) {
        take_back(t, first);
        return false;
    }
    ++t->line;
    return true;
}

/* Draws the lines beside those from point `from` on, and beside these, until there is no room. */
static void draw_beside(tracer *t, size_t from)
{
    for (size_t k = from; k < t->count && !t->failed; ++k) {
        const sph2d_vec2 at = t->points[k].at;
        sph2d_vec2 direction;
        for (int side = -1; side <= 1 && direction_at(t, at, &direction); side += 2)
            draw_line(t,
                      (sph2d_vec2){at.x - side * t->distance * direction.y, at.y + side * t->distance * direction.x});
    }
}

/* All lines: from the middle of each bin that is still empty. */
static void draw_all(tracer *t)
{
    for (int row = 0; row < t->bins_up; ++row)
        for (int column = 0; column < t->bins_across && !t->failed; ++column) {
            const size_t from = t->count;
            if (draw_line(t, (sph2d_vec2){t->corner.x + (column + 0.5) * t->distance,
                                          t->corner.y + (row + 0.5) * t->distance}))
                draw_beside(t, from);
        }
}

/* ---- setup ------------------------------------------------------------------------------------------------------- */

/* Takes the velocities of the lattice; false when memory is short. */
static bool take_velocities(tracer *t, const sph2d__sampled *s, const sph2d_picture *p)
{
    t->columns = s->columns;
    t->rows = s->rows;
    t->cell = s->step;
    t->origin = s->origin;
    t->velocities = malloc(((size_t)s->columns * (size_t)s->rows + 1) * 2 * sizeof *t->velocities);
    if (!t->velocities)
        return false;
    double largest = 0.0;
    for (int row = 0; row < s->rows; ++row)
        for (int column = 0; column < s->columns; ++column) {
            double *v = t->velocities + 2 * ((size_t)row * (size_t)s->columns + (size_t)column);
            v[0] = v[1] = NAN;
            if (sph2d__sampled_at(s, column, row, part_for_lines, v))
                largest = fmax(largest, hypot(v[0], v[1]));
        }
    t->slowest = fmax(slow * largest, slow_for_arrows * p->arrow_speed);
    return true;
}

/* Lays the bins over a box; false when memory is short. */
static bool lay_bins(tracer *t, sph2d_box box, double wanted)
{
    const double wide = box.max.x - box.min.x, high = box.max.y - box.min.y;
    t->distance = fmin(fmax(wanted, sqrt(wide * high / MOST_BINS)), fmax(wide, high));
    t->step = fmin(step_part * t->distance, 2.0 * t->cell);
    t->bins_across = (int)fmax(ceil(wide / t->distance), 1.0);
    t->bins_up = (int)fmax(ceil(high / t->distance), 1.0);
    t->corner = box.min;
    const size_t count = (size_t)t->bins_across * (size_t)t->bins_up;
    t->bins = malloc(count * sizeof *t->bins);
    for (size_t k = 0; k < count && t->bins; ++k)
        t->bins[k] = -1;
    return t->bins;
}

/* ---- pieces ------------------------------------------------------------------------------------------------------ */

/* Adds a head whose middle is at point k, of the length in pixels. */
static void add_head(sph2d__lines *lines, const tracer *t, const point *at, double length)
{
    sph2d_vec2 direction;
    if (!direction_at(t, at->at, &direction))
        return;
    const sph2d_vec2 middle = sph2d__view_at(t->view, at->at.x, at->at.y);
    const sph2d_vec2 half = {0.5 * length * direction.x, -0.5 * length * direction.y};
    sph2d__lines_add(lines, &(sph2d__piece){.from = {middle.x - half.x, middle.y - half.y},
                                            .to = {middle.x + half.x, middle.y + half.y},
                                            .wider = head_wide * length});
}

/* Adds one line, its points `from` to `to` - 1. */
static void add_line(sph2d__lines *lines, const tracer *t, size_t from, size_t to)
{
    const sph2d_vec2 seed = sph2d__view_at(t->view, t->points[from].at.x, t->points[from].at.y);
    sph2d_vec2 last = seed;
    size_t turn = from + 1; /* where those against the stream begin */
    for (size_t k = from + 1; k < to; ++k) {
        const sph2d_vec2 at = sph2d__view_at(t->view, t->points[k].at.x, t->points[k].at.y);
        const bool turned = t->points[k].along < 0.0 && t->points[k - 1].along >= 0.0;
        sph2d__lines_add(lines, &(sph2d__piece){.from = turned ? seed : last, .to = at, .has_next = true});
        turn += t->points[k].along > 0.0;
        last = at;
    }
    const double unit = sph2d__canvas_unit((int)t->view->width, (int)t->view->height);
    const double length = fmin(head_part * t->distance * t->view->scale, head_units * unit);
    const size_t count = to - from;
    const size_t heads = (size_t)fmax(1.0, round((double)count * t->step / (head_to_head * t->distance)));
    for (size_t k = 0; k < heads; ++k) { /* evenly from the upper end to the lower */
        const size_t n = (size_t)(((double)k + 0.5) / (double)heads * (double)count), against = to - turn;
        add_head(lines, t, &t->points[n < against ? to - 1 - n : from + n - against], length);
    }
}

void sph2d__streamlines_find(sph2d__lines *lines, const sph2d__view *view, const sph2d_picture *p,
                             const sph2d__cover *walls)
{
    const sph2d_box box = sph2d__lines_box(view);
    const double side = sqrt((p->view.max.x - p->view.min.x) * (p->view.max.y - p->view.min.y));
    const double wanted = p->streamline_spacing > 0.0 ? p->streamline_spacing : side / distances;
    const sph2d__samples samples = {p->count, p->x, p->y, p->stream_vx, p->stream_vy, p->spacing};
    tracer t = {.view = view, .walls = walls};
    t.failed = !sph2d__sampled_take(&lines->sampled, box, fmax(p->spacing, smallest_cell / view->scale), &samples) ||
               !take_velocities(&t, &lines->sampled, p) ||
               !lay_bins(&t, box, fmax(wanted, smallest_distance / view->scale));
    if (!t.failed)
        draw_all(&t);
    for (size_t from = 0, to; from < t.count && !t.failed; from = to) {
        for (to = from + 1; to < t.count && t.points[to].line == t.points[from].line; ++to)
            continue;
        add_line(lines, &t, from, to);
    }
    lines->failed |= t.failed;
    free(t.velocities);
    free(t.bins);
    free(t.points);
}
