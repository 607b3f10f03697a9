/* SPDX-License-Identifier: MIT */
/** @file packing.c
 *  Places for as many particles as an area holds. One thread: it is done once, and few places move. */
#include "sim/packing.h"

#include <math.h>
#include <string.h>

#include "kernels/kernel.h"

/* Places move that are within so many cells of an edge which passes through cells. */
enum { BAND = 12 };
/* Support radius over spacing: half as much again as the method's between these two, or the method's where that is more.
 * By 2.4 places lie 0.1 to 0.4 % too dense inside, by 3 within 0.15 %; at H/dx = 1.6, where density is what the nearest
 * few make of it, the largest is 4 % too much by 2.4 and 7 % by 3. */
static const double LEAST_SUPPORT = 2.4, FAIR_SUPPORT = 3, WIDER = 1.5;
/* The descent: length of a step for a gradient of 1 over the spacing, the part of the last step that goes on, both in
 * spacings; the farthest step; and when it is done. */
static const double RATE = 0.5, INERTIA = 0.9, FARTHEST = 0.1, DONE = 3e-4;
enum { MOST_ROUNDS = 400 };
/* Neighbours are looked for this much farther than they act, in spacings, and again when one may have come so far. */
static const double SKIN = 0.5;
/* Values of the kernel's slope that are kept, by q^2: between them straight lines are right to 1e-6. */
enum { SLOPES = 2048 };
/* A boundary particle stands for what is nearer to it than this many spacings, on its side of the wall's surface. It may
 * be as near to part of a quarter of a cell whose middle is nearer than that. In quarters so many points are looked at. */
static const double COVERED = 0.72, COVERED_IN_PART = 1.1;
enum { LOOKS = 8 };

/** One packing under way. */
typedef struct packer {
    sph2d_sim *sim;
    sph2d__region *region;
    sph2d_kernel kernel;
    double size, support; /**< spacing; H */
    double slope[SLOPES + 2]; /**< of W over the distance, times the area of a particle, by q^2 SLOPES */
    size_t count, movers;
    sph2d_vec2 *at, *velocity, *gradient, *old; /**< of every place; velocity: the last step */
    uint32_t *mover;                           /**< those that move */
    unsigned char *near_edge;                  /**< cells near which something is missing */
    unsigned char *chosen;                     /**< cells that have a place */
    uint32_t *start, *order;                   /**< buckets of the places: by rows, H + skin wide */
    uint32_t *first, *partner;                 /**< neighbours of each mover */
    size_t partner_capacity;
    size_t bx, by;
    double bucket;
} packer;

static size_t cell_count(const packer *p)
{
    return p->region->nx * p->region->ny;
}

static size_t cell_of(const packer *p, sph2d_vec2 at)
{
    sph2d_vec2 cell = sph2d__region_in_cells(p->region, at);
    double i = fmin(fmax(floor(cell.x), 0), (double)p->region->nx - 1);
    double j = fmin(fmax(floor(cell.y), 0), (double)p->region->ny - 1);
    return (size_t)j * p->region->nx + (size_t)i;
}

/* ---- how many, and where first ----------------------------------------------------------------------------------- */

/** Goes through the cells along a Z curve and chooses the one in which the covered area reaches the next whole particle
 *  and a half: over any part of the area the number of places is right within one or two. */
static void choose(packer *p, size_t i, size_t j, size_t side, long *points)
{
    const sph2d__region *r = p->region;
    if (i >= r->nx || j >= r->ny)
        return;
    if (side > 1) {
        side /= 2;
        for (int k = 0; k < 4; ++k)
            choose(p, i + (k & 1 ? side : 0), j + (k & 2 ? side : 0), side, points);
        return;
    }
    size_t cell = j * r->nx + i;
    long before = (*points + SPH2D__REGION_WHOLE / 2) / SPH2D__REGION_WHOLE;
    *points += sph2d__region_cover(r, cell);
    p->chosen[cell] = (*points + SPH2D__REGION_WHOLE / 2) / SPH2D__REGION_WHOLE > before;
    p->count += p->chosen[cell];
}

