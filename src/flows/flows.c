/* SPDX-License-Identifier: MIT */
/** @file flows.c
 *  The table of known flows, and what all share: checks of the numbers and the loop over points. */
#include <math.h>
#include <stdbool.h>

#include "flows/flow.h"

/* The parameters of a kind, besides its centre and the density. */
enum {
    SPEED = 1,      /* any */
    LENGTH = 2,     /* > 0 */
    DEPTH = 4,      /* > 0 */
    VISCOUS = 8,    /* viscosity > 0 */
    DOWNWARDS = 16, /* gravity (0, -g), g > 0 */
    AXES = 32,      /* of an ellipse, followed in time */
    START = 64      /* known at time 0 alone */
};

static const struct kind {
    const char *name;
    sph2d__flow_function *at;
    unsigned reads;
} kinds[] = {
    [SPH2D_FLOW_NONE] = {"none", NULL, 0},
    [SPH2D_FLOW_STILL] = {"still", sph2d__flow_still, 0},
    [SPH2D_FLOW_TAYLOR_GREEN] = {"taylor_green", sph2d__flow_taylor_green, SPEED | LENGTH},
    [SPH2D_FLOW_GRESHO] = {"gresho", sph2d__flow_gresho, SPEED | LENGTH},
    [SPH2D_FLOW_POISEUILLE] = {"poiseuille", sph2d__flow_poiseuille, SPEED | LENGTH | VISCOUS},
    [SPH2D_FLOW_COUETTE] = {"couette", sph2d__flow_couette, SPEED | LENGTH | VISCOUS},
    [SPH2D_FLOW_STANDING_WAVE] = {"standing_wave", sph2d__flow_standing_wave, SPEED | LENGTH | DEPTH | DOWNWARDS},
    [SPH2D_FLOW_STRAIN] = {"strain", sph2d__flow_strain, SPEED | LENGTH | AXES},
    [SPH2D_FLOW_ROTATION] = {"rotation", sph2d__flow_rotation, SPEED | LENGTH},
    [SPH2D_FLOW_PATCH] = {"patch", sph2d__flow_patch, SPEED | LENGTH | START},
    [SPH2D_FLOW_DROP] = {"drop", sph2d__flow_drop, SPEED | LENGTH},
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* Longest time of a strain, in units of one over its largest rate: half a second of computing. */
static const double LONGEST_STRAIN = 1e4;

sph2d_flow sph2d_flow_default(void)
{
    return (sph2d_flow){.kind = SPH2D_FLOW_NONE};
}

const char *sph2d_flow_name(sph2d_flow_kind kind)
{
    return (unsigned)kind < KINDS ? kinds[kind].name : "unknown";
}

/* ---- checks ------------------------------------------------------------------------------------------------------ */

static sph2d_status refuse(sph2d_report *report, sph2d_code code, const char *message)
{
    sph2d_report_add(report, SPH2D_ERROR, code, NULL, "%s", message);
    return SPH2D_INVALID;
}

/** A fault unless the value is finite. */
static bool is_finite(sph2d_report *report, const char *what, double value)
{
    if (!isfinite(value))
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL, "%s of a flow is %g: must be finite", what,
                         value);
    return isfinite(value);
}

/** A fault unless the value is above 0. */
static bool is_positive(sph2d_report *report, const char *what, double value)
{
    if (!(value > 0))
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL, "%s of a flow is %g: must be above 0",
                         what, value);
    return value > 0;
}

/** A fault unless the value is 0 or above. */
static bool is_not_negative(sph2d_report *report, const char *what, double value)
{
    if (!(value >= 0))
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL, "%s of a flow is %g: must be at least 0",
                         what, value);
    return value >= 0;
}

/** Checks the scene's parameters. */
static bool check_context(const sph2d_flow_context *c, sph2d_report *report)
{
    bool good = is_positive(report, "the density", c->density) && is_finite(report, "the density", c->density);
    good &= is_not_negative(report, "the viscosity", c->dynamic_viscosity) &&
            is_finite(report, "the viscosity", c->dynamic_viscosity);
    good &= is_not_negative(report, "the surface tension", c->surface_tension) &&
            is_finite(report, "the surface tension", c->surface_tension);
    good &= is_finite(report, "gravity", c->gravity[0]) && is_finite(report, "gravity", c->gravity[1]);
    good &= is_not_negative(report, "the central force's rate", c->central_rate) &&
            is_finite(report, "the central force's rate", c->central_rate);
    return good;
}

