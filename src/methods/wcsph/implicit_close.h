/* SPDX-License-Identifier: MIT */
/** @file implicit_close.h
 *  Close pairs, and what walls stop, of one particle after another (implicit_close.c), in C and in OpenCL C. */
#ifndef SPH2D_METHODS_WCSPH_IMPLICIT_CLOSE_H
#define SPH2D_METHODS_WCSPH_IMPLICIT_CLOSE_H

#include "methods/common/slab.h"
#include "methods/wcsph/wcsph_frozen.h"
#include "simd/lanes.h"

/* In place of another particle: walls. */
SPH2D__FIXED size_t WALL = SIZE_MAX;

SPH2D__INLINE SPH2D__ARRAY sph2d__close_row *rows_of(const sph2d__frozen *z, size_t i)
{
    return z->close_rows + z->first_close[i];
}

SPH2D__INLINE SPH2D__ARRAY sph2d__close_row *rows_end(const sph2d__frozen *z, size_t i)
{
    return z->close_rows + z->end_close[i];
}

/** The most rows that a particle has. */
SPH2D__INLINE size_t most_rows(const sph2d__system *s, size_t i)
{
    return s->frozen->close[i / s->neighbours.lanes] + 1;
}

/** Whether it draws the particle. */
SPH2D__INLINE bool pulls(SPH2D__ARRAY const sph2d__close_row *row)
{
    return row->solved < 0;
}

/** The row of particle i for j; one without e where they are not close. */
SPH2D__INLINE sph2d__close_row row_of(const sph2d__system *s, size_t i, size_t j)
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
    SPH2D__ARRAY const float *v = z->velocity + 4 * i, *u = z->velocity + 4 * j;
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
SPH2D__INLINE sph2d__close_row wall_row_of(const sph2d__system *s, size_t i)
{
    const sph2d__frozen *z = s->frozen;
    const double near = SPH2D__CLOSE * s->spacing, nx = z->front_nx[i], ny = z->front_ny[i];
    sph2d__close_row row = {.other = WALL};
    if ((nx == 0 && ny == 0) || (z->holds && z->held[i] > 0))
        return row;
    SPH2D__ARRAY const float *v = z->velocity + 4 * i;
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

/** Appends a row that has an e. */
SPH2D__INLINE void put_row(sph2d__frozen *z, size_t *end, sph2d__close_row row)
{
    if (row.x != 0 || row.y != 0)
        z->close_rows[(*end)++] = row;
}

/** Finds the rows of particle i, which begin at `first`. */
SPH2D__INLINE void find_rows(sph2d__system *s, size_t i, size_t first)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__frozen *z = s->frozen;
    SPH2D__ARRAY const sph2d__slice *at = &n->slices[i / n->lanes];
    size_t k = at->begin + ((size_t)at->fluid + at->walls) * n->stride + i % n->lanes, end = first;
    z->pushed_x[i] = z->pushed_y[i] = z->stopped[i] = z->stop_speed[i] = z->repelled[i] = 0;
    for (uint32_t slot = 0; slot < z->close[i / n->lanes]; ++slot, k += n->stride)
        put_row(z, &end, row_of(s, i, n->index[k]));
    if (at->walls > 0)
        put_row(z, &end, wall_row_of(s, i));
    z->first_close[i] = first;
    z->end_close[i] = end;
}

/** E of the motion. */
SPH2D__INLINE double row_rate(const sph2d__frozen *z, size_t i, SPH2D__ARRAY const sph2d__close_row *row)
{
    SPH2D__ARRAY const float *v = z->velocity + 4 * i;
    if (row->other == WALL)
        return 2 * (row->scale * z->stop_speed[i] - row->x * (double)v[0] - row->y * (double)v[1]);
    SPH2D__ARRAY const float *u = z->velocity + 4 * row->other;
    return row->x * ((double)u[0] - (double)v[0]) + row->y * ((double)u[1] - (double)v[1]);
}

SPH2D__INLINE void add_squares(SPH2D__ARRAY const sph2d__close_row *row, sph2d__slab_sum *sum)
{
    sum->first += 0.5 * row->residual * row->residual;
    sum->second += 0.5 * row->first * row->residual;
    sum->third += 0.5 * row->first * row->first;
}

