/* SPDX-License-Identifier: MIT */
/** @file region.c
 *  The area of a block's liquid on a grid. */
#include "start/region.h"

#include <math.h>
#include <stdlib.h>

#include "scene/liquid.h"
#include "scene/resolve.h"
#include "scene/shape.h"
#include "start/cloud.h"

/* A side that is at most so many cells from a grid line lies on it. */
static const double ON_LINE = 0.02;

/** Point `k` of a cell of size 1: a Hammersley set, with one point in each of 16 x 16 subcells and no two in one row or
 *  column, so that edges of any slope are resolved. */
static sph2d_vec2 point_of(unsigned k)
{
    unsigned reversed = 0;
    for (int bit = 0; bit < 8; ++bit)
        reversed |= (k >> bit & 1) << (7 - bit);
    return (sph2d_vec2){(k + 0.5) / SPH2D__REGION_POINTS, (reversed + 0.5) / SPH2D__REGION_POINTS};
}

bool sph2d__region_contains(const sph2d__region *r, sph2d_vec2 p)
{
    const sph2d_scene *scene = &r->sim->world.scene;
    if (!sph2d__shape_contains(r->shape, p))
        return false;
    if (r->cloud &&
        (sph2d__in_block(&r->sim->world.scene, p) || sph2d__cloud_cover_of(r->cloud, r->sim, p) < r->least_cover))
        return false;
    double length_x = sph2d__period_x(scene), length_y = sph2d__period_y(scene);
    int across = length_x > 0, along = length_y > 0;
    for (int image_x = -across; image_x <= across; ++image_x)
        for (int image_y = -along; image_y <= along; ++image_y) {
            sph2d_vec2 image = {p.x + image_x * length_x, p.y + image_y * length_y};
            sph2d__solid_list near = sph2d__solids_near(&r->sim->solids, image);
            for (size_t k = 0; k < near.count; ++k)
                if (sph2d__wall_fills(scene, &r->sim->world.walls[near.wall[k]], image))
                    return false;
        }
    return true;
}

/* ---- cells ------------------------------------------------------------------------------------------------------- */

enum { UNKNOWN = 255 }; /* in the first quarter of a cell: an edge may cut it */

/** Marks the cells along a segment of an edge: in each row those that it crosses, and their neighbours. */
static void mark_piece(sph2d__region *r, sph2d__segment s)
{
    sph2d_vec2 a = sph2d__region_in_cells(r, s.a), b = sph2d__region_in_cells(r, s.b);
    double first = fmax(floor(fmin(a.y, b.y)) - 1, 0), last = fmin(floor(fmax(a.y, b.y)) + 1, (double)r->ny - 1);
    for (double row = first; row <= last; ++row) {
        double t0 = 0, t1 = 1;
        if (a.y != b.y) { /* the part of it in this row and half a row beside it */
            double low = (row - 0.5 - a.y) / (b.y - a.y), high = (row + 1.5 - a.y) / (b.y - a.y);
            t0 = fmin(fmax(fmin(low, high), 0), 1);
            t1 = fmin(fmax(fmax(low, high), 0), 1);
        }
        double x0 = a.x + t0 * (b.x - a.x), x1 = a.x + t1 * (b.x - a.x);
        double from = fmax(floor(fmin(x0, x1)) - 1, 0), to = fmin(floor(fmax(x0, x1)) + 1, (double)r->nx - 1);
        for (double column = from; column <= to; ++column)
            r->quarters[4 * ((size_t)row * r->nx + (size_t)column)] = UNKNOWN;
    }
}

static void mark_outline(sph2d__region *r, const sph2d_shape *outline, double shift_x, double shift_y)
{
    size_t pieces = sph2d__shape_pieces(outline, r->size);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__shape_piece(outline, r->size, k);
        mark_piece(r, (sph2d__segment){{s.a.x + shift_x, s.a.y + shift_y}, {s.b.x + shift_x, s.b.y + shift_y}});
    }
}

