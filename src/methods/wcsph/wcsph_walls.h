/* SPDX-License-Identifier: MIT */
/** @file wcsph_walls.h
 *  The forces of method `wcsph` between a particle and walls, one by one, for the sums of loads, in C and in OpenCL C. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_WALLS_H
#define SPH2D_METHODS_WCSPH_WCSPH_WALLS_H

#include "kernels/kernel.h"
#include "methods/common/wall_force.h"
#include "methods/wcsph/wcsph_stick.h"

/** By the means over the step, at the places of its middle; without the friction of smooth walls. */
SPH2D__INLINE sph2d__wall_force mean_wall_force(const sph2d__system *s, size_t i, size_t b, double dx, double dy)
{
    const sph2d__frozen *z = s->frozen;
    if (!z->capacity) /* at the start */
        return (sph2d__wall_force){{0, 0}, {0, 0}};
    const double h2 = s->support * s->support;
    const double weight =
        z->part[b] * s->walls.mass[b] / s->rest_density * sph2d__kernel_constant(s->method.kernel) / (h2 * h2);
    const double slope = weight * sph2d__kernel_slope_at(s->method.kernel, sqrt(dx * dx + dy * dy) / s->support);
    volatile float gx = (float)(slope * dx), gy = (float)(slope * dy), rx = (float)dx, ry = (float)dy; /* as they act */
    const double more = sph2d__thickness(s, i, b, rx, ry);
    gx = (float)((double)gx + more * (double)gx);
    gy = (float)((double)gy + more * (double)gy);
    const double x = (double)gx, y = (double)gy;
    const double ax = z->bxx[i] * x + z->bxy[i] * y, ay = z->bxy[i] * x + z->byy[i] * y;
    const double pull = z->mean_ex[i] * dx + z->mean_ey[i] * dy;
    const double nx = z->wall_xx[i] * ax + z->wall_xy[i] * ay, ny = z->wall_xy[i] * ax + z->wall_yy[i] * ay;
    const double repel = z->mean_repelled[i] * sph2d__front_share(s, i, b, x, y, (double)rx, (double)ry);
    sph2d_vec2 friction = {0, 0};
    if (z->sticks) {
        const sph2d__frozen_stick k = stick_of(s, i, b, x, y, (double)rx, (double)ry);
        const double mx = z->mean_vx[i], my = z->mean_vy[i];
        friction.x += s->mass * (z->past * k.x - k.xx * mx - k.xy * my);
        friction.y += s->mass * (z->past * k.y - k.xy * mx - k.yy * my);
    }
    return (sph2d__wall_force){.pressure = {pull * ax - z->mean_work[i] * nx + repel * z->front_nx[i],
                                            pull * ay - z->mean_work[i] * ny + repel * z->front_ny[i]},
                               .friction = friction};
}

/** Away from each side, by the means over the step. Forces along a side cancel in their sum. */
SPH2D__INLINE void mean_side_push(const sph2d__system *s, size_t i, double push[4])
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__sides *d = &z->sides;
    const double x = s->fluid.x[i], y = s->fluid.y[i];
    push[0] = push[1] = push[2] = push[3] = 0;
    if (!z->images.count)
        return;
    if (x - d->low_x < d->high_x - x)
        push[0] = z->push_x[i];
    else
        push[1] = -z->push_x[i];
    if (y - d->low_y < d->high_y - y)
        push[2] = z->push_y[i];
    else
        push[3] = -z->push_y[i];
}

/** Elastic energy of particle i [J/kg]. */
SPH2D__INLINE double elastic_of(const sph2d__system *s, size_t i)
{
    return s->sound_speed * s->sound_speed * s->fluid.log_density[i] * s->fluid.log_density[i] / 2 + s->fluid.stored[i];
}

#endif
