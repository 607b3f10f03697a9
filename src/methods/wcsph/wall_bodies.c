/* SPDX-License-Identifier: MIT */
/** @file wall_bodies.c
 *  Bodies that the liquid moves, by method `wcsph`. The pressure p_b of a boundary particle depends on its acceleration
 *  (wcsph.h), and the body's acceleration q = (A, alpha) on all p_b:
 *
 *      p_b(q) = p_b(q') - W_b . (a_b(q) - a_b(q'))       W_b = sum c_j rho_j r_bj W / sum W
 *      F(q)   = F(q') - K (q - q')                       K   = sum_b s_b w_b'
 *
 *  with s_b the force and torque on the body of a unit of p_b, and w_b the same of W_b. K is the inertia of the liquid
 *  between the body's surface and the middle of the support, which moves along with it: an added mass. Explicitly, with
 *  the acceleration of the step before, bodies lighter than that would be unstable. So q follows from
 *
 *      (M + K)(q - h) = F(q') + K (q' - h) + all other forces
 *
 *  where h is acceleration by contacts, and q' is what the walls were placed with; the pressures of all walls are then
 *  found anew. The velocities on which it all depends stay those that were predicted.
 *
 *  The part of p_b that a_b makes has no potential: its power on body and liquid is its volume times the rate of
 *  compression D_b before the wall (wcsph.h), 0 as long as the liquid yields along the body. In an impact it is not, and
 *  what a body did to liquid and what it got for it were 10 % apart until the sound had left. So of a_b counts
 *  1/(1 + (D_b H/(0.05 c0))^2). Of 100 random scenes 6 with impacts on bodies gained 0.1 to 2.5 % of energy, with this
 *  two 0.2 and 0.3 %; with 0.1 in place of 0.05 three 0.1 to 0.7 %, with 0.03 two 0.1 and 0.2 %:
 *  0.05 was chosen by these scenes. */
#include "base/parallel.h"
#include "boundary/rigid.h"
#include "kernels/kernel.h"
#include "methods/wcsph/wcsph.h"

/* D_b H/c0 at which half of an acceleration counts. */
static const double SUDDEN = 0.05;

double sph2d__wcsph_felt_part(const sph2d__system *s, size_t b)
{
    uint64_t id = s->walls.id[b], first = s->rigids[0].first_id, end = s->rigids[s->rigid_count - 1].end_id;
    double rate = id >= first && id < end ? s->rigid_compression_rate[id - first] : 0;
    double t = rate * s->support / (SUDDEN * s->sound_speed);
    return 1 / (1 + t * t);
}

bool sph2d__wcsph_near_body(const sph2d__system *s, size_t i)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    uint64_t first = s->rigids[0].first_id, end = s->rigids[s->rigid_count - 1].end_id;
    uint32_t cell = sph2d__cells_find(&s->wall_cells, f->x[i], f->y[i]);
    if (cell == UINT32_MAX)
        return false;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, b) {
        double dx = w->x[b] - (f->x[i] + ranges.x[r]), dy = w->y[b] - (f->y[i] + ranges.y[r]);
        if (w->id[b] >= first && w->id[b] < end && dx * dx + dy * dy < s->support * s->support)
            return true;
    }
    return false;
}

void sph2d__wcsph_keep_compression_rates(sph2d__system *s)
{
    uint64_t first = s->rigids[0].first_id, end = s->rigids[s->rigid_count - 1].end_id;
    double h2 = s->support * s->support;
    for (uint64_t id = first; id < end; ++id)
        s->rigid_compression_rate[id - first] = s->walls.wall_rate[s->rigid_index[id - first]] / h2;
}

/** What a boundary particle adds: force by its pressure as it is, the same of a unit of pressure, and W_b. */
typedef struct lever {
    sph2d_vec2 force, unit, weight;
} lever;

static lever lever_of(const sph2d__system *s, size_t b)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    uint32_t cell = sph2d__cells_find(&s->fluid_cells, w->x[b], w->y[b]);
    lever sum = {{0, 0}, {0, 0}, {0, 0}};
    double h2 = s->support * s->support, constant = sph2d__kernel_constant(s->method.kernel) / (h2 * h2), weights = 0;
    double volume = w->mass[b] / w->density[b], unit = volume * volume * s->mass / w->mass[b];
    if (cell == UINT32_MAX || !(w->mass[b] > 0))
        return sum;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->fluid_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, i) {
        double dx = f->x[i] - (w->x[b] + ranges.x[r]), dy = f->y[i] - (w->y[b] + ranges.y[r]), r2 = dx * dx + dy * dy;
        if (!(r2 < h2))
            continue;
        double q = sqrt(r2) / s->support, value = sph2d__kernel_value_at(s->method.kernel, q);
        double rho = value * f->density[i] * sph2d__connection(f->filling[i]);
        double push = unit * constant * sph2d__kernel_slope_at(s->method.kernel, q);
        sph2d_vec2 force = sph2d__wcsph.wall_force(s, i, b, dx, dy).pressure;
        sum.force = (sph2d_vec2){sum.force.x - force.x, sum.force.y - force.y};
        sum.unit = (sph2d_vec2){sum.unit.x + push * dx, sum.unit.y + push * dy};
        sum.weight = (sph2d_vec2){sum.weight.x - rho * dx, sum.weight.y - rho * dy};
        weights += value;
    }
    double share = weights > 1e-12 ? sph2d__wcsph_felt_part(s, b) / weights : 0;
    sum.weight = (sph2d_vec2){share * sum.weight.x, share * sum.weight.y};
    return sum;
}

