/* SPDX-License-Identifier: MIT */
/** @file check.c
 *  `sph2d check SCENE`: reports all errors of a scene, then estimates the run. */
#include <math.h>
#include <sph2d/contacts.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "coarse_run.h"
#include "command.h"
#include "device.h"
#include "exit.h"
#include "frame_writer.h"
#include "input.h"
#include "json.h"
#include "loop.h"
#include "message.h"
#include "text.h"
#include "threads.h"

/* A checked scene, and the estimates of its run. */
typedef struct checked {
    const cli_options *options;
    sph2d_scene_file *file;
    const sph2d_scene *scene; /* that of the file, or the coarse one */
    sph2d_scene coarse;
    sph2d_block *coarse_blocks;
    double coarsening; /* factor of its spacing; 1: the scene of the file */
    sph2d_sim *sim;
    sph2d_plan plan;
    thread_choice threads;
    device_choice device;
    double device_bytes;           /* that the run takes there */
    double step_seconds, step_cpu; /* measured, per step */
    double steps;                  /* expected of the run */
    double seconds, cpu;           /* expected of the run [s] */
    double disk;                   /* expected of its snapshots without compression [bytes] */
    uint64_t steps_measured;
    sph2d_report report;
} checked;

static int report_status(checked *c, sph2d_status status)
{
    message_report(status, &c->report, c->file);
    return exit_of_status(status);
}

/* Measures the time of some steps, none of them beyond the end of the run. The first step warms up caches and threads,
 * and is not counted unless it is the only one. */
static int measure(checked *c)
{
    const double longest = 0.3;
    double begun = clock_wall(), cpu = clock_cpu();
    sph2d_status status = sph2d_sim_step(c->sim, &c->report);
    if (status == SPH2D_OK && loop_done(c->sim)) {
        c->steps_measured = 1;
    } else {
        begun = clock_wall();
        cpu = clock_cpu();
    }
    for (; status == SPH2D_OK && !loop_done(c->sim) && c->steps_measured < 50; ++c->steps_measured) {
        if (c->steps_measured > 0 && clock_wall() - begun >= longest)
            break;
        status = sph2d_sim_step(c->sim, &c->report);
    }
    if (c->steps_measured > 0) {
        c->step_seconds = (clock_wall() - begun) / (double)c->steps_measured;
        c->step_cpu = (clock_cpu() - cpu) / (double)c->steps_measured;
    }
    return report_status(c, status);
}

/* With fewer particles the time of a step does not scale with their number. */
static const double MIN_SCALING = 200;

/* Estimates the run: the time of its first steps times the ratios of a coarse run. */
static void estimate(checked *c)
{
    const double particles = (double)c->plan.fluid_particles;
    const coarse_run run = coarse_run_estimate(c->scene, c->plan.steps, c->plan.steps * c->step_cpu, particles);
    c->steps = c->plan.steps * run.steps;
    c->cpu = c->steps * run.particles * run.cost * c->step_cpu;
    if (c->device.number == 0 && (particles < MIN_SCALING || c->scene->source_count > 0) && run.cpu_of_particle > 0)
        c->cpu = c->steps * (run.cpu_of_step + run.mean * run.cpu_of_particle);
    const double mean = c->scene->source_count > 0 && run.mean > 0 ? run.mean : particles * run.particles;
    c->disk = c->plan.disk + (mean - particles) * c->plan.disk_of_particle;
    c->seconds = c->step_cpu > 0 ? c->cpu * c->step_seconds / c->step_cpu : c->cpu;
}

static int draw_preview(checked *c)
{
    frame_style style = frame_style_of_scene(sph2d_sim_scene(c->sim));
    frame_writer *writer = NULL;
    sph2d_status status = frame_writer_create(&style, c->options, &writer, &c->report);
    particle_source source = {.sim = c->sim};
    if (status == SPH2D_OK)
        status = frame_writer_write(writer, &source, &style, c->options->preview, NULL, &c->report);
    frame_writer_destroy(writer);
    if (status == SPH2D_OK)
        message_note("the first frame is in '%s'", c->options->preview);
    return report_status(c, status);
}

