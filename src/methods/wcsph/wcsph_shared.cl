/* SPDX-License-Identifier: MIT */
/* What the programs of methods `wcsph` and `constraint` share; KIND is the kernel's. */
#include "sim/shapes.cl"

#include "methods/wcsph/wcsph_frozen.h"

static inline sph2d__frozen placed_frozen(__global uchar *arena, __global const uchar *at)
{
    sph2d__frozen z = *(__global const sph2d__frozen *)at;
#define PLACE(name) z.name = BLOCK(double, z.name);
    SPH2D__FROZEN_ARRAYS(PLACE)
    SPH2D__IMPLICIT_ARRAYS(PLACE)
    PLACE(part)
    PLACE(left)
    PLACE(beyond)
    PLACE(lift)
#undef PLACE
#define PLACE(name) z.name = BLOCK(float, z.name);
    SPH2D__FROZEN_RECORDS(PLACE)
    SPH2D__FROZEN_PAIRS(PLACE)
#undef PLACE
    z.flags = BLOCK(unsigned char, z.flags);
    z.close = BLOCK(uint32_t, z.close);
    z.imaged = BLOCK(uint32_t, z.imaged);
    z.image_starts = BLOCK(uint32_t, z.image_starts);
    z.close_rows = BLOCK(sph2d__close_row, z.close_rows);
    z.first_close = BLOCK(size_t, z.first_close);
    z.end_close = BLOCK(size_t, z.end_close);
    z.close_starts = BLOCK(size_t, z.close_starts);
    place_store(arena, &z.images);
    place_cells(arena, &z.image_cells);
    return z;
}

#define SYSTEM                                                                                                         \
    sph2d__system s = placed(arena, numbers + system_at);                                                              \
    sph2d__frozen frozen = placed_frozen(arena, numbers + system_at + sizeof(sph2d__system));                          \
    s.frozen = &frozen;
#include "sim/kernels.cl"

#include "methods/wcsph/wcsph_gather.h"
#include "methods/wcsph/wcsph_spans.h"
#include "methods/wcsph/wcsph_walls.h"
#include "sim/wall_loads.h"

/* ---- what stands still ------------------------------------------------------------------------------------------- */

/* Adds up what each particle of a group has, in the order of the particles; where a particle's begin, and at the end of the group how many
 * there are. */
static inline uint32_t places_of(__local uint32_t *counts, uint32_t count, uint32_t *all)
{
    const size_t l = get_local_id(0);
    uint32_t before = 0, sum = 0;
    counts[l] = count;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (size_t k = 0; k < SPH2D__SLAB; ++k) {
        before += k < l ? counts[k] : 0;
        sum += counts[k];
    }
    *all = sum;
    return before;
}

KERNEL(count_images)
{
    __local uint32_t counts[SPH2D__SLAB];
    const size_t i = get_global_id(0);
    SYSTEM
    int in[MOST_IMAGES];
    uint32_t all;
    places_of(counts, i < count ? (uint32_t)images_of(&s, i, in) : 0, &all);
    if (get_local_id(0) == 0)
        ((__global uint32_t *)results)[get_group_id(0)] = all;
}

KERNEL(list_images)
{
    __local uint32_t counts[SPH2D__SLAB];
    const size_t i = get_global_id(0);
    SYSTEM
    int in[MOST_IMAGES];
    uint32_t all;
    const int own = i < count ? images_of(&s, i, in) : 0;
    const size_t first = frozen.image_starts[get_group_id(0)] + places_of(counts, (uint32_t)own, &all);
    for (int k = 0; k < own; ++k) {
        const sph2d_vec2 at = mirrored(&frozen.sides, in[k], (sph2d_vec2){s.fluid.x[i], s.fluid.y[i]});
        frozen.images.x[first + k] = at.x;
        frozen.images.y[first + k] = at.y;
        frozen.images.vx[first + k] = frozen.images.vy[first + k] = 0;
        frozen.images.id[first + k] = i * IMAGE_SIDES + (size_t)in[k];
    }
}

static inline void see_one(sph2d__system *s, size_t i, sph2d__slab_sum *sum)
{
    sph2d__pairs to = sph2d__pairs_of_particle(&s->neighbours, i);
    const size_t begin = to.next;
    sph2d__pairs_search(&to, &to.walls, &s->wall_cells, &s->walls, &s->fluid, i, s->support * s->support, false, 0);
    find_sight(s, i, begin, sph2d__pairs_write(&s->neighbours, &to, 0));
    sum->most = to.full;
}
TOTAL(see_pass, see_one)

static inline void gather_one(sph2d__system *s, size_t i, sph2d__slab_sum *sum)
{
    sph2d__pairs to = sph2d__pairs_of_particle(&s->neighbours, i);
    gather_slice(s, &to, i, KIND);
    sum->most = to.full;
}
TOTAL(gather_pass, gather_one)

SPAN(keep_state_pass, keep_state)
SPAN(turn_pass, turn_some)
SPAN(start_of_images, start_of)
SPAN(sight_of_images, sight_of)
SPAN(slopes_of_images, slopes_of)
SPAN(velocity_of_images, velocity_of)
SPAN(pressure_of_images, pressure_of)
SPAN(rest_of_images, rest_of)
SPAN(compare_pass, compare)
SPAN(bound_pass, bound_some)
SPAN(spare_pass, spare_some)
SPAN(stick_pass, stick_some)

/* ---- the step ---------------------------------------------------------------------------------------------------- */

SPAN(go_to_middle_pass, go_to_middle)
SPAN(go_back_pass, go_back)
SPAN(begin_pass, start_some)
SPAN(report_pass, report)

TOTAL(store_pass, store_one)

TOTAL(sum_lifted_pass, add_lifted)
WITH(shorten_pass, double, shorten_one)

static inline void nothing_after(const sph2d__system *s, double dt, size_t i)
{
}
ADVECT(whole_way, nothing_after)

/* ---- balances ---------------------------------------------------------------------------------------------------- */

static inline void one_energy(const sph2d__system *s, size_t i, sph2d__slab_sum *sum)
{
    sph2d__add_energy(s, i, elastic_of(s, i), sum);
}
TOTAL(sum_energy, one_energy)

LOADS(mean_side_push, mean_wall_force)