/** Spreads marks over a number of cells around them, along rows or columns. */
static void dilate(const packer *p, unsigned char *marks, size_t reach, bool columns)
{
    const sph2d__region *r = p->region;
    size_t lines = columns ? r->nx : r->ny, length = columns ? r->ny : r->nx, step = columns ? r->nx : 1;
    for (size_t line = 0; line < lines; ++line) {
        unsigned char *m = marks + (columns ? line : line * r->nx);
        size_t left = 0; /* cells to mark still, behind a mark */
        for (size_t k = 0; k < length; ++k) {
            left = m[k * step] == 1 ? reach + 1 : left;
            if (left > 0 && --left < reach && m[k * step] == 0)
                m[k * step] = 2;
        }
        left = 0;
        for (size_t k = length; k-- > 0;) {
            left = m[k * step] == 1 ? reach + 1 : left;
            if (left > 0 && --left < reach && m[k * step] == 0)
                m[k * step] = 2;
        }
        for (size_t k = 0; k < length; ++k)
            m[k * step] = m[k * step] != 0;
    }
}

static void dilate_both(const packer *p, unsigned char *marks, size_t reach)
{
    dilate(p, marks, reach, false);
    dilate(p, marks, reach, true);
}

/** Sets the first places, and which of them move. */
static bool set_places(packer *p)
{
    sph2d__memory *memory = &p->sim->memory;
    size_t cells = cell_count(p), n = 0;
    unsigned char *moving = sph2d__alloc(memory, cells, 1);
    if (!moving)
        return false;
    for (size_t cell = 0; cell < cells; ++cell) {
        int cover = sph2d__region_cover(p->region, cell);
        if (p->chosen[cell]) {
            p->at[n] = sph2d__region_middle(p->region, cell);
            moving[cell] = sph2d__sim_taken(p->sim, p->at[n++], 1) != SPH2D__FREE;
        }
        moving[cell] |= cover > 0 && cover < SPH2D__REGION_WHOLE;
    }
    dilate_both(p, moving, BAND);
    for (size_t i = 0; i < p->count; ++i)
        if (moving[cell_of(p, p->at[i])])
            p->mover[p->movers++] = (uint32_t)i;
    void *block = moving;
    sph2d__release(memory, &block, cells, 1);
    return true;
}

/* ---- what fills the rest of the room ----------------------------------------------------------------------------- */

/** Whether a boundary particle is part of layers, and stands for an area. */
static bool has_area(const sph2d__store *walls, size_t j)
{
    return walls->mass && walls->mass[j] > 0 && walls->bounce[j] < 0;
}

/** Whether the way between two places crosses a wall, where the walls are at the start. */
static bool crosses(const sph2d_sim *sim, sph2d_vec2 from, sph2d_vec2 to)
{
    bool crossed = !sph2d__barrier_far(&sim->barrier, from, to) && sph2d__barrier_crosses(&sim->barrier, from, to);
    for (size_t k = 0; k < sim->moving_count && !crossed; ++k) {
        const sph2d__barrier *b = &sim->moving[k].barrier;
        crossed = !sph2d__barrier_far(b, from, to) && sph2d__barrier_crosses(b, from, to);
    }
    return crossed;
}

/** Whether a boundary particle is nearer to a place than a distance; `behind`: and on the same side of all surfaces, as
 *  it is not of a gap between the liquid and a wall. */
static bool is_covered(const sph2d_sim *sim, sph2d_vec2 at, double distance, bool behind)
{
    const sph2d__store *w = &sim->system.walls;
    uint32_t cell = w->count > 0 ? sph2d__cells_find(&sim->system.wall_cells, at.x, at.y) : UINT32_MAX;
    if (cell == UINT32_MAX)
        return false;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&sim->system.wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        sph2d_vec2 image = {at.x + ranges.x[r], at.y + ranges.y[r]}, wall = {w->x[j], w->y[j]};
        if (has_area(w, j) && hypot(image.x - wall.x, image.y - wall.y) < distance * sim->scene.spacing &&
            !(behind && crosses(sim, image, wall)))
            return true;
    }
    return false;
}

