/* SPDX-License-Identifier: MIT */
/** @file wcsph_force.h
 *  The forces and rates of wcsph.h that do not depend on how time goes on. Every lane is a particle. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_FORCE_H
#define SPH2D_METHODS_WCSPH_WCSPH_FORCE_H

#include "methods/common/shortest.h"
#include "methods/common/slab.h"
#include "methods/wcsph/wcsph_pair.h"

/** Sums of a force over the pairs of a slice. */
typedef struct force_sums {
    sph2d__lanes px, py; /* P_j B_j G_ij */
    sph2d__lanes dx, dy; /* b s G_ij */
    sph2d__lanes vx, vy; /* w r G_ij, times the pair's viscosity where each particle has its own */
    sph2d__lanes diffused;
    sph2d__lanes rx, ry; /* r_j c_ji */
    sph2d__lanes ex, ey; /* P_k G_ik */
} force_sums;

/** What is summed up over pairs. */
typedef struct terms {
    bool whole;   /* what acts once a step: diffusion and e */
    bool viscous; /* viscosity */
    bool walled;  /* pressures' gradients, as some are at walls */
} terms;

/** Adds the pairs of some slots from k on. Density does not diffuse to images: pressure bends at a side, and would flow. */
SPH2D__INLINE void add_pairs(const sph2d__system *s, size_t first, size_t k, uint32_t slots, terms with, bool images,
                             force_sums *to)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__frozen *z = s->frozen;
    const sph2d__four own = sph2d__four_load(z->velocity + 4 * first);
    const sph2d__lanes theta = sph2d__four_load(z->press + 4 * first).d;
    const double limiter = SPH2D__LIMITER / s->sound_speed;
    const sph2d__lanes one = sph2d__lanes_all(1), most = sph2d__lanes_all(z->most_brake);
    const sph2d__lanes own_mu = s->viscosities ? sph2d__lanes_load(s->viscosities + first) : one;
    force_sums sum = *to;
    for (uint32_t slot = 0; slot < slots; ++slot, k += SPH2D__STRIDE) {
        SPH2D__ARRAY const uint32_t *j = n->index + k;
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k),
                           inverse = sph2d__floats_load(z->inverse + k);
        const sph2d__four q = sph2d__four_gather(z->press, j), v = sph2d__four_gather(z->velocity, j);
        sum.px += q.a * gx + q.b * gy;
        sum.py += q.b * gx + q.c * gy;
        const sph2d__lanes vx = own.a - v.a, vy = own.b - v.b, w = -inverse * (vx * gx + vy * gy);
        const sph2d__lanes apart = sph2d__minmod(w, w - sph2d__floats_load(z->linear_w + k));
        const sph2d__lanes size = sph2d__lanes_max(apart, -apart);
        const sph2d__lanes brake = sph2d__lanes_min(limiter * size, most) * apart;
        sum.dx += brake * gx;
        sum.dy += brake * gy;
        if (with.viscous) {
            sph2d__lanes rate = vx * sph2d__floats_load(z->rx + k) + vy * sph2d__floats_load(z->ry + k);
            if (s->viscosities) {
                const sph2d__lanes mu = sph2d__lanes_gather(s->viscosities, j);
                rate = rate * sph2d__lanes_where(mu + own_mu, (sph2d__lanes){0}, 2 * mu * own_mu / (mu + own_mu));
            }
            sum.vx += rate * gx;
            sum.vy += rate * gy;
        }
        if (with.whole) {
            const sph2d__lanes size_g = (gx * gx + gy * gy) * inverse;
            const sph2d__four rest = sph2d__four_gather(z->rest, j);
            const sph2d__lanes part = size_g - rest.c * gx - rest.d * gy;
            sum.rx += rest.a * part;
            sum.ry += rest.b * part;
            const sph2d__lanes jump = theta - q.d;
            if (!images)
                sum.diffused += sph2d__minmod(jump, jump - sph2d__floats_load(z->linear_theta + k)) * size_g;
        }
        if (with.walled) {
            const sph2d__lanes work = sph2d__lanes_gather(z->work, j);
            sum.ex += work * gx;
            sum.ey += work * gy;
        }
    }
    *to = sum;
}

