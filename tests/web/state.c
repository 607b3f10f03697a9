/* SPDX-License-Identifier: MIT */
/** @file state.c
 *  state SCENE STEPS: the liquid after a number of steps by the baseline instruction set and one thread, as the test of
 *  the page compares it: x, y and both velocities of all particles, as they lie in memory. */
#include <stdio.h>
#include <stdlib.h>

#include <sph2d/contacts.h>
#include <sph2d/io.h>
#include <sph2d/sph2d.h>

int main(int argc, char **argv)
{
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_sim *sim = NULL;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.isa = SPH2D_ISA_BASELINE;
    sph2d_status status =
        argc == 3 ? sph2d_scene_file_read(argv[1], NULL, 0, &file, &report) : SPH2D_INVALID;
    if (status == SPH2D_OK)
        status = sph2d_sim_create(sph2d_scene_file_scene(file), &options, &sim, &report);
    if (status == SPH2D_OK)
        status = sph2d_contacts_attach(sim);
    for (long k = argc == 3 ? strtol(argv[2], NULL, 10) : 0; k > 0 && status == SPH2D_OK; --k)
        status = sph2d_sim_step(sim, &report);
    if (status == SPH2D_OK) {
        const sph2d_view fluid = sph2d_sim_fluid(sim);
        const double *const all[] = {fluid.x, fluid.y, fluid.vx, fluid.vy};
        for (int k = 0; k < 4; ++k)
            fwrite(all[k], sizeof *all[k], fluid.count, stdout);
    }
    for (size_t i = 0; i < report.count; ++i)
        fprintf(stderr, "%s\n", report.items[i].message);
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
    return status == SPH2D_OK && fflush(stdout) == 0 ? 0 : 1;
}