/** Checks the flow's own parameters, if its kind reads them. */
static bool check_flow(const sph2d_flow *f, unsigned reads, sph2d_report *report)
{
    bool good = is_finite(report, "the centre", f->center[0]) && is_finite(report, "the centre", f->center[1]);
    if (reads & SPEED)
        good &= is_finite(report, "the speed", f->speed);
    if (reads & LENGTH)
        good &= is_positive(report, "the length", f->length) && is_finite(report, "the length", f->length);
    if (reads & DEPTH)
        good &= is_positive(report, "the depth", f->depth);
    return good;
}

/** Checks what a kind requires of the scene and the time; all numbers are in range. */
static sph2d_status check_kind(const sph2d__flow_moment *m, unsigned reads, sph2d_report *report)
{
    const sph2d_flow_context *c = m->context;
    if ((reads & VISCOUS) && !(m->viscosity > 0))
        return refuse(report, SPH2D_CODE_OUT_OF_RANGE, "a flow between walls needs a viscosity above 0");
    if ((reads & DOWNWARDS) && !(c->gravity[0] == 0 && c->gravity[1] < 0))
        return refuse(report, SPH2D_CODE_OUT_OF_RANGE, "a standing wave needs gravity straight down, (0, -g)");
    if ((reads & START) && m->time > 0)
        return refuse(report, SPH2D_CODE_UNSUPPORTED, "the flow 'patch' is known at time 0 alone");
    if ((reads & AXES) && !(m->time * sph2d__flow_strain_pace(m->flow, c) <= LONGEST_STRAIN))
        return refuse(report, SPH2D_CODE_OUT_OF_RANGE, "the time is too long to follow the flow 'strain'");
    return SPH2D_OK;
}

/** Checks everything and makes the moment. */
static sph2d_status begin(sph2d__flow_moment *m, const sph2d_flow *flow, const sph2d_flow_context *context, double time,
                          sph2d_report *report)
{
    if (!flow || !context)
        return refuse(report, SPH2D_CODE_GENERAL, "a flow and its context must be given, not NULL");
    if ((unsigned)flow->kind >= KINDS || !kinds[flow->kind].at)
        return refuse(report, SPH2D_CODE_GENERAL, "unknown flow");
    unsigned reads = kinds[flow->kind].reads;
    bool good = is_not_negative(report, "the time", time) && is_finite(report, "the time", time);
    good &= check_flow(flow, reads, report);
    good &= check_context(context, report);
    if (!good)
        return SPH2D_INVALID;
    *m = (sph2d__flow_moment){flow, context, time, context->dynamic_viscosity / context->density, 0, 0, 0};
    return check_kind(m, reads, report);
}

/* ---- values ------------------------------------------------------------------------------------------------------ */

sph2d_status sph2d_flow_values(const sph2d_flow *flow, const sph2d_flow_context *context, double time, size_t count,
                               const double *x, const double *y, double *vx, double *vy, double *pressure,
                               sph2d_report *report)
{
    sph2d__flow_moment m;
    sph2d_status status = begin(&m, flow, context, time, report);
    if (status != SPH2D_OK)
        return status;
    if (count > 0 && (!x || !y))
        return refuse(report, SPH2D_CODE_GENERAL, "the points of a flow must be given, not NULL");
    if (kinds[flow->kind].reads & AXES)
        sph2d__flow_strain_axes(&m);
    for (size_t i = 0; i < count; ++i) {
        sph2d__flow_value value = kinds[flow->kind].at(&m, x[i] - flow->center[0], y[i] - flow->center[1]);
        if (vx)
            vx[i] = value.vx;
        if (vy)
            vy[i] = value.vy;
        if (pressure)
            pressure[i] = value.pressure;
    }
    return SPH2D_OK;
}

sph2d_status sph2d_flow_axes(const sph2d_flow *flow, const sph2d_flow_context *context, double time, double *a,
                             double *b, double *rate, sph2d_report *report)
{
    sph2d__flow_moment m;
    sph2d_status status = begin(&m, flow, context, time, report);
    if (status != SPH2D_OK)
        return status;
    if (!(kinds[flow->kind].reads & AXES))
        return refuse(report, SPH2D_CODE_GENERAL, "only the flow 'strain' has axes");
    sph2d__flow_strain_axes(&m);
    if (a)
        *a = m.a;
    if (b)
        *b = m.b;
    if (rate)
        *rate = m.rate;
    return SPH2D_OK;
}
