/* SPDX-License-Identifier: MIT */
/** @file help.c
 *  What --help, --version and `sph2d help` print. */
#include "command.h"

#include <stdio.h>
#include <string.h>

#include <sph2d/study.h>
#include <sph2d/version.h>

#include "build.h"
#include "completion.h"
#include "exit.h"
#include "frame.h"
#include "frame_writer.h"
#include "json.h"
#include "keys.h"
#include "message.h"
#include "option_table.h"
#include "pages.h"
#include "schema.h"
#include "text.h"

/* ---- commands ---------------------------------------------------------------------------------------------------- */

/* The long description of each command. */
static const char *const details[CLI_COMMAND_COUNT] = {
    [CLI__RUN] =
        "Writes the outputs of the scene to DIR: snapshot_000000.h5 and on, frames/frame_000000.png and on, and\n"
        "NAME.csv for each probe. At the end prints speed and error. The first Ctrl-C (SIGINT, SIGTERM, SIGHUP)\n"
        "finishes the step and writes checkpoint.h5; 'sph2d resume DIR' continues, and all files are the same\n"
        "byte for byte. Before the first step it ends the run at once.\n"
        "A guard that stops a run writes guard.h5.\n"
        "SCENE may be -, the standard input; paths in it are then relative to the current folder. Without -o the\n"
        "folder gets the name of the scene.\n"
        "\n"
        "  sph2d run scene.yaml -o out\n"
        "  sph2d run scene.yaml -o out --set run.until=0.5 --set 'gravity=[0, -1.62]' --threads 2\n"
        "  ./make_scene.py | sph2d run - -o out\n",
    [CLI__RESUME] =
        "Continues from the newest complete snapshot or checkpoint in DIR, with the scene stored in it. Later\n"
        "outputs are written again, the same byte for byte. Only run.until can be changed.\n"
        "\n"
        "  sph2d resume out\n"
        "  sph2d resume out --set run.until=5\n",
    [CLI__PLAY] = "Opens a window in which the scene, or the first of its own, follows the clock; below the picture\n"
                  "stands how far it does. Nothing is written but by S and F, under new names in the current folder.\n"
                  "\n"
                  "  mouse     left: the tool, or to hold a body; right: push, or by tools W D J take away what\n"
                  "            was drawn, as a click does; wheel: reach, with Ctrl: zoom; middle: move the\n"
                  "            view; Home: all of it\n"
                  "  P G O E W tools: pull, push, pour a jet, wipe away, draw a wall\n"
                  "  D         draw a body: in turn a circle from its centre, a box from corner to corner, an outline\n"
                  "  [ ]       density of bodies that are drawn, at first half of the liquid's\n"
                  "  J         hold a body: a click on it is a hinge there, or lets go of it; a drag from it is a\n"
                  "            spring to a fixed point\n"
                  "  space .   pause; one step          + -       faster, slower\n"
                  "  arrows 0  gravity; none            V B       viscosity up, down\n"
                  "  T Y       surface tension          K L       stiffness\n"
                  "  M N C ,   metaballs, points; look of metaballs; colour by a field; colour of what is poured\n"
                  "  X Z I     arrows of the velocity; streamlines; isolines of pressure\n"
                  "  1 to 9    scenes of its own; Tab or PageDown: the next one; PageUp: the one before\n"
                  "  U Ctrl-Z  undo: back to before the last act, of ten (128 MiB of liquid at most)\n"
                  "  R A       from the start with the scene's gravity; with as many particles as follow the clock\n"
                  "  S F       save; begin and end a film, by ffmpeg where it is installed, else its frames\n"
                  "  H Q       this help; quit\n"
                  "\n"
                  "  sph2d play\n"
                  "  sph2d play scene.yaml --set spacing=0.02 --color speed\n",
    [CLI__RENDER] =
        "Writes frame_000000.png and on, one per snapshot in the order given; a folder stands for all of its\n"
        "snapshots. Of one snapshot -o FILE.png makes that file. Size, style, look, radius and colours are those of\n"
        "the scene's own frames unless an option says otherwise.\n"
        "With --film ffmpeg makes a film of them: .mp4, or an animated image for a page, .gif or .png (.apng), with\n"
        "up to 128 colours and, unless --size says otherwise, 640 pixels wide. It has the pace of the scene: --fps\n"
        "changes that. Up to 60 frames of a second are in a film, 25 in an image.\n"
        "\n"
        "  sph2d render out -o pictures\n"
        "  sph2d render out --film out.mp4\n"
        "  sph2d render out --film out.gif --size 480x270 --fps 30\n"
        "  sph2d render out/snapshot_*.h5 -o pictures --color speed --range 0,3 --size 1920x1080\n",
    [CLI__PLOT] =
        "Draws the series NAME.csv of probes by gnuplot: each quantity of each probe is a panel over time, those of\n"
        "one unit share one, such as the energies. With names, only these probes. The picture is DIR/plot.svg, or\n"
        "what -o says, SVG or PNG. The run may still be at work.\n"
        "\n"
        "  sph2d plot out\n"
        "  sph2d plot out energy gauge -o energy.png\n",
    [CLI__EXPORT] =
        "As CSV: one row per particle of the liquid, by its number, and a column with its unit for each field. Scenes\n"
        "read such a file as 'particles' and as 'start.table' of a block. As poly data for VTK, .vtp: liquid, "
        "boundary\n"
        "particles and outlines, told apart by Kinds. As a series, .pvd: snapshots, or those of a run's folder, as\n"
        "NAME_000000.vtp and so on, and their times in NAME.pvd, which ParaView opens.\n"
        "\n"
        "  sph2d export out/snapshot_000042.h5 -o particles.csv\n"
        "  sph2d export out/snapshot_000042.h5 -o splash.vtp\n"
        "  sph2d export out -o splash.pvd\n",
    [CLI__CHECK] =
        "Reports all errors at once, each with its line. If there are none: particles, derived values with their\n"
        "formulas, and estimates of steps, memory, disk and time. SCENE may be -, the standard input.\n"
        "\n"
        "  sph2d check scene.yaml --preview first.png\n",
    [CLI__STUDY] =
        "Runs the scene that STUDY names once a row, each with changes of its own, reduces the series of probes\n"
        "to numbers, compares them with what is expected, and prints one table, error beside speed, and the\n"
        "cheapest row for a wanted error. Ends with 1 when an error is above its bound. With -o the folder gets\n"
        "the numbers, plots, a page and the cheapest scene, and the same command continues where it was stopped.\n"
        "STUDY may be a scene: then its spacing and its stiffness are varied.\n"
        "With --shard I/N only every Nth row runs, from row I on: N such commands share one folder, on one machine\n"
        "or several, at the same time or not. The one that finds all rows there writes the table, and so does the\n"
        "command without --shard.\n"
        "\n"
        "  sph2d study study.yaml\n"
        "  sph2d study study.yaml -o out --all --jobs 2\n"
        "  for i in 1 2 3 4; do sph2d study study.yaml -o out --shard $i/4 & done; wait\n"
        "  sph2d study scene.yaml -o out --target 1%\n",
    [CLI__INFO] =
        "Of a snapshot prints each field with type, shape, unit and range, and the state of the run; of the\n"
        "folder of a run how far it is, whether it is finished, running or stopped and can go on, its files and\n"
        "its error of energy.\n"
        "\n"
        "  sph2d info out/snapshot_000042.h5\n"
        "  sph2d info out\n",
    [CLI__INIT] = "Writes NAME/scene.yaml, or NAME itself if it ends in .yaml. It has every key with its meaning,\n"
                  "unit, range and default.\n"
                  "\n"
                  "  sph2d init basin --template stir\n",
    [CLI__DEVICES] =
        "Prints graphics cards and other devices with OpenCL 1.2: their numbers for --device, memory, drivers, and\n"
        "whether a run has the bits of one by the processor with --isa baseline. 'sph2d check SCENE --device gpu' "
        "says\n"
        "whether a device takes a scene, and what memory that needs.\n"
        "\n"
        "  sph2d devices\n"
        "  sph2d run scene.yaml -o out --device gpu\n"
        "  sph2d run scene.yaml -o out --device 2 --same-bits\n",
    [CLI__HELP] = ("Topics: a command; exit (exit codes); codes (of messages); scene (all keys of a scene file);\n"
                   "materials (named liquids); methods (use, defaults and keys of each); schema, study.schema (JSON\n"
                   "schemas of scene and study files, for editors).\n"),
};