/** Sums over the pairs of a slice; `without`: those without images. */
SPH2D__INLINE force_sums sum_pairs(const sph2d__system *s, size_t first, terms with, force_sums *without)
{
    SPH2D__ARRAY const sph2d__slice *at = &s->neighbours.slices[first / SPH2D__LANES];
    const uint32_t images = s->frozen->imaged[first / SPH2D__LANES], own = at->fluid - images;
    force_sums sum = {0};
    add_pairs(s, first, at->begin, own, with, false, &sum);
    *without = sum;
    if (images > 0)
        add_pairs(s, first, at->begin + (size_t)own * SPH2D__STRIDE, images, with, true, &sum);
    return sum;
}

/** The same; most sweeps find neither viscosity nor walls, and have a loop of their own. */
SPH2D__INLINE force_sums sum_forces(const sph2d__system *s, size_t first, bool whole, force_sums *without)
{
    const sph2d__frozen *z = s->frozen;
    const bool walled = z->flags[first / SPH2D__LANES] & SPH2D__FROZEN_WALLED,
               viscous = s->viscosity > 0 && (whole || z->thick);
    if (whole)
        return sum_pairs(s, first, (terms){true, viscous, walled}, without);
    return viscous || walled ? sum_pairs(s, first, (terms){false, viscous, walled}, without)
                             : sum_pairs(s, first, (terms){false, false, false}, without);
}

/** Adds the repulsion of close pairs to dx and dy, over V0 rho0 c0. */
SPH2D__INLINE void add_repulsion(const sph2d__system *s, size_t first, force_sums *sum, force_sums *without)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__frozen *z = s->frozen;
    SPH2D__ARRAY const sph2d__slice *at = &n->slices[first / SPH2D__LANES];
    const sph2d__period *period = &s->fluid_cells.period;
    const double strength = SPH2D__REPULSION * s->sound_speed / s->spacing, unit = 1 / (SPH2D__CLOSE * s->spacing);
    const sph2d__lanes x = sph2d__lanes_load(z->px + first), y = sph2d__lanes_load(z->py + first), none = {0};
    size_t k = at->begin + ((size_t)at->fluid + at->walls) * SPH2D__STRIDE;
    for (uint32_t slot = 0; slot < z->close[first / SPH2D__LANES]; ++slot, k += SPH2D__STRIDE) {
        const sph2d__lanes dx = sph2d__shortest(x - sph2d__lanes_gather(z->px, n->index + k), period->length_x);
        const sph2d__lanes dy = sph2d__shortest(y - sph2d__lanes_gather(z->py, n->index + k), period->length_y);
        const sph2d__lanes r = sph2d__lanes_sqrt(dx * dx + dy * dy);
        const sph2d__lanes t = sph2d__lanes_max(1 - unit * r, none),
                           push = sph2d__lanes_where(r, none, strength * t * t / r);
        sum->dx += push * dx;
        sum->dy += push * dy;
        for (int l = 0; l < SPH2D__LANES; ++l)
            if (n->index[k + (size_t)l] < z->first_image) {
                SPH2D__LANE(without->dx, l) += SPH2D__LANE(push, l) * SPH2D__LANE(dx, l);
                SPH2D__LANE(without->dy, l) += SPH2D__LANE(push, l) * SPH2D__LANE(dy, l);
            }
    }
}

/** A vector in each lane. */
typedef struct vectors {
    sph2d__lanes x, y;
} vectors;

SPH2D__INLINE vectors load(SPH2D__ARRAY const double *x, SPH2D__ARRAY const double *y, size_t i)
{
    return (vectors){sph2d__lanes_load(x + i), sph2d__lanes_load(y + i)};
}

SPH2D__INLINE sph2d__lanes dot(vectors a, vectors b)
{
    return a.x * b.x + a.y * b.y;
}

/** Adds the lanes of particles below `last` to a sum, one after another. */
SPH2D__INLINE void add_lanes(double *sum, sph2d__lanes a, size_t first, size_t last)
{
    for (int l = 0; l < SPH2D__LANES && first + (size_t)l < last; ++l)
        *sum += SPH2D__LANE(a, l);
}

