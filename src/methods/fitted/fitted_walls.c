/* SPDX-License-Identifier: MIT */
/** @file fitted_walls.c
 *  Forces of the liquid on walls with fitted operators, which have none between particles and walls: stress at the
 *  surface before a boundary particle of the first layer, times the length of surface that this represents,
 *
 *      F = (-p n + mu (grad v + (grad v)^T) . n) L,   n into the liquid
 *
 *  Velocity and density are quadratic polynomials around that point, fitted to the particles and to what is known of
 *  walls, as those around a particle are (fitted.h, fitted_pair.h): at walls the velocity, and the slope of the density
 *  along their normals, by which pressure balances the body force. Surface that another wall covers is left out: that
 *  with more boundary particles in front of it than liquid. */
#include <math.h>

#include "kernels/kernel.h"
#include "methods/fitted/fitted.h"

/* Terms of the polynomials: 1, xi, eta, xi^2, xi eta, eta^2; that of velocity has none of 1, as it is known. */
enum { TERMS = 6, LINEAR = 3 };

/* A pivot below this part of its diagonal element: the neighbours do not determine the term. */
static const double LEAST_PIVOT = 1e-4;

/** Normal equations for one polynomial of each of two fields. */
typedef struct equations {
    double matrix[TERMS][TERMS], right[2][TERMS];
} equations;

static void set_terms(double terms[TERMS], double x, double y)
{
    const double all[TERMS] = {1, x, y, x * x, x * y, y * y};
    for (int a = 0; a < TERMS; ++a)
        terms[a] = all[a];
}

static void add_equation(equations *e, const double terms[TERMS], double weight, double first, double second)
{
    for (int a = 0; a < TERMS; ++a) {
        for (int b = 0; b <= a; ++b)
            e->matrix[a][b] += weight * terms[a] * terms[b];
        e->right[0][a] += weight * terms[a] * first;
        e->right[1][a] += weight * terms[a] * second;
    }
}

/** Solves for the terms from `from` to `to` - 1 by Cholesky's method, A = L D L^T; the others are 0. False if the
 *  neighbours do not determine them. */
static bool solve_terms(const equations *e, int from, int to, double c[2][TERMS])
{
    double l[TERMS][TERMS], pivot[TERMS];
    for (int a = from; a < to; ++a)
        for (int b = from; b <= a; ++b) {
            double rest = e->matrix[a][b];
            for (int n = from; n < b; ++n)
                rest -= l[a][n] * pivot[n] * l[b][n];
            if (a > b)
                l[a][b] = rest / pivot[b];
            else if (rest > LEAST_PIVOT * e->matrix[a][a])
                pivot[a] = rest;
            else
                return false;
        }
    for (int f = 0; f < 2; ++f) {
        for (int a = 0; a < TERMS; ++a)
            c[f][a] = a >= from && a < to ? e->right[f][a] : 0;
        for (int a = from; a < to; ++a)
            for (int n = from; n < a; ++n)
                c[f][a] -= l[a][n] * c[f][n];
        for (int a = to - 1; a >= from; --a) {
            c[f][a] /= pivot[a];
            for (int n = a + 1; n < to; ++n)
                c[f][a] -= l[n][a] * c[f][n];
        }
    }
    return true;
}

static void solve_or_less(const equations *e, int from, double c[2][TERMS])
{
    for (int to = TERMS; to > from; to = to == TERMS ? LINEAR : to - 1)
        if (solve_terms(e, from, to, c))
            return;
    for (int a = 0; a < TERMS; ++a)
        c[0][a] = c[1][a] = 0;
}

/** A point of the surface, the wall's velocity there, and the normal into the liquid. */
typedef struct surface_point {
    sph2d_vec2 at, velocity, normal;
} surface_point;

/** What is known around a point, and the weights of liquid and of boundary particles in front of it. */
typedef struct surroundings {
    equations velocity, density;
    double liquid, walls;
} surroundings;

static surface_point surface_before(const sph2d__system *s, size_t b)
{
    const sph2d__store *w = &s->walls;
    sph2d_vec2 at = {w->x[b] + w->depth[b] * w->normal_x[b], w->y[b] + w->depth[b] * w->normal_y[b]};
    return (surface_point){at, sph2d__surface_velocity(s, b), {w->normal_x[b], w->normal_y[b]}};
}