/** (x, y, turn) of a vector at an arm. */
static void at_arm(sph2d_vec2 v, sph2d_vec2 arm, double out[3])
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = arm.x * v.y - arm.y * v.x;
}

static sph2d_vec2 arm_of(const sph2d__system *s, const sph2d__rigid *r, size_t b)
{
    const sph2d__period *p = &s->wall_cells.period;
    sph2d_vec2 center = sph2d__rigid_center(r, r->now);
    return (sph2d_vec2){sph2d__period_nearest(s->walls.x[b] - center.x, p->length_x),
                        sph2d__period_nearest(s->walls.y[b] - center.y, p->length_y)};
}

/** Solves m q = f by elimination with pivots. False for a singular matrix. */
static bool solve(double m[3][4])
{
    for (int k = 0; k < 3; ++k) {
        int pivot = k;
        for (int i = k + 1; i < 3; ++i)
            pivot = fabs(m[i][k]) > fabs(m[pivot][k]) ? i : pivot;
        if (!(fabs(m[pivot][k]) > 0))
            return false;
        for (int j = 0; j < 4; ++j) {
            double other = m[k][j];
            m[k][j] = m[pivot][j];
            m[pivot][j] = other;
        }
        for (int i = 0; i < 3; ++i)
            for (int j = 3; i != k && j >= k; --j)
                m[i][j] -= m[i][k] / m[k][k] * m[k][j];
    }
    for (int k = 0; k < 3; ++k)
        m[k][3] /= m[k][k];
    return true;
}

/** The change of a body's acceleration from that with which its walls were placed. */
static sph2d__twist change_of(const sph2d__system *s, const sph2d__rigid *r, const lever *of, uint64_t first)
{
    const double mass[3] = {r->mass, r->mass, r->inertia}, free[3] = {r->free.x, r->free.y, r->free.turn};
    const sph2d__twist *felt = &r->state->felt, *h = &r->state->held_up;
    const double guess[3] = {felt->x - h->x, felt->y - h->y, felt->turn - h->turn},
                 other[3] = {r->other.x, r->other.y, r->other.turn};
    double m[3][4] = {{0}};
    for (uint64_t id = r->first_id; id < r->end_id; ++id) {
        const lever *l = &of[id - first];
        sph2d_vec2 arm = arm_of(s, r, s->rigid_index[id - first]);
        double force[3], unit[3], weight[3];
        at_arm(l->force, arm, force);
        at_arm(l->unit, arm, unit);
        at_arm(l->weight, arm, weight);
        for (int i = 0; i < 3; ++i) {
            m[i][3] += free[i] * force[i];
            for (int j = 0; j < 3; ++j)
                m[i][j] += free[i] * unit[i] * weight[j] * free[j];
        }
    }
    for (int i = 0; i < 3; ++i) {
        m[i][3] += free[i] * (other[i] - mass[i] * guess[i]); /* for the change: K q' cancels */
        m[i][i] += mass[i];
    }
    return solve(m) ? (sph2d__twist){m[0][3], m[1][3], m[2][3]} : (sph2d__twist){0, 0, 0};
}

/** Gives a body's boundary particles the acceleration that it feels. */
static void feel(sph2d__system *s, const sph2d__rigid *r, uint64_t first)
{
    const sph2d__twist *a = &r->state->felt;
    double w2 = r->state->felt_way.turn * r->state->felt_way.turn;
    for (uint64_t id = r->first_id; id < r->end_id; ++id) {
        size_t b = s->rigid_index[id - first];
        sph2d_vec2 arm = arm_of(s, r, b);
        s->walls.ax[b] = a->x - a->turn * arm.y - w2 * arm.x;
        s->walls.ay[b] = a->y + a->turn * arm.x - w2 * arm.y;
    }
}

bool sph2d__wcsph_move_bodies(sph2d__system *s)
{
    uint64_t first = s->rigids[0].first_id, end = s->rigids[s->rigid_count - 1].end_id;
    size_t count = (size_t)(end - first);
    void *block = sph2d__alloc(s->memory, count + 1, sizeof(lever));
    if (!block)
        return false;
    lever *of = block; /* by id from the first body's first on */
#pragma omp taskloop num_tasks(sph2d__tasks(count, SPH2D__LOOK_GRAIN)) if (count > SPH2D__LOOK_GRAIN)
    for (size_t k = 0; k < count; ++k)
        of[k] = lever_of(s, s->rigid_index[k]);
    for (size_t k = 0; k < s->rigid_count; ++k) {
        sph2d__rigid *r = &s->rigids[k];
        if (!r->knows_felt)
            r->state->felt = sph2d__twist_add(r->state->felt, 1, change_of(s, r, of, first));
        feel(s, r, first);
    }
    sph2d__release(s->memory, &block, count + 1, sizeof(lever));
    return true;
}