/* ---- large scenes ------------------------------------------------------------------------------------------------ */

/* A check takes a second or two and less than a gigabyte: of more particles than this a coarser scene is checked, and
 * its numbers are extrapolated. Placing liquid around obstacles takes longer: so many halve the number. Where no
 * coarser scene can be made, up to TRIED times as many particles are tried. */
static const double MOST_PARTICLES = 1e5, HALVING_OBSTACLES = 250, TRIED = 10;

static double most_particles(const sph2d_scene *scene)
{
    return MOST_PARTICLES / (1 + (double)(scene->obstacle_count + scene->body_count) / HALVING_OBSTACLES);
}

/* The factor of the spacing; 1 for scenes of single particles, which have no coarser form. */
static double choose_coarsening(const sph2d_scene *scene)
{
    const double most = most_particles(scene);
    double k = 1;
    for (double many = sph2d_scene_particles(scene); many > most && scene->particles.count == 0; k *= 1.1) {
        sph2d_scene coarse = *scene;
        sph2d_block *blocks = coarse_scene(&coarse, k);
        if (!blocks)
            return 1;
        many = sph2d_scene_particles(&coarse);
        free(blocks);
    }
    return k;
}

static sph2d_status create(checked *c, const sph2d_scene *scene, sph2d_report *report)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = c->threads.wanted;
    options.isa = c->options->isa;
    device_set(&options, &c->device);
    sph2d_status status = sph2d_sim_create(scene, &options, &c->sim, report);
    sph2d_contacts_attach(c->sim);
    return status;
}

/* Makes a coarser simulation; false if there is none. */
static bool create_coarse(checked *c)
{
    const double k = choose_coarsening(c->scene);
    c->coarse = *c->scene;
    c->coarse_blocks = k > 1 ? coarse_scene(&c->coarse, k) : NULL;
    sph2d_report nobody_reads = {0};
    const bool created = c->coarse_blocks && create(c, &c->coarse, &nobody_reads) == SPH2D_OK;
    sph2d_report_clear(&nobody_reads);
    if (!created)
        return false;
    message_note(
        "checked with a spacing %.3g times as large, since it has about %.2g particles: counts, steps and times "
        "are extrapolated",
        k, sph2d_scene_particles(c->scene));
    c->coarsening = k;
    c->scene = &c->coarse;
    return true;
}

static sph2d_status create_affordable(checked *c)
{
    sph2d_report twice = {0}; /* what is created repeats its warnings */
    const sph2d_status status = sph2d_scene_fits(c->scene, &twice);
    sph2d_report_clear(&twice);
    if (status != SPH2D_OK)
        return sph2d_scene_fits(c->scene, &c->report);
    if (create_coarse(c))
        return SPH2D_OK;
    const double many = sph2d_scene_particles(c->scene);
    if (many <= TRIED * most_particles(c->scene))
        return create(c, c->scene, &c->report);
    message_note("its start was not tried: it has about %.2g particles, too many for a check, and no coarser form of "
                 "it can be made",
                 many);
    return SPH2D_OK;
}

/* From the coarse scene's numbers to those of the scene: areas by k^2, lengths and steps by k. Of snapshots what is not
 * liquid is walls, mostly. */
static void extrapolate(checked *c)
{
    const double k = c->coarsening;
    sph2d_plan *p = &c->plan;
    const double liquid = c->disk - p->disk + (double)p->fluid_particles * p->disk_of_particle;
    c->disk = k * (c->disk - liquid) + k * k * liquid;
    p->fluid_particles = (size_t)((double)p->fluid_particles * k * k);
    p->wall_particles = (size_t)((double)p->wall_particles * k);
    p->particle_mass /= k * k;
    p->support_radius /= k;
    p->time_step /= k;
    p->memory *= k * k;
    const double on_device = (double)sph2d_sim_device_memory(c->sim),
                 fixed = fmin(on_device, SPH2D_DEVICE_FIXED_MEMORY);
    c->device_bytes = fixed + k * k * (on_device - fixed);
    c->steps *= k;
    c->cpu *= k * k * k;
    c->seconds *= k * k * k;
}

