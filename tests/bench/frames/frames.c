/* SPDX-License-Identifier: MIT */
/** @file frames.c
 *  frames [PARTICLES [FRAMES [ROUNDS]]]: the CPU time that frames of a dam break take, drawn by one thread of Mesa's software OpenGL.
 *
 *  Each frame is drawn and written several times, and the least time of each part counts, so that other jobs matter
 *  little. Writing waits for the disk, which is no CPU time. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <sph2d/render.h>
#include <sph2d/sph2d.h>

/** How many, and how often each is drawn. */
static int frames = 8, rounds = 5;

/** A column of 2 by 1 beside a wall, which falls and runs to the other one [m]. */
static sph2d_sim *make_dam(double particles)
{
    sph2d_scene scene = sph2d_scene_default();
    sph2d_block column = sph2d_block_default();
    scene.domain = (sph2d_box){{0, 0}, {4, 2.25}};
    scene.spacing = 1 / round(sqrt(particles / 2));
    scene.gravity = (sph2d_vec2){0, -9.81};
    scene.fluid.dynamic_viscosity = 3;
    scene.method.name = SPH2D_METHOD_MULLER;
    column.shape.kind = SPH2D_SHAPE_BOX;
    column.shape.box = (sph2d_box){{0, 0}, {1, 2}};
    scene.blocks = &column;
    scene.block_count = 1;
    sph2d_sim *sim = NULL;
    sph2d_report report = {0};
    if (sph2d_sim_create(&scene, NULL, &sim, &report) != SPH2D_OK)
        fprintf(stderr, "frames: %s\n", report.count ? report.items[0].message : "out of memory");
    return sim;
}

static double cpu(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

/** What frames of a size and style took, summed over them [ms], and their bytes. */
typedef struct row {
    const char *name;
    unsigned width, height;
    sph2d_style style;
    bool colored;
    sph2d_renderer *renderer;
    double draw, encode, bytes;
} row;

static bool measure(row *r, const sph2d_picture *picture, const char *path)
{
    double draw = INFINITY, encode = INFINITY;
    for (int round = 0; round < rounds; ++round) {
        const double begun = cpu();
        if (sph2d_renderer_draw(r->renderer, picture, NULL) != SPH2D_OK)
            return false;
        const double drawn = cpu();
        if (sph2d_renderer_write_png(r->renderer, path, NULL) != SPH2D_OK)
            return false;
        draw = fmin(draw, drawn - begun);
        encode = fmin(encode, cpu() - drawn);
    }
    struct stat info;
    r->draw += draw;
    r->encode += encode;
    r->bytes += stat(path, &info) == 0 ? (double)info.st_size : NAN;
    return true;
}

static bool measure_all(sph2d_sim *sim, row *rows, size_t count, const char *path)
{
    const sph2d_scene *scene = sph2d_sim_scene(sim);
    const sph2d_view fluid = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < count; ++i) {
        const bool balls = rows[i].style == SPH2D_STYLE_METABALLS;
        const sph2d_picture picture = {.view = scene->domain,
                                       .radius = (balls ? 2 : 0.5) * scene->spacing,
                                       .count = fluid.count,
                                       .x = fluid.x,
                                       .y = fluid.y,
                                       .values = rows[i].colored ? fluid.density : NULL,
                                       .value_label = rows[i].colored ? "Densities [kg/m^2]" : NULL,
                                       .caption = "dam_break   t = 0.500 s"};
        if (!measure(&rows[i], &picture, path))
            return false;
    }
    return true;
}

int main(int argc, char **argv)
{
    row rows[] = {{"metaballs", 1280, 720, SPH2D_STYLE_METABALLS, false, NULL, 0, 0, 0},
                  {"metaballs, coloured", 1280, 720, SPH2D_STYLE_METABALLS, true, NULL, 0, 0, 0},
                  {"points, coloured", 1280, 720, SPH2D_STYLE_POINTS, true, NULL, 0, 0, 0},
                  {"metaballs", 1920, 1080, SPH2D_STYLE_METABALLS, false, NULL, 0, 0, 0}};
    const size_t count = sizeof rows / sizeof *rows;
    frames = argc > 2 ? (int)strtol(argv[2], NULL, 10) : frames;
    rounds = argc > 3 ? (int)strtol(argv[3], NULL, 10) : rounds;
    setenv("LP_NUM_THREADS", "0", 1); /* Mesa draws in the calling thread */
    char path[] = "/tmp/sph2d-frames-XXXXXX";
    const int file = mkstemp(path);
    sph2d_sim *sim = make_dam(argc > 1 ? strtod(argv[1], NULL) : 16384);
    bool ok = sim && file >= 0;
    for (size_t i = 0; i < count && ok; ++i) {
        sph2d_render_options options = sph2d_render_options_default();
        options.width = rows[i].width;
        options.height = rows[i].height;
        options.style = rows[i].style;
        ok = sph2d_renderer_create(&options, &rows[i].renderer, NULL) == SPH2D_OK;
    }
    for (int frame = 0; frame < frames && ok; ++frame) {
        while (ok && sph2d_sim_time(sim) < 0.15 * frame)
            ok = sph2d_sim_step(sim, NULL) == SPH2D_OK;
        ok = ok && measure_all(sim, rows, count, path);
    }
    if (ok)
        printf("%zu particles, CPU ms per frame\n\n| frames | size | draw, read | encode | both | kB "
               "|\n|---|---|--:|--:|--:|--:|\n",
               sph2d_sim_fluid(sim).count);
    for (size_t i = 0; i < count; ++i) {
        if (ok)
            printf("| %s | %u x %u | %.1f | %.1f | %.1f | %.0f |\n", rows[i].name, rows[i].width, rows[i].height,
                   rows[i].draw / frames, rows[i].encode / frames, (rows[i].draw + rows[i].encode) / frames,
                   rows[i].bytes / frames / 1000);
        sph2d_renderer_destroy(rows[i].renderer);
    }
    sph2d_sim_destroy(sim);
    if (file >= 0) {
        close(file);
        unlink(path);
    }
    if (!ok)
        fprintf(stderr, "frames: it cannot draw\n");
    return ok ? 0 : 1;
}
