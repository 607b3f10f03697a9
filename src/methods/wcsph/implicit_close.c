/* SPDX-License-Identifier: MIT */
/** @file implicit_close.c
 *  Close pairs, and what walls stop, in the matrix of an implicit step (implicit.c). What is done to velocities after the
 *  solve is not in D: each stop left theta of its neighbours too low, and tension drew the tip of a wedge together. And an
 *  explicit force may be as strong as the head alone in such a step, less than what presses rows of particles together.
 *
 *  The force of a pair at r is F t^2 a mass, t = 1 - r/r0, F = R/(rho0 dx^2), four times the head over dx. With t_0 at the
 *  start, t' where velocities at the start lead to, and e along the pair in the middle,
 *  towards the side on which it began, it is the secant
 *
 *      F (t_0^2 + (t_0 + t') (t_1 - t_0)) = k (r0 t_0^2/(t_0 + t') + r_0 - r_1),  k = F (t_0 + t')/r0
 *
 *  As t^2 is convex it takes at least the energy that the pair stores until t_1 <= t', and where particles part it gives
 *  at most what they had. As p follows from theta,
 *
 *      (w/(dt c0^2) + w^2 E E^T) q = w/dt s (r0 t_0^2/(t_0 + t') + min(r0 - r_0, 0)) + w E(v_0 + w g)
 *      E v = -s e . (v_i - v_j),  s^2 = k/c0^2,  acceleration of i by q: s e q
 *
 *  together with D and p; q has the norm of energy, as p has. A particle's image in an obstacle stops it, a friction by
 *  what is left of its approach at the end: with t in the middle and k = F t/r0,
 *
 *      (w/(dt c0^2) + w^2 E E^T) q = w E(v_0 + w g) - (dt - w) E(v_0)/2,  E v = -2 s n . (v - v_wall)
 *
 *  Conjugate gradients leave p . left + q . left = 0, not each: what a row's force does apart from its equation is friction,
 *  as what pressure does apart from its own is no energy of the liquid; it was up to 0.08 % of a drop's.
 *
 *  Neither draws: rows with q < 0 are dropped, and the rest is solved for once more. Each particle has rows of its own for its
 *  pairs, the same as the other's to the sign: half of each counts. */
#include <math.h>

#include "methods/wcsph/wcsph.h"

/* In place of another particle: walls. */
static const size_t WALL = SIZE_MAX;

struct sph2d__close_row {
    size_t other;
    double x, y;              /* s e [1/m] */
    double theta;             /* the right side, but for the motion */
    double scale;             /* s, of a wall, else 0 */
    double solved, direction; /* q, and of its next change [m^2/s^2] */
    double residual, product; /* what is left of the equation; the matrix times the direction */
    double first, of_first;   /* what the solve starts from, and its product */
};

static sph2d__close_row *rows_of(sph2d__frozen *z, size_t i)
{
    return z->close_rows + z->first_close[i];
}

static sph2d__close_row *rows_end(sph2d__frozen *z, size_t i)
{
    return z->close_rows + z->first_close[i + 1];
}

/** Whether it draws the particle. */
static bool pulls(const sph2d__close_row *row)
{
    return row->solved < 0;
}

bool sph2d__close_reserve(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    const size_t lanes = s->neighbours.lanes;
    size_t wanted = 0;
    for (size_t k = 0; k < s->fluid.count; k += lanes)
        wanted += (z->close[k / lanes] + 1) * lanes;
    if (wanted <= z->close_capacity)
        return true;
    void *block = z->close_rows;
    if (!sph2d__resize(s->memory, &block, z->close_capacity, wanted + wanted / 2, sizeof *z->close_rows))
        return false;
    z->close_rows = block;
    z->close_capacity = wanted + wanted / 2;
    return true;
}