/** l of particle i [J/m]. */
SPH2D__INLINE sph2d__lanes wall_brake(const sph2d__system *s, size_t i)
{
    const sph2d__frozen *z = s->frozen;
    const vectors wall = load(z->sx, z->sy, i), v = load(s->fluid.vx, s->fluid.vy, i);
    const sph2d__lanes none = {0};
    const double c = s->sound_speed;
    const sph2d__lanes size = sph2d__lanes_sqrt(dot(wall, wall)),
                       to = 2 * dot(v, wall) - sph2d__lanes_load(z->wall_rate + i);
    const sph2d__lanes w = sph2d__lanes_where(size, none, to / size);
    const sph2d__lanes apart = sph2d__lanes_max(sph2d__minmod(w, w - sph2d__lanes_load(z->wall_linear + i)), none);
    return s->mass * c * sph2d__lanes_min(SPH2D__LIMITER / c * apart, sph2d__lanes_all(z->most_brake)) * apart;
}

/** a, with the logarithm of density theta and the walls' part of D: 0 in films under tension that leave, which no wall holds. */
SPH2D__INLINE sph2d__lanes acts_at(const sph2d__system *s, size_t i, sph2d__lanes theta, sph2d__lanes by)
{
    const sph2d__lanes none = {0}, one = sph2d__lanes_all(1), walled = sph2d__lanes_load(s->frozen->walled + i);
    if (s->fills)
        return one;
    return sph2d__lanes_where(sph2d__lanes_max(sph2d__lanes_max(theta, by), walled), none, one);
}

/** The force of walls: of the pressure before them, and l, which is also returned. */
SPH2D__INLINE sph2d__lanes add_walls(const sph2d__system *s, size_t i, const force_sums *f, vectors *force)
{
    sph2d__frozen *z = s->frozen;
    const vectors wall = load(z->sx, z->sy, i);
    const sph2d__lanes p = sph2d__lanes_load(z->work + i), brake = wall_brake(s, i);
    const sph2d__lanes press = 2 * sph2d__lanes_load(z->acts + i) * p + brake,
                       walled = sph2d__lanes_load(z->walled + i);
    const vectors e = {f->ex - p * sph2d__lanes_load(z->nx + i), f->ey - p * sph2d__lanes_load(z->ny + i)};
    force->x += dot(load(z->cxx, z->cxy, i), e) - press * wall.x;
    force->y += dot(load(z->cyx, z->cyy, i), e) - press * wall.y;
    sph2d__lanes_store(z->brake + i, brake);
    sph2d__lanes_store(z->mean_work + i, sph2d__lanes_load(z->mean_work + i) + z->share * press);
    sph2d__lanes_store(z->mean_ex + i,
                       sph2d__lanes_load(z->mean_ex + i) + z->share * dot(load(z->axx, z->axy, i), e) * walled);
    sph2d__lanes_store(z->mean_ey + i,
                       sph2d__lanes_load(z->mean_ey + i) + z->share * dot(load(z->axy, z->ayy, i), e) * walled);
    return brake;
}

/** By how much its image in the walls before it repels a particle that would else have velocity v, along their normal: as a
 *  close particle there does, but not more than stops it. What is before it changes from step to step at edges, so that such
 *  a force has no potential: it gave a splash on two bent sheets 11 % of its energy. */
SPH2D__INLINE sph2d__lanes repelled(const sph2d__system *s, size_t i, vectors n, vectors v)
{
    sph2d__frozen *z = s->frozen;
    const vectors at = load(z->px, z->py, i), middle = load(s->fluid.x, s->fluid.y, i);
    const double c = s->sound_speed, unit = 1 / (SPH2D__CLOSE * s->spacing);
    const sph2d__lanes apart =
        2 * (sph2d__lanes_load(z->front + i) + (at.x - middle.x) * n.x + (at.y - middle.y) * n.y);
    const sph2d__lanes t = sph2d__lanes_max(1 - unit * apart, (sph2d__lanes){0});
    const sph2d__lanes away = dot(v, n) - sph2d__lanes_load(z->front_speed + i);
    const sph2d__lanes stop = s->mass / z->dt * sph2d__lanes_max(-away, (sph2d__lanes){0});
    const sph2d__lanes push = sph2d__lanes_min(s->mass * c * c * SPH2D__REPULSION / s->spacing * t * t, stop);
    sph2d__lanes_store(z->repelled + i, push);
    sph2d__lanes_store(z->mean_repelled + i, sph2d__lanes_load(z->mean_repelled + i) + z->share * push);
    return push;
}

