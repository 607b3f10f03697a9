/* SPDX-License-Identifier: MIT */
/** @file export_parts.c
 *  What the forms of an export share: the order of particles, texts in XML. */
#include <stdlib.h>

#include "export.h"

typedef struct row_of {
    uint64_t id;
    size_t index;
} row_of;

static int by_id(const void *a, const void *b)
{
    const row_of *p = a, *q = b;
    if (p->id != q->id)
        return p->id < q->id ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

size_t *export_order(const sph2d_snapshot *snapshot, sph2d_group group, size_t *count)
{
    /* Corners have no numbers of their own and keep their order. */
    const bool particles = group != SPH2D_GROUP_OUTLINE;
    const sph2d_array *ids = sph2d_snapshot_array(snapshot, group, particles ? "ParticleIDs" : "OutlineIDs");
    *count = ids ? ids->count : 0;
    row_of *rows = calloc(*count + 1, sizeof *rows);
    size_t *order = calloc(*count + 1, sizeof *order);
    if (rows && order) {
        for (size_t i = 0; i < *count; ++i)
            rows[i] = (row_of){particles ? ((const uint64_t *)ids->data[0])[i * ids->stride] : 0, i};
        qsort(rows, *count, sizeof *rows, by_id);
        for (size_t i = 0; i < *count; ++i)
            order[i] = rows[i].index;
    } else {
        free(order);
        order = NULL;
    }
    free(rows);
    return order;
}

void export_xml_text(const char *text, FILE *out)
{
    for (const char *c = text; *c != '\0'; ++c) {
        if (*c == '&')
            fputs("&amp;", out);
        else if (*c == '<')
            fputs("&lt;", out);
        else if (*c == '"')
            fputs("&quot;", out);
        else
            fputc(*c, out);
    }
}
