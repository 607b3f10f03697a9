/* SPDX-License-Identifier: MIT */
/** @file engine.c
 *  A program with an engine for rigid bodies of its own, such as a game, moves the bodies in the liquid: poses go in,
 *  forces come out. The engine is stood in for by a few lines here: it lets a raft fall on a floor of its own, y = 0.3.
 *
 *      cc engine.c $(pkg-config --cflags --libs sph2d) -o engine && ./engine */
#include <stdio.h>

#include <sph2d/sph2d.h>

/** The engine's world. */
typedef struct world {
    double floor; /**< [m] */
    int landings;
} world;

/** Called once per step: each body comes with its place and the velocity that the liquid's force, gravity and springs
 *  give it, and leaves with the velocity that the engine decides on. An engine that integrates forces by itself takes
 *  them from sph2d_sim_body() and overwrites the velocities. This one's floor is at rest and does no work; one that
 *  moves would add its work to `wall_work`, for the energy balance. */
static sph2d_status move(void *user, const sph2d_sim *sim, double dt, sph2d_contact_body *bodies, size_t count,
                         double *wall_work)
{
    world *w = user;
    const double half_height = 0.05;
    (void)sim;
    (void)wall_work;
    for (size_t k = 0; k < count; ++k) {
        double next = bodies[k].center.y + dt * bodies[k].velocity.y - half_height;
        if (next < w->floor) {
            bodies[k].velocity.y = 0;
            ++w->landings;
        }
    }
    return SPH2D_OK;
}

int main(void)
{
    sph2d_scene scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    scene.spacing = 0.02;
    sph2d_block water = sph2d_block_default();
    water.shape.kind = SPH2D_SHAPE_BOX;
    water.shape.box = (sph2d_box){{0, 0}, {1, 0.5}};
    scene.blocks = &water;
    scene.block_count = 1;
    sph2d_body raft = sph2d_body_default();
    raft.shape.kind = SPH2D_SHAPE_BOX;
    raft.shape.box = (sph2d_box){{0.3, 0.7}, {0.7, 0.8}};
    raft.density = 1500;
    scene.bodies = &raft;
    scene.body_count = 1;

    world engine = {.floor = 0.3};
    sph2d_sim *sim = NULL;
    sph2d_report report = {0};
    sph2d_status status = sph2d_sim_create(&scene, NULL, &sim, &report);
    if (status == SPH2D_OK)
        status = sph2d_sim_set_contacts(sim, move, &engine);
    while (status == SPH2D_OK && sph2d_sim_time(sim) < 1)
        status = sph2d_sim_step(sim, &report);
    for (size_t i = 0; i < report.count; ++i)
        fprintf(stderr, "%s\n", report.items[i].message);
    if (status == SPH2D_OK) {
        sph2d_body_state b = sph2d_sim_body(sim, 0);
        printf("raft at (%.3f, %.3f) m, %.2f rad; the water pushes with (%.0f, %.0f) N/m; on the floor in %d steps\n",
               b.center.x, b.center.y, b.angle, b.force.x, b.force.y, engine.landings);
    }
    sph2d_sim_destroy(sim);
    return status == SPH2D_OK ? 0 : 1;
}
