/* SPDX-License-Identifier: MIT */
/** @file grid_solve_pass.c
 *  Liquid and air on the grid of method `hybrid`, their equations, and what faces say of the solution. What is done to a square is in
 *  grid_squares.h; where a device solves, each loop is a kernel. */
#include <string.h>

#include "methods/hybrid/grid.h"
#include "methods/hybrid/grid_squares.h"

/* Iterations for pressure, which starts from that of the step before, and for displacements. */
enum { PRESSURE_ITERATIONS = 3, VOLUME_ITERATIONS = 2, BODY_ITERATIONS = 3 };

/** Runs a kernel with a number, where a device solves. */
static bool by_device(const sph2d__grid *g, const char *kernel, size_t count, float factor)
{
    if (g->on_device)
        sph2d__grid_run(g, kernel, count, &(sph2d__grid_work){.factor = factor});
    return g->on_device != NULL;
}

/** Runs the statement behind it for the squares k that a step sets. */
#define FOR_SET(g, k)                                                                                                  \
    for (int j_ = (g)->first; j_ <= (g)->last; ++j_)                                                                   \
        SPH2D__FOR_SPAN (g, j_, k)

/** The same from the first liquid square of each row to the last. */
#define FOR_LIQUID(g, k)                                                                                               \
    for (int j_ = 1; j_ <= (g)->ny; ++j_)                                                                              \
        for (size_t k = sph2d__at(g, (g)->level->from[j_], j_), end_ = sph2d__at(g, (g)->level->to[j_] + 1, j_);       \
             k < end_; ++k)

/** The same for those with a left or lower face that liquid touches. */
#define FOR_FACES(g, k)                                                                                                \
    for (int j_ = 1; j_ <= (g)->ny + 1; ++j_)                                                                          \
        for (size_t k = sph2d__at(g, lower((g)->level->from[j_], (g)->level->from[j_ - 1]), j_),                       \
                    end_ = sph2d__at(g, higher((g)->level->to[j_], (g)->level->to[j_ - 1]) + 1, j_);                   \
             k <= end_; ++k)

static void take_means(const sph2d__grid *g)
{
    if (!by_device(g, "grid_means", g->size, 0))
        FOR_SET (g, k)
            take_mean(g, k);
    if (g->nozzle_count > 0 && !by_device(g, "grid_set_jets", 1, 0))
        set_jets(g);
}

/** Tells of `count` squares with their middle in a solid how full they are, by those beside them, one after the other: through
 *  gaps too narrow for particles to tell. */
static void spread_inwards(const sph2d__grid *g, float *known, uint32_t *left, size_t count)
{
    size_t before;
    do {
        before = count;
        for (size_t n = 0; n < count; ++n)
            g->filled[n] = mean_beside(g, known, left[n]);
        count = 0;
        for (size_t n = 0; n < before; ++n) {
            known[left[n]] = g->filled[n];
            if (g->filled[n] < 0)
                left[count++] = left[n];
        }
    } while (count < before);
}

/** Fills what solids hide; of the squares that are cut those count that the step sets. */
static void fill_cut_squares(const sph2d__grid *g)
{
    float *beside = g->pressure.residual,
          *known = g->s; /* free before the pressure; s is 0 where the step sets nothing */
    uint32_t *here = g->pocket_end, *left = g->member; /* free before there are pockets */
    size_t count = 0, inside = 0;
    if (g->on_device) {
        sph2d__grid_fill_cut_squares(g);
        return;
    }
    for (size_t n = 0; n < g->cut_count; ++n) {
        const uint32_t k = g->cut[n];
        if (is_set(g, k)) {
            here[count++] = k;
            known[k] = UNKNOWN;
        }
    }
    for (size_t n = 0; n < count; ++n) {
        beside[here[n]] = mean_beside(g, known, here[n]);
        if (!(g->hidden[here[n]] < 0.5F))
            left[inside++] = here[n];
    }
    spread_inwards(g, known, left, inside);
    for (size_t n = 0; n < count; ++n)
        fill_hidden(g, beside, known, here[n]);
}

static void find_liquid(const sph2d__grid *g)
{
    if (!by_device(g, "grid_find_liquid", (size_t)g->ny + 2, 0))
        for (int j = 0; j <= g->ny + 1; ++j)
            find_liquid_of(g, j);
}

/** Couplings of the faces. */
static void couple_all(const sph2d__grid *g)
{
    if (!by_device(g, "grid_couple_faces", g->size, 0))
        FOR_FACES (g, k)
            couple_faces(g, k);
}

/** Diagonals and right sides. */
static void set_equations(const sph2d__grid *g)
{
    if (!by_device(g, "grid_set_equations", g->size, 0))
        FOR_LIQUID (g, k)
            set_equation(g, k);
    if (g->nozzle_count > 0 && !by_device(g, "grid_feed", 1, 0))
        feed(g);
}

/** The right side for displacements. */
static void set_volumes(const sph2d__grid *g)
{
    if (by_device(g, "grid_set_volumes", g->size, 0))
        return;
    FOR_SET (g, k)
        g->s[k] = 0;
    FOR_LIQUID (g, k)
        set_volume(g, k);
}

