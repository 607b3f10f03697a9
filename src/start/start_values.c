/* SPDX-License-Identifier: MIT */
/** @file start_values.c
 *  Liquid that starts with the values of a table or a snapshot. */
#include <stdio.h>

#include "methods/common/state_equation.h"
#include "scene/cubic.h"
#include "scene/method_table.h"
#include "start/cloud.h"
#include "start/start.h"

/** Sets the density of a particle to that of a pressure, with methods that do not compute it. */
static void set_pressure(sph2d_sim *sim, size_t i, double pressure)
{
    if (!sph2d__method_row_of(&sim->world.scene.method)->summed_density)
        sim->system.fluid.density[i] = sph2d__density_of(&sim->system, pressure);
}

/* ---- tables ------------------------------------------------------------------------------------------------------ */

/** A value of a grid by the weights along x and y. */
static double value_at(const sph2d_grid *grid, const double *values, const sph2d__cubic *x, const sph2d__cubic *y)
{
    double sum = 0;
    for (size_t j = 0; j < y->count; ++j) {
        const double *row = values + (y->first + j) * grid->nx + x->first;
        double along = 0;
        for (size_t i = 0; i < x->count; ++i)
            along += x->weight[i] * row[i];
        sum += y->weight[j] * along;
    }
    return sum;
}

static bool is_in_grid(const sph2d_grid *g, double x, double y, double slack)
{
    return x >= g->x[0] - slack && x <= g->x[g->nx - 1] + slack && y >= g->y[0] - slack && y <= g->y[g->ny - 1] + slack;
}

static sph2d_status refuse_place(const sph2d_grid *g, double x, double y, const char *key, sph2d_report *report)
{
    char path[80];
    snprintf(path, sizeof path, "%s.table", key);
    sph2d_diagnostic *d =
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUTSIDE, path,
                         "liquid at (%g, %g) lies outside the table, which reaches from (%g, %g) to (%g, %g)", x, y,
                         g->x[0], g->y[0], g->x[g->nx - 1], g->y[g->ny - 1]);
    sph2d_diagnostic_hint(d, "add rows to the table, or make the liquid smaller");
    return SPH2D_SCENE;
}

static sph2d_status start_table(sph2d_sim *sim, const sph2d_grid *grid, size_t first, const char *key,
                                sph2d_report *report)
{
    sph2d__store *f = &sim->system.fluid;
    double slack = 1e-6 * sim->world.scene.spacing; /* rounding */
    for (size_t i = first; i < f->count; ++i) {
        if (!is_in_grid(grid, f->x[i], f->y[i], slack))
            return refuse_place(grid, f->x[i], f->y[i], key, report);
        sph2d__cubic x = sph2d__cubic_at(grid->x, 1, grid->nx, f->x[i]);
        sph2d__cubic y = sph2d__cubic_at(grid->y, 1, grid->ny, f->y[i]);
        f->vx[i] += grid->vx ? value_at(grid, grid->vx, &x, &y) : 0;
        f->vy[i] += grid->vy ? value_at(grid, grid->vy, &x, &y) : 0;
        if (grid->pressure)
            set_pressure(sim, i, value_at(grid, grid->pressure, &x, &y));
    }
    return SPH2D_OK;
}

/* ---- snapshots --------------------------------------------------------------------------------------------------- */

static sph2d_status start_snapshot(sph2d_sim *sim, const sph2d_cloud *given, size_t first)
{
    sph2d__store *f = &sim->system.fluid;
    sph2d__cloud cloud;
    if (!sph2d__cloud_make(&cloud, given, sim))
        return SPH2D_NOMEM;
    for (size_t i = first; i < f->count; ++i) {
        double values[SPH2D__CLOUD_VALUES];
        if (!sph2d__cloud_values(&cloud, (sph2d_vec2){f->x[i], f->y[i]}, values))
            continue;
        f->vx[i] += values[SPH2D__CLOUD_VX];
        f->vy[i] += values[SPH2D__CLOUD_VY];
        set_pressure(sim, i, values[SPH2D__CLOUD_PRESSURE]);
    }
    sph2d__cloud_free(&cloud, &sim->memory);
    return SPH2D_OK;
}

/* ---- any --------------------------------------------------------------------------------------------------------- */

static sph2d_status refuse_unread(const char *key, const char *which, sph2d_report *report)
{
    char path[80];
    snprintf(path, sizeof path, "%s.%s", key, which);
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_MISSING_KEY, path,
                     "was not read: only a scene that is read from a file has files");
    return SPH2D_SCENE;
}

sph2d_status sph2d__sim_start(sph2d_sim *sim, const sph2d_start *start, size_t first, const char *key, bool lattice,
                              sph2d_report *report)
{
    if (start->table.file && start->table.nx == 0)
        return refuse_unread(key, "table", report);
    if (start->snapshot.file && start->snapshot.count == 0)
        return refuse_unread(key, "snapshot", report);
    if (start->flow.kind != SPH2D_FLOW_NONE)
        return sph2d__sim_start_flow(sim, &start->flow, first, lattice, report);
    if (start->table.nx > 0)
        return start_table(sim, &start->table, first, key, report);
    return start->snapshot.count > 0 ? start_snapshot(sim, &start->snapshot, first) : SPH2D_OK;
}
