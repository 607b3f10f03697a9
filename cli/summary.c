/* SPDX-License-Identifier: MIT */
/** @file summary.c
 *  The summary of a run: speed and errors, among them how noisy the series of pressure gauges are. Their running mean is
 *  centred, so that it follows what changes steadily; it is over a quarter of the part that is judged, and differences from
 *  it count where all of that is inside. */
#include "session.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "json.h"
#include "text.h"

/* ---- noise of gauges --------------------------------------------------------------------------------------------- */

enum { MIN_SAMPLES = 16, PARTS = 4 };

/* Of the last quarter of the series of a pressure gauge. */
typedef struct gauge_noise {
    double mean;      /* [Pa] */
    double deviation; /* root mean square of the differences from the running mean over a quarter of it [Pa] */
} gauge_noise;

/* The first row of the last quarter of the time. */
static size_t begin_of_end(const sph2d_table *table, size_t rows)
{
    const double first = sph2d_table_value(table, 0, 0), last = sph2d_table_value(table, rows - 1, 0);
    size_t row = rows - 1;
    while (row > 0 && sph2d_table_value(table, row - 1, 0) >= last - (last - first) / PARTS)
        --row;
    return row;
}

static double mean_of(const sph2d_table *table, size_t from, size_t to)
{
    double sum = 0;
    for (size_t row = from; row < to; ++row)
        sum += sph2d_table_value(table, row, 1);
    return sum / (double)(to - from);
}

static bool judge(const sph2d_table *table, gauge_noise *out)
{
    const size_t rows = sph2d_table_rows(table), begin = rows > 0 ? begin_of_end(table, rows) : 0;
    const size_t count = rows - begin, half = count / PARTS / 2;
    if (count < MIN_SAMPLES)
        return false;
    double squares = 0, running = mean_of(table, begin, begin + 2 * half + 1);
    for (size_t row = begin + half; row < rows - half; ++row) {
        const double apart = sph2d_table_value(table, row, 1) - running;
        squares += apart * apart;
        if (row + half + 1 < rows)
            running += (sph2d_table_value(table, row + half + 1, 1) - sph2d_table_value(table, row - half, 1)) /
                       (double)(2 * half + 1);
    }
    *out = (gauge_noise){mean_of(table, begin, rows), sqrt(squares / (double)(count - 2 * half))};
    return isfinite(out->mean) && isfinite(out->deviation);
}

/* Reads the series NAME.csv of a probe of kind pressure in the folder of a run. False when it cannot be read, is too short,
 * with less than MIN_SAMPLES samples in its last quarter, or has samples without liquid there. */
static bool gauge_noise_read(const char *path, gauge_noise *out)
{
    const sph2d_table_column columns[] = {{"time", NULL, false}, {"pressure", NULL, false}};
    sph2d_table *table = NULL;
    sph2d_report report = {0};
    const bool ok = sph2d_table_read(path, columns, 2, &table, &report) == SPH2D_OK && judge(table, out);
    sph2d_table_destroy(table);
    sph2d_report_clear(&report);
    return ok;
}

/* ---- the run ----------------------------------------------------------------------------------------------------- */

static const char *const side_names[] = {"left", "right", "bottom", "top"};
static const char *const limit_names[] = {"acoustic", "force", "viscous", "fixed"};

static double ratio(double numerator, double denominator)
{
    return denominator > 0 ? numerator / denominator : NAN;
}

double summary_energy_change(const sph2d_summary *s)
{
    return s->kinetic + s->potential + s->elastic + s->bodies - s->energy_start - s->energy_fed;
}

/* ---- the table --------------------------------------------------------------------------------------------------- */

