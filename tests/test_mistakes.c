/* SPDX-License-Identifier: MIT */
/** @file test_mistakes.c
 *  Usual mistakes in YAML, each with what the message says to do. */
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "sph2d/io.h"

#define HEAD "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.1\n"
#define BOX "box: {min: [0, 0], max: [0.4, 0.8]}\n"
#define BLOCKS "blocks:\n  - " BOX

static const struct {
    const char *text;
    int line;
    const char *hint;
} mistakes[] = {
    /* tabs */
    {HEAD "run:\n\tuntil: 1\n", 4, "indent by blanks"},
    {HEAD "run:\n  until: 1\n  \tframes: {}\n", 4, "indent by blanks"},
    /* signs without a blank, other signs */
    {"domain: {min: [0, 0], max: [1, 1]}\nspacing:0.05\nblocks: []\n", 2,
     "write a blank after the colon: spacing: ..."},
    {HEAD BLOCKS "name:x\n", 5, "write a blank after the colon: name: ..."},
    {HEAD "run: {until:1}\n", 3, "write a blank after the colon: until: ..."},
    {HEAD "run:\n  until:1\n", 4, "write a blank after the colon: until: ..."},
    {HEAD "blocks:\n  - box:{min: [0, 0], max: [0.4, 0.8]}\n", 4, "write a blank after the colon: box: ..."},
    {"domain = {min: [0, 0], max: [1, 1]}\nspacing = 0.1\n", 1, "in place of the sign =: domain: ..."},
    {HEAD "run:\n  until = 1\n", 4, "in place of the sign =: until: ..."},
    {HEAD "run: {until = 1}\n", 3, "in place of the sign =: until: ..."},
    {HEAD "blocks:\n  -" BOX, 3, "write a blank after the dash: - box"},
    {"// a scene\n" HEAD BLOCKS, 1, "a comment begins with #"},
    {HEAD "hello\n", 3, "`key: value`"},
    {HEAD "run:\n\xc2\xa0\xc2\xa0until: 1\n", 4, "no-break space"},
    /* lists and groups */
    {HEAD "blocks:\n  " BOX, 3, "begin each item of a list by a dash and a blank: - box: ..."},
    {HEAD "blocks: {box: {min: [0, 0], max: [0.4, 0.8]}}\n", 3, "a list has items: blocks: [{box: ...}]"},
    {HEAD "blocks: 3\n", 3, "a list has items: blocks: [{box: ...}]"},
    {HEAD "blocks:\n", 3, "a list has items: blocks: [{box: ...}]"},
    {HEAD "blocks: [3]\n", 3, "an item of blocks has keys: {box: ...}"},
    {HEAD "blocks: [[3]]\n", 3, "an item of blocks has keys: {box: ...}"},
    {HEAD "blocks:\n  -\n", 4, "an item of blocks has keys: {box: ...}"},
    {HEAD BLOCKS "fluid:\n  - density: 1000\n", 5, "leave the dashes out: fluid has keys, not items"},
    {"domain: [0, 0, 1, 1]\nspacing: 0.1\n" BLOCKS, 1, "domain has keys: {min: ...}"},
    {HEAD BLOCKS "run: 5\n", 5, "run has keys: {until: ...}"},
    {HEAD BLOCKS "run:\nname: x\n", 5, "indent its keys below it"},
    {HEAD BLOCKS "- x\n", 5, "it belongs below the key of its list"},
    /* indentation */
    {HEAD BLOCKS "  " BOX, 5, "or indent this line by 4 blanks"},
    {HEAD BLOCKS "   velocity: [1, 0]\n", 5, "or indent this line by 4 blanks"},
    {HEAD "run:\n  until: 1\n   frames: {}\n", 4, "the key of line 5 begins in column 4, this one in 3"},
    {HEAD "run:\n    until: 1\n  # of them\n\n  frames: {}\n", 7,
     "the key of line 4 begins in column 5, this one in 3"},
    {HEAD " name: x\n", 2, "the key of line 3 begins in column 2, this one in 1"},
    {"  domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.1\n", 2, "the key of line 1 begins in column 3, this one in 1"},
    {"# \xc3\xa4\r\nrun:\r\n    until: 1\r\n  frames: {}\r\n", 4,
     "the key of line 3 begins in column 5, this one in 3"},
    {HEAD BLOCKS "fluid:\n  gravity: [0, 0]\n", 6, "'gravity' is no part of a group"},
    /* brackets */
    {"domain: {min: [0, 0], max: [1, 1]\nspacing: 0.1\n", 2, "close the bracket { of line 1 by }, or indent this line"},
    {"domain: {min: [0, 0, max: [1, 1]}\n", 1, "the bracket to close here is the [ of line 1: write ]"},
    {"domain: {min: [0, 0]], max: [1, 1]}\n", 1, "the bracket to close here is the { of line 1: write }"},
    {"name: \"[\" # {\ndomain: {min: [0, 0), max: [1, 1]}\n", 2,
     "the bracket to close here is the [ of line 2: write ]"},
    {"domain: {name: it's, max: [1, 1]]\n", 1, "the bracket to close here is the { of line 1: write }"},
    {HEAD "blocks: [{box: {min: [0, 0], max: [0.4, 0.8]}}}]\n", 3,
     "the bracket to close here is the [ of line 3: write ]"},
    {HEAD "gravity: [0, 0]]\n", 3, "no bracket is open here: leave this one out"},
    {HEAD "blocks: [\n  {box: {min: [0, 0], max: [0.4, 0.8]}}\n", 3, "close it by ]"},
    {HEAD "run: {until: 1\n", 3, "close it by }"},
    {"domain: {min: [0, 0] max: [1, 1]}\n", 1, "write a comma before it"},
    {"{\"spacing\": 0.1\n \"name\": 1}\n", 2, "write a comma before it"},
    /* quotes */
    {"name: \"dam\n" HEAD, 1, "close the text by the quote that it begins with"},
    {HEAD "name: 'dam", 3, "close the text by the quote that it begins with"},
    {"name: 'it's'\n" HEAD, 1, "write '' for a ' in the text"},
    {"name: \"a \"b\" c\"\n" HEAD, 1, "write \\\" for a \" in the text"},
    {"name: \"C:\\dam\"\n" HEAD, 1, "write \\\\ for a backslash"},
    {"name: dam: break\n" HEAD, 1, "put a text with a colon and a blank in it into quotes"},
    {HEAD "name: @x\n", 3, "put a text that begins with this sign into quotes"},
    {HEAD "name: *\n", 3, "put a text that begins with this sign into quotes"},
    /* what YAML has and scenes have not */
    {HEAD "blocks:\n  - &b\n    " BOX, 4, "write the value again where it is used"},
    {HEAD "blocks:\n  - " BOX "  - *b\n", 5, "write the value itself here"},
    {HEAD BLOCKS "  - <<: *b\n    velocity: [1, 0]\n", 5, "write the value itself here"},
    {HEAD BLOCKS "name: !!str x\n", 5, "leave it out"},
    {HEAD "---\n" HEAD, 3, "put it into a file of its own"},
    {HEAD "spacing: 0.2\n", 3, "first on line 2; keep one of them"},
};