void help_print(void)
{
    printf("sph2d simulates liquids in two dimensions with smoothed particle hydrodynamics.\n\n");
    printf("usage: sph2d COMMAND ...\n\n");
    for (size_t i = 0; i < CLI_COMMAND_COUNT; ++i)
        printf("  %-8s %-20s %s\n", commands[i].name, commands[i].operands, commands[i].text);
    printf("\n'sph2d COMMAND --help' prints the options of a command, 'sph2d --version' the features of this build.\n");
}

void help_print_command(const cli_command *about)
{
    printf("usage: sph2d %s %s [options]\n\n", about->name, about->operands);
    printf("%s.\n\n%s\n", about->text, details[about - commands]);
    if (about->bit == CLI_INIT) {
        printf("templates:\n");
        for (size_t i = 0; i < scene_template_count; ++i)
            printf("  %-24s %s\n", scene_templates[i].name, scene_templates[i].text);
        putchar('\n');
    }
    if (about->bit == CLI_STUDY) {
        printf("keys of a study file:\n\n");
        keys_print(sph2d_study_keys());
        putchar('\n');
    }
    printf("options:\n");
    options_print(about->bit);
}

/* ---- version ----------------------------------------------------------------------------------------------------- */

static void list_isas(char *out, size_t size)
{
    out[0] = '\0';
    for (int isa = SPH2D_ISA_BASELINE; isa <= SPH2D_ISA_AVX512; ++isa) {
        size_t used = strlen(out);
        if (sph2d_isa_available((sph2d_isa)isa))
            snprintf(out + used, size - used, "%s%s", used > 0 ? " " : "", sph2d_isa_name((sph2d_isa)isa));
    }
}

