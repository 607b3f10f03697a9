/* SPDX-License-Identifier: MIT */
/** @file snapshot.c
 *  Accessors of a snapshot in memory. */
#include "files/snapshot.h"

#include <stdlib.h>
#include <string.h>

void sph2d_snapshot_destroy(sph2d_snapshot *snapshot)
{
    if (!snapshot)
        return;
    sph2d__pool_free(&snapshot->pool);
    free(snapshot);
}

sph2d_snapshot_info sph2d_snapshot_get_info(const sph2d_snapshot *snapshot)
{
    if (!snapshot)
        return (sph2d_snapshot_info){0};
    return snapshot->info;
}

sph2d_state sph2d_snapshot_state(const sph2d_snapshot *snapshot)
{
    if (!snapshot)
        return (sph2d_state){0};
    return (sph2d_state){snapshot->state_version, snapshot->arrays, snapshot->array_count};
}

const sph2d_array *sph2d_snapshot_array(const sph2d_snapshot *snapshot, sph2d_group group, const char *name)
{
    if (!snapshot || !name)
        return NULL;
    for (size_t i = 0; i < snapshot->array_count; ++i)
        if (snapshot->arrays[i].group == group && strcmp(snapshot->arrays[i].name, name) == 0)
            return &snapshot->arrays[i];
    return NULL;
}