/** The acceleration by forces that places and velocities alone determine. */
SPH2D__INLINE vectors fall(const sph2d__system *s, size_t i, vectors v)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__forces *forces = &s->forces;
    const vectors at = load(z->px, z->py, i);
    vectors a = {sph2d__lanes_all(forces->gravity.x), sph2d__lanes_all(forces->gravity.y)};
    for (int l = 0; z->varies && l < SPH2D__LANES && i + (size_t)l < s->fluid.count; ++l) {
        double ax = 0, ay = 0;
        sph2d__forces_add(
            forces,
            (sph2d__place){SPH2D__LANE(at.x, l), SPH2D__LANE(at.y, l), SPH2D__LANE(v.x, l), SPH2D__LANE(v.y, l)}, &ax,
            &ay);
        SPH2D__LANE(a.x, l) = ax;
        SPH2D__LANE(a.y, l) = ay;
    }
    return a;
}

/** The part of it whose work is of a kind, and is booked. */
SPH2D__INLINE vectors drive_of(const sph2d__system *s, size_t i, vectors v, sph2d__work_kind kind)
{
    const vectors at = load(s->frozen->px, s->frozen->py, i);
    vectors a = {{0}, {0}};
    for (int l = 0; l < SPH2D__LANES && i + (size_t)l < s->fluid.count; ++l) {
        double ax = 0, ay = 0;
        sph2d__forces_drive(
            &s->forces, kind,
            (sph2d__place){SPH2D__LANE(at.x, l), SPH2D__LANE(at.y, l), SPH2D__LANE(v.x, l), SPH2D__LANE(v.y, l)}, &ax,
            &ay);
        SPH2D__LANE(a.x, l) = ax;
        SPH2D__LANE(a.y, l) = ay;
    }
    return a;
}

/** Adds the friction of walls to an acceleration and to the drag. */
SPH2D__INLINE void rub(const sph2d__system *s, size_t i, vectors v, vectors *a, vectors *drag)
{
    sph2d__frozen *z = s->frozen;
    const double dt = z->dt, m = s->mass;
    vectors by = {{0}, {0}};
    if (z->rubs)
        by = load(z->rub_x, z->rub_y, i);
    if (z->sticks) {
        const vectors k = load(z->stick_x, z->stick_y, i);
        const sph2d__lanes xx = 1 + dt * sph2d__lanes_load(z->stick_xx + i),
                           xy = dt * sph2d__lanes_load(z->stick_xy + i),
                           yy = 1 + dt * sph2d__lanes_load(z->stick_yy + i);
        const vectors to = {v.x + dt * (a->x + by.x + k.x), v.y + dt * (a->y + by.y + k.y)};
        const sph2d__lanes unit = 1 / (xx * yy - xy * xy);
        const vectors next = {unit * (yy * to.x - xy * to.y), unit * (xx * to.y - xy * to.x)};
        by.x += k.x - (1 / dt) * ((xx - 1) * next.x + xy * next.y);
        by.y += k.y - (1 / dt) * (xy * next.x + (yy - 1) * next.y);
        sph2d__lanes_store(z->mean_vx + i, sph2d__lanes_load(z->mean_vx + i) + z->share * next.x);
        sph2d__lanes_store(z->mean_vy + i, sph2d__lanes_load(z->mean_vy + i) + z->share * next.y);
    }
    *a = (vectors){a->x + by.x, a->y + by.y};
    *drag = (vectors){drag->x + m * by.x, drag->y + m * by.y};
}

