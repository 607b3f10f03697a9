/* SPDX-License-Identifier: MIT */
/** @file groups.c
 *  Bodies that hang together by contacts. Each group is solved by itself, so that its iterations end when it has come
 *  to an end, and its energy is its own. */
#include "contacts/contacts.h"

static bool moves(const sph2d__contacts *c, uint32_t body)
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

/** The root of the group of a contact; the number of bodies if neither body moves. */
static uint32_t root_of_contact(const sph2d__contacts *c, uint32_t *parents, const sph2d__contact *contact)
{
    if (moves(c, contact->a))
        return root_of(parents, contact->a);
    return moves(c, contact->b) ? root_of(parents, contact->b) : c->body_count;
}

/** Joins the bodies of all contacts, and marks those that move and have one. */
static void join(const sph2d__contacts *c, uint32_t *parents, bool *touched)
{
    for (size_t i = 0; i < c->contact_count; ++i) {
        uint32_t a = c->contacts[i].a, b = c->contacts[i].b;
        if (moves(c, a))
            touched[a] = true;
        if (moves(c, b))
            touched[b] = true;
        if (!moves(c, a) || !moves(c, b))
            continue;
        a = root_of(parents, a);
        b = root_of(parents, b);
        /* The smaller number is the root, whatever the order of contacts. */
        parents[a > b ? a : b] = a > b ? b : a;
    }
}

/** Turns counts of items by group into the ends of the groups before, from which sorting counts up to their own. */
static void to_begins(size_t *counts, size_t count)
{
    size_t sum = 0;
    for (size_t g = 0; g < count; ++g) {
        size_t own = counts[g];
        counts[g] = sum;
        sum += own;
    }
}

/** Sorts bodies and contacts by groups; `number` has the number of the group of each root. */
static void sort(const sph2d__contacts *c, uint32_t *parents, const bool *touched, const uint32_t *number,
                 sph2d__groups *groups)
{
    for (uint32_t i = 0; i < c->body_count; ++i)
        if (touched[i])
            ++groups->body_end[number[root_of(parents, i)]];
    for (size_t i = 0; i < c->contact_count; ++i) {
        uint32_t root = root_of_contact(c, parents, &c->contacts[i]);
        if (root < c->body_count)
            ++groups->contact_end[number[root]];
    }
    to_begins(groups->body_end, groups->count);
    to_begins(groups->contact_end, groups->count);
    for (uint32_t i = 0; i < c->body_count; ++i)
        if (touched[i])
            groups->bodies[groups->body_end[number[root_of(parents, i)]]++] = i;
    for (size_t i = 0; i < c->contact_count; ++i) {
        uint32_t root = root_of_contact(c, parents, &c->contacts[i]);
        if (root < c->body_count)
            groups->contacts[groups->contact_end[number[root]]++] = (uint32_t)i;
    }
}

sph2d_status sph2d__find_groups(sph2d__contacts *c, sph2d__groups *groups)
{
    size_t n = c->body_count;
    uint32_t *parents = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *parents);
    uint32_t *number = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *number);
    bool *touched = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *touched);
    groups->bodies = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *groups->bodies);
    groups->contacts = sph2d__arena_alloc(&c->arena, &c->memory, c->contact_count, sizeof *groups->contacts);
    groups->body_end = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *groups->body_end);
    groups->contact_end = sph2d__arena_alloc(&c->arena, &c->memory, n, sizeof *groups->contact_end);
    if (!parents || !number || !touched || !groups->bodies || !groups->contacts || !groups->body_end ||
        !groups->contact_end)
        return SPH2D_NOMEM;
    for (uint32_t i = 0; i < c->body_count; ++i)
        parents[i] = i;
    join(c, parents, touched);
    for (uint32_t i = 0; i < c->body_count; ++i)
        if (touched[i] && root_of(parents, i) == i)
            number[i] = (uint32_t)groups->count++;
    sort(c, parents, touched, number, groups);
    return SPH2D_OK;
}