static void print_speed(const cli_session *s, const loop_result *result)
{
    char rate[TEXT_SIZE], cpu_rate[TEXT_SIZE], wall[TEXT_SIZE], cpu[TEXT_SIZE];
    char output[TEXT_SIZE], output_cpu[TEXT_SIZE];
    if (result->steps > 0) {
        double particle_steps = (double)result->particle_steps;
        text_row("speed", "%s particle-steps/s; %s per CPU second",
                 text_count(rate, ratio(particle_steps, result->step_wall)),
                 text_count(cpu_rate, ratio(particle_steps, result->step_cpu)));
        text_row("", "%.3g simulated seconds per second", ratio(result->simulated, result->step_wall));
    }
    text_row("", "stepping %s, CPU %s; output %s, CPU %s", text_seconds(wall, result->step_wall),
             text_seconds(cpu, result->step_cpu), text_seconds(output, result->output_wall),
             text_seconds(output_cpu, result->output_cpu));
    char frames[TEXT_SIZE], in_use[TEXT_SIZE], by[TEXT_DEVICE_SIZE];
    if (result->frames.frames > 0)
        text_row("", "%zu frame%s, %s", result->frames.frames, result->frames.frames == 1 ? "" : "s",
                 frame_times_describe(frames, &result->frames));
    if (s->device.number > 0)
        text_row("", "%s", device_describe(by, &s->device));
    text_row("", "%s, %s", threads_describe(in_use, sph2d_sim_threads(s->sim), &s->threads),
             sph2d_isa_name(sph2d_sim_isa(s->sim)));
}

/* From this part of its volume on an error of it is worth advice; most scenes have 0.001 to 0.03. */
static const double WRONG = 0.05;

/* A largest compression that is worth a word: examples at 400 particles have 0.43 at most, but for those by muller with soft
 * liquids or sources: 0.52 to 1.8. */
static const double PRESSED = 0.5;

/* How much more room the liquid takes than it should, and what its densities tell of that. */
static void print_volume(const sph2d_sim *sim, const sph2d_scene *scene, const sph2d_summary *s)
{
    sph2d_densities inside = sph2d_sim_densities(sim);
    double apart = fmax(s->density_apart, fabs(inside.reported - inside.counted));
    if (isfinite(inside.covered))
        text_row("volume", "%+.2g %% against what its particles stand for", 100 * (inside.covered - 1));
    if (isfinite(inside.reported))
        text_row("density inside", "reported %.5g, counted %.5g of rest density; largest difference %.3g %%",
                 inside.reported, inside.counted, 100 * apart);
    if (fabs(inside.covered - 1) > WRONG || (isfinite(apart) && apart > WRONG))
        text_row("",
                 "spray takes more room, and so do voids that stay in liquid that was mixed: a smaller spacing%s "
                 "leaves fewer",
                 scene->method.name == SPH2D_METHOD_CONSTRAINT ? "" : ", or method constraint,");
}

static void print_errors(const sph2d_sim *sim, const sph2d_scene *scene, const sph2d_summary *s)
{
    print_volume(sim, scene, s);
    double change = summary_energy_change(s), excess = ratio(s->compression_p99, scene->method.max_compression);
    text_row("compression", "p99 %.3g %%, mean %.3g %%, maximum %.3g %%", 100 * s->compression_p99,
             100 * s->compression_mean, 100 * s->compression_max);
    if (excess > 1 && scene->method.name == SPH2D_METHOD_HYBRID)
        text_row("", "above method.max_compression, %.3g %%: a smaller method.cfl leaves less",
                 100 * scene->method.max_compression);
    else if (excess > 1)
        text_row("", "above method.max_compression, %.3g %%: about %.3g times the sound speed would limit it",
                 100 * scene->method.max_compression, fmax(1.01, sqrt(excess)));
    if (s->compression_max > PRESSED)
        text_row("", "some liquid had %.3g times its density for a moment: a smaller method.cfl or spacing leaves less",
                 1 + s->compression_max);
    if (s->energy_start != 0 && scene->opening_count == 0) /* of what flows through, the start says nothing */
        text_row("energy", "%+.4g J/m (%+.3g %%)", change, 100 * ratio(change, fabs(s->energy_start)));
    else
        text_row("energy", "%+.4g J/m", change);
    text_row("", "start %.6g, now %.6g, net input by particles %.6g J/m", s->energy_start,
             s->kinetic + s->potential + s->elastic + s->bodies, s->energy_fed);
    text_row(
        "", "work of walls %.4g, forces %.4g; lost to viscosity %.4g, diffusion %.4g, stops %.4g, impacts %.4g J/m",
        s->energy_walls, s->energy_forces, s->energy_viscous, s->energy_diffused, s->energy_stopped, s->energy_pressed);
    if (scene->body_count > 0)
        text_row("", "of bodies and their springs %.4g; lost to their contacts %.4g J/m", s->bodies,
                 s->energy_contacts);
    if (s->energy_scale > 0 && isfinite(s->energy_error))
        text_row("energy error",
                 "%+.3g %% of the scene's %.4g J/m, %+.3g %% of the largest kinetic %.4g J/m, unaccounted for",
                 100 * s->energy_error / s->energy_scale, s->energy_scale, 100 * ratio(s->energy_error, s->kinetic_max),
                 s->kinetic_max);
    if (s->energy_scale > 0 && isfinite(s->energy_rise))
        text_row("", "at most %.3g %%, %.3g %% of the kinetic, came from nothing",
                 100 * s->energy_rise / s->energy_scale, 100 * ratio(s->energy_rise, s->kinetic_max));
    text_row("momentum", "%.4g, %.4g kg/s", s->momentum[0], s->momentum[1]);
    if (isfinite(s->momentum_error_max))
        text_row("", "%.3g, %.3g kg/s from nothing; at most %.3g, %.3g %% of the largest sum of sizes, %.4g kg/s",
                 s->momentum_error[0], s->momentum_error[1], s->momentum_error_max,
                 100 * ratio(s->momentum_error_max, s->momentum_moved), s->momentum_moved);
    text_row("largest speed", "%.4g m/s", s->speed_max);
}

