/* SPDX-License-Identifier: MIT */
/** @file muller_pairs.c
 *  The sums of muller_pairs.h. */
#include "muller_pairs.h"

#include <math.h>
#include <string.h>

cloud fluid, walls;

double kernel(double support, double r2)
{
    double h2 = support * support;
    return r2 < h2 ? 4 / (TEST_PI * pow(support, 8)) * pow(h2 - r2, 3) : 0;
}

liquid liquid_of(const sph2d_scene *scene)
{
    double dx = scene->spacing, lattice = 0, pressed = 0;
    liquid l = {scene->method.support_ratio * dx,
                scene->fluid.density,
                scene->fluid.density * dx * dx,
                0,
                scene->fluid.dynamic_viscosity,
                0,
                0,
                dx};
    for (int i = -7; i <= 7; ++i)
        for (int j = -7; j <= 7; ++j) {
            double r = hypot(i, j) * dx, near = fmax(l.support - r, 0), d = near * (l.support + r);
            lattice += dx * dx * kernel(l.support, r * r);
            pressed += dx * dx * 4 / (TEST_PI * pow(l.support, 8)) * 3 * d * d * r * r; /* -dW/d ln(r^2) */
            l.carried += dx * dx / 4 * r * 30 / (TEST_PI * pow(l.support, 5)) * near * near;
        }
    l.calibration = 1 / lattice;
    double c0 = scene->method.sound_speed;
    l.stiffness = c0 * c0 / (l.carried * pressed / lattice);
    double alpha = scene->method.artificial_viscosity > 0 ? scene->method.artificial_viscosity : 0.1;
    l.mu = fmax(l.mu, alpha * l.rho0 * c0 * l.support);
    return l;
}

/** Sum of masses times W over a cloud. */
static double summed(const liquid *l, const cloud *from, double x, double y)
{
    double sum = 0;
    for (size_t j = 0; j < from->count; ++j)
        sum += from->mass[j] * kernel(l->support, pow(x - from->x[j], 2) + pow(y - from->y[j], 2));
    return sum;
}

static double pressure(const liquid *l, double rho)
{
    return fmax(l->stiffness * (rho - l->rho0), 0);
}

/** Of a filled lattice of spacing s: sums of m W, and of r |W'|, the pair force's kernel, for particles of area dx^2.
 *  */
static void lattice_sums(const liquid *l, double s, double *density, double *push)
{
    *density = *push = 0;
    for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j) {
            double r = hypot(i, j) * s, near = fmax(l->support - r, 0);
            *density += l->calibration * l->dx * l->dx * kernel(l->support, r * r);
            *push += l->dx * l->dx * r * 30 / (TEST_PI * pow(l->support, 5)) * near * near;
        }
}

double pair_gain(const liquid *l, double density)
{
    const double h = 1e-5;
    double near = 0.25 * l->dx, far = l->dx, rho[3], push[3], ratio[2];
    if (density <= 1)
        return 1;
    for (int k = 0; k < 60; ++k) {
        double middle = (near + far) / 2;
        lattice_sums(l, middle, &rho[0], &push[0]);
        *(rho[0] > density ? &near : &far) = middle;
    }
    for (int k = 0; k < 2; ++k) {
        double s = k == 0 ? far : l->dx;
        for (int step = -1; step <= 1; ++step)
            lattice_sums(l, s * (1 + step * h), &rho[step + 1], &push[step + 1]);
        ratio[k] = (rho[0] - rho[2]) / (4 * h) / push[1]; /* d ln n = -2 d ln s */
    }
    return ratio[0] / ratio[1];
}

void sum_densities(const liquid *l)
{
    for (size_t b = 0; b < walls.count; ++b)
        walls.mass[b] = 1;
    static double weight[WALLS_MOST];
    for (size_t b = 0; b < walls.count; ++b)
        weight[b] = l->rho0 / summed(l, &walls, walls.x[b], walls.y[b]);
    memcpy(walls.mass, weight, walls.count * sizeof *weight);
    for (size_t i = 0; i < fluid.count; ++i)
        fluid.mass[i] = l->mass;
    for (size_t i = 0; i < fluid.count; ++i) {
        double x = fluid.x[i], y = fluid.y[i];
        fluid.rho[i] = l->calibration * summed(l, &fluid, x, y) + summed(l, &walls, x, y);
        fluid.p[i] = pressure(l, fluid.rho[i]);
    }
    for (size_t b = 0; b < walls.count; ++b) {
        walls.rho[b] = l->rho0 + l->calibration * summed(l, &fluid, walls.x[b], walls.y[b]);
        walls.p[b] = pressure(l, walls.rho[b]);
    }
}

void add_forces(const liquid *l, size_t i, const cloud *from, double a[2], double *size)
{
    double h5 = pow(l->support, 5);
    for (size_t j = 0; j < from->count; ++j) {
        double dx = fluid.x[i] - from->x[j], dy = fluid.y[i] - from->y[j], r = hypot(dx, dy);
        if (r >= l->support)
            continue;
        double volume = from->mass[j] / from->rho[j], near = l->support - r;
        double slope = 30 / (TEST_PI * h5) * near * near, laplacian = 40 / (TEST_PI * h5) * near;
        if (r > 0 && from == &walls) {
            double d = l->support * l->support - r * r, slope6 = 24 / (TEST_PI * pow(l->support, 8)) * d * d;
            double push = l->carried * fluid.p[i] / pow(fluid.rho[i], 2) * from->mass[j] * slope6;
            a[0] += push * dx;
            a[1] += push * dy;
        } else if (r > 0) {
            double q = fluid.gain[i] * fluid.p[i] + from->gain[j] * from->p[j];
            double push = volume * q / 2 * slope / fluid.rho[i];
            a[0] += push * dx / r;
            a[1] += push * dy / r;
        }
        double drag = l->mu / fluid.rho[i] * volume * laplacian;
        a[0] += drag * (from->vx[j] - fluid.vx[i]);
        a[1] += drag * (from->vy[j] - fluid.vy[i]);
        *size += volume * l->stiffness * (fluid.rho[i] + from->rho[j]) / 2 * slope / fluid.rho[i] +
                 drag * hypot(from->vx[j] - fluid.vx[i], from->vy[j] - fluid.vy[i]);
    }
}
