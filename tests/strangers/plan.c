/* SPDX-License-Identifier: MIT */
/* What check foretells of a run, and what it warns of, against the run. */
#include <math.h>
#include <string.h>

#include "judge.h"

/** The sound speed is chosen for max_compression, but for surface tension, of which check warns. Methods that project
 *  have no such choice: they tell what did not converge. */
static void judge_compression(const char *messages, const sph2d_sim *sim, const library_run *run, verdict *v)
{
    const sph2d_plan *plan = sph2d_sim_plan(sim);
    const sph2d_method_options *m = &sph2d_sim_scene(sim)->method;
    const double c2 = plan->sound_speed * plan->sound_speed, p99 = run->summary.compression_p99;
    const double told = (plan->head + plan->capillary_head) / c2, capillary = plan->capillary_head / c2;
    const bool warned = strstr(messages, "compresses the thinnest block") != NULL;
    if (m->name != SPH2D_METHOD_WCSPH && m->name != SPH2D_METHOD_MULLER)
        return;
    if (!(p99 <= PRESSED_BOUND * fmax(m->max_compression, told)))
        verdict_fail(v, "plan", "compressed by %.3g %%, with a max_compression of %.3g %%, and check tells %.3g %%",
                     100 * p99, 100 * m->max_compression, 100 * told);
    if (warned && !(p99 >= UNPRESSED_BOUND * capillary))
        verdict_fail(v, "plan", "check warns of a compression of %.3g %%, and there is one of %.3g %%", 100 * capillary,
                     100 * p99);
}

bool foretells_fall(const char *messages)
{
    return strstr(messages, "along a period nothing but friction") != NULL;
}

void judge_plan(const char *told, const char *messages, const sph2d_sim *sim, const library_run *run, verdict *v)
{
    const double steps = number(told, "steps"), took = (double)run->summary.steps;
    if (sim == NULL)
        return;
    if (!(took <= STEPS_BOUND * steps + STEPS_SLACK && steps <= STEPS_BOUND * took + STEPS_SLACK))
        verdict_fail(v, "plan", "check foretells %.0f steps, there are %.0f", steps, took);
    const sph2d_plan *plan = sph2d_sim_plan(sim);
    const double speed = sqrt(2 * (plan->head + plan->capillary_head));
    bool pressed = false; /* blocks start with less than the spacing between particles: nothing is foretold of that */
    for (size_t i = 0; i < sph2d_sim_scene(sim)->block_count; ++i)
        pressed = pressed || (sph2d_sim_scene(sim)->blocks[i].spacing > 0 &&
                              sph2d_sim_scene(sim)->blocks[i].spacing < sph2d_sim_scene(sim)->spacing);
    if (pressed)
        return;
    if (!foretells_fall(messages) && !(run->fastest <= SPEED_BOUND * speed))
        verdict_fail(v, "plan", "liquid gets as fast as %.3g m/s, the sound speed is made for %.3g m/s", run->fastest,
                     speed);
    judge_compression(messages, sim, run, v);
}