/** Sums up external forces `a`, at velocity v, and the work of those that have no potential. Returns that of those that take. */
SPH2D__INLINE sph2d__lanes drive(const sph2d__system *s, size_t i, size_t last, vectors a, vectors v, vectors middle,
                                 sph2d__slab_sum *sum)
{
    const double impulse = s->mass * s->frozen->dt;
    add_lanes(&sum->x, s->mass * a.x, i, last);
    add_lanes(&sum->y, s->mass * a.y, i, last);
    add_lanes(&sum->fourth, impulse * dot(drive_of(s, i, v, SPH2D__WORK), middle), i, last);
    return impulse * dot(drive_of(s, i, v, SPH2D__LOSS), middle);
}

/** Particles in reservoirs keep their velocity. */
SPH2D__INLINE void hold(const sph2d__system *s, size_t i, size_t last, vectors v, vectors *a, sph2d__slab_sum *sum)
{
    const sph2d__lanes held = sph2d__lanes_load(s->frozen->held + i);
    add_lanes(&sum->third, s->mass * s->frozen->dt * held * dot(v, *a), i, last);
    sph2d__lanes_store(s->frozen->withheld_x + i, held * a->x);
    sph2d__lanes_store(s->frozen->withheld_y + i, held * a->y);
    *a = (vectors){(1 - held) * a->x, (1 - held) * a->y};
}

/** The factor of e over m c0, for so many acoustic steps at once [1/m]. No row of r has a larger sum than 2, so that a step
 *  that takes 1/4 of e takes at most all. */
SPH2D__INLINE double smoothing(const sph2d__system *s, double steps)
{
    const double most = 0.25 / (s->sound_speed * s->frozen->dt), rate = steps * SPH2D__SMOOTHING / s->spacing;
    return rate < most ? rate : most;
}

/** The factor of the sums of viscosity, which acts at once for so many acoustic steps or, if it is thick, in each. */
SPH2D__INLINE double viscosity(const sph2d__system *s, double steps)
{
    const double mu = s->viscosities ? 1 : s->viscosity;
    return (s->frozen->thick ? 1 : steps) * s->mass / s->rest_density * mu * s->central_weight;
}

/** What r_i takes in e, with the sum of |G| `weight` and that of G `n`. */
SPH2D__INLINE vectors own_rest(const sph2d__frozen *z, size_t i, sph2d__lanes weight, vectors n)
{
    const sph2d__four rest = sph2d__four_load(z->rest + 4 * i);
    const sph2d__lanes part = weight + rest.c * n.x + rest.d * n.y;
    return (vectors){rest.a * part, rest.b * part};
}

/** The forces d and e. */
SPH2D__INLINE vectors dissipate(const sph2d__system *s, size_t i, const force_sums *f, double hv)
{
    const sph2d__frozen *z = s->frozen;
    const double strength = s->mass * s->sound_speed; /* V0 rho0 c0 */
    const vectors own = own_rest(z, i, sph2d__lanes_load(z->weight + i), load(z->nx, z->ny, i));
    return (vectors){strength * (f->dx + hv * (f->rx - own.x)), strength * (f->dy + hv * (f->ry - own.y))};
}

/** A motion as neighbours see it, but for the part of z that walls' own motion adds. */
SPH2D__INLINE sph2d__four seen_motion(const sph2d__frozen *z, size_t i, vectors v, bool walls)
{
    const sph2d__lanes none = {0};
    sph2d__four seen = {v.x, v.y, none, none};
    if (walls) {
        seen.c = dot(load(z->cxx, z->cyx, i), v);
        seen.d = dot(load(z->cxy, z->cyy, i), v);
    }
    return seen;
}

/** Adds an acceleration by sides to its mean over the step. */
SPH2D__INLINE void add_push(sph2d__frozen *z, size_t i, sph2d__lanes ax, sph2d__lanes ay)
{
    sph2d__lanes_store(z->push_x + i, sph2d__lanes_load(z->push_x + i) + z->share * ax);
    sph2d__lanes_store(z->push_y + i, sph2d__lanes_load(z->push_y + i) + z->share * ay);
}

/** What gravity beyond sides takes away, g_i - g. */
SPH2D__INLINE vectors turn(sph2d__frozen *z, size_t i, vectors gravity)
{
    const vectors turned = {-2 * gravity.x * sph2d__lanes_load(z->across_x + i),
                            -2 * gravity.y * sph2d__lanes_load(z->across_y + i)};
    add_push(z, i, turned.x, turned.y);
    return turned;
}