/** What the directions push the particle by, E^T of them. */
SPH2D__INLINE void push_by_rows(sph2d__frozen *z, size_t i)
{
    double x = 0, y = 0, stopped = 0;
    for (SPH2D__ARRAY const sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row) {
        x += row->direction * row->x;
        y += row->direction * row->y;
        stopped += row->direction * row->scale;
    }
    z->pushed_x[i] = x;
    z->pushed_y[i] = y;
    z->stopped[i] = stopped;
}

/** The right side, with the motion without pressures; the solve starts from the force at the start of the step. */
SPH2D__INLINE void close_load(sph2d__system *s, size_t i, bool again, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    const double stiffness = z->dt / z->ahead * s->sound_speed * s->sound_speed;
    for (SPH2D__ARRAY sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row) {
        row->residual = row->theta + z->ahead * (row_rate(z, i, row) + 2 * row->scale * z->front_speed[i]);
        row->solved = row->of_first = 0;
        row->first = row->direction = again ? row->direction : stiffness * fmax(row->theta, 0);
        add_squares(row, sum);
    }
    push_by_rows(z, i);
}

SPH2D__INLINE double close_multiply(sph2d__system *s, size_t i)
{
    sph2d__frozen *z = s->frozen;
    const double w = z->ahead, c2 = s->sound_speed * s->sound_speed;
    double sum = 0;
    for (SPH2D__ARRAY sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row) {
        row->product = w / z->dt * row->direction / c2 + w * w * row_rate(z, i, row);
        sum += 0.5 * row->direction * row->product;
    }
    return sum;
}

SPH2D__INLINE void close_step(sph2d__system *s, size_t i, double alpha, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    for (SPH2D__ARRAY sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row) {
        row->solved += alpha * row->direction;
        row->residual -= alpha * row->product;
        sum->first += 0.5 * row->residual * row->residual;
        sum->second += 0.5 * row->residual * row->of_first;
    }
}

SPH2D__INLINE void close_direct(sph2d__system *s, size_t i, double beta, double gamma)
{
    sph2d__frozen *z = s->frozen;
    for (SPH2D__ARRAY sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row)
        row->direction = row->residual + beta * row->direction - gamma * row->first;
    push_by_rows(z, i);
}

SPH2D__INLINE void close_keep_first(sph2d__system *s, size_t i)
{
    for (SPH2D__ARRAY sph2d__close_row *row = rows_of(s->frozen, i); row < rows_end(s->frozen, i); ++row)
        row->of_first = row->product;
}

/** Drops those that draw it. */
SPH2D__INLINE void close_drop(sph2d__system *s, size_t i)
{
    for (SPH2D__ARRAY sph2d__close_row *row = rows_of(s->frozen, i); row < rows_end(s->frozen, i); ++row)
        if (pulls(row))
            row->x = row->y = row->scale = row->theta = row->solved = 0;
}

/** What its rows push it by with what was found, which `last` adds to the mean force of sides, too. */
SPH2D__INLINE void close_push(sph2d__system *s, size_t i, bool last)
{
    sph2d__frozen *z = s->frozen;
    for (SPH2D__ARRAY sph2d__close_row *row = rows_of(z, i); row < rows_end(z, i); ++row) {
        row->direction = row->solved;
        if (last && row->other != WALL && row->other >= z->first_image) {
            z->push_x[i] += row->solved * row->x;
            z->push_y[i] += row->solved * row->y;
        }
    }
    push_by_rows(z, i);
    if (last)
        z->repelled[i] = z->mean_repelled[i] = s->mass * z->stopped[i];
}

/** Whether some of what was found draws it: then the rest is solved for once more. */
SPH2D__INLINE bool close_pulls(const sph2d__system *s, size_t i)
{
    bool any = false;
    for (SPH2D__ARRAY const sph2d__close_row *row = rows_of(s->frozen, i); row < rows_end(s->frozen, i); ++row)
        any = any || pulls(row);
    return any;
}

/** What is left of its rows' equations by what was found: energy over m dt/w. */
SPH2D__INLINE double close_residual(const sph2d__system *s, size_t i)
{
    double sum = 0;
    for (SPH2D__ARRAY const sph2d__close_row *row = rows_of(s->frozen, i); row < rows_end(s->frozen, i); ++row)
        sum += 0.5 * row->solved * row->residual;
    return sum;
}

#endif
