/* SPDX-License-Identifier: MIT */
/** @file groups.c
 *  Bodies that hang together by contacts. Each group is solved by itself, so that its iterations end when it has come
 *  to an end, and its energy is its own. */
#include <stdlib.h>

#include "contacts/contacts.h"

bool sph2d__moves(const sph2d__contacts *c, uint32_t body)
{
    if (body == c->body_count)
        return false;
    const sph2d_contact_body *b = &c->bodies[body];
    return b->inverse_mass_x > 0 || b->inverse_mass_y > 0 || b->inverse_inertia > 0;
}

static uint32_t root_of(uint32_t *parents, uint32_t i)
{
    while (parents[i] != i) {
        parents[i] = parents[parents[i]];
        i = parents[i];
    }
    return i;
}

/** Joins the bodies of all contacts, and marks those that move and have one. */
static void join(const sph2d__contacts *c, uint32_t *parents, bool *touched)
{
    for (size_t i = 0; i < c->contact_count; ++i) {
        uint32_t a = c->contacts[i].a, b = c->contacts[i].b;
        const bool first = sph2d__moves(c, a), second = sph2d__moves(c, b);
        if (first)
            touched[a] = true;
        if (second)
            touched[b] = true;
        if (!first || !second)
            continue;
        a = root_of(parents, a);
        b = root_of(parents, b);
        /* The smaller number is the root, whatever the order of contacts. */
        parents[a > b ? a : b] = a > b ? b : a;
    }
}

static int compare(const void *first, const void *second)
{
    const sph2d__member *a = first, *b = second;
    if (a->group != b->group)
        return a->group < b->group ? -1 : 1;
    return a->index < b->index ? -1 : a->index > b->index;
}

sph2d_status sph2d__find_groups(sph2d__contacts *c, sph2d__groups *groups)
{
    size_t n = c->body_count;
    uint32_t *parents = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *parents);
    bool *touched = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *touched);
    groups->bodies = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *groups->bodies);
    groups->contacts = sph2d__arena_alloc(&c->arena, &c->memory, c->contact_count, sizeof *groups->contacts);
    if (!parents || !touched || !groups->bodies || !groups->contacts)
        return SPH2D_NOMEM;
    for (uint32_t i = 0; i < c->body_count; ++i)
        parents[i] = i;
    join(c, parents, touched);
    for (uint32_t i = 0; i < c->body_count; ++i)
        if (touched[i])
            groups->bodies[groups->body_count++] = (sph2d__member){root_of(parents, i), i};
    for (uint32_t i = 0; i < c->contact_count; ++i) {
        const sph2d__contact *contact = &c->contacts[i];
        uint32_t moving = sph2d__moves(c, contact->a) ? contact->a : contact->b;
        groups->contacts[i] = (sph2d__member){root_of(parents, moving), i};
    }
    qsort(groups->bodies, groups->body_count, sizeof *groups->bodies, compare);
    qsort(groups->contacts, c->contact_count, sizeof *groups->contacts, compare);
    return SPH2D_OK;
}