static sph2d_vec2 quarter_middle(const packer *p, size_t cell, int q)
{
    const sph2d__region *r = p->region;
    return sph2d__region_place(r, (double)(cell % r->nx) + (q & 1 ? 0.75 : 0.25),
                               (double)(cell / r->nx) + (q & 2 ? 0.75 : 0.25));
}

/** What is missing of a quarter of a cell near boundary particles, in points. */
static int missing_beside_walls(const packer *p, sph2d_vec2 middle, size_t cell, int q)
{
    const sph2d__region *r = p->region;
    bool wet = r->quarters[4 * cell + (size_t)q] > 0;
    int missing = 0;
    for (int k = 0; k < LOOKS * LOOKS; ++k) {
        double x = ((k % LOOKS + 0.5) / LOOKS - 0.5) / 2, y = ((k / LOOKS + 0.5) / LOOKS - 0.5) / 2;
        sph2d_vec2 at = {middle.x + (x * r->axis.x - y * r->axis.y) * r->size,
                         middle.y + (x * r->axis.y + y * r->axis.x) * r->size};
        missing += !(wet && sph2d__region_contains(r, at)) && !is_covered(p->sim, at, COVERED, true);
    }
    return missing * SPH2D__REGION_QUARTER / (LOOKS * LOOKS);
}

/** Turns the cover of each quarter of a cell into what is missing, where no boundary particle stands for it. */
static void turn_to_missing(packer *p)
{
    size_t cells = cell_count(p);
    for (size_t cell = 0; cell < cells; ++cell) {
        unsigned char *quarters = p->region->quarters + 4 * cell;
        for (int q = 0; q < 4; ++q) {
            sph2d_vec2 middle = quarter_middle(p, cell, q);
            int missing = SPH2D__REGION_QUARTER - quarters[q];
            if (missing > 0 && is_covered(p->sim, middle, COVERED_IN_PART, false))
                missing = missing_beside_walls(p, middle, cell, q);
            quarters[q] = (unsigned char)missing;
            p->near_edge[cell] |= quarters[q] > 0;
        }
    }
    dilate_both(p, p->near_edge, (size_t)ceil(p->support / p->size) + 1);
}

/** Adds a part of a particle's area at (x, y) from a place. */
static inline void add_area(const packer *p, double x, double y, double part, sph2d_vec2 *sum)
{
    double s = (x * x + y * y) * (SLOPES / (p->support * p->support));
    if (!(s < SLOPES))
        return;
    size_t k = (size_t)s;
    double g = part * (p->slope[k] + (s - (double)k) * (p->slope[k + 1] - p->slope[k]));
    sum->x += g * x;
    sum->y += g * y;
}

/** What is missing around a place: of each cell one place in the middle of it, so that what is beyond an edge is as
 *  coarse as the liquid. Against quarters, which are nearly an integral, the liquid beside an edge keeps a row's force
 *  less by 1/24 of its slope (the midpoint rule), and ends 0.04 spacings farther in. */
static void add_missing(const packer *p, sph2d_vec2 at, sph2d_vec2 *sum)
{
    const sph2d__region *r = p->region;
    if (!p->near_edge[cell_of(p, at)])
        return;
    double reach = p->support / p->size;
    sph2d_vec2 c = sph2d__region_in_cells(r, at);
    size_t i0 = (size_t)fmax(floor(c.x - reach), 0), i1 = (size_t)fmin(floor(c.x + reach), (double)r->nx - 1);
    size_t j0 = (size_t)fmax(floor(c.y - reach), 0), j1 = (size_t)fmin(floor(c.y + reach), (double)r->ny - 1);
    for (size_t j = j0; j <= j1; ++j)
        for (size_t i = i0; i <= i1; ++i) {
            size_t cell = j * r->nx + i;
            sph2d_vec2 m = {0, 0};
            double missing = 0;
            for (int q = 0; q < 4; ++q) {
                double part = r->quarters[4 * cell + (size_t)q];
                sph2d_vec2 middle = quarter_middle(p, cell, q);
                missing += part;
                m.x += part * middle.x;
                m.y += part * middle.y;
            }
            if (missing > 0)
                add_area(p, at.x - m.x / missing, at.y - m.y / missing, missing / SPH2D__REGION_WHOLE, sum);
        }
}

