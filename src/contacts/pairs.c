/* SPDX-License-Identifier: MIT */
/** @file pairs.c
 *  Pairs that are near each other: boxes sorted by where they begin along x, and swept. */
#include <math.h>
#include <stdlib.h>

#include "contacts/contacts.h"

/** A box in the order of the sweep. */
typedef struct entry {
    sph2d_box box;
    uint32_t index; /**< of placed */
} entry;

static int compare(const void *first, const void *second)
{
    const entry *a = first, *b = second;
    if (a->box.min.x != b->box.min.x)
        return a->box.min.x < b->box.min.x ? -1 : 1;
    return a->index < b->index ? -1 : a->index > b->index;
}

static bool overlap(const sph2d_box *a, const sph2d_box *b)
{
    return a->min.x <= b->max.x && b->min.x <= a->max.x && a->min.y <= b->max.y && b->min.y <= a->max.y;
}

static void shift(sph2d__placed *placed, double x, double y)
{
    placed->to = (sph2d_vec2){placed->to.x + x, placed->to.y + y};
    placed->box.min = (sph2d_vec2){placed->box.min.x + x, placed->box.min.y + y};
    placed->box.max = (sph2d_vec2){placed->box.max.x + x, placed->box.max.y + y};
}

/** Adds the images of one body by a period along x and y that come near `reach`. */
static sph2d_status add_images(sph2d__contacts *c, uint32_t body, double width, double height, const sph2d_box *reach)
{
    int along_x = width > 0, along_y = height > 0;
    for (int i = -along_x; i <= along_x; ++i) {
        for (int j = -along_y; j <= along_y; ++j) {
            sph2d__placed image = c->placed[body];
            image.image = true;
            shift(&image, i * width, j * height);
            if ((i == 0 && j == 0) || !overlap(&image.box, reach))
                continue;
            if (!sph2d__place_corners(c, &image) ||
                !sph2d__room_for_one(&c->memory, &c->placed, c->placed_count, &c->placed_room, sizeof *c->placed))
                return SPH2D_NOMEM;
            c->placed[c->placed_count++] = image;
        }
    }
    return SPH2D_OK;
}

/** Brings bodies into the domain and adds their images. */
static sph2d_status add_all_images(sph2d__contacts *c)
{
    sph2d_box reach = c->scene->domain;
    double width = c->scene->boundary.left == SPH2D_SIDE_PERIODIC ? reach.max.x - reach.min.x : 0;
    double height = c->scene->boundary.bottom == SPH2D_SIDE_PERIODIC ? reach.max.y - reach.min.y : 0;
    if (width == 0 && height == 0)
        return SPH2D_OK;
    double widest = 0, highest = 0;
    for (uint32_t i = 0; i < c->body_count; ++i) {
        sph2d__placed *body = &c->placed[i];
        shift(body, width > 0 ? -width * floor((body->to.x - reach.min.x) / width) : 0,
              height > 0 ? -height * floor((body->to.y - reach.min.y) / height) : 0);
        if (!sph2d__place_corners(c, body))
            return SPH2D_NOMEM;
        widest = fmax(widest, body->box.max.x - body->box.min.x);
        highest = fmax(highest, body->box.max.y - body->box.min.y);
    }
    /* All that bodies with their centres in the domain may meet: of each pair there is one of the first and an image of
     * the second. */
    reach.min = (sph2d_vec2){reach.min.x - widest, reach.min.y - highest};
    reach.max = (sph2d_vec2){reach.max.x + widest, reach.max.y + highest};
    sph2d_status status = SPH2D_OK;
    for (uint32_t i = 0; i < c->body_count && status == SPH2D_OK; ++i)
        status = add_images(c, i, width, height, &reach);
    return status;
}

/** Whether two meet at all, the first being a body, or an image of one at a wall; each pair of bodies in one order. */
static bool meet(const sph2d__contacts *c, const sph2d__placed *a, const sph2d__placed *b)
{
    if (a->number == c->body_count || (b->number != c->body_count && (a->image || a->number >= b->number)))
        return false;
    return sph2d__moves(c, a->number) || sph2d__moves(c, b->number);
}

static sph2d_status add_pair(sph2d__contacts *c, uint32_t a, uint32_t b)
{
    if (!meet(c, &c->placed[a], &c->placed[b]))
        return SPH2D_OK;
    if (!sph2d__room_for_one(&c->memory, &c->pairs, c->pair_count, &c->pair_room, sizeof *c->pairs))
        return SPH2D_NOMEM;
    c->pairs[c->pair_count++] = (sph2d__pair){a, b};
    return SPH2D_OK;
}

sph2d_status sph2d__find_pairs(sph2d__contacts *c)
{
    sph2d_status status = add_all_images(c);
    if (status != SPH2D_OK)
        return status;
    size_t count = c->placed_count;
    entry *entries = sph2d__arena_alloc(&c->arena, &c->memory, count, sizeof *entries);
    if (!entries)
        return SPH2D_NOMEM;
    for (size_t i = 0; i < count; ++i)
        entries[i] = (entry){c->placed[i].box, (uint32_t)i};
    qsort(entries, count, sizeof *entries, compare);
    for (size_t i = 0; i < count; ++i) {
        const sph2d_box *box = &entries[i].box;
        for (size_t j = i + 1; j < count && entries[j].box.min.x <= box->max.x && status == SPH2D_OK; ++j) {
            uint32_t a = entries[i].index, b = entries[j].index;
            if (!overlap(box, &entries[j].box))
                continue;
            status = add_pair(c, a, b);
            if (status == SPH2D_OK)
                status = add_pair(c, b, a);
        }
    }
    return status;
}
