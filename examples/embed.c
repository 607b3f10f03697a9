/* SPDX-License-Identifier: MIT */
/** @file embed.c
 *  The solver inside another program: a scene from structs, steps, positions. Links libsph2d alone.
 *
 *      cc embed.c $(pkg-config --cflags --libs sph2d) -o embed && ./embed */
#include <sph2d/sph2d.h>
#include <stdio.h>

int main(void)
{
    sph2d_scene scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    scene.spacing = 0.02;
    sph2d_block column = sph2d_block_default();
    column.shape.kind = SPH2D_SHAPE_BOX;
    column.shape.box = (sph2d_box){{0, 0}, {0.4, 0.6}};
    scene.blocks = &column;
    scene.block_count = 1;

    sph2d_sim *sim = NULL;
    sph2d_report report = {0};
    sph2d_status status = sph2d_sim_create(&scene, NULL, &sim, &report);
    while (status == SPH2D_OK && sph2d_sim_time(sim) < 0.5)
        status = sph2d_sim_step(sim, &report);
    for (size_t i = 0; i < report.count; ++i)
        fprintf(stderr, "%s\n", report.items[i].message);
    if (status == SPH2D_OK) {
        sph2d_view fluid = sph2d_sim_fluid(sim);
        double front = 0;
        for (size_t i = 0; i < fluid.count; ++i)
            front = fluid.x[i] > front ? fluid.x[i] : front;
        printf("%zu particles, front at %.3f m, compression %.1f %%\n", fluid.count, front,
               100 * sph2d_sim_summary(sim).compression_p99);
    }
    sph2d_sim_destroy(sim);
    return (int)status;
}