static void add_walls(const packer *p, sph2d_vec2 at, sph2d_vec2 *sum)
{
    const sph2d__system *s = &p->sim->system;
    const sph2d__store *w = &s->walls;
    uint32_t cell = w->count > 0 ? sph2d__cells_find(&s->wall_cells, at.x, at.y) : UINT32_MAX;
    if (cell == UINT32_MAX)
        return;
    double area = s->rest_density * p->size * p->size;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j)
        if (has_area(w, j))
            add_area(p, at.x + ranges.x[r] - w->x[j], at.y + ranges.y[r] - w->y[j], w->mass[j] / area, sum);
}

/* ---- neighbours -------------------------------------------------------------------------------------------------- */

/** The bucket of a number of cells from the first. */
static size_t bucket_of(const packer *p, double cells, size_t n)
{
    return (size_t)fmin(fmax(floor(cells * p->size / p->bucket), 0), (double)n - 1);
}

/** Sorts the places into buckets, in their order. */
static void fill_buckets(packer *p)
{
    size_t buckets = p->bx * p->by;
    memset(p->start, 0, (buckets + 1) * sizeof *p->start);
    for (int pass = 0; pass < 2; ++pass) {
        for (size_t i = 0; i < p->count; ++i) {
            sph2d_vec2 c = sph2d__region_in_cells(p->region, p->at[i]);
            size_t b = bucket_of(p, c.y, p->by) * p->bx + bucket_of(p, c.x, p->bx);
            if (pass == 0)
                ++p->start[b + 1];
            else
                p->order[p->start[b]++] = (uint32_t)i;
        }
        for (size_t b = 0; b < buckets && pass == 0; ++b)
            p->start[b + 1] += p->start[b];
    }
    memmove(p->start + 1, p->start, buckets * sizeof *p->start);
    p->start[0] = 0;
}

static bool add_partner(packer *p, size_t used, uint32_t j)
{
    if (used == p->partner_capacity) {
        void *block = p->partner;
        size_t grown = 2 * p->partner_capacity + 64 * p->movers;
        if (!sph2d__resize(&p->sim->memory, &block, p->partner_capacity, grown, sizeof *p->partner))
            return false;
        p->partner = block;
        p->partner_capacity = grown;
    }
    p->partner[used] = j;
    return true;
}

/** Finds the neighbours of each mover; false when memory is short. */
static bool find_partners(packer *p)
{
    size_t used = 0;
    fill_buckets(p);
    memcpy(p->old, p->at, p->count * sizeof *p->at);
    for (size_t m = 0; m < p->movers; ++m) {
        size_t i = p->mover[m];
        sph2d_vec2 c = sph2d__region_in_cells(p->region, p->at[i]);
        size_t x = bucket_of(p, c.x, p->bx), y = bucket_of(p, c.y, p->by);
        p->first[m] = (uint32_t)used;
        for (size_t b = y > 0 ? y - 1 : 0; b <= y + 1 && b < p->by; ++b) {
            size_t from = p->start[b * p->bx + (x > 0 ? x - 1 : 0)];
            size_t to = p->start[b * p->bx + (x + 1 < p->bx ? x + 1 : x) + 1];
            for (size_t k = from; k < to; ++k) {
                uint32_t j = p->order[k];
                if (j == i || hypot(p->at[i].x - p->at[j].x, p->at[i].y - p->at[j].y) > p->bucket)
                    continue;
                if (!add_partner(p, used++, j))
                    return false;
            }
        }
    }
    p->first[p->movers] = (uint32_t)used;
    return true;
}

static bool partners_are_old(const packer *p)
{
    for (size_t m = 0; m < p->movers; ++m) {
        size_t i = p->mover[m];
        if (hypot(p->at[i].x - p->old[i].x, p->at[i].y - p->old[i].y) > SKIN / 2 * p->size)
            return true;
    }
    return false;
}