void help_print_version(bool json)
{
#ifdef _OPENMP
    const bool openmp = true;
#else
    const bool openmp = false;
#endif
    char isas[64];
    list_isas(isas, sizeof isas);
    if (json) {
        cli_json line = json_begin(stdout);
        json_text(&line, "name", "sph2d");
        json_text(&line, "version", sph2d_version());
        json_text(&line, "license", "MIT");
        json_text(&line, "hdf5", sph2d_io_hdf5_version());
        json_text(&line, "rendering", frame_writer_backends());
        json_flag(&line, "openmp", openmp);
        json_text(&line, "isa", isas);
        json_text(&line, "compiler", build_compiler);
        json_text(&line, "flags", build_flags);
        json_text(&line, "commit", build_commit);
        json_end(&line);
        return;
    }
    printf("sph2d %s\n", sph2d_version());
    printf("License MIT: free to use, change and share, without any warranty.\n\n");
    text_row("HDF5", "%s", sph2d_io_hdf5_version());
    text_row("rendering", "%s", frame_writer_backends());
    text_row("OpenMP", "%s", openmp ? "yes" : "no");
    text_row("instruction sets", "%s", isas);
    text_row("compiler", "%s", build_compiler);
    text_row("flags", "%s", build_flags);
    text_row("commit", "%s", build_commit);
}

/* ---- completions of shells --------------------------------------------------------------------------------------- */

static void print_option_words(const option_row *row)
{
    char colors[200];
    const char *separator = "";
    const char *const *words = options_words(row->id);
    if (strcmp(row->name, "color") == 0) { /* "speed, Densities": without the commas */
        for (const char *c = frame_colors(colors, sizeof colors); *c != '\0'; ++c)
            if (*c != ',')
                putchar(*c);
    } else if (strcmp(row->name, "template") == 0) {
        for (size_t i = 0; i < scene_template_count; ++i, separator = " ")
            printf("%s%s", separator, scene_templates[i].name);
    } else if (words) {
        for (size_t i = 0; words[i]; ++i, separator = " ")
            printf("%s%s", separator, words[i]);
    } else {
        putchar('-');
    }
}