/** The row of particle i for j; one without e where they are not close. */
static sph2d__close_row row_of(const sph2d__system *s, size_t i, size_t j)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__period *p = &s->fluid_cells.period;
    const double near = SPH2D__CLOSE * s->spacing;
    const double dx = sph2d__shortest_way(z->px[i] - z->px[j], p->length_x),
                 dy = sph2d__shortest_way(z->py[i] - z->py[j], p->length_y);
    const double r = sqrt(dx * dx + dy * dy);
    sph2d__close_row row = {.other = j};
    if (!(r > 0) || r > 2 * near)
        return row;
    const float *v = z->velocity + 4 * i, *u = z->velocity + 4 * j;
    const double ex = dx / r, ey = dy / r;
    const double away = ex * ((double)v[0] - (double)u[0]) + ey * ((double)v[1] - (double)u[1]);
    const double side = r > z->dt / 2 * away ? 1 : -1; /* that on which they began */
    const double start = near - side * (r - z->dt / 2 * away), t0 = fmax(start / near, 0),
                 t1 = 1 - side * (r + z->dt / 2 * away) / near;
    if (t1 > 0 && (side < 0 || r < near)) {
        const double scale = side * sqrt(z->repulsion * (t0 + t1) / (s->spacing * near));
        row.x = scale * ex;
        row.y = scale * ey;
        row.theta = z->ahead / z->dt * fabs(scale) * (near * t0 * t0 / (t0 + t1) + fmin(start, 0));
    }
    return row;
}

/** The row of particle i for its image in the walls before it. */
static sph2d__close_row wall_row_of(const sph2d__system *s, size_t i)
{
    const sph2d__frozen *z = s->frozen;
    const double near = SPH2D__CLOSE * s->spacing, nx = z->front_nx[i], ny = z->front_ny[i];
    sph2d__close_row row = {.other = WALL};
    if ((nx == 0 && ny == 0) || (z->holds && z->held[i] > 0))
        return row;
    const float *v = z->velocity + 4 * i;
    const double away = 2 * (nx * (double)v[0] + ny * (double)v[1] - z->front_speed[i]);
    const double r = 2 * (z->front[i] + (z->px[i] - s->fluid.x[i]) * nx + (z->py[i] - s->fluid.y[i]) * ny);
    const double t = 1 - r / near;
    if (t > 0) {
        const double scale = sqrt(z->repulsion * t / (s->spacing * near));
        row.theta = (z->dt - z->ahead) * scale * away / 2;
        row.x = scale * nx;
        row.y = scale * ny;
        row.scale = scale;
    }
    return row;
}

void sph2d__close_find(sph2d__system *s)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__frozen *z = s->frozen;
    size_t count = 0;
    for (size_t i = 0; i < s->fluid.count; ++i) {
        const sph2d__slice *at = &n->slices[i / n->lanes];
        size_t k = at->begin + ((size_t)at->fluid + at->walls) * n->lanes + i % n->lanes;
        z->first_close[i] = count;
        z->pushed_x[i] = z->pushed_y[i] = z->stopped[i] = z->stop_speed[i] = z->repelled[i] = 0;
        for (uint32_t slot = 0; slot < z->close[i / n->lanes]; ++slot, k += n->lanes) {
            z->close_rows[count] = row_of(s, i, n->index[k]);
            count += z->close_rows[count].x != 0 || z->close_rows[count].y != 0;
        }
        if (at->walls > 0) {
            z->close_rows[count] = wall_row_of(s, i);
            count += z->close_rows[count].x != 0 || z->close_rows[count].y != 0;
        }
    }
    z->first_close[s->fluid.count] = count;
}

/** E of the motion. */
static double rate_of(const sph2d__frozen *z, size_t i, const sph2d__close_row *row)
{
    const float *v = z->velocity + 4 * i;
    if (row->other == WALL)
        return 2 * (row->scale * z->stop_speed[i] - row->x * (double)v[0] - row->y * (double)v[1]);
    const float *u = z->velocity + 4 * row->other;
    return row->x * ((double)u[0] - (double)v[0]) + row->y * ((double)u[1] - (double)v[1]);
}