START_TEST(each_has_a_hint)
{
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    const char *text = mistakes[_i].text;
    bool told = false;
    ck_assert_int_eq(sph2d_scene_file_parse(text, strlen(text), "s", NULL, 0, &file, &report), SPH2D_SCENE);
    for (size_t i = 0; i < report.count; ++i)
        told |= report.items[i].line == mistakes[_i].line && strstr(report.items[i].hint, mistakes[_i].hint);
    ck_assert_msg(told, "%s\nnot told '%s' in line %d, but\n%s", text, mistakes[_i].hint, mistakes[_i].line,
                  test_report_text(&report));
    sph2d_report_clear(&report);
}
END_TEST

/** A value on the command line has no lines. */
START_TEST(values_have_hints)
{
    const sph2d_override set = {"blocks", "[{box: {min: [0, 0}}]"};
    const char *text = HEAD BLOCKS;
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    ck_assert_int_eq(sph2d_scene_file_parse(text, strlen(text), "s", &set, 1, &file, &report), SPH2D_SCENE);
    ck_assert_str_eq(report.items[0].hint, "the bracket to close here is the [: write ]");
    sph2d_report_clear(&report);
}
END_TEST

/** Wherever a scene is cut or a byte of it is another, there is a sentence and no more reading than there is text. */
START_TEST(no_text_is_too_short)
{
    static const char signs[] = "\t\n -:=[]{}'\"#,&*!@";
    char text[] =
        HEAD "blocks:\n  - " BOX "    velocity: [1, 0]\nrun: {until: 1, frames: {size: [64, 64]}}\nname: \"it's\"";
    const size_t length = sizeof text - 1;
    for (size_t i = 0; i < length; ++i)
        for (size_t k = 0; k < sizeof signs; ++k) {
            const char before = text[i];
            text[i] = signs[k];
            char *copy = strndup(text, k + 1 < sizeof signs ? length : i); /* the last is its end */
            sph2d_report report = {0};
            sph2d_scene_file *file = NULL;
            ck_assert_ptr_nonnull(copy);
            sph2d_status status = sph2d_scene_file_parse(copy, strlen(copy), "s", NULL, 0, &file, &report);
            ck_assert(status == SPH2D_OK ? file && report.errors == 0 : !file && report.errors > 0);
            sph2d_scene_file_destroy(file);
            sph2d_report_clear(&report);
            free(copy);
            text[i] = before;
        }
}
END_TEST

Suite *suite_mistakes(void)
{
    Suite *suite = suite_create("mistakes");
    TCase *tests = tcase_create("hints");
    tcase_add_loop_test(tests, each_has_a_hint, 0, sizeof mistakes / sizeof *mistakes);
    tcase_add_test(tests, values_have_hints);
    tcase_add_test(tests, no_text_is_too_short);
    suite_add_tcase(suite, tests);
    return suite;
}
