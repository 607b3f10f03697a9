/* SPDX-License-Identifier: MIT */
/** @file suites.h
 *  The list of test suites. Suite NAME is `Suite *suite_NAME(void)`; a new one is one new row here. */
#ifndef SPH2D_TESTS_SUITES_H
#define SPH2D_TESTS_SUITES_H

#include <check.h>

/* Else it makes paragraphs of long lists. */
// clang-format off
#ifdef SPH2D_NO_RENDER
#define RENDER_SUITES(X)
#else
#define RENDER_SUITES(X)                                                                                               \
    X(render)                                                                                                          \
    X(drawing)                                                                                                         \
    X(shapes) X(looks) X(balls) X(background) X(lines) X(streamlines) X(frame_times) X(null_render)
#endif

#define SUITES(X)                                                                                                      \
    X(kernels)                                                                                                         \
    X(smoothing)                                                                                                       \
    X(flows)                                                                                                           \
    X(flows_channels)                                                                                                  \
    X(flows_free)                                                                                                      \
    X(parallel)                                                                                                        \
    X(device)                                                                                                          \
    X(store)                                                                                                           \
    X(cells)                                                                                                           \
    X(periodic)                                                                                                        \
    X(muller)                                                                                                          \
    X(muller_energy)                                                                                                   \
    X(friction)                                                                                                        \
    X(tension)                                                                                                         \
    X(fitted)                                                                                                          \
    X(fitted_walls)                                                                                                    \
    X(fitted_openings) X(fitted_wall_forces)                                                                           \
    X(projection)                                                                                                      \
    X(reported_pressure)                                                                                               \
    X(limited_viscosity)                                                                                               \
    X(hybrid)                                                                                                          \
    X(variational)                                                                                                     \
    X(variational_loads)                                                                                               \
    X(variational_walls) \
    X(solvers)                                                                                                         \
    X(rest)                                                                                                            \
    X(impacts)                                                                                                         \
    X(solver_limits)                                                                                                   \
    X(features)                                                                                                        \
    X(conservation)                                                                                                    \
    X(symmetry)                                                                                                        \
    X(leapfrog)                                                                                                        \
    X(invariance)                                                                                                      \
    X(walls)                                                                                                           \
    X(layers)                                                                                                          \
    X(sides)                                                                                                           \
    X(thin)                                                                                                            \
    X(pose)                                                                                                            \
    X(forces) X(frame)                                                                                                           \
    X(turning)                                                                                                         \
    X(arcs)                                                                                                            \
    X(slip)                                                                                                            \
    X(barrier)                                                                                                         \
    X(tunnelling)                                                                                                      \
    X(absorb)                                                                                                          \
    X(implicit_viscosity)                                                                                              \
    X(closed_flow)                                                                                                     \
    X(openings) X(openings_around) X(openings_refused) X(check_flow)                                                   \
    X(open_channels)                                                                                                   \
    X(rheology)                                                                                                        \
    X(sources)                                                                                                         \
    X(edit)                                                                                                            \
    X(tracers)                                                                                                         \
    X(colors)                                                                                                          \
    X(steering)                                                                                                        \
    X(twins)                                                                                                           \
    X(scene_keys)                                                                                                      \
    X(scene_check)                                                                                                     \
    X(scene_file) X(quantity) X(foreign) X(mistakes)                                                                   \
    X(overrides)                                                                                                       \
    X(scene_text)                                                                                                      \
    X(materials)                                                                                                       \
    X(methods)                                                                                                         \
    X(plan)                                                                                                            \
    X(basin)                                                                                                           \
    X(packing)                                                                                                         \
    X(packing_rest)                                                                                                    \
    X(placing)                                                                                                         \
    X(starts) X(svg)                                                                                                          \
    X(fields)                                                                                                          \
    X(state)                                                                                                           \
    X(extremes)                                                                                                        \
    X(guards)                                                                                                          \
    X(settings)                                                                                                        \
    X(ledger)                                                                                                          \
    X(ledger_pressure)                                                                                                 \
    X(momentum)                                                                                                        \
    X(memory)                                                                                                          \
    X(shared)                                                                                                          \
    X(broken)                                                                                                          \
    X(null)                                                                                                            \
    X(outputs)                                                                                                         \
    X(sample)                                                                                                          \
    X(probes)                                                                                                          \
    X(elementary)                                                                                                      \
    X(elevation)                                                                                                       \
    X(gauge)                                                                                                           \
    X(loads)                                                                                                           \
    X(bodies)                                                                                                          \
    X(bodies_carried)                                                                                                  \
    X(gaps)                                                                                                            \
    X(outlines)                                                                                                        \
    X(vorticity)                                                                                                       \
    X(coverage)                                                                                                        \
    X(contacts)                                                                                                        \
    X(contacts_pile)                                                                                                   \
    X(series)                                                                                                          \
    X(snapshot)                                                                                                        \
    X(study)                                                                                                           \
    X(study_numbers)                                                                                                   \
    X(study_rows)                                                                                                      \
    X(study_front)                                                                                                     \
    X(study_record)                                                                                                    \
    X(study_results)                                                                                                   \
    X(report)                                                                                                          \
    RENDER_SUITES(X)
// clang-format on

#define DECLARE_SUITE(name) Suite *suite_##name(void);
SUITES(DECLARE_SUITE)
#undef DECLARE_SUITE

#endif