static void add_squares(const sph2d__close_row *row, sph2d__slab_sum *sum)
{
    sum->first += 0.5 * row->residual * row->residual;
    sum->second += 0.5 * row->first * row->residual;
    sum->third += 0.5 * row->first * row->first;
}

/** What the directions push the particle by, E^T of them. */
static void push(sph2d__frozen *z, size_t i)
{
    double x = 0, y = 0, stopped = 0;
    for (const sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row) {
        x += row->direction * row->x;
        y += row->direction * row->y;
        stopped += row->direction * row->scale;
    }
    z->pushed_x[i] = x;
    z->pushed_y[i] = y;
    z->stopped[i] = stopped;
}

/** The right side, with the motion without pressures; the solve starts from the force at the start of the step. */
void sph2d__close_load(sph2d__system *s, size_t i, bool again, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    const double stiffness = z->dt / z->ahead * s->sound_speed * s->sound_speed;
    for (sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row) {
        row->residual = row->theta + z->ahead * (rate_of(z, i, row) + 2 * row->scale * z->front_speed[i]);
        row->solved = row->of_first = 0;
        row->first = row->direction = again ? row->direction : stiffness * fmax(row->theta, 0);
        add_squares(row, sum);
    }
    push(z, i);
}

double sph2d__close_multiply(sph2d__system *s, size_t i)
{
    sph2d__frozen *z = s->frozen;
    const double w = z->ahead, c2 = s->sound_speed * s->sound_speed;
    double sum = 0;
    for (sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row) {
        row->product = w / z->dt * row->direction / c2 + w * w * rate_of(z, i, row);
        sum += 0.5 * row->direction * row->product;
    }
    return sum;
}

void sph2d__close_step(sph2d__system *s, size_t i, double alpha, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    for (sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row) {
        row->solved += alpha * row->direction;
        row->residual -= alpha * row->product;
        sum->first += 0.5 * row->residual * row->residual;
        sum->second += 0.5 * row->residual * row->of_first;
    }
}

void sph2d__close_direct(sph2d__system *s, size_t i, double beta, double gamma)
{
    sph2d__frozen *z = s->frozen;
    for (sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row)
        row->direction = row->residual + beta * row->direction - gamma * row->first;
    push(z, i);
}

void sph2d__close_keep_first(sph2d__system *s, size_t i)
{
    for (sph2d__close_row *row = rows_of(s->frozen, i); row < rows_end(s->frozen, i); ++row)
        row->of_first = row->product;
}

void sph2d__close_drop(sph2d__system *s, size_t i)
{
    for (sph2d__close_row *row = rows_of(s->frozen, i); row < rows_end(s->frozen, i); ++row)
        if (pulls(row))
            row->x = row->y = row->scale = row->theta = row->solved = 0;
}

void sph2d__close_push(sph2d__system *s, size_t i, bool last)
{
    sph2d__frozen *z = s->frozen;
    for (sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row) {
        row->direction = row->solved;
        if (last && row->other != WALL && row->other >= z->first_image) {
            z->push_x[i] += row->solved * row->x;
            z->push_y[i] += row->solved * row->y;
        }
    }
    push(z, i);
    if (last)
        z->repelled[i] = z->mean_repelled[i] = s->mass * z->stopped[i];
}

bool sph2d__close_pull(const sph2d__system *s)
{
    for (size_t k = 0; k < s->frozen->first_close[s->fluid.count]; ++k)
        if (pulls(&s->frozen->close_rows[k]))
            return true;
    return false;
}

double sph2d__close_residual(const sph2d__system *s, size_t i)
{
    double sum = 0;
    for (const sph2d__close_row *row = rows_of(s->frozen, i); row < rows_end(s->frozen, i); ++row)
        sum += 0.5 * row->solved * row->residual;
    return sum;
}

void sph2d__close_free(sph2d__system *s)
{
    void *rows = s->frozen->close_rows;
    sph2d__release(s->memory, &rows, s->frozen->close_capacity, sizeof *s->frozen->close_rows);
}
