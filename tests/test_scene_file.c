/* SPDX-License-Identifier: MIT */
/** @file test_scene_file.c
 *  Scene files: what is read, and that every fault is told once, with its code and its place. */
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "sph2d/io.h"
#include "sph2d/key.h"

#define DOMAIN "domain: {min: [0, 0], max: [1, 1]}\n"
#define SPACING "spacing: 0.1\n"
#define BLOCKS "blocks:\n  - box: {min: [0, 0], max: [0.4, 0.8]}\n"
#define FLUID "fluid: {dynamic_viscosity: 100}\n"
#define SOUND DOMAIN SPACING BLOCKS FLUID /* five lines that are a scene without a warning */

static sph2d_status parse(const char *text, const sph2d_override *overrides, size_t count, sph2d_scene_file **file,
                          sph2d_report *report)
{
    sph2d_report_clear(report);
    return sph2d_scene_file_parse(text, strlen(text), "s.yaml", overrides, count, file, report);
}

/* ---- one fault, one sentence ------------------------------------------------------------------------------------- */

static const struct fault {
    const char *text;
    sph2d_code code;
    const char *path;
    int line, column;
    const char *message, *hint; /**< parts of them */
} faults[] = {
    /* keys */
    {SOUND "colour: 3\n", SPH2D_CODE_UNKNOWN_KEY, "colour", 6, 1, "unknown key 'colour'", "keys here: name, domain"},
    {DOMAIN SPACING BLOCKS "fluid: {desnity: 1}\n", SPH2D_CODE_UNKNOWN_KEY, "fluid.desnity", 5, 9, "'desnity'",
     "did you mean 'density'?"},
    {SOUND "Gravity: [0, 0]\n", SPH2D_CODE_UNKNOWN_KEY, "Gravity", 6, 1, "'Gravity'", "did you mean 'gravity'?"},
    {SOUND "density: 1000\n", SPH2D_CODE_UNKNOWN_KEY, "density", 6, 1, "'density'", "did you mean 'fluid.density'?"},
    {DOMAIN SPACING "blocks:\n  - box: {min: [0, 0], max: [0.4, 0.8]}\n    velocty: [0, 1]\n", SPH2D_CODE_UNKNOWN_KEY,
     "blocks[0].velocty", 5, 5, "'velocty'", "did you mean 'velocity'?"},
    {SOUND "spacing: 0.1\n", SPH2D_CODE_DUPLICATE_KEY, "spacing", 6, 1, "'spacing' is given twice", "first on line 2"},
    {SPACING BLOCKS, SPH2D_CODE_MISSING_KEY, "domain", 0, 0, "'domain' must be given", "the simulated rectangle"},
    {DOMAIN BLOCKS, SPH2D_CODE_MISSING_KEY, "spacing", 0, 0, "'spacing' must be given", "in m"},
    {"domain: {min: [0, 0]}\n" SPACING BLOCKS, SPH2D_CODE_MISSING_KEY, "domain.max", 1, 9, "'max' must be given", ""},
    {DOMAIN SPACING "blocks:\n  - box: {min: [0, 0], max: [0.4, 0.8]}\n    disc: {center: [0, 0], radius: 1}\n",
     SPH2D_CODE_CONFLICT, "blocks[0].circle", 5, 5, "'disc' excludes 'box' on line 4", "one of box, circle, polygon"},
    {DOMAIN SPACING "blocks:\n  - velocity: [0, 0]\n", SPH2D_CODE_MISSING_KEY, "blocks[0]", 4, 5, "has no shape",
     "box, circle, polygon"},
    {"domain: {min: [0.2, 0.2], max: [1, 1]}\n" SPACING "blocks:\n  - disc: {radius: 0.1}\n", SPH2D_CODE_MISSING_KEY,
     "blocks[0].circle.center", 4, 11, "'center' must be given", "centre"}, /* and nothing of where it is then */
    {DOMAIN SPACING "blocks:\n  - box: {min: [0, 0], max: [0.4, 0.8]}\n    disk: {radius: 0.1}\n",
     SPH2D_CODE_UNKNOWN_KEY, "blocks[0].disk", 5, 5, "unknown key 'disk'", "did you mean 'disc'?"},
    {DOMAIN SPACING "blocks:\n  - disc: {center: [0.2, 0.2], radius: 0}\n", SPH2D_CODE_OUT_OF_RANGE,
     "blocks[0].circle.radius", 4, 40, "must be above 0", ""}, /* a word for the same */
    {DOMAIN SPACING
     "blocks:\n  - disc: {center: [0.3, 0.3], radius: 0.1}\n    circle: {center: [0.3, 0.3], radius: 0.1}\n",
     SPH2D_CODE_DUPLICATE_KEY, "blocks[0].circle", 5, 5, "'circle' is given twice", "first on line 4"},
    /* types */
    {DOMAIN "spacing: abc\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 2, 10, "expected a number, got 'abc'", "in m"},
    {DOMAIN "spacing: 0.1 m\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 2, 10, "got '0.1 m'", "0.1 m: write 0.1 [m]"},
    {DOMAIN "spacing: \"0.1\"\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 2, 10, "got the text '0.1'",
     "write it without quotes: 0.1"},
    {DOMAIN "spacing: 0x10\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 2, 10, "got '0x10'", ""},
    {DOMAIN "spacing: 1e\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 2, 10, "got '1e'", ""},
    {DOMAIN "spacing: 0,1\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 2, 10, "got '0,1'", ""},
    {DOMAIN "spacing:\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 2, 1, "got nothing", ""},
    {DOMAIN "spacing: ~\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 2, 1, "got nothing", ""},
    {DOMAIN "spacing: [0.1]\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 2, 10, "got a list of 1", ""},
    {DOMAIN "spacing:\n  a: 1\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 2, 1, "got a mapping", ""},
    {SOUND "gravity: [0, -9.81, 0]\n", SPH2D_CODE_WRONG_TYPE, "gravity", 6, 10, "two numbers [x, y], got a list of 3",
     "m/s^2"},
    {SOUND "method: {max_compression: 2%}\n", SPH2D_CODE_WRONG_TYPE, "method.max_compression", 6, 27,
     "expected a number, got '2%'", "2%: write 0.02"},
    {SOUND "gravity: [0, -9.81 m/s2]\n", SPH2D_CODE_WRONG_TYPE, "gravity", 6, 14, "", "write -9.81 [m/s^2]"},
    {SOUND "gravity: [0,0, -9,81]\n", SPH2D_CODE_WRONG_TYPE, "gravity", 6, 10, "got a list of 4", "[0.0, -9.81]?"},
    {SOUND "gravity: [0 -9.81]\n", SPH2D_CODE_WRONG_TYPE, "gravity", 6, 10, "got a list of 1", "write a comma between"},
    {SOUND "gravity_path: [[0 ms, 0, 0]]\n", SPH2D_CODE_WRONG_TYPE, "gravity_path", 6, 17, "", "write 0 [s]"},
    {SOUND "gravity_path: [[0, 0, 1 g]]\n", SPH2D_CODE_WRONG_TYPE, "gravity_path", 6, 23, "",
     "in [m/s^2]: g is a unit of"},
    {SOUND "run: {frames: {size: 1280x720}}\n", SPH2D_CODE_WRONG_TYPE, "run.frames.size", 6, 22, "",
     "write [1280, 720]"},
    {SOUND "gravity: [0, down]\n", SPH2D_CODE_WRONG_TYPE, "gravity", 6, 14, "expected a number, got 'down'", ""},
    {"domain: 3\n" SPACING BLOCKS, SPH2D_CODE_WRONG_TYPE, "domain", 1, 9, "expected a mapping, got '3'", ""},
    {DOMAIN SPACING "blocks: {}\n", SPH2D_CODE_WRONG_TYPE, "blocks", 3, 9, "expected a list, got a mapping", ""},
    {DOMAIN SPACING "blocks:\n  - 3\n", SPH2D_CODE_WRONG_TYPE, "blocks[0]", 4, 5, "expected a mapping, got '3'", ""},
    {DOMAIN SPACING "blocks:\n  - polygon: 1\n", SPH2D_CODE_WRONG_TYPE, "blocks[0].polygon", 4, 14,
     "a list of point [x, y]s", ""},
    {SOUND "boundary: {left: no}\n", SPH2D_CODE_WRONG_TYPE, "boundary.left", 6, 18, "unknown value 'no'",
     "one of: wall, open"},
    {SOUND "walls: sprin\n", SPH2D_CODE_WRONG_TYPE, "walls", 6, 8, "'sprin'", "did you mean 'spring'?"},
    {SOUND "walls: [spring]\n", SPH2D_CODE_WRONG_TYPE, "walls", 6, 8, "expected a word, got a list of 1", ""},
    {SOUND "name: [a]\n", SPH2D_CODE_WRONG_TYPE, "name", 6, 7, "expected a text, got a list of 1", ""},
    {SOUND "run: {frames: {size: [1280.5, 720]}}\n", SPH2D_CODE_WRONG_TYPE, "run.frames.size", 6, 23,
     "a whole number, got '1280.5'", "pixels"},
    /* numbers */
    {DOMAIN "spacing: -0.1\n" BLOCKS, SPH2D_CODE_OUT_OF_RANGE, "spacing", 2, 10, "-0.1 is out of range", "in m"},
    {DOMAIN "spacing: 0\n" BLOCKS, SPH2D_CODE_OUT_OF_RANGE, "spacing", 2, 10, "must be above 0", ""},
    {DOMAIN "spacing: nan\n" BLOCKS, SPH2D_CODE_OUT_OF_RANGE, "spacing", 2, 10, "'nan' is not a finite number", ""},
    {DOMAIN "spacing: .NaN\n" BLOCKS, SPH2D_CODE_OUT_OF_RANGE, "spacing", 2, 10, "'.NaN' is not a finite", ""},
    {DOMAIN "spacing: +.inf\n" BLOCKS, SPH2D_CODE_OUT_OF_RANGE, "spacing", 2, 10, "'+.inf' is not a finite", ""},
    {DOMAIN "spacing: 1e999\n" BLOCKS, SPH2D_CODE_OUT_OF_RANGE, "spacing", 2, 10, "range of a double", ""},
    {DOMAIN "spacing: 1e-999\n" BLOCKS, SPH2D_CODE_OUT_OF_RANGE, "spacing", 2, 10, "range of a double", ""},
    {SOUND "run: {frames: {size: [1280, -720]}}\n", SPH2D_CODE_OUT_OF_RANGE, "run.frames.size", 6, 29,
     "must be at least 16 and at most 16384", ""},
    {SOUND "run: {snapshots: {compress: 99999999999999999999}}\n", SPH2D_CODE_OUT_OF_RANGE, "run.snapshots.compress", 6,
     29, "at most 9", ""},
    {SOUND "run: {snapshots: {compress: 10}}\n", SPH2D_CODE_OUT_OF_RANGE, "run.snapshots.compress", 6, 29, "at most 9",
     ""},
    {DOMAIN SPACING "blocks:\n  - box: {min: [0, 0], max: [0.4, 1.8]}\n", SPH2D_CODE_OUTSIDE, "blocks[0].box", 4, 10,
     "lies outside the domain", "(0, 0) to (1, 1)"},
    {DOMAIN SPACING, SPH2D_CODE_NO_PARTICLES, "blocks", 0, 0, "neither liquid nor a source", ""},
    /* what is no YAML, or more than a scene needs of it */
    {"", SPH2D_CODE_SYNTAX, "", 0, 0, "it is empty", "key: value"},
    {"# nothing\n\n", SPH2D_CODE_SYNTAX, "", 0, 0, "it is empty", ""},
    {"just words\n", SPH2D_CODE_SYNTAX, "", 1, 1, "expected the keys of a scene, got 'just words'", ""},
    {"- a\n- b\n", SPH2D_CODE_SYNTAX, "", 1, 1, "got a list of 2", ""},
    {DOMAIN "spacing: [0.1\n" FLUID, SPH2D_CODE_SYNTAX, "", 2, 10, "the bracket that opens here is not closed", ""},
    {DOMAIN "spacing: \"0.1\n", SPH2D_CODE_SYNTAX, "", 2, 11, "without closing quote", ""},
    {DOMAIN "spacing: a: b\n", SPH2D_CODE_SYNTAX, "", 2, 11, "invalid nested block mapping", ""},
    {DOMAIN "fluid:\n\tdensity: 1\n", SPH2D_CODE_SYNTAX, "", 3, 1, "tab character", ""},
    {SOUND "---\nname: again\n", SPH2D_CODE_SYNTAX, "", 6, 1, "a second document", ""},
    {SOUND "name: &a b\n", SPH2D_CODE_SYNTAX, "", 6, 8, "anchors (&name) are not allowed", ""},
    {SOUND "name: *a\n", SPH2D_CODE_SYNTAX, "", 6, 8, "aliases (*name) are not allowed", ""},
    {SOUND "name: !!str b\n", SPH2D_CODE_SYNTAX, "", 6, 7, "tags (!name) are not allowed", ""},
    {SOUND "? [a]\n: b\n", SPH2D_CODE_SYNTAX, "", 6, 3, "a key must be a word", ""},
    {SOUND "name: \"a\\0b\"\n", SPH2D_CODE_SYNTAX, "", 6, 8, "NUL character", ""},
    {SOUND "name: \xff\n", SPH2D_CODE_SYNTAX, "", 6, 7, "byte 0xff", ""},
    {SOUND "name: \xc3(\n", SPH2D_CODE_SYNTAX, "", 6, 7, "byte 0xc3", ""},
    {SOUND "name: \xed\xa0\x80\n", SPH2D_CODE_SYNTAX, "", 6, 7, "byte 0xed", ""},
    {SOUND "name: \x01\n", SPH2D_CODE_SYNTAX, "", 6, 7, "byte 0x01", ""},
    /* places behind characters of several bytes, and behind other line ends */
    {"# \xc3\xa4\r\n" DOMAIN "# \xe2\x82\xac\rspacing: \xc3\xa4\r\n" BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 4, 10,
     "got '\xc3\xa4'", ""},
    {"\xef\xbb\xbfspacing: x\n" DOMAIN BLOCKS, SPH2D_CODE_WRONG_TYPE, "spacing", 1, 10, "got 'x'", ""},
    {DOMAIN "fluid: {\"density\": 'x'}\n" SPACING BLOCKS, SPH2D_CODE_WRONG_TYPE, "fluid.density", 2, 20, "the text 'x'",
     ""},
};

START_TEST(each_fault_has_its_place)
{
    const struct fault *f = &faults[_i];
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    ck_assert_int_eq(parse(f->text, NULL, 0, &file, &report), SPH2D_SCENE);
    ck_assert_ptr_null(file);
    ck_assert_msg(report.count == 1 && report.errors == 1, "more than one error:\n%s", test_report_text(&report));
    const sph2d_diagnostic *d = &report.items[0];
    const char *all = test_report_text(&report);
    ck_assert_msg(d->code == f->code, "%s", all);
    ck_assert_str_eq(d->path, f->path);
    ck_assert_str_eq(d->file, "s.yaml");
    ck_assert_msg(d->line == f->line && d->column == f->column, "expected %d:%d in\n%s", f->line, f->column, all);
    ck_assert_msg(strstr(d->message, f->message) != NULL, "expected '%s' in\n%s", f->message, all);
    ck_assert_msg(strstr(d->hint, f->hint) != NULL, "expected '%s' in\n%s", f->hint, all);
    ck_assert_int_eq(d->excerpt[0] != '\0', d->line > 0);
}
END_TEST

START_TEST(all_faults_come_at_once_in_the_order_of_the_file)
{
    static const char text[] = "nmae: x\n"
                               "domain: {min: [0, 0], max: [1, 1]}\n"
                               "spacing: -1\n"
                               "fluid: {density: x, density: 2}\n"
                               "blocks:\n"
                               "  - box: {min: [0, 0], max: [2, 2]}\n"
                               "run: {until: soon, frames: {style: blobs}}\n";
    static const struct {
        sph2d_code code;
        int line, column;
    } expected[] = {{SPH2D_CODE_UNKNOWN_KEY, 1, 1}, {SPH2D_CODE_OUT_OF_RANGE, 3, 10},
                    {SPH2D_CODE_WRONG_TYPE, 4, 18}, {SPH2D_CODE_DUPLICATE_KEY, 4, 21},
                    {SPH2D_CODE_WRONG_TYPE, 7, 14}, {SPH2D_CODE_WRONG_TYPE, 7, 36}};
    sph2d_report report = {0};
    sph2d_scene_file *file;
    ck_assert_int_eq(parse(text, NULL, 0, &file, &report), SPH2D_SCENE);
    ck_assert_msg(report.count == 6, "%s", test_report_text(&report));
    for (size_t i = 0; i < 6; ++i) {
        ck_assert_int_eq(report.items[i].code, expected[i].code);
        ck_assert_int_eq(report.items[i].line, expected[i].line);
        ck_assert_int_eq(report.items[i].column, expected[i].column);
    }
    ck_assert_str_eq(report.items[2].excerpt, "fluid: {density: x, density: 2}");
}
END_TEST

START_TEST(consequences_of_a_fault_are_not_faults)
{
    /* the domain cannot be read, so nothing can be outside it */
    sph2d_report report = {0};
    sph2d_scene_file *file;
    ck_assert_int_eq(parse("domain: {min: [0, 0], max: [x, 1]}\n" SPACING BLOCKS, NULL, 0, &file, &report),
                     SPH2D_SCENE);
    ck_assert_msg(report.count == 1 && report.items[0].code == SPH2D_CODE_WRONG_TYPE, "%s", test_report_text(&report));
    /* but an unknown key spoils nothing */
    static const char both[] = DOMAIN SPACING "blocks:\n  - box: {min: [0, 0], max: [0.4, 1.8]}\n    x: 1\n";
    ck_assert_int_eq(parse(both, NULL, 0, &file, &report), SPH2D_SCENE);
    ck_assert_msg(report.count == 2, "%s", test_report_text(&report));
    ck_assert(test_report_has(&report, SPH2D_CODE_OUTSIDE, "blocks[0].box"));
    ck_assert(test_report_has(&report, SPH2D_CODE_UNKNOWN_KEY, "blocks[0].x"));
}
END_TEST

START_TEST(faults_beyond_the_report_are_counted)
{
    char text[1000] = SOUND;
    for (int i = 0; i < 30; ++i)
        snprintf(text + strlen(text), sizeof text - strlen(text), "qqqqq%d: 1\n", i);
    sph2d_report report = {0};
    sph2d_scene_file *file;
    ck_assert_int_eq(parse(text, NULL, 0, &file, &report), SPH2D_SCENE);
    ck_assert_uint_eq(report.count, SPH2D_REPORT_CAPACITY);
    ck_assert_uint_eq(report.errors, 30);
    ck_assert_uint_eq(report.dropped, 10);
    ck_assert_int_eq(sph2d_scene_file_parse(text, strlen(text), "s.yaml", NULL, 0, &file, NULL), SPH2D_SCENE);
    ck_assert_int_eq(sph2d_scene_file_parse(NULL, 3, "s.yaml", NULL, 0, &file, NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_scene_file_parse("", 0, "s.yaml", NULL, 0, NULL, NULL), SPH2D_INVALID);
}
END_TEST

/* ---- what is read ------------------------------------------------------------------------------------------------ */

static const char whole[] =
    "name: \"a: b\"\n"
    "domain:\n  min: [-1, 0]\n  max: [3, +2.]\n"
    "boundary: {left: open, right: wall, bottom: wall, top: wall}\n"
    "walls: reflect\nwall_damping: .5\ngravity: [1.5e0, -9.81]\nspacing: 1.0E-1\n"
    "fluid: {density: 900, dynamic_viscosity: 20}\n"
    "method: {name: muller, max_compression: 0.2, stiffness: 300, support_ratio: 2.5, cfl: 0.2, time_step: 1e-4}\n"
    "blocks:\n"
    "  - disc: {center: [1, 1], radius: 0.3}\n    velocity: [2, 3]\n    spacing: 0.05\n"
    "  - polygon: [[0, 0], [0.5, 0], [0, 0.5]]\n"
    "sources:\n  - {at: [2, 1.5], speed: 2, width: 0.2, rate: 0.1, spread: 0.1, seed: 18446744073709551615, stop: 3}\n"
    "drains: [{box: {min: [2, 0], max: [3, 0.1]}, start: 1}]\n"
    "obstacles:\n  - line: [[0, 1], [0.5, 1]]\n    form: reflect\n    restitution: 0.9\n"
    "  - polyline:\n    - [2, 0.5]\n    - [2.2, 0.6]\n    - [2.4, 0.5]\n"
    "  - circle: {center: [2, 1], radius: 0.2}\n"
    "interactions: [{path: [[0, 1, 1], [1, 2, 1]], radius: 0.5, acceleration: -20}]\n"
    "probes: [{name: all, kind: energy, per_second: 10}, {name: here, kind: speed, at: [1, 1], every: 0.5}]\n"
    "run:\n  until: 4\n  snapshots: {per_second: 60, compress: 6}\n"
    "  frames: {every: 0.1, size: [640, 480], style: points, radius: 0.02, color: speed, color_range: [0, 5]}\n"
    "  impacts: [0.5, 1]\n";

START_TEST(every_key_arrives)
{
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_status status = parse(whole, NULL, 0, &file, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    const sph2d_scene *s = sph2d_scene_file_scene(file);
    ck_assert_str_eq(s->name, "a: b");
    ck_assert(s->domain.min.x == -1 && s->domain.max.x == 3 && s->domain.max.y == 2);
    ck_assert(s->boundary.left == SPH2D_SIDE_OPEN && s->boundary.top == SPH2D_SIDE_WALL);
    ck_assert(s->walls == SPH2D_WALL_REFLECT && s->wall_damping == 0.5 && s->gravity.x == 1.5);
    ck_assert(s->spacing == 0.1 && s->fluid.density == 900 && s->method.time_step == 1e-4);
    ck_assert_uint_eq(s->block_count, 2);
    ck_assert(s->blocks[0].shape.kind == SPH2D_SHAPE_CIRCLE && s->blocks[0].shape.circle.radius == 0.3);
    ck_assert(s->blocks[0].velocity.y == 3 && s->blocks[0].spacing == 0.05);
    ck_assert(s->blocks[1].shape.kind == SPH2D_SHAPE_POLYGON && s->blocks[1].shape.points.count == 3);
    ck_assert(s->blocks[1].shape.points.items[2].y == 0.5);
    ck_assert_uint_eq(s->source_count, 1);
    ck_assert(s->sources[0].seed == UINT64_MAX && s->sources[0].direction.y == -1 && s->sources[0].stop == 3);
    ck_assert(s->drain_count == 1 && s->drains[0].shape.box.max.y == 0.1 && s->drains[0].start == 1);
    ck_assert_uint_eq(s->obstacle_count, 3);
    ck_assert(s->obstacles[0].shape.kind == SPH2D_SHAPE_LINE && s->obstacles[0].form == SPH2D_WALL_REFLECT);
    ck_assert(s->obstacles[1].shape.points.count == 3 && s->obstacles[1].restitution == 0.5);
    ck_assert(s->obstacles[2].shape.kind == SPH2D_SHAPE_CIRCLE && s->obstacles[2].shape.circle.radius == 0.2);
    ck_assert(s->interaction_count == 1 && s->interactions[0].path.count == 2);
    ck_assert(s->interactions[0].path.items[1].t == 1 && s->interactions[0].path.items[1].x == 2);
    ck_assert(s->probe_count == 2 && s->probes[1].kind == SPH2D_PROBE_SPEED && s->probes[1].rate.every == 0.5);
    ck_assert_str_eq(s->probes[0].name, "all");
    ck_assert(s->run.until == 4 && s->run.snapshots.compress == 6 && s->run.frames.size[1] == 480);
    ck_assert(s->run.frames.style == SPH2D_STYLE_POINTS && s->run.frames.color_range.y == 5);
    ck_assert_str_eq(s->run.frames.color, "speed");
    ck_assert(s->run.impacts.count == 2 && s->run.impacts.items[0] == 0.5);
    ck_assert_str_eq(sph2d_scene_file_text(file), whole);
    sph2d_scene_file_destroy(file);
    sph2d_scene_file_destroy(NULL);
}
END_TEST

START_TEST(json_works_too)
{
    static const char text[] = "{\n\t\"domain\": {\"min\": [0, 0], \"max\": [1, 1]},\n\t\"spacing\": 0.1,\n"
                               "\t\"name\": \"\\u00e9\", \"fluid\": {\"dynamic_viscosity\": 100},\n"
                               "\t\"blocks\": [{\"box\": {\"min\": [0, 0], \"max\": [0.4, 0.8]}}]\n}\n";
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_status status = parse(text, NULL, 0, &file, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    ck_assert_str_eq(sph2d_scene_file_scene(file)->name, "\xc3\xa9");
    sph2d_scene_file_destroy(file);
}
END_TEST

START_TEST(numbers_have_points_in_every_locale)
{
    const char *locale = setlocale(LC_NUMERIC, "de_DE.UTF-8"); /* NULL where it is not installed */
    locale_t before = uselocale((locale_t)0);
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_status status = parse(SOUND, NULL, 0, &file, &report);
    ck_assert_msg(status == SPH2D_OK, "%s: %s", locale ? locale : "C", test_report_text(&report));
    ck_assert(sph2d_scene_file_scene(file)->spacing == 0.1);
    ck_assert(uselocale((locale_t)0) == before);
    sph2d_scene_file_destroy(file);
}
END_TEST

static size_t most_keys(const sph2d_keys *keys)
{
    size_t most = keys->count;
    for (size_t i = 0; i < keys->count; ++i) {
        size_t inner = keys->items[i].keys ? most_keys(keys->items[i].keys) : 0;
        most = inner > most ? inner : most;
    }
    return most;
}

START_TEST(no_struct_has_more_keys_than_the_reader_takes)
{
    ck_assert_uint_le(most_keys(sph2d_scene_keys()), 64);
}
END_TEST

/* ---- places ------------------------------------------------------------------------------------------------------ */

START_TEST(paths_are_located)
{
    static const struct {
        const char *path;
        int line, column;
    } places[] = {{"blocks[0].box.max", 4, 29},
                  {"blocks[0].box", 4, 10},
                  {"blocks[0]", 4, 5},
                  {"blocks", 3, 1},
                  {"blocks[7].box", 3, 1},
                  {"fluid.density", 5, 8},
                  {"fluid.a[0].b", 5, 8},
                  {"spacing", 2, 10},
                  {"domain.max[1]", 1, 32},
                  {"nothing", 0, 0},
                  {"", 0, 0},
                  {"[0]", 0, 0}};
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    ck_assert_int_eq(parse(SOUND, NULL, 0, &file, &report), SPH2D_OK);
    for (size_t i = 0; i < sizeof places / sizeof places[0]; ++i) {
        sph2d_diagnostic d = {0};
        snprintf(d.path, sizeof d.path, "%s", places[i].path);
        sph2d_scene_file_locate(file, &d);
        ck_assert_str_eq(d.file, "s.yaml");
        ck_assert_msg(d.line == places[i].line && d.column == places[i].column, "%s: %d:%d", d.path, d.line, d.column);
    }
    sph2d_scene_file_destroy(file);
}
END_TEST

START_TEST(a_long_line_is_cut_between_characters)
{
    char euros[301];
    for (size_t i = 0; i < 300; ++i)
        euros[i] = "\xe2\x82\xac"[i % 3];
    euros[300] = '\0';
    char text[600];
    snprintf(text, sizeof text, "%s# %s\nname: {\t}\n", SOUND, euros);
    sph2d_report report = {0};
    sph2d_scene_file *file;
    ck_assert_int_eq(parse(text, NULL, 0, &file, &report), SPH2D_SCENE);
    ck_assert_str_eq(report.items[0].excerpt, "name: { }");
    snprintf(text, sizeof text, "%s%s: 1\n", SOUND, euros);
    ck_assert_int_eq(parse(text, NULL, 0, &file, &report), SPH2D_SCENE);
    ck_assert_int_eq(report.items[0].line, 6);
    ck_assert_uint_eq(strlen(report.items[0].excerpt), 159);
}
END_TEST

START_TEST(a_message_holds_nothing_for_the_terminal)
{
    sph2d_report report = {0};
    sph2d_scene_file *file;
    ck_assert_int_eq(parse(SOUND "\"\\e[31m\\n\": \"\\e[0m\"\nspacing: 1\n", NULL, 0, &file, &report), SPH2D_SCENE);
    ck_assert_str_eq(report.items[0].path, "?[31m?");
    ck_assert_str_eq(report.items[0].message, "unknown key '?[31m?'");
}
END_TEST

/* ---- almost scenes ----------------------------------------------------------------------------------------------- */

/** Changes a good scene at random. Whatever comes out, it is either read or refused with a reason. */
START_TEST(nothing_that_is_nearly_a_scene_does_harm)
{
    static const char *const pieces[] = {"[",     "]",           "{",   "}",   ": ",  "- ",   "\n",   "\n  ",
                                         "\"",    "'",           "&a ", "*a ", "!t ", "|\n ", ">-\n", "---\n",
                                         "...\n", "%YAML 1.2\n", "#",   "? ",  ",",   "\t",   "~"};
    enum { PIECES = sizeof pieces / sizeof pieces[0] };
    uint64_t random = 7;
    for (int round = 0; round < 2000; ++round) {
        char text[sizeof whole + 200];
        memcpy(text, whole, sizeof whole);
        size_t length = sizeof whole - 1;
        for (int change = 0; change < 4; ++change) {
            size_t at = (size_t)test_random(&random, 0, (double)length);
            const char *piece = pieces[(size_t)test_random(&random, 0, PIECES)];
            if (test_random(&random, 0, 1) < 0.3) {
                text[at] = (char)test_random(&random, 0, 128);
            } else {
                size_t more = strlen(piece);
                memmove(text + at + more, text + at, length - at);
                for (size_t i = 0; i < more; ++i)
                    text[at + i] = piece[i];
                length += more;
            }
        }
        sph2d_report report = {0};
        sph2d_scene_file *file = NULL;
        sph2d_status status = sph2d_scene_file_parse(text, length, "s.yaml", NULL, 0, &file, &report);
        ck_assert(status == SPH2D_OK || status == SPH2D_SCENE);
        ck_assert_int_eq(status == SPH2D_OK, report.errors == 0);
        ck_assert_int_eq(status == SPH2D_OK, file != NULL);
        sph2d_scene_file_destroy(file);
    }
}
END_TEST

TCase *scene_file_on_disk(void); /* scene_file_on_disk.c */

Suite *suite_scene_file(void)
{
    Suite *suite = suite_create("scene_file");
    TCase *text = tcase_create("text");
    tcase_add_loop_test(text, each_fault_has_its_place, 0, sizeof faults / sizeof faults[0]);
    tcase_add_test(text, all_faults_come_at_once_in_the_order_of_the_file);
    tcase_add_test(text, consequences_of_a_fault_are_not_faults);
    tcase_add_test(text, faults_beyond_the_report_are_counted);
    tcase_add_test(text, every_key_arrives);
    tcase_add_test(text, json_works_too);
    tcase_add_test(text, numbers_have_points_in_every_locale);
    tcase_add_test(text, no_struct_has_more_keys_than_the_reader_takes);
    tcase_add_test(text, paths_are_located);
    tcase_add_test(text, a_long_line_is_cut_between_characters);
    tcase_add_test(text, a_message_holds_nothing_for_the_terminal);
    tcase_add_test(text, nothing_that_is_nearly_a_scene_does_harm);
    suite_add_tcase(suite, text);
    suite_add_tcase(suite, scene_file_on_disk());
    return suite;
}
