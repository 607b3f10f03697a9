/* SPDX-License-Identifier: MIT */
/** @file probes.c
 *  Time series: one row a kind. */
#include "probes/probes.h"

typedef struct row {
    sph2d__probe_kind *evaluate;
    const char *columns;
} row;

static const row rows[] = {
    [SPH2D_PROBE_ENERGY] = {sph2d__probe_energy, "kinetic [J/m],potential [J/m],momentum_x [kg/s],momentum_y [kg/s],"
                                                 "particles,speed_max [m/s],elastic [J/m],energy_error"},
    [SPH2D_PROBE_SPEED] = {sph2d__probe_speed, "vx [m/s],vy [m/s],speed [m/s],neighbours"},
    [SPH2D_PROBE_PRESSURE] = {sph2d__probe_pressure, "pressure [Pa],density [kg/m^3],neighbours"},
    [SPH2D_PROBE_ELEVATION] = {sph2d__probe_elevation, "elevation [m]"},
    [SPH2D_PROBE_EXTENT] = {sph2d__probe_extent, "left [m],right [m],bottom [m],top [m]"},
    [SPH2D_PROBE_AXES] = {sph2d__probe_axes,
                          "centre_x [m],centre_y [m],a [m],b [m],angle [rad],a_x [m],a_y [m],ab [m^2]"},
    [SPH2D_PROBE_QUALITY] = {sph2d__probe_quality,
                             "spacing_min,spacing_p1,paired,density_rms,density_max,mach,reported,counted"},
    [SPH2D_PROBE_MOMENTUM] = {sph2d__probe_momentum, "momentum_x [kg/s],momentum_y [kg/s],angular_momentum [kg m/s],"
                                                     "centre_x [m],centre_y [m]"},
    [SPH2D_PROBE_ERROR] = {sph2d__probe_error, "speed_l1,vector_l1,vector_max,pressure_l1,pressure_rms,kinetic"},
    [SPH2D_PROBE_VOLUME] = {sph2d__probe_volume, "volume [m^2],placed [m^2]"},
    [SPH2D_PROBE_LEVEL] = {sph2d__probe_level, "level [m]"},
};

const char *sph2d_probe_columns(sph2d_probe_kind kind)
{
    return (size_t)kind < sizeof rows / sizeof rows[0] ? rows[kind].columns : "";
}

size_t sph2d_sim_probe(const sph2d_sim *sim, size_t index, double values[SPH2D_PROBE_MAX_COLUMNS])
{
    if (index >= sim->scene.probe_count)
        return 0;
    const sph2d_probe *probe = &sim->scene.probes[index];
    return rows[probe->kind].evaluate(sim, probe, values);
}
