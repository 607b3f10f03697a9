/* SPDX-License-Identifier: MIT */
/** @file window.c
 *  The liquid in a program's own window and OpenGL context, here by GLFW: it follows the clock, the mouse pulls it. Links
 *  libsph2d and libsph2d-render.
 *
 *      cc window.c $(pkg-config --cflags --libs sph2d-render glfw3) -o window && ./window */
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <sph2d/field.h>
#include <sph2d/render.h>
#include <stdio.h>

/** Draws the liquid and its walls into the window's framebuffer. The program may draw more around or over it. */
static sph2d_status draw(sph2d_renderer *renderer, const sph2d_sim *sim, sph2d_report *report)
{
    const sph2d_scene *scene = sph2d_sim_scene(sim);
    const sph2d_view fluid = sph2d_sim_fluid(sim);
    const sph2d_array corners = sph2d_field(sim, SPH2D_GROUP_OUTLINE, 0);
    const sph2d_picture picture = {.view = scene->domain,
                                   .radius = 2 * scene->spacing,
                                   .count = fluid.count,
                                   .x = fluid.x,
                                   .y = fluid.y,
                                   .outline_count = corners.count,
                                   .outline_x = corners.data[0],
                                   .outline_y = corners.data[1],
                                   .outline_id = sph2d_field(sim, SPH2D_GROUP_OUTLINE, 1).data[0],
                                   .outline_liquid = sph2d_field(sim, SPH2D_GROUP_OUTLINE, 2).data[0],
                                   .wall_thickness = scene->spacing};
    return sph2d_renderer_draw_to(renderer, 0, 0, 0, &picture, report);
}

/** Lets the simulation catch up with the clock, for at most a sixtieth of a second of it. */
static sph2d_status follow(sph2d_sim *sim, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    const double begun = glfwGetTime();
    while (status == SPH2D_OK && sph2d_sim_time(sim) < begun && glfwGetTime() < begun + 1.0 / 60)
        status = sph2d_sim_step(sim, report);
    return status;
}

static sph2d_status run(GLFWwindow *window, sph2d_sim *sim, sph2d_renderer *renderer, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    while (status == SPH2D_OK && !glfwWindowShouldClose(window) && sph2d_sim_time(sim) < 2) {
        double x, y;
        sph2d_vec2 at;
        glfwPollEvents();
        glfwGetCursorPos(window, &x, &y);
        const int down = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT);
        if (sph2d_renderer_locate(renderer, x, y, &at))
            sph2d_sim_set_pointer(sim, at, 0.2, down ? 40 : 0);
        status = follow(sim, report);
        if (status == SPH2D_OK)
            status = draw(renderer, sim, report);
        glfwSwapBuffers(window);
    }
    return status;
}

int main(void)
{
    sph2d_scene scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {1.6, 0.9}};
    scene.spacing = 0.02;
    sph2d_block column = sph2d_block_default();
    column.shape.kind = SPH2D_SHAPE_BOX;
    column.shape.box = (sph2d_box){{0, 0}, {0.5, 0.7}};
    scene.blocks = &column;
    scene.block_count = 1;

    glfwInit();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    GLFWwindow *window = glfwCreateWindow(960, 540, "liquid", NULL, NULL);
    if (!window)
        return puts("this needs a display with OpenGL 3.3"), 1;
    glfwMakeContextCurrent(window);

    sph2d_render_options options = sph2d_render_options_default();
    options.width = 960;
    options.height = 540;
    options.get_proc_address = glfwGetProcAddress;
    sph2d_sim *sim = NULL;
    sph2d_renderer *renderer = NULL;
    sph2d_report report = {0};
    sph2d_status status = sph2d_sim_create(&scene, NULL, &sim, &report);
    if (status == SPH2D_OK)
        status = sph2d_renderer_create(&options, &renderer, &report);
    if (status == SPH2D_OK)
        status = run(window, sim, renderer, &report);
    for (size_t i = 0; i < report.count; ++i)
        fprintf(stderr, "%s\n", report.items[i].message);
    printf("%zu particles, %.1f s\n", sph2d_sim_fluid(sim).count, sph2d_sim_time(sim));
    sph2d_renderer_destroy(renderer);
    sph2d_sim_destroy(sim);
    glfwTerminate();
    return (int)status;
}