static double weight_at(double x, double y)
{
    double t = fmax(1 - hypot(x, y), 0);
    return t * t * t;
}

/** Adds the liquid around a point. */
static void add_liquid(const sph2d__system *s, const surface_point *p, surroundings *to)
{
    const sph2d__store *f = &s->fluid;
    uint32_t cell = sph2d__cells_find(&s->fluid_cells, p->at.x, p->at.y);
    if (cell == UINT32_MAX)
        return;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->fluid_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, i) {
        double x = (f->x[i] - p->at.x - ranges.x[r]) / s->support, y = (f->y[i] - p->at.y - ranges.y[r]) / s->support;
        double weight = weight_at(x, y), terms[TERMS];
        set_terms(terms, x, y);
        if (!(weight > 0))
            continue;
        add_equation(&to->velocity, terms, weight, f->vx[i] - p->velocity.x, f->vy[i] - p->velocity.y);
        add_equation(&to->density, terms, weight, f->density[i] - s->rest_density, 0);
        to->liquid += x * p->normal.x + y * p->normal.y > 0 ? weight : 0;
    }
}

/** Adds what is known at the surface before boundary particle b, less `shift`, around a point. */
static void add_surface(const sph2d__system *s, const surface_point *p, size_t b, sph2d_vec2 shift, surroundings *to)
{
    surface_point other = surface_before(s, b);
    double x = (other.at.x - p->at.x - shift.x) / s->support, y = (other.at.y - p->at.y - shift.y) / s->support;
    double weight = weight_at(x, y), terms[TERMS], nx = other.normal.x, ny = other.normal.y;
    if (!(weight > 0))
        return;
    set_terms(terms, x, y);
    add_equation(&to->velocity, terms, weight, other.velocity.x - p->velocity.x, other.velocity.y - p->velocity.y);
    const double slope[TERMS] = {0, nx, ny, 2 * x * nx, x * ny + y * nx, 2 * y * ny};
    add_equation(&to->density, slope, GRADIENT_WEIGHT * weight, sph2d__fitted_slope(s, b, s->rest_density, other.at),
                 0);
}

/** Adds the walls around a point. */
static void add_walls(const sph2d__system *s, const surface_point *p, surroundings *to)
{
    const sph2d__store *w = &s->walls;
    uint32_t cell = sph2d__cells_find(&s->wall_cells, p->at.x, p->at.y);
    if (cell == UINT32_MAX)
        return;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, b) {
        double x = (w->x[b] - p->at.x - ranges.x[r]) / s->support, y = (w->y[b] - p->at.y - ranges.y[r]) / s->support;
        if (x * p->normal.x + y * p->normal.y > 0)
            to->walls += weight_at(x, y) * w->mass[b] / s->mass;
        if (w->depth[b] <= FIRST_LAYER * s->spacing)
            add_surface(s, p, b, (sph2d_vec2){ranges.x[r], ranges.y[r]}, to);
    }
}

sph2d__wall_force sph2d__fitted_surface_force(const sph2d__system *s, size_t b)
{
    const sph2d__store *w = &s->walls;
    const surface_point p = surface_before(s, b);
    surroundings around = {0};
    double v[2][TERMS], rho[2][TERMS];
    add_liquid(s, &p, &around);
    add_walls(s, &p, &around);
    if (around.liquid <= around.walls)
        return (sph2d__wall_force){0};
    solve_or_less(&around.velocity, 1, v);
    solve_or_less(&around.density, 0, rho);
    double nx = w->normal_x[b], ny = w->normal_y[b], length = w->skin[b], mu = s->viscosity / s->support;
    double press = sph2d__pressure_of(s, s->rest_density + rho[0][0]) * length;
    double shear = v[0][2] + v[1][1]; /* du/dy + dv/dx */
    return (sph2d__wall_force){
        .pressure = {press * nx, press * ny},
        .friction = {-mu * length * (2 * v[0][1] * nx + shear * ny), -mu * length * (shear * nx + 2 * v[1][2] * ny)}};
}