/* ---- the table --------------------------------------------------------------------------------------------------- */

static void print_active(const sph2d_scene *scene)
{
    static const char *const forms[] = {"walls", "spring walls", "heavy walls", "reflecting walls",
                                        "generalised walls"};
    sph2d_boundary b = scene->boundary;
    bool walled = b.left == SPH2D_SIDE_WALL || b.right == SPH2D_SIDE_WALL || b.bottom == SPH2D_SIDE_WALL ||
                  b.top == SPH2D_SIDE_WALL;
    const struct {
        size_t count;
        const char *name;
    } lists[] = {{scene->block_count, "blocks"},
                 {scene->source_count, "sources"},
                 {scene->drain_count, "drains"},
                 {scene->opening_count, "openings"},
                 {scene->obstacle_count, "obstacles"},
                 {scene->body_count, "bodies"},
                 {scene->interaction_count, "interactions"},
                 {scene->probe_count, "probes"}};
    printf("%-22s pressure", "active");
    if (scene->fluid.dynamic_viscosity > 0)
        printf(", viscosity");
    if (scene->fluid.surface_tension > 0)
        printf(", surface tension");
    if (scene->gravity.x != 0 || scene->gravity.y != 0)
        printf(", gravity");
    if (scene->central_force.rate > 0)
        printf(", central force");
    if (walled)
        printf(", %s", forms[scene->walls]);
    for (size_t i = 0; i < sizeof lists / sizeof *lists; ++i)
        if (lists[i].count > 0)
            printf(", %s: %zu", lists[i].name, lists[i].count);
    putchar('\n');
}

/* What a pressure over density of the plan compresses. */
static double compression_by(const sph2d_plan *plan, double head)
{
    return plan->sound_speed > 0 ? head / (plan->sound_speed * plan->sound_speed) : NAN;
}

/* Steps that are this many times as short as those of sound are worth another method. */
static const double SHORT_STEPS = 10;

/** Says so where viscosity makes steps that short, which only wcsph and muller have to take. */
static void print_short_steps(const checked *c)
{
    const sph2d_method_options *m = &sph2d_sim_scene(c->sim)->method;
    double of_sound = m->cfl * c->plan.support_radius / c->plan.sound_speed;
    if (strcmp(c->plan.time_step_limit, "viscous") == 0 && of_sound > SHORT_STEPS * c->plan.time_step &&
        (m->name == SPH2D_METHOD_WCSPH || m->name == SPH2D_METHOD_MULLER))
        text_row("", "%.2g times as short as for sound alone; method constraint solves thick liquids at any step",
                 of_sound / c->plan.time_step);
}

static void print_pressure(const checked *c)
{
    const sph2d_plan *plan = &c->plan;
    if (sph2d_sim_scene(c->sim)->method.name == SPH2D_METHOD_HYBRID) {
        text_row("pressure", "by a grid, once a step: for looking and playing, not for studies of pressure");
        return;
    }
    text_row("sound speed", "%.6g m/s: %s", plan->sound_speed, plan->sound_speed_formula);
    text_row("compression", "%.3g %% hydrostatic; %.3g %% in a full impact", 100 * compression_by(plan, plan->head),
             100 * plan->impact_compression);
    if (plan->capillary_head > 0)
        text_row("", "%.3g %% by surface tension in the thinnest block",
                 100 * compression_by(plan, plan->capillary_head));
}

static void print_device(const checked *c)
{
    char bytes[TEXT_SIZE], most[TEXT_SIZE];
    if (c->device.number == 0)
        return;
    text_row("device", "%d, %s, %s", c->device.number, c->device.about.name,
             c->device.about.same_bits ? "with the bits of baseline" : "which differs in the last digits");
    text_row("", "%s of its memory, which gives %s at most", text_bytes(bytes, c->device_bytes),
             text_bytes(most, c->device.about.largest));
}