static void set_faces(const sph2d__grid *g)
{
    const int most = 4 * higher(g->nx, g->ny);
    if (!by_device(g, "grid_set_faces", g->size, 0))
        FOR_FACES (g, k)
            set_faces_of(g, k);
    if (g->nozzle_count > 0 && !by_device(g, "grid_close_jets", 1, 0))
        close_jets(g);
    if (!by_device(g, "grid_close_sides", (size_t)most, 0))
        for (int n = 0; n < most; ++n)
            close_side(g, n % 4, n / 4 + 1);
}

static void continue_pressure(const sph2d__grid *g)
{
    if (!by_device(g, "grid_continue", g->size, 0))
        FOR_SET (g, k)
            continue_pressure_to(g, k);
}

/** Adds `factor` times what pressure changes velocities by. */
static void press(const sph2d__grid *g, float factor)
{
    if (!by_device(g, "grid_press", g->size, factor))
        FOR_FACES (g, k)
            press_faces(g, factor, k);
    sph2d__grid_wrap(g, g->level, g->u);
    sph2d__grid_wrap(g, g->level, g->v);
}

/** Viscosity acts on what the pressure of the last step leaves of the forces: on all of them it would hold up liquid at rest
 *  along walls without slip, as high as if it weighed less within sqrt(nu dt) of them. */
static void apply_viscosity(sph2d__grid *g, double viscosity)
{
    if (!sph2d__grid_is_viscous(g, viscosity))
        return;
    if (!by_device(g, "grid_keep_liquid", g->size, 0))
        FOR_SET (g, k)
            g->q[k] = is_liquid(g, k) ? g->q[k] : 0;
    sph2d__grid_wrap(g, g->level, g->q);
    press(g, 1);
    sph2d__grid_fetch(g, (void *[]){g->u, g->v, g->wet_x, g->wet_y}, 4);
    sph2d__grid_viscosity(g, viscosity);
    sph2d__grid_send(g, (void *[]){g->u, g->v}, 2);
    press(g, -1);
}

/** Finds pockets, and takes their means out of the right sides. The host does, also where a device solves: it goes from square to square. */
static void level_right_sides(sph2d__grid *g)
{
    const sph2d__level *l = g->level;
    void *const sides[] = {g->pressure.residual, g->volume.residual};
    sph2d__grid_fetch(g, (void *[]){l->left, l->below, l->air, l->inverse, l->from, l->to}, 6);
    sph2d__grid_find_pockets(g);
    for (int n = 0; n < 2 && g->pockets > 0; ++n) {
        sph2d__grid_fetch(g, &sides[n], 1);
        sph2d__grid_level_pockets(g, sides[n]);
        sph2d__grid_send(g, &sides[n], 1);
    }
}

static void wrap_faces(const sph2d__grid *g)
{
    if (!(g->wraps_x || g->wraps_y) || by_device(g, "grid_wrap_faces", g->size, 0))
        return;
    for (int j = 0; j < g->ny + 4; ++j)
        for (int i = 0; i < g->nx + 4; ++i) {
            wrap_quad(g, g->face_x, i, j);
            wrap_quad(g, g->face_y, i, j);
        }
}

static void solve(sph2d__grid *g, double viscosity)
{
    const sph2d__level *l = g->level;
    take_means(g);
    sph2d__grid_wrap(g, l, g->mass);
    fill_cut_squares(g);
    sph2d__grid_wrap(g, l, g->mass);
    find_liquid(g);
    couple_all(g);
    float *const ringed[] = {g->u, g->v, g->wet_x, g->wet_y};
    for (size_t n = 0; n < sizeof ringed / sizeof *ringed; ++n)
        sph2d__grid_wrap(g, l, ringed[n]);
    apply_viscosity(g, viscosity);
    set_equations(g);
    set_volumes(g);
    level_right_sides(g);
    g->solver->prepare(g);
    if (!by_device(g, "grid_keep_known", g->size, 0))
        FOR_SET (g, k)
            g->q[k] = l->inverse[k] > 0 ? g->q[k] : 0;
    sph2d__grid_wet_parts(g);
#pragma omp task if (!g->on_device)
    g->solver->solve(g, &g->volume, g->s, false, VOLUME_ITERATIONS); /* around bodies where they are */
    g->solver->solve(g, &g->pressure, g->q, true, PRESSURE_ITERATIONS + BODY_ITERATIONS * (int)g->body_count);
    if (g->pockets > 0) {
        sph2d__grid_fetch(g, (void *[]){g->q}, 1);
        sph2d__grid_level_pockets(g, g->q);
        sph2d__grid_send(g, (void *[]){g->q}, 1);
    }
#pragma omp taskwait
    sph2d__grid_wrap(g, l, g->q);
    sph2d__grid_wrap(g, l, g->s);
    set_faces(g);
    continue_pressure(g);
    wrap_faces(g);
}

const sph2d__grid_passes SPH2D__OF_ISA(sph2d__grid_passes) = {solve};