static void print_option_of(const cli_command *command, const option_row *row)
{
    char letter[] = "-?";
    letter[1] = (char)row->id;
    printf("option\t%s\t%s\t--%s\t%s\t", command->name, row->id < 256 ? letter : "-", row->name,
           row->argument ? row->argument : "-");
    print_option_words(row);
    printf("\t%s\n", row->text);
}

/* What the completions of shells (completions/) ask the command, so that no list of theirs can go stale. Lines of fields
 * between tabs, "-" where there is none:
 *
 *      command NAME OPERANDS TEXT
 *      option  COMMAND LETTER NAME ARGUMENT WORDS TEXT      -o --output DIR
 *
 * for each command and each option of it. WORDS are the values that it can have, between spaces. `sph2d help completions`
 * prints the topics of help after them; with the name of a file, lines about the scene there (completion.h). */
static void print_commands(void)
{
    for (size_t i = 0; i < CLI_COMMAND_COUNT; ++i) {
        const cli_command *command = &commands[i];
        printf("command\t%s\t%s\t%s\n", command->name, command->operands[0] != '\0' ? command->operands : "-",
               command->text);
        const option_row *row;
        for (size_t k = 0; (row = options_row(k)); ++k)
            if (row->commands & command->bit)
                print_option_of(command, row);
    }
}

/* ---- topics ------------------------------------------------------------------------------------------------------ */

static void print_exits(void)
{
    static const struct {
        int value;
        const char *sysexit, *text;
    } exits[] = {
#define EXIT_ROW(name, value, sysexit, text) {value, sysexit, text},
        CLI_EXIT_MAP(EXIT_ROW)
#undef EXIT_ROW
    };
    for (size_t i = 0; i < sizeof exits / sizeof *exits; ++i)
        printf("%4d  %-14s %s\n", exits[i].value, exits[i].sysexit, exits[i].text);
}

static void print_codes(void)
{
    static const struct {
        const char *code, *text;
    } codes[] = {
#define CODE_ROW(name, code, text) {code, text},
        SPH2D_CODE_MAP(CODE_ROW)
#undef CODE_ROW
    };
    for (size_t i = 0; i < sizeof codes / sizeof *codes; ++i)
        printf("%s  %s\n", codes[i].code, codes[i].text);
}

static void print_materials(void)
{
    size_t count;
    const sph2d_material_data *materials = sph2d_materials(&count);
    char law[200];
    printf("At 20 C, unless the source says otherwise. 'fluid: NAME' sets density and viscosity, or the model of a\n"
           "liquid that has no single viscosity; surface_tension is 0 unless it is given.\n\n");
    printf("%-10s %8s %18s %16s  %s\n", "name", "density", "dynamic_viscosity", "surface_tension", "source");
    printf("%-10s %8s %18s %16s\n", "", "kg/m^3", "Pa s", "N/m");
    for (size_t i = 1; i < count; ++i) {
        char viscosity[24] = "see below", tension[24] = "-";
        if (materials[i].model == SPH2D_RHEOLOGY_NEWTONIAN)
            snprintf(viscosity, sizeof viscosity, "%g", materials[i].dynamic_viscosity);
        if (materials[i].surface_tension > 0)
            snprintf(tension, sizeof tension, "%g", materials[i].surface_tension);
        printf("%-10s %8g %18s %16s  %s\n", materials[i].name, materials[i].density, viscosity, tension,
               materials[i].source);
    }
    printf("\nTheir viscosity depends on the shear rate: with wcsph (variational operators) and constraint. With\n"
           "'model: newtonian' and a dynamic_viscosity they are liquids for every method.\n\n");
    for (size_t i = 1; i < count; ++i)
        if (keys_law(&materials[i], law, sizeof law)[0] != '\0')
            printf("%-10s %s\n", materials[i].name, law);
}