static int check_device_memory(const checked *c)
{
    char bytes[TEXT_SIZE], most[TEXT_SIZE];
    if (c->device.number == 0 || c->device_bytes <= c->device.about.largest)
        return CLI_EXIT_SUCCESS;
    message_error(SPH2D_CODE_DEVICE, "a larger spacing takes less",
                  "device %d gives %s at most, and the scene takes about %s", c->device.number,
                  text_bytes(most, c->device.about.largest), text_bytes(bytes, c->device_bytes));
    return CLI_EXIT_UNAVAILABLE;
}

static void print_table(const checked *c)
{
    const sph2d_plan *plan = &c->plan;
    char memory[TEXT_SIZE], disk[TEXT_SIZE], duration[TEXT_SIZE], cpu[TEXT_SIZE], in_use[TEXT_SIZE];
    char by[TEXT_DEVICE_SIZE];
    text_row("scene", "%s: no errors", c->scene->name);
    print_active(sph2d_sim_scene(c->sim));
    text_row("particles", "%zu in the liquid, %zu in walls", plan->fluid_particles, plan->wall_particles);
    if (plan->area_asked > 0)
        text_row("area", "%.6g m^2 requested, %.6g m^2 placed (%+.2f %%)", plan->area_asked, plan->area_placed,
                 100 * (plan->area_placed / plan->area_asked - 1));
    if (plan->area_left_out > 0)
        text_row("", "%.3g m^2 of blocks inside obstacles are left out, the largest part of blocks[%zu]: %.3g %%",
                 plan->area_left_out, plan->most_left_out_block, 100 * plan->most_left_out);
    if (plan->places_left_free > 0)
        text_row("", "%zu lattice sites left free at obstacles", plan->places_left_free);
    text_row("particle mass", "%.6g kg/m", plan->particle_mass);
    text_row("support radius", "%.6g m (%.3g spacings)", plan->support_radius,
             plan->support_radius * c->coarsening / c->scene->spacing);
    print_pressure(c);
    text_row("time step", "%.4g s at the start, set by: %s", plan->time_step, plan->time_step_limit);
    print_short_steps(c);
    text_row("steps", "about %.3g, to t = %g s", c->steps, c->scene->run.until);
    text_row("memory", "%s at the start", text_bytes(memory, plan->memory));
    print_device(c);
    text_row("snapshots", "%.0f, %s%s", plan->snapshots, text_bytes(disk, c->disk),
             c->scene->run.snapshots.compress > 0 ? " without compression" : "");
    text_row("frames", "%.0f of %u x %u", plan->frames, (unsigned)c->scene->run.frames.size[0],
             (unsigned)c->scene->run.frames.size[1]);
    if (c->steps_measured > 0)
        text_row("time", "about %s, %s CPU, without outputs; %s%s", text_seconds(duration, c->seconds),
                 text_seconds(cpu, c->cpu), c->device.number > 0 ? "by " : "with ",
                 c->device.number > 0 ? device_describe(by, &c->device)
                                      : threads_describe(in_use, sph2d_sim_threads(c->sim), &c->threads));
}

/* All that is known of a scene whose start was not tried. */
static void print_untried(const checked *c)
{
    const double particles = sph2d_scene_particles(c->scene);
    if (c->options->json) {
        cli_json line = json_begin(stdout);
        json_text(&line, "scene", c->scene->name);
        json_count(&line, "particles", (uint64_t)particles);
        json_number(&line, "until", c->scene->run.until);
        json_end(&line);
    } else if (!c->options->quiet) {
        text_row("scene", "%s: no errors", c->scene->name);
        print_active(c->scene);
        text_row("particles", "about %.2g", particles);
    }
}

