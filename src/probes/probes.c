/* SPDX-License-Identifier: MIT */
/** @file probes.c
 *  The table of probe kinds. */
#include "probes/probes.h"

static const struct {
    sph2d__probe_kind *evaluate;
    const char *columns;
} rows[] = {
#define ROW(name, word, columns_) [SPH2D_PROBE_##name] = {sph2d__probe_##word, columns_},
    SPH2D_PROBE_MAP(ROW)
#undef ROW
};

const char *sph2d_probe_columns(sph2d_probe_kind kind)
{
    return (size_t)kind < sizeof rows / sizeof rows[0] ? rows[kind].columns : "";
}

size_t sph2d_sim_probe(const sph2d_sim *sim, size_t index, double values[SPH2D_PROBE_MAX_COLUMNS])
{
    if (!sim || !values)
        return 0;
    if (index >= sim->world.scene.probe_count || sph2d__sim_is_broken(sim))
        return 0;
    const sph2d_probe *probe = &sim->world.scene.probes[index];
    size_t failures = sim->system.memory->failures, count = rows[probe->kind].evaluate(sim, probe, values);
    return sim->system.memory->failures == failures ? count : 0;
}