/* ---- the descent ------------------------------------------------------------------------------------------------- */

/** The gradient at each mover. Returns the largest, times the spacing. */
static double take_gradients(packer *p)
{
    double largest = 0;
    for (size_t m = 0; m < p->movers; ++m) {
        size_t i = p->mover[m];
        sph2d_vec2 sum = {0, 0};
        for (uint32_t k = p->first[m]; k < p->first[m + 1]; ++k) {
            sph2d_vec2 other = p->at[p->partner[k]];
            add_area(p, p->at[i].x - other.x, p->at[i].y - other.y, 1, &sum);
        }
        add_walls(p, p->at[i], &sum);
        add_missing(p, p->at[i], &sum);
        p->gradient[i] = sum;
        largest = fmax(largest, hypot(sum.x, sum.y) * p->size);
    }
    return largest;
}

/** Distance to the nearest side of the domain that is a wall of springs; they push what is nearer than half a spacing. */
static double distance_to_springs(const sph2d_sim *sim, sph2d_vec2 at)
{
    const sph2d_boundary b = sim->scene.boundary;
    const sph2d_box d = sim->scene.domain;
    if (sim->scene.walls != SPH2D_WALL_SPRING)
        return INFINITY;
    double left = b.left == SPH2D_SIDE_WALL ? at.x - d.min.x : INFINITY;
    double right = b.right == SPH2D_SIDE_WALL ? d.max.x - at.x : INFINITY;
    double bottom = b.bottom == SPH2D_SIDE_WALL ? at.y - d.min.y : INFINITY;
    double top = b.top == SPH2D_SIDE_WALL ? d.max.y - at.y : INFINITY;
    return fmin(fmin(left, right), fmin(bottom, top));
}

/** Whether a place may be taken: in the area, on its side of every wall, not into springs. */
static bool may_go(const packer *p, sph2d_vec2 from, sph2d_vec2 to)
{
    double apart = distance_to_springs(p->sim, to);
    if (apart < p->size / 2 && apart < distance_to_springs(p->sim, from))
        return false;
    if (p->near_edge[cell_of(p, to)] && !sph2d__region_contains(p->region, to))
        return false;
    return !crosses(p->sim, from, to);
}

/** Moves all down their gradients. Inertia is lost where it leads up. */
static void descend(packer *p)
{
    double downhill = 0;
    for (size_t m = 0; m < p->movers; ++m) {
        size_t i = p->mover[m];
        downhill -= p->velocity[i].x * p->gradient[i].x + p->velocity[i].y * p->gradient[i].y;
    }
    double keep = downhill < 0 ? 0 : INERTIA;
    for (size_t m = 0; m < p->movers; ++m) {
        size_t i = p->mover[m];
        double x = keep * p->velocity[i].x - RATE * p->size * p->size * p->gradient[i].x;
        double y = keep * p->velocity[i].y - RATE * p->size * p->size * p->gradient[i].y;
        double shorten = fmin(FARTHEST * p->size / fmax(hypot(x, y), 1e-300), 1);
        sph2d_vec2 to = {p->at[i].x + shorten * x, p->at[i].y + shorten * y};
        bool goes = may_go(p, p->at[i], to);
        p->velocity[i] = goes ? (sph2d_vec2){shorten * x, shorten * y} : (sph2d_vec2){0, 0};
        p->at[i] = goes ? to : p->at[i];
    }
}

static bool relax(packer *p, double *residual)
{
    *residual = 0;
    if (p->movers == 0)
        return true;
    for (int round = 0; round < MOST_ROUNDS; ++round) {
        if ((round == 0 || partners_are_old(p)) && !find_partners(p))
            return false;
        *residual = take_gradients(p);
        if (*residual < DONE)
            break;
        descend(p);
    }
    return true;
}

/* ---- all of it --------------------------------------------------------------------------------------------------- */

/** The kernel that places are packed by: the method's, or Wendland's kernel of about the same standard deviation where
 *  that is a spline. The Fourier transforms of splines are negative somewhere, so that sum W_ij is least where particles
 *  lie in pairs (Dehnen & Aly 2012): by the cubic spline at H = 3.9 dx they came within 1e-6 dx of each other. */