static void mark_edges(sph2d__region *r)
{
    const sph2d_scene *scene = &r->sim->world.scene;
    double length_x = sph2d__period_x(scene), length_y = sph2d__period_y(scene);
    int across = length_x > 0, along = length_y > 0;
    mark_outline(r, r->shape, 0, 0);
    const sph2d__world *world = &r->sim->world;
    for (size_t k = SPH2D__WALL_OBSTACLE; k < world->wall_count; ++k) {
        if (sph2d__shape_is_open(&world->walls[k].shape))
            continue;
        for (int image_x = -across; image_x <= across; ++image_x)
            for (int image_y = -along; image_y <= along; ++image_y)
                mark_outline(r, &world->walls[k].shape, image_x * length_x, image_y * length_y);
    }
}

static void sample_cell(sph2d__region *r, size_t cell)
{
    unsigned char *quarters = r->quarters + 4 * cell;
    quarters[0] = 0;
    for (unsigned k = 0; k < SPH2D__REGION_POINTS; ++k) {
        sph2d_vec2 p = point_of(k);
        sph2d_vec2 at = sph2d__region_position(r, (double)(cell % r->nx) + p.x, (double)(cell / r->nx) + p.y);
        quarters[2 * (p.y > 0.5) + (p.x > 0.5)] += sph2d__region_contains(r, at);
    }
}

/** Cells that no edge cuts are inside or outside like the cell before. */
static void fill_rows(sph2d__region *r)
{
    for (size_t j = 0; j < r->ny; ++j) {
        bool known = false, inside = false;
        for (size_t i = 0; i < r->nx; ++i) {
            size_t cell = j * r->nx + i;
            if (r->quarters[4 * cell] == UNKNOWN) {
                sample_cell(r, cell);
                known = false;
                continue;
            }
            if (!known)
                inside = sph2d__region_contains(r, sph2d__region_position(r, (double)i + 0.5, (double)j + 0.5));
            known = true;
            for (int q = 0; q < 4; ++q)
                r->quarters[4 * cell + (size_t)q] = inside ? SPH2D__QUARTER_POINTS : 0;
        }
    }
}

/** The longest side of a polygon. */
static sph2d__segment longest_side(sph2d_points corners)
{
    sph2d__segment longest = {corners.items[0], corners.items[1]};
    for (size_t k = 1; k < corners.count; ++k) {
        sph2d_vec2 a = corners.items[k], b = corners.items[(k + 1) % corners.count];
        if (hypot(b.x - a.x, b.y - a.y) > (1 + 1e-9) * hypot(longest.b.x - longest.a.x, longest.b.y - longest.a.y))
            longest = (sph2d__segment){a, b};
    }
    return longest;
}

/** Side k of the shape's polygon, in cells from the region's origin; `turned`: with x and y exchanged. */
static sph2d__segment side_in_cells(const sph2d__region *r, size_t k, bool turned)
{
    sph2d_points corners = r->shape->points;
    sph2d_vec2 a = sph2d__region_in_cells(r, corners.items[k]);
    sph2d_vec2 b = sph2d__region_in_cells(r, corners.items[(k + 1) % corners.count]);
    return turned ? (sph2d__segment){{a.y, a.x}, {b.y, b.x}} : (sph2d__segment){a, b};
}

/** Length of a polygon's sides that lie on grid lines through x = `from`; `rows`: y. */
static double length_on_lines(const sph2d__region *r, double from, bool rows)
{
    double length = 0;
    for (size_t k = 0; k < r->shape->points.count; ++k) {
        sph2d__segment s = side_in_cells(r, k, rows);
        double x = s.a.x - from;
        if (fabs(s.b.x - s.a.x) < ON_LINE && fabs(x - floor(x + 0.5)) < ON_LINE)
            length += fabs(s.b.y - s.a.y);
    }
    return length;
}

/** The offset of the columns, or rows, for which most of the polygon's sides lie on grid lines; in cells. */
static double best_offset(const sph2d__region *r, bool rows)
{
    double best = 0, longest = length_on_lines(r, 0, rows);
    for (size_t k = 0; k < r->shape->points.count; ++k) {
        sph2d__segment s = side_in_cells(r, k, rows);
        double length = fabs(s.b.x - s.a.x) < ON_LINE ? length_on_lines(r, s.a.x, rows) : 0;
        if (length > longest * (1 + 1e-9)) {
            longest = length;
            best = s.a.x - floor(s.a.x);
        }
    }
    return best;
}

