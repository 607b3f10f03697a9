/* SPDX-License-Identifier: MIT */
/** @file implicit_spans.h
 *  What an implicit step (implicit.c) does to particles one by one, besides its sweeps, in C and in OpenCL C. */
#ifndef SPH2D_METHODS_WCSPH_IMPLICIT_SPANS_H
#define SPH2D_METHODS_WCSPH_IMPLICIT_SPANS_H

#include "methods/wcsph/implicit_close.h"

/* ---- before the solve -------------------------------------------------------------------------------------------- */

/** The pressures of a particle, as neighbours see them. */
SPH2D__INLINE void press(sph2d__frozen *z, size_t i, double p)
{
    SPH2D__ARRAY float *row = z->press + 4 * i;
    row[0] = (float)(p * z->bxx[i]);
    row[1] = (float)(p * z->bxy[i]);
    row[2] = (float)(p * z->byy[i]);
    row[3] = (float)p;
}

/** Particles where they are expected in the middle of the step, and no pressures. */
SPH2D__INLINE void expect_some(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        SPH2D__ARRAY float *row = z->press + 4 * i;
        row[0] = row[1] = row[2] = 0;
        row[3] = (float)f->log_density[i];
        z->px[i] += z->dt / 2 * f->vx[i];
        z->py[i] += z->dt / 2 * f->vy[i];
        z->work[i] = z->body_rate[i] = 0;
    }
}

/** What theta changes by over the step, into `summed`, if all of it is paid for: a part of its way. */
SPH2D__INLINE void relax_step(sph2d__system *s, size_t i, const double *part)
{
    s->frozen->summed[i] *= *part / sph2d__density_ratio(s->fluid.log_density[i]);
}

/** What friction takes of particle i, which had velocity v, in the step [J/kg]. Where the liquid is thick, of the flow that it
 *  had: what relaxation itself drives takes friction as the square of it, and cannot pay for it. */
SPH2D__INLINE double rubbed(const sph2d__frozen *z, size_t i, double vx, double vy)
{
    const double x = z->rubbed_x[i], y = z->rubbed_y[i], late = z->thick ? 0 : z->dt / 2;
    return -z->dt * (x * (vx + late * x) + y * (vy + late * y));
}

/** Adds what relaxation costs by the pressures that were found, what damping takes with them, and friction [J/m]. */
SPH2D__INLINE void add_cost(const sph2d__system *s, size_t i, sph2d__slab_sum *sum)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__store *f = &s->fluid;
    const double c2 = s->sound_speed * s->sound_speed, m = s->mass, part = z->ahead / z->dt;
    const double p = z->solved[i], relaxed = z->summed[i];
    const double then = z->soft[i] * p + (1 - c2 * z->soft[i]) * f->log_density[i];
    const double squeezed = (then - f->log_density[i]) / part, before = f->log_density[i] - part * relaxed;
    const double cost = m * c2 * relaxed * then, change = squeezed + relaxed;
    sum->first += cost;
    sum->second += cost + m * (p * squeezed - c2 * change * (before + change / 2));
    sum->third += m * rubbed(z, i, f->vx[i], f->vy[i]);
}

/* ---- the right side ---------------------------------------------------------------------------------------------- */

SPH2D__INLINE double known(const sph2d__system *s, size_t i)
{
    const double c2 = s->sound_speed * s->sound_speed;
    return s->frozen->holds && s->frozen->known[i] > 0 ? c2 * s->fluid.log_density[i] : 0;
}

/** The pressures that are known: those of reservoirs. */
SPH2D__INLINE void press_known(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i)
        press(s->frozen, i, known(s, i));
}

/** The liquid's motion in the middle of the step, without the pressures that are not known. */
SPH2D__INLINE void start_flow(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        const double w = z->ahead * (z->holds ? 1 - z->held[i] : 1);
        double x = f->vx[i] + w * (f->ax[i] + z->rubbed_x[i]), y = f->vy[i] + w * (f->ay[i] + z->rubbed_y[i]);
        if (z->holds) {
            x -= w * z->pull_back_x[i];
            y -= w * z->pull_back_y[i];
        }
        SPH2D__ARRAY float *row = z->velocity + 4 * i;
        row[0] = (float)x;
        row[1] = (float)y;
        row[2] = (float)(z->cxx[i] * x + z->cyx[i] * y + z->wall_zx[i]);
        row[3] = (float)(z->cxy[i] * x + z->cyy[i] * y + z->wall_zy[i]);
    }
}

/** The right side, with D of that motion in `product`, and where the solve starts: if it is done `again`, in `direction`. Adds
 *  their squares and product. */
SPH2D__INLINE void load_one(sph2d__system *s, size_t i, const bool *again, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    const double w = z->ahead, c2 = s->sound_speed * s->sound_speed;
    const double stiff = c2 + SPH2D__DAMPING * s->sound_speed * s->support / w;
    const bool held = z->holds && z->known[i] > 0;
    const double theta = s->fluid.log_density[i] + (*again ? 0 : z->diffused[i] + w / z->dt * z->summed[i]),
                 p = known(s, i);
    s->fluid.log_density[i] = theta;
    z->soft[i] = 1 / (held ? c2 : stiff);
    z->solved[i] = held ? p : 0;
    z->residual[i] = w * (z->product[i] - z->acts[i] * z->wall_rate[i]) + (held ? 0 : c2 / stiff * theta);
    z->first[i] = z->direction[i] = held ? 0 : *again ? z->direction[i] : c2 * theta;
    press(z, i, z->direction[i]);
    sph2d__slab_sum of = {0}; /* of this particle: whoever runs it adds that to the slab's at once */
    close_load(s, i, *again, &of);
    sum->first += of.first + (held ? 0 : z->residual[i] * z->residual[i]);
    sum->second += of.second + (held ? 0 : z->first[i] * z->residual[i]);
    sum->third += of.third + (held ? 0 : z->first[i] * z->first[i]);
}