static sph2d_kernel packing_kernel(sph2d_kernel kernel)
{
    if (kernel == SPH2D_KERNEL_CUBIC)
        return SPH2D_KERNEL_WENDLAND_C2;
    return kernel == SPH2D_KERNEL_QUINTIC ? SPH2D_KERNEL_WENDLAND_C4 : kernel;
}

static packer packer_of(sph2d_sim *sim, sph2d__region *region)
{
    packer p = {.sim = sim, .region = region, .kernel = packing_kernel(sim->system.method.kernel), .size = region->size};
    double own = sim->system.support / sim->system.spacing;
    p.support = fmax(own, fmin(fmax(WIDER * own, LEAST_SUPPORT), FAIR_SUPPORT)) * p.size;
    double h2 = p.support * p.support;
    for (int k = 0; k <= SLOPES; ++k)
        p.slope[k] = p.size * p.size * sph2d__kernel_constant(p.kernel) / (h2 * h2) *
                     sph2d__kernel_slope_at(p.kernel, sqrt((double)k / SLOPES));
    p.bucket = p.support + SKIN * p.size;
    p.bx = (size_t)ceil((double)region->nx * p.size / p.bucket) + 1;
    p.by = (size_t)ceil((double)region->ny * p.size / p.bucket) + 1;
    return p;
}

static size_t room_for(const sph2d__region *region)
{
    size_t side = 1;
    while (side < region->nx || side < region->ny)
        side *= 2;
    return side;
}

bool sph2d__pack(sph2d_sim *sim, sph2d__region *region, sph2d__packing *packing)
{
    sph2d__memory *memory = &sim->memory;
    packer p = packer_of(sim, region);
    size_t cells = cell_count(&p), buckets = p.bx * p.by + 1;
    *packing = (sph2d__packing){0};
    void *marks[2] = {sph2d__alloc(memory, cells, 1), sph2d__alloc(memory, cells, 1)};
    p.chosen = marks[0];
    p.near_edge = marks[1];
    long points = 0;
    if (p.chosen)
        choose(&p, 0, 0, room_for(region), &points);
    const size_t n = p.count;
    void *vectors[4], *numbers[3], *start = sph2d__alloc(memory, buckets, sizeof *p.start);
    for (int k = 0; k < 4; ++k)
        vectors[k] = sph2d__alloc(memory, n + 1, sizeof(sph2d_vec2));
    for (int k = 0; k < 3; ++k)
        numbers[k] = sph2d__alloc(memory, n + 1, sizeof(uint32_t));
    p.at = vectors[0];
    p.velocity = vectors[1];
    p.gradient = vectors[2];
    p.old = vectors[3];
    p.mover = numbers[0];
    p.order = numbers[1];
    p.first = numbers[2];
    p.start = start;
    bool ok = p.chosen && p.near_edge && p.at && p.velocity && p.gradient && p.old && p.mover && p.order && p.first &&
              p.start && set_places(&p);
    if (ok) {
        turn_to_missing(&p);
        ok = relax(&p, &packing->residual);
    }
    void *partner = p.partner;
    sph2d__release(memory, &partner, p.partner_capacity, sizeof *p.partner);
    sph2d__release(memory, &start, buckets, sizeof *p.start);
    for (int k = ok ? 1 : 0; k < 4; ++k)
        sph2d__release(memory, &vectors[k], n + 1, sizeof(sph2d_vec2));
    for (int k = 0; k < 3; ++k)
        sph2d__release(memory, &numbers[k], n + 1, sizeof(uint32_t));
    for (int k = 0; k < 2; ++k)
        sph2d__release(memory, &marks[k], cells, 1);
    packing->places = ok ? p.at : NULL;
    packing->count = ok ? n : 0;
    return ok;
}

void sph2d__packing_free(sph2d__packing *packing, sph2d__memory *memory)
{
    void *block = packing->places;
    sph2d__release(memory, &block, packing->count + 1, sizeof(sph2d_vec2));
    packing->places = NULL;
}