/* ---- gauges ------------------------------------------------------------------------------------------------------ */

/* Whether a probe is a gauge whose noise is known. */
static bool find_noise(const sph2d_probe *probe, cli_folder *folder, gauge_noise *noise)
{
    const char *path = probe->kind == SPH2D_PROBE_PRESSURE ? folder_file(folder, "%s.csv", probe->name) : NULL;
    return path && gauge_noise_read(path, noise);
}

static void print_gauges(const sph2d_scene *scene, cli_folder *folder)
{
    const char *row = "noise of gauges";
    for (size_t i = 0; i < scene->probe_count; ++i) {
        const sph2d_probe *probe = &scene->probes[i];
        gauge_noise n;
        if (!find_noise(probe, folder, &n))
            continue;
        text_row(row, "%s: %.3g Pa, %.3g %% of the mean, %.4g Pa, in the last quarter; rise time %.3g s", probe->name,
                 n.deviation, 100 * ratio(n.deviation, fabs(n.mean)), n.mean, probe->rise_time);
        row = "";
    }
}

static void print_particles(const sph2d_summary *s, const sph2d_scene *scene)
{
    text_row("particles", "%" PRIu64 "; %.3g neighbours on average; %" PRIu64 " nearer than 0.3 spacings to another",
             s->particles, s->neighbours, s->paired);
    if (s->fed > 0 || s->blocked > 0)
        text_row("", "fed %" PRIu64 ", blocked %" PRIu64 "%s", s->fed, s->blocked,
                 s->blocked > 0 ? ", for which their nozzle had no room" : "");
    if (scene->opening_count > 0)
        text_row("", "openings: %" PRIu64 " in, %" PRIu64 " out", s->let_in, s->let_out);
    uint64_t lost = s->drained;
    for (int i = 0; i < 4; ++i)
        lost += s->left_open[i];
    text_row("particles lost", "%" PRIu64, lost);
    if (s->drained > 0)
        text_row("", "%" PRIu64 " through drains", s->drained);
    for (int i = 0; i < 4; ++i)
        if (s->left_open[i] > 0)
            text_row("", "%" PRIu64 " through the open side: %s", s->left_open[i], side_names[i]);
    text_row("walls", "%" PRIu64 " backstop hits, %" PRIu64 " reflections", s->backstop_hits, s->reflections);
}

static void print_steps(const sph2d_summary *s)
{
    text_row("steps", "%" PRIu64, s->steps);
    if (s->steps > 0)
        text_row("", "of %.3g to %.3g s", s->time_step_min, s->time_step_max);
    for (int i = 0; i < 4; ++i)
        if (s->limited_by[i] > 0)
            text_row("", "%s: %" PRIu64, limit_names[i], s->limited_by[i]);
    if (s->iterations > 0)
        text_row("pressure solver", "%.3g iterations per step; not converged in %" PRIu64 " steps",
                 ratio((double)s->iterations, (double)s->steps), s->unconverged);
}