/** Bounds of the shape, in cells from the region's origin. */
static sph2d_box bounds_in_cells(const sph2d__region *r)
{
    sph2d_box b = sph2d__shape_bounds(r->shape);
    if (r->shape->kind != SPH2D_SHAPE_POLYGON)
        return (sph2d_box){sph2d__region_in_cells(r, b.min), sph2d__region_in_cells(r, b.max)};
    b = (sph2d_box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (size_t k = 0; k < r->shape->points.count; ++k) {
        sph2d_vec2 p = sph2d__region_in_cells(r, r->shape->points.items[k]);
        b = (sph2d_box){{fmin(b.min.x, p.x), fmin(b.min.y, p.y)}, {fmax(b.max.x, p.x), fmax(b.max.y, p.y)}};
    }
    return b;
}

/** Sets the size of a region whose origin and axis are set, with no cells known. False when memory is short. */
static bool set_cells(sph2d__region *region, sph2d_sim *sim, int margin)
{
    sph2d_box b = bounds_in_cells(region);
    double i = floor(b.min.x + 1e-9) - margin, j = floor(b.min.y + 1e-9) - margin;
    region->nx = (size_t)(ceil(b.max.x - 1e-9) + margin - i);
    region->ny = (size_t)(ceil(b.max.y - 1e-9) + margin - j);
    region->origin = sph2d__region_position(region, i, j);
    region->quarters = sph2d__alloc(&sim->memory, region->nx * region->ny, 4);
    return region->quarters;
}

bool sph2d__region_make(sph2d__region *region, sph2d_sim *sim, const sph2d_shape *shape, sph2d_vec2 corner, double size,
                        int margin)
{
    *region = (sph2d__region){.sim = sim, .shape = shape, .axis = {1, 0}, .origin = corner, .size = size};
    if (shape->kind == SPH2D_SHAPE_POLYGON) {
        sph2d__segment side = longest_side(shape->points);
        double length = hypot(side.b.x - side.a.x, side.b.y - side.a.y);
        region->axis = (sph2d_vec2){(side.b.x - side.a.x) / length, (side.b.y - side.a.y) / length};
        region->origin = side.a;
        region->origin = sph2d__region_position(region, best_offset(region, false), best_offset(region, true));
    }
    if (!set_cells(region, sim, margin))
        return false;
    mark_edges(region);
    fill_rows(region);
    return true;
}

/* ---- what a snapshot covers -------------------------------------------------------------------------------------- */

/* Cover from which on a cell is inside the liquid, and the places in each direction at which others are looked at. */
static const double INSIDE = 0.8;
enum { LOOKS = 4 };

static int decreasing(const void *a, const void *b)
{
    double p = *(const double *)a, q = *(const double *)b;
    return (p < q) - (p > q);
}

/** Marks the cells that a surface of the snapshot may cut; lines, too, have liquid on one side only. */
static size_t mark_surface(sph2d__region *r)
{
    const sph2d_scene *scene = &r->sim->world.scene;
    size_t marked = 0;
    mark_edges(r);
    for (size_t i = 0; i < scene->block_count; ++i)
        mark_outline(r, &scene->blocks[i].shape, 0, 0);
    const sph2d__world *world = &r->sim->world;
    for (size_t k = SPH2D__WALL_OBSTACLE; k < world->wall_count; ++k)
        if (sph2d__shape_is_open(&world->walls[k].shape))
            mark_outline(r, &world->walls[k].shape, 0, 0);
    for (size_t cell = 0; cell < r->nx * r->ny; ++cell) {
        sph2d_vec2 p = sph2d__region_position(r, (double)(cell % r->nx) + 0.5, (double)(cell / r->nx) + 0.5);
        double cover = sph2d__cloud_cover(r->cloud, p);
        if (cover > 0 && cover < INSIDE)
            r->quarters[4 * cell] = UNKNOWN;
        marked += r->quarters[4 * cell] == UNKNOWN;
    }
    return marked;
}

/** The cover of the liquid's places in cell `cell`, of LOOKS x LOOKS; returns their number. */
static size_t look_at(sph2d__region *r, size_t cell, double *covers)
{
    size_t count = 0;
    for (int k = 0; k < LOOKS * LOOKS; ++k) {
        double x = (k % LOOKS + 0.5) / LOOKS, y = (k / LOOKS + 0.5) / LOOKS;
        sph2d_vec2 p = sph2d__region_position(r, (double)(cell % r->nx) + x, (double)(cell / r->nx) + y);
        covers[count] = sph2d__region_contains(r, p) ? sph2d__cloud_cover(r->cloud, p) : 0;
        count += covers[count] > 0;
    }
    return count;
}

/** Finds the cover beyond which lies the area of so many cells. False when memory is short. */
static bool find_least_cover(sph2d__region *r, sph2d__memory *memory, size_t marked, double cells)
{
    size_t count = 0, size = marked * LOOKS * LOOKS + 1;
    double inside = 0;
    void *block = sph2d__alloc(memory, size, sizeof(double));
    double *covers = block;
    if (!covers)
        return false;
    for (size_t cell = 0; cell < r->nx * r->ny; ++cell) {
        if (r->quarters[4 * cell] == UNKNOWN)
            count += look_at(r, cell, covers + count);
        else
            inside += sph2d__region_contains(
                r, sph2d__region_position(r, (double)(cell % r->nx) + 0.5, (double)(cell / r->nx) + 0.5));
    }
    qsort(covers, count, sizeof *covers, decreasing);
    double wanted = fmax(floor((cells - inside) * LOOKS * LOOKS + 0.5), 1);
    if (count > 0)
        r->least_cover = covers[(size_t)fmin(wanted, (double)count) - 1];
    sph2d__release(memory, &block, size, sizeof(double));
    return true;
}

bool sph2d__region_make_covered(sph2d__region *region, sph2d_sim *sim, const sph2d_shape *shape,
                                const sph2d__cloud *cloud, sph2d_vec2 corner, double size, int margin, double cells)
{
    *region =
        (sph2d__region){.sim = sim, .shape = shape, .cloud = cloud, .axis = {1, 0}, .origin = corner, .size = size};
    region->least_cover = SPH2D__LEAST_COVER;
    if (!set_cells(region, sim, margin))
        return false;
    size_t marked = mark_surface(region);
    bool ok = find_least_cover(region, &sim->memory, marked, cells);
    if (ok)
        fill_rows(region);
    else
        sph2d__region_free(region, &sim->memory);
    return ok;
}

void sph2d__region_free(sph2d__region *region, sph2d__memory *memory)
{
    void *block = region->quarters;
    sph2d__release(memory, &block, region->nx * region->ny, 4);
    region->quarters = NULL;
}

double sph2d__region_area(const sph2d__region *r)
{
    double points = 0; /* an integer, exact */
    for (size_t cell = 0; cell < r->nx * r->ny; ++cell)
        points += sph2d__region_covered(r, cell);
    return points / SPH2D__REGION_POINTS * r->size * r->size;
}

/** The covered point of a cell that is nearest to a position. */
static sph2d_vec2 nearest_covered(const sph2d__region *r, size_t cell, sph2d_vec2 to)
{
    sph2d_vec2 nearest = to;
    double least = INFINITY;
    for (unsigned k = 0; k < SPH2D__REGION_POINTS; ++k) {
        sph2d_vec2 p = point_of(k);
        p = sph2d__region_position(r, (double)(cell % r->nx) + p.x, (double)(cell / r->nx) + p.y);
        double distance = hypot(p.x - to.x, p.y - to.y);
        if (distance < least && sph2d__region_contains(r, p)) {
            least = distance;
            nearest = p;
        }
    }
    return nearest;
}

sph2d_vec2 sph2d__region_place(const sph2d__region *r, size_t cell)
{
    double x = 0, y = 0, count = 0, i = (double)(cell % r->nx), j = (double)(cell / r->nx);
    if (sph2d__region_covered(r, cell) == SPH2D__REGION_POINTS)
        return sph2d__region_position(r, i + 0.5, j + 0.5);
    for (unsigned k = 0; k < SPH2D__REGION_POINTS; ++k) {
        sph2d_vec2 p = point_of(k), at = sph2d__region_position(r, i + p.x, j + p.y);
        if (!sph2d__region_contains(r, at))
            continue;
        x += at.x;
        y += at.y;
        ++count;
    }
    sph2d_vec2 centroid = {x / count, y / count};
    return sph2d__region_contains(r, centroid) ? centroid : nearest_covered(r, cell, centroid);
}