static void print_methods(void)
{
    const sph2d_method_info *method;
    for (size_t k = 0; (method = sph2d_method_row(k)); ++k) {
        printf("%s%s\n", method->name, k == 0 ? " (the default)" : "");
        printf("  for       %s\n", method->use);
        printf("  scheme    %s\n", method->scheme);
        printf("  source    %s\n", method->source);
        printf("  defaults  support_ratio %g, max_compression %g\n", method->support_ratio, method->max_compression);
        char forms[80] = "";
        keys_append_wall_forms(method->wall_forms, forms, sizeof forms);
        printf("  walls     %s\n\n", forms);
    }
    printf("Keys that not every method has, and the methods that have them:\n");
#define FEATURE_ROW(name, key) SPH2D_FEATURE_##name,
    static const sph2d_feature features[] = {SPH2D_FEATURE_MAP(FEATURE_ROW)};
#undef FEATURE_ROW
    for (size_t k = 0; k < sizeof features / sizeof *features; ++k) {
        char having[200] = "";
        keys_append_methods(features[k], having, sizeof having);
        printf("  %-32s %s\n", sph2d_feature_key(features[k]), having);
    }
}

static void print_schema(void)
{
    schema_print(sph2d_scene_keys(), "scene of sph2d");
}

static void print_study_schema(void)
{
    schema_print(sph2d_study_keys(), "study of sph2d");
}

static void print_completions(void);

static const struct {
    const char *name;
    void (*print)(void);
    bool of_users; /* the others are for programs */
} topics[] = {{"exit", print_exits, true},
              {"codes", print_codes, true},
              {"scene", keys_print_all, true},
              {"materials", print_materials, true},
              {"methods", print_methods, true},
              {"schema", print_schema, true},
              {"study.schema", print_study_schema, true},
              /* what completions of shells ask */
              {"completions", print_completions, false},
              /* what `make scene-docs` puts into docs/scenes.md and sph2d-scene.5 */
              {"scene.md", pages_print_markdown, false},
              {"scene.5", pages_print_manual, false}};
enum { TOPIC_COUNT = sizeof topics / sizeof *topics };

static void print_completions(void)
{
    print_commands();
    for (size_t i = 0; i < TOPIC_COUNT; ++i)
        if (topics[i].of_users)
            printf("topic\t%s\n", topics[i].name);
}

static void unknown_topic(const char *topic)
{
    const char *names[CLI_COMMAND_COUNT + TOPIC_COUNT];
    size_t count = 0;
    for (size_t i = 0; i < CLI_COMMAND_COUNT; ++i)
        names[count++] = commands[i].name;
    for (size_t i = 0; i < TOPIC_COUNT; ++i)
        names[count++] = topics[i].name;
    const char *nearest = text_nearest(topic, names, count);
    if (nearest)
        message_usage("help", "unknown topic '%s'; did you mean '%s'?", topic, nearest);
    else
        message_usage("help", "unknown topic '%s'", topic);
}

int command_help(const cli_options *options)
{
    if (options->operand_count == 0) {
        help_print();
        return CLI_EXIT_SUCCESS;
    }
    if (options->operand_count == 2 && strcmp(options->operands[0], "completions") == 0) {
        completion_print(options->operands[1]);
        return CLI_EXIT_SUCCESS;
    }
    if (options->operand_count > 1) {
        message_usage("help", "one topic at a time");
        return CLI_EXIT_USAGE;
    }
    const char *topic = options->operands[0];
    const cli_command *about = command_find(topic);
    if (about) {
        help_print_command(about);
        return CLI_EXIT_SUCCESS;
    }
    for (size_t i = 0; i < TOPIC_COUNT; ++i) {
        if (strcmp(topics[i].name, topic) == 0) {
            topics[i].print();
            return CLI_EXIT_SUCCESS;
        }
    }
    if (keys_print_one(topic))
        return CLI_EXIT_SUCCESS;
    unknown_topic(topic);
    return CLI_EXIT_USAGE;
}