/* Phases that a method does not have are left out. */
static void print_profile(const sph2d_sim *sim, const loop_result *result)
{
    sph2d_profile p = sph2d_sim_profile(sim);
    double all = 0;
    for (int k = 0; k < SPH2D_PHASE_COUNT; ++k)
        all += p.wall[k];
    const char *row = "profile";
    for (int k = 0; k < SPH2D_PHASE_COUNT; ++k) {
        if (p.calls[k] == 0)
            continue;
        char wall[TEXT_SIZE], cpu[TEXT_SIZE];
        text_row(row, "%-8s %4.1f %%  %s, CPU %s; %.3g CPU ns per particle and step", sph2d_phase_name((sph2d_phase)k),
                 100 * ratio(p.wall[k], all), text_seconds(wall, p.wall[k]), text_seconds(cpu, p.cpu[k]),
                 1e9 * ratio(p.cpu[k], (double)result->particle_steps));
        row = "";
    }
}

static void print_table(cli_session *session, const sph2d_summary *s, const loop_result *result, const char *reason)
{
    const sph2d_scene *scene = sph2d_sim_scene(session->sim);
    text_row(scene->name, "%s at t = %.6g s of %.6g s", reason, s->time, scene->run.until);
    print_speed(session, result);
    print_errors(session->sim, scene, s);
    print_gauges(scene, &session->folder);
    print_particles(s, scene);
    print_steps(s);
    print_profile(session->sim, result);
}

/* ---- JSON -------------------------------------------------------------------------------------------------------- */

static void add_frames(cli_json *line, const frame_times *frames)
{
    json_open_object(line, "frames");
    json_count(line, "count", frames->frames);
    json_number(line, "draw_seconds", frames->sum.draw);
    json_number(line, "read_seconds", frames->sum.read);
    json_number(line, "encode_seconds", frames->sum.encode);
    json_close_object(line);
}

static void add_speed(cli_json *line, const cli_session *s, const loop_result *result)
{
    const int threads = sph2d_sim_threads(s->sim);
    double particle_steps = (double)result->particle_steps;
    json_open_object(line, "speed");
    json_number(line, "particle_steps_per_second", ratio(particle_steps, result->step_wall));
    json_number(line, "particle_steps_per_cpu_second", ratio(particle_steps, result->step_cpu));
    json_number(line, "real_time_factor", ratio(result->simulated, result->step_wall));
    json_number(line, "step_seconds", result->step_wall);
    json_number(line, "step_cpu_seconds", result->step_cpu);
    json_number(line, "output_seconds", result->output_wall);
    json_number(line, "output_cpu_seconds", result->output_cpu);
    json_count(line, "steps", result->steps);
    json_count(line, "particle_steps", result->particle_steps);
    json_count(line, "threads", (uint64_t)threads);
    json_text(line, "threads_from", threads_source(threads, &s->threads));
    json_text(line, "isa", sph2d_isa_name(sph2d_sim_isa(s->sim)));
    json_text(line, "device", device_name(&s->device));
    add_frames(line, &result->frames);
    json_close_object(line);
}

static void add_errors(cli_json *line, const sph2d_sim *sim, const sph2d_summary *s)
{
    sph2d_densities inside = sph2d_sim_densities(sim);
    json_open_object(line, "error");
    json_number(line, "compression_p99", s->compression_p99);
    json_number(line, "compression_mean", s->compression_mean);
    json_number(line, "compression_max", s->compression_max);
    json_number(line, "volume_covered", inside.covered);
    json_number(line, "density_reported", inside.reported);
    json_number(line, "density_counted", inside.counted);
    json_number(line, "density_apart", fmax(s->density_apart, fabs(inside.reported - inside.counted)));
    json_number(line, "energy_change", summary_energy_change(s));
    json_number(line, "energy_start", s->energy_start);
    json_number(line, "energy_kinetic", s->kinetic);
    json_number(line, "energy_potential", s->potential);
    json_number(line, "energy_elastic", s->elastic);
    json_number(line, "energy_bodies", s->bodies);
    json_number(line, "energy_fed", s->energy_fed);
    json_number(line, "energy_rise", s->energy_rise);
    json_number(line, "energy_error", s->energy_error);
    json_number(line, "energy_error_rise", s->energy_error_rise);
    json_number(line, "energy_walls", s->energy_walls);
    json_number(line, "energy_forces", s->energy_forces);
    json_number(line, "energy_viscous", s->energy_viscous);
    json_number(line, "energy_diffused", s->energy_diffused);
    json_number(line, "energy_stopped", s->energy_stopped);
    json_number(line, "energy_pressed", s->energy_pressed);
    json_number(line, "energy_contacts", s->energy_contacts);
    json_number(line, "energy_scale", s->energy_scale);
    json_number(line, "kinetic_max", s->kinetic_max);
    json_pair(line, "momentum", s->momentum[0], s->momentum[1]);
    json_pair(line, "momentum_error", s->momentum_error[0], s->momentum_error[1]);
    json_number(line, "momentum_error_max", s->momentum_error_max);
    json_number(line, "momentum_moved", s->momentum_moved);
    json_number(line, "speed_max", s->speed_max);
    json_close_object(line);
}