/** How sides push particles by the sums over images. */
SPH2D__INLINE void push_by_sides(const sph2d__system *s, size_t i, const force_sums *f, const force_sums *without,
                                 double once)
{
    sph2d__frozen *z = s->frozen;
    const double m = s->mass, strength = m * s->sound_speed, hv = smoothing(s, once);
    const double thick = viscosity(s, once);
    const sph2d__four q = sph2d__four_load(z->press + 4 * i);
    const vectors n = load(z->image_nx, z->image_ny, i);
    const vectors own = own_rest(z, i, sph2d__lanes_load(z->image_weight + i), n);
    const sph2d__lanes px = strength * (f->dx - without->dx + hv * (f->rx - without->rx - own.x)) +
                            thick * (f->vx - without->vx) - (f->px - without->px) - (q.a * n.x + q.b * n.y);
    const sph2d__lanes py = strength * (f->dy - without->dy + hv * (f->ry - without->ry - own.y)) +
                            thick * (f->vy - without->vy) - (f->py - without->py) - (q.b * n.x + q.c * n.y);
    add_push(z, i, px / m, py / m);
}

/* ---- rates ------------------------------------------------------------------------------------------------------- */

/** Sums of a rate of density: (v_i - v_j) G^T, and z_k . G_ik; and (v_i - v_j) |G|. */
typedef struct rate_sums {
    sph2d__lanes xx, xy, yx, yy, z, x, y;
} rate_sums;

SPH2D__INLINE rate_sums sum_rates(const sph2d__system *s, size_t first, bool rest)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__frozen *z = s->frozen;
    SPH2D__ARRAY const sph2d__slice *at = &n->slices[first / SPH2D__LANES];
    const sph2d__four own = sph2d__four_load(z->velocity + 4 * first);
    const bool beside = z->flags[first / SPH2D__LANES] & SPH2D__FROZEN_BESIDE;
    rate_sums sum = {0};
    for (size_t k = at->begin, slot = 0; slot < at->fluid; ++slot, k += SPH2D__STRIDE) {
        SPH2D__ARRAY const uint32_t *j = n->index + k;
        const sph2d__four v = sph2d__four_gather(z->velocity, j);
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k);
        const sph2d__lanes vx = own.a - v.a, vy = own.b - v.b;
        sum.xx += vx * gx;
        sum.xy += vx * gy;
        sum.yx += vy * gx;
        sum.yy += vy * gy;
        if (rest) {
            const sph2d__lanes size = (gx * gx + gy * gy) * sph2d__floats_load(z->inverse + k);
            sum.x += vx * size;
            sum.y += vy * size;
        }
        if (beside)
            sum.z += v.c * gx + v.d * gy;
    }
    return sum;
}

/** D by these sums, but for walls and what is theirs. */
SPH2D__INLINE sph2d__lanes liquid_rate(const sph2d__frozen *z, size_t i, const rate_sums *r)
{
    return sph2d__lanes_load(z->bxx + i) * r->xx + sph2d__lanes_load(z->bxy + i) * (r->xy + r->yx) +
           sph2d__lanes_load(z->byy + i) * r->yy + r->z;
}

/** r, over sum |G|, and A s. */
SPH2D__INLINE void keep_rest(sph2d__system *s, size_t i, const rate_sums *r)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__lanes smooth = sph2d__lanes_load(z->smooth + i), weight = sph2d__lanes_load(z->weight + i);
    const vectors k = load(z->kx, z->ky, i);
    const sph2d__lanes part = smooth * sph2d__lanes_where(weight, (sph2d__lanes){0}, 1 / weight);
    const sph2d__lanes rx = part * r->x + smooth * (r->xx * k.x + r->xy * k.y);
    const sph2d__lanes ry = part * r->y + smooth * (r->yx * k.x + r->yy * k.y);
    sph2d__four_store(z->rest + 4 * i, (sph2d__four){part * rx, part * ry, weight * k.x, weight * k.y});
}

#endif
