/* SPDX-License-Identifier: MIT */
/** @file gauge.c
 *  A pressure gauge with a round face and a rise time.
 *
 *  The mean of p over a disc of diameter D normal to the plane is a weighted mean along its diameter,
 *
 *      p_face = 8/(pi D^2) int p(s) sqrt(D^2/4 - s^2) ds = sum_k w_k p(s_k),   s_k = D/2 cos(k pi/(n + 1)),
 *      w_k = 2/(n + 1) sin^2(k pi/(n + 1)),   k = 1 ... n
 *
 *  (Gauss-Chebyshev quadrature of the second kind, exact up to degree 2n - 1). The gauge's reading P follows p_face as
 *  a first-order low-pass filter, tau dP/dt = p_face - P, which rises from 10 to 90 % of a step in
 *  t_r = tau ln 9. During a time step p_face is taken as linear; then, with e = exp(-dt/tau), m = (1 - e) tau/dt,
 *
 *      P(t + dt) = e P(t) + (m - e) p_face(t) + (1 - m) p_face(t + dt)
 *
 *  is exact. Without liquid there is air, of pressure 0. */
#include <math.h>

#include "base/pi.h"
#include "methods/common/on_device.h"
#include "probes/probes.h"

/* Quadrature points of a face: two per spacing, within these limits. */
enum { MIN_POINTS = 5, MAX_POINTS = 1001 };

static double points_of(const sph2d_sim *sim, const sph2d_probe *probe)
{
    return fmin(fmax(MIN_POINTS, ceil(2 * probe->size / sim->world.scene.spacing)), MAX_POINTS);
}

/** Pressure and density at a point; pressure 0 in air, density NaN. */
static sph2d_sample sample_at(const sph2d_sim *sim, sph2d_vec2 at)
{
    sph2d_sample sample;
    if (!sph2d_sim_sample(sim, at, &sample))
        sample.pressure = 0;
    return sample;
}

double sph2d__gauge_face(const sph2d_sim *sim, const sph2d_probe *probe)
{
    sph2d_vec2 along;
    const sph2d_vec2 at = sph2d__probe_place(sim, probe, &along);
    if (!(probe->size > 0))
        return sample_at(sim, at).pressure;
    double n = points_of(sim, probe), length = hypot(along.x, along.y), sum = 0;
    for (int k = 1; k <= (int)n; ++k) {
        double angle = k * SPH2D__PI / (n + 1), s = probe->size / 2 * cos(angle) / length;
        double weight = 2 / (n + 1) * sin(angle) * sin(angle);
        sum += weight * sample_at(sim, (sph2d_vec2){at.x + s * along.x, at.y + s * along.y}).pressure;
    }
    return sum;
}

double sph2d__gauge_reading(const sph2d_sim *sim, size_t index)
{
    const sph2d_probe *probe = &sim->world.scene.probes[index];
    return probe->rise_time > 0 ? sim->gauges[2 * index + 1] : sph2d__gauge_face(sim, probe);
}

static bool has_rise_time(const sph2d_probe *probe)
{
    return probe->kind == SPH2D_PROBE_PRESSURE && probe->rise_time > 0;
}

void sph2d__sim_start_gauges(sph2d_sim *sim)
{
    for (size_t i = 0; i < sim->world.scene.probe_count; ++i)
        if (has_rise_time(&sim->world.scene.probes[i]))
            sim->gauges[2 * i] = sim->gauges[2 * i + 1] = sph2d__gauge_face(sim, &sim->world.scene.probes[i]);
}

void sph2d__sim_read_gauges(sph2d_sim *sim, double dt)
{
    for (size_t i = 0; sim->gauges_lag && i < sim->world.scene.probe_count; ++i) {
        const sph2d_probe *probe = &sim->world.scene.probes[i];
        if (!has_rise_time(probe))
            continue;
        sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
        double *before = &sim->gauges[2 * i], *reading = before + 1, now = sph2d__gauge_face(sim, probe);
        double x = dt * log(9) / probe->rise_time, e = exp(-x), m = -expm1(-x) / x;
        *reading = e * *reading + (m - e) * *before + (1 - m) * now;
        *before = now;
    }
}