static void add_gauges(cli_json *line, const sph2d_scene *scene, cli_folder *folder)
{
    json_open_object(line, "gauges");
    for (size_t i = 0; i < scene->probe_count; ++i) {
        gauge_noise n;
        if (!find_noise(&scene->probes[i], folder, &n))
            continue;
        json_open_object(line, scene->probes[i].name);
        json_number(line, "mean", n.mean);
        json_number(line, "noise", n.deviation);
        json_number(line, "rise_time", scene->probes[i].rise_time);
        json_close_object(line);
    }
    json_close_object(line);
}

static void add_particles(cli_json *line, const sph2d_summary *s)
{
    json_open_object(line, "particles");
    json_count(line, "now", s->particles);
    json_number(line, "neighbours", s->neighbours);
    json_count(line, "paired", s->paired);
    json_count(line, "fed", s->fed);
    json_count(line, "blocked", s->blocked);
    json_count(line, "drained", s->drained);
    json_count(line, "let_in", s->let_in);
    json_count(line, "let_out", s->let_out);
    json_open_object(line, "left");
    for (int i = 0; i < 4; ++i)
        json_count(line, side_names[i], s->left_open[i]);
    json_close_object(line);
    json_count(line, "backstop_hits", s->backstop_hits);
    json_count(line, "reflections", s->reflections);
    json_close_object(line);
}

static void add_steps(cli_json *line, const sph2d_summary *s)
{
    json_count(line, "steps", s->steps);
    json_count(line, "particle_steps", s->particle_steps);
    json_pair(line, "time_step", s->time_step_min, s->time_step_max);
    json_open_object(line, "limited_by");
    for (int i = 0; i < 4; ++i)
        json_count(line, limit_names[i], s->limited_by[i]);
    json_close_object(line);
    json_count(line, "iterations", s->iterations);
    json_count(line, "unconverged", s->unconverged);
}

static void add_profile(cli_json *line, const sph2d_sim *sim)
{
    sph2d_profile p = sph2d_sim_profile(sim);
    json_open_object(line, "profile");
    for (int k = 0; k < SPH2D_PHASE_COUNT; ++k) {
        if (p.calls[k] == 0)
            continue;
        json_open_object(line, sph2d_phase_name((sph2d_phase)k));
        json_number(line, "seconds", p.wall[k]);
        json_number(line, "cpu_seconds", p.cpu[k]);
        json_count(line, "calls", p.calls[k]);
        json_close_object(line);
    }
    json_close_object(line);
}

static void print_object(cli_session *session, const sph2d_summary *s, const loop_result *result, const char *reason)
{
    const sph2d_scene *scene = sph2d_sim_scene(session->sim);
    cli_json line = json_begin(stdout);
    json_text(&line, "scene", scene->name);
    json_text(&line, "end", reason);
    json_number(&line, "time", s->time);
    json_number(&line, "until", scene->run.until);
    add_speed(&line, session, result);
    add_errors(&line, session->sim, s);
    add_gauges(&line, scene, &session->folder);
    add_particles(&line, s);
    add_steps(&line, s);
    if (session->options->profile)
        add_profile(&line, session->sim);
    json_end(&line);
}

void summary_print(cli_session *s, const loop_result *result, const char *reason)
{
    sph2d_summary summary = sph2d_sim_summary(s->sim);
    if (s->options->json)
        print_object(s, &summary, result, reason);
    else if (!s->options->quiet)
        print_table(s, &summary, result, reason);
}