static void print_object(const checked *c)
{
    const sph2d_plan *plan = &c->plan;
    cli_json line = json_begin(stdout);
    json_text(&line, "scene", c->scene->name);
    json_count(&line, "particles", plan->fluid_particles);
    json_count(&line, "wall_particles", plan->wall_particles);
    json_count(&line, "places_left_free", plan->places_left_free);
    json_number(&line, "area_asked", plan->area_asked);
    json_number(&line, "area_placed", plan->area_placed);
    json_number(&line, "area_left_out", plan->area_left_out);
    json_number(&line, "particle_mass", plan->particle_mass);
    json_number(&line, "support_radius", plan->support_radius);
    json_number(&line, "sound_speed", plan->sound_speed);
    json_text(&line, "sound_speed_formula", plan->sound_speed_formula);
    json_number(&line, "compression", compression_by(plan, plan->head));
    json_number(&line, "capillary_compression", compression_by(plan, plan->capillary_head));
    json_number(&line, "impact_compression", plan->impact_compression);
    json_number(&line, "time_step", plan->time_step);
    json_text(&line, "time_step_limit", plan->time_step_limit);
    json_number(&line, "steps", c->steps);
    json_number(&line, "until", c->scene->run.until);
    json_number(&line, "memory_bytes", plan->memory);
    json_number(&line, "snapshots", plan->snapshots);
    json_number(&line, "frames", plan->frames);
    json_number(&line, "disk_bytes", c->disk);
    json_number(&line, "seconds", c->steps_measured > 0 ? c->seconds : NAN);
    json_number(&line, "cpu_seconds", c->steps_measured > 0 ? c->cpu : NAN);
    json_count(&line, "threads", (uint64_t)sph2d_sim_threads(c->sim));
    json_text(&line, "device", device_name(&c->device));
    json_number(&line, "device_memory_bytes", c->device_bytes);
    json_end(&line);
}

/* ---- the command ------------------------------------------------------------------------------------------------- */

/* Reading repeats the warnings of the check, so only the last prints them. */
static int prepare(checked *c)
{
    const cli_options *options = c->options;
    sph2d_status status = scene_input_read(options, &c->file, &c->report);
    if (status != SPH2D_OK)
        return report_status(c, status);
    sph2d_report_clear(&c->report);
    c->scene = sph2d_scene_file_scene(c->file);
    frame_style style = frame_style_of_scene(c->scene);
    sph2d_status style_status = frame_style_check(&style, &c->report);
    const char *refused = c->device.number > 0 ? sph2d_device_refuses(c->scene) : NULL;
    if (refused) { /* a coarse scene would hide it */
        sph2d_report_add(&c->report, SPH2D_ERROR, SPH2D_CODE_UNSUPPORTED, NULL, "no device takes this scene: %s",
                         refused);
        return report_status(c, SPH2D_SCENE);
    }
    status = create_affordable(c);
    if (status == SPH2D_OK && c->sim)
        c->plan = *sph2d_sim_plan(c->sim);
    return report_status(c, status != SPH2D_OK ? status : style_status);
}

static int try_start(checked *c)
{
    int code = CLI_EXIT_SUCCESS;
    if (c->options->preview)
        code = draw_preview(c);
    if (code == CLI_EXIT_SUCCESS)
        code = measure(c);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    estimate(c);
    extrapolate(c);
    if (c->options->json)
        print_object(c);
    else if (!c->options->quiet)
        print_table(c);
    return check_device_memory(c);
}

int command_check(const cli_options *options)
{
    if (options->operand_count != 1) {
        message_usage("check", options->operand_count == 0 ? "a scene file must be given" : "one scene at a time");
        return CLI_EXIT_USAGE;
    }
    checked c = {.options = options, .threads = threads_choose(options), .coarsening = 1};
    int code = device_choose(&c.device, options);
    if (code == CLI_EXIT_SUCCESS)
        code = prepare(&c);
    if (code == CLI_EXIT_SUCCESS && c.sim)
        code = try_start(&c);
    else if (code == CLI_EXIT_SUCCESS)
        print_untried(&c);
    sph2d_sim_destroy(c.sim);
    free(c.coarse_blocks);
    sph2d_scene_file_destroy(c.file);
    return code;
}