/* ---- conjugate gradients ----------------------------------------------------------------------------------------- */

/** How far a step goes along the direction; what the next direction has of this one, and of the first pressures, to which it
 *  is made conjugate. */
typedef struct factors {
    double alpha, beta, gamma;
} factors;

/** A step along the direction. Adds the square of the residual, and its product with that of the first pressures. */
SPH2D__INLINE void step_one(sph2d__system *s, size_t i, const factors *f, sph2d__slab_sum *sum)
{
    sph2d__frozen *z = s->frozen;
    const double residual = z->residual[i] - f->alpha * z->product[i];
    const bool held = z->holds && z->known[i] > 0;
    z->solved[i] += f->alpha * z->direction[i];
    z->residual[i] = residual;
    sph2d__slab_sum of = {0};
    close_step(s, i, f->alpha, &of);
    sum->first += of.first + (held ? 0 : residual * residual);
    sum->second += of.second + (held ? 0 : residual * z->of_first[i]);
}

/** The next direction. */
SPH2D__INLINE void direct_one(sph2d__system *s, size_t i, const factors *f)
{
    sph2d__frozen *z = s->frozen;
    const bool held = z->holds && z->known[i] > 0;
    z->direction[i] = held ? 0 : z->residual[i] + f->beta * z->direction[i] - f->gamma * z->first[i];
    press(z, i, z->direction[i]);
    close_direct(s, i, f->beta, f->gamma);
}

SPH2D__INLINE void keep_first(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i) {
        s->frozen->of_first[i] = s->frozen->product[i];
        close_keep_first(s, i);
    }
}

/* ---- once more --------------------------------------------------------------------------------------------------- */

/** Makes the next solve start from what was found. */
SPH2D__INLINE void keep_found(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; ++i) {
        z->direction[i] = z->solved[i];
        close_push(s, i, false);
        z->pushed_x[i] = z->pushed_y[i] = z->stopped[i] = 0;
    }
}

/** Whether a wall holds a film by tension. */
SPH2D__INLINE bool clings(const sph2d__system *s, size_t i)
{
    const sph2d__frozen *z = s->frozen;
    const bool beside = z->sx[i] * z->sx[i] + z->sy[i] * z->sy[i] > 0;
    return beside && !s->fills && !(z->walled[i] > 0) && z->acts[i] > 0 && z->solved[i] < 0;
}

/** Whether a wall or another particle draws it. */
SPH2D__INLINE bool is_drawn(const sph2d__system *s, size_t i)
{
    return clings(s, i) || close_pulls(s, i);
}

/** Keeps a part of the relaxation, and nothing that draws. */
SPH2D__INLINE void take_back(sph2d__system *s, size_t i, const double *part)
{
    sph2d__frozen *z = s->frozen;
    s->fluid.log_density[i] -= (1 - *part) * z->ahead / z->dt * z->summed[i];
    z->summed[i] *= *part;
    if (clings(s, i))
        z->acts[i] = 0;
    close_drop(s, i);
}

/* ---- what was found ---------------------------------------------------------------------------------------------- */

SPH2D__INLINE void press_found(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i) {
        press(s->frozen, i, s->frozen->solved[i]);
        close_push(s, i, false);
    }
}

/** The same for good. */
SPH2D__INLINE void press_solved(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i) {
        press(s->frozen, i, s->frozen->solved[i]);
        close_push(s, i, true);
    }
}

/** The logarithm of density at the end of the step, by that at w. Adds what pressure and damping take, what is left of close
 *  pairs, over m dt/w, and what openings feed [J/m]. */
SPH2D__INLINE void compress(sph2d__system *s, size_t i, sph2d__slab_sum *sum)
{
    const sph2d__frozen *z = s->frozen;
    const double c2 = s->sound_speed * s->sound_speed, part = z->ahead / z->dt;
    const double theta = s->fluid.log_density[i], soft = z->soft[i], p = z->solved[i], relaxed = z->summed[i];
    const double damped = 1 - c2 * soft; /* e over c0^2 + e */
    double squeezed = (1 / part) * (soft * p + damped * theta - theta);
    const double before = theta - part * relaxed, change = squeezed + relaxed;
    sum->first += s->mass * (c2 * change * (before + 0.5 * change) - p * squeezed);
    sum->second += close_residual(s, i);
    if (z->holds) {
        sum->third += s->mass * c2 * z->known[i] * theta / part * z->residual[i];
        squeezed = (1 - z->known[i]) * squeezed;
    }
    s->fluid.log_density[i] = before + (squeezed + relaxed);
}

/** The accelerations by all but friction with the pressures that were found, which the next solve starts from. */
SPH2D__INLINE void expect_pressed(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; ++i) {
        z->rubbed_x[i] = s->fluid.ax[i] - z->pull_back_x[i];
        z->rubbed_y[i] = s->fluid.ay[i] - z->pull_back_y[i];
    }
}

#endif
