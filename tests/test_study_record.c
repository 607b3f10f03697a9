/* SPDX-License-Identifier: MIT */
/** @file test_study_record.c
 *  What a row of a study leaves behind comes back as it was, and what is damaged is refused. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../cli/study/study_record.h"
#include "common.h"
#include "sph2d/sim.h"

static study_record record, back;

static void set_up(void)
{
    record = back = (study_record){0};
}

static void tear_down(void)
{
    study_record_free(&record);
    study_record_free(&back);
}

/* ---- making ------------------------------------------------------------------------------------------------------ */

static char *copy(const char *text)
{
    char *made = strdup(text);
    ck_assert_ptr_nonnull(made);
    return made;
}

/** Adds a series of `count` rows; its numbers go through whatever a double can be. */
static void add_series(const char *probe, const char *headings, size_t columns, size_t count)
{
    static const double odd[] = {0.1,    -0.0,     NAN,     INFINITY,   -INFINITY, 5e-324, 1 / 3.,
                                 1e-300, -1.5e308, 0x1p-30, 12345678.9, 2,         -7e22};
    enum { ODD = sizeof odd / sizeof *odd };
    study_series *grown = realloc(record.series, (record.series_count + 1) * sizeof *grown);
    ck_assert_ptr_nonnull(grown);
    record.series = grown;
    study_series *series = &grown[record.series_count++];
    *series = (study_series){.probe = copy(probe), .headings = copy(headings), .columns = columns};
    double values[SPH2D_PROBE_MAX_COLUMNS];
    for (size_t i = 0; i < count; ++i) {
        for (size_t k = 0; k < columns; ++k)
            values[k] = odd[(i * columns + k) % ODD];
        ck_assert(study_series_add(series, 0.1 * (double)i, values));
    }
}

static void add_samples(sph2d_quantity quantity, size_t count)
{
    study_samples *samples = study_record_add_samples(&record, count);
    ck_assert_ptr_nonnull(samples);
    ck_assert_uint_eq(samples->count, count);
    samples->quantity = quantity;
    samples->ends[0] = (sph2d_vec2){-0.0, 0.1};
    samples->ends[1] = (sph2d_vec2){1 / 3., -1e-9};
    for (size_t i = 0; i < count; ++i) {
        samples->along[i] = (double)i / (double)count;
        samples->values[i] = i == 1 ? NAN : -1.1 * (double)i;
    }
}

/** A record with something in every field. */
static void fill(void)
{
    record = (study_record){.end = STUDY_GUARD,
                            .code = 4,
                            .reason = "speed above 10 c0, at step 7",
                            .isa = "avx2",
                            .spacing = 0.1,
                            .time = 1 / 3.,
                            .particles = UINT64_MAX,
                            .left = 3,
                            .steps = 12345678901234567,
                            .particle_steps = UINT64_MAX - 1,
                            .repeats = 5,
                            .cpu = 1.5e-300,
                            .wall = NAN,
                            .start = INFINITY,
                            .probes = -0.0};
    add_series("energy", "kinetic [J/m], potential [J/m]", 2, 5);
    add_series("empty", "elevation [m]", 1, 0);
    add_series("wide", "a, b, c, d, e, f, g, h", SPH2D_PROBE_MAX_COLUMNS, 3);
    add_samples(SPH2D_QUANTITY_DENSITY, 0);
    add_samples(SPH2D_QUANTITY_VX, 3);
}

/** A record as text; the caller frees it. */
static char *text_of(const study_record *of)
{
    char *text = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&text, &length);
    ck_assert_ptr_nonnull(out);
    study_record_write(of, out);
    ck_assert_int_eq(fclose(out), 0);
    ck_assert_uint_eq(strlen(text), length);
    return text;
}

/* ---- comparing --------------------------------------------------------------------------------------------------- */

static bool same(double a, double b)
{
    return (isnan(a) && isnan(b)) || memcmp(&a, &b, sizeof a) == 0;
}

static void check_numbers(const double *a, const double *b, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        ck_assert_msg(same(a[i], b[i]), "number %zu: %.17g is not %.17g", i, a[i], b[i]);
}

static void check_parts(const study_record *a, const study_record *b)
{
    ck_assert_uint_eq(a->series_count, b->series_count);
    for (size_t i = 0; i < a->series_count; ++i) {
        const study_series *s = &a->series[i], *t = &b->series[i];
        ck_assert_str_eq(s->probe, t->probe);
        ck_assert_str_eq(s->headings, t->headings);
        ck_assert_uint_eq(s->columns, t->columns);
        ck_assert_uint_eq(s->count, t->count);
        check_numbers(s->time, t->time, s->count);
        check_numbers(s->values, t->values, s->count * s->columns);
    }
    ck_assert_uint_eq(a->samples_count, b->samples_count);
    for (size_t i = 0; i < a->samples_count; ++i) {
        const study_samples *s = &a->samples[i], *t = &b->samples[i];
        ck_assert_int_eq(s->quantity, t->quantity);
        ck_assert_uint_eq(s->count, t->count);
        check_numbers(&s->ends[0].x, &t->ends[0].x, 2);
        check_numbers(&s->ends[1].x, &t->ends[1].x, 2);
        check_numbers(s->along, t->along, s->count);
        check_numbers(s->values, t->values, s->count);
    }
}

static void check_equal(const study_record *a, const study_record *b)
{
    ck_assert_int_eq(a->end, b->end);
    ck_assert_int_eq(a->code, b->code);
    ck_assert_str_eq(a->reason, b->reason);
    ck_assert_str_eq(a->isa, b->isa);
    ck_assert_uint_eq(a->particles, b->particles);
    ck_assert_uint_eq(a->left, b->left);
    ck_assert_uint_eq(a->steps, b->steps);
    ck_assert_uint_eq(a->particle_steps, b->particle_steps);
    ck_assert_uint_eq(a->repeats, b->repeats);
    ck_assert(same(a->spacing, b->spacing) && same(a->time, b->time) && same(a->cpu, b->cpu));
    ck_assert(same(a->wall, b->wall) && same(a->start, b->start) && same(a->probes, b->probes));
    check_parts(a, b);
}

/** Writes the record and reads it into `back`. */
static void pass(void)
{
    char *text = text_of(&record);
    study_record_free(&back);
    ck_assert_msg(study_record_read(&back, text), "%s", text);
    free(text);
}

/* ---- there and back ---------------------------------------------------------------------------------------------- */

START_TEST(a_record_comes_back_as_it_was)
{
    fill();
    pass();
    check_equal(&record, &back);
}
END_TEST

START_TEST(an_empty_record_comes_back_empty)
{
    pass();
    check_equal(&record, &back);
    ck_assert(back.series == NULL && back.samples == NULL);
}
END_TEST

START_TEST(every_end_and_code_comes_back)
{
    static const int codes[] = {0, 1, 75, 143, -1};
    for (int end = STUDY_FINISHED; end <= STUDY_DIED; ++end) {
        record.end = (study_end)end;
        record.code = codes[end];
        pass();
        check_equal(&record, &back);
    }
}
END_TEST

START_TEST(equal_records_are_equal_texts)
{
    fill();
    char *first = text_of(&record);
    pass();
    char *second = text_of(&back);
    ck_assert_str_eq(first, second);
    back.series[0].values[0] = nextafter(back.series[0].values[0], 1); /* every digit of it */
    char *third = text_of(&back);
    ck_assert_str_ne(first, third);
    free(first);
    free(second);
    free(third);
}
END_TEST

START_TEST(a_reason_of_several_lines_becomes_one)
{
    snprintf(record.reason, sizeof record.reason, "first\nsecond\r\n\tthird: \xc3\xa9 ");
    add_series("p\nq", "a\n[m]", 1, 1);
    pass();
    ck_assert_str_eq(back.reason, "first second   third: \xc3\xa9 ");
    ck_assert_str_eq(back.series[0].probe, "p q");
    ck_assert_str_eq(back.series[0].headings, "a [m]");
    memset(record.reason, 'x', sizeof record.reason - 1);
    memset(record.isa, 'y', sizeof record.isa - 1);
    pass();
    ck_assert_str_eq(back.reason, record.reason);
    ck_assert_str_eq(back.isa, record.isa);
}
END_TEST

START_TEST(a_reason_may_look_like_the_rest_of_a_record)
{
    snprintf(record.reason, sizeof record.reason, "isa x\nwhole\nseries 1 1");
    pass();
    ck_assert_str_eq(back.reason, "isa x whole series 1 1");
    ck_assert_uint_eq(back.series_count, 0);
}
END_TEST

START_TEST(series_that_were_read_can_grow_on)
{
    add_series("long", "a, b", 2, 1000); /* more than the first room */
    add_series("empty", "a, b", 2, 0);
    pass();
    check_equal(&record, &back);
    for (int i = 0; i < 300; ++i) {
        ck_assert(study_series_add(&back.series[0], i, (const double[2]){i, 7}));
        ck_assert(study_series_add(&back.series[1], i, (const double[2]){i, 8}));
    }
    ck_assert(back.series[0].count == 1300 && back.series[1].count == 300);
    ck_assert(back.series[0].time[1299] == 299 && back.series[0].values[2599] == 7 &&
              back.series[1].values[598] == 299);
    check_numbers(back.series[0].values, record.series[0].values, 2000);
}
END_TEST

START_TEST(a_freed_record_is_empty_and_can_be_freed_again)
{
    fill();
    study_record_free(&record);
    ck_assert(record.series == NULL && record.series_count == 0 && record.samples == NULL && record.reason[0] == '\0');
    study_record_free(&record);
}
END_TEST

/* ---- damage ------------------------------------------------------------------------------------------------------ */

START_TEST(a_text_that_ends_anywhere_is_refused)
{
    fill();
    char *text = text_of(&record);
    for (size_t length = strlen(text); length-- > 0;) {
        char *part = strndup(text, length); /* of its very size, so that a look behind its end is seen */
        ck_assert_ptr_nonnull(part);
        ck_assert_msg(!study_record_read(&back, part), "cut to %zu bytes", length);
        study_record_free(&back);
        free(part);
    }
    free(text);
}
END_TEST

START_TEST(no_changed_byte_does_harm)
{
    fill();
    char *text = text_of(&record);
    for (const char *wrong = "9-\n x"; *wrong; ++wrong)
        for (size_t i = 0; text[i]; ++i) {
            char kept = text[i];
            text[i] = *wrong;
            study_record_read(&back, text); /* a digit may be another one, and no reader can tell */
            study_record_free(&back);
            text[i] = kept;
        }
    free(text);
}
END_TEST

/** The text of the record with the first `what` in it exchanged; the caller frees it. */
static char *changed(const char *what, const char *with)
{
    char *text = text_of(&record), *at = strstr(text, what);
    ck_assert_msg(at != NULL, "no '%s' in\n%s", what, text);
    size_t size = strlen(text) + strlen(with) + 1;
    char *out = malloc(size);
    ck_assert_ptr_nonnull(out);
    snprintf(out, size, "%.*s%s%s", (int)(at - text), text, with, at + strlen(what));
    free(text);
    return out;
}

static const struct {
    const char *what, *with;
} damages[] = {
    {"sph2d study row 1\n", "sph2d study row 2\n"},
    {"end 1 4\n", "end 5 4\n"}, /* no such end */
    {"end 1 4\n", "end 1\n"},
    {"end 1 4\n", "end 1 4 0\n"},
    {"reason ", "reasons "},
    {"isa avx2\n", ""},
    {"counts ", "counts x"},
    {"counts ", "counts 1 "},
    {"numbers ", "numbers 0 "},
    {"numbers 0.1", "numbers 0,1"},
    {"series 2 5\n", "series 2 4\n"},
    {"series 2 5\n", "series 2 6\n"},
    {"series 2 5\n", "series 3 5\n"},
    {"series 2 5\n", "series 0 5\n"},
    {"series 1 0\n", "series 9 0\n"}, /* more columns than a probe has */
    {"probe energy\n", ""},
    {"samples 4 0\n", "samples 4 1\n"},
    {"samples 0 3\n", "samples 0 2\n"},
    {"samples 0 3\n", "samples 0 4\n"},
    {"whole\n", "whole"},
    {"whole\n", "whole\n\n"},
    {"whole\n", "whole\nwhole\n"},
    {"whole\n", "whole\n\x01"},
    {"whole\n", "rubbish\nwhole\n"},
};

START_TEST(a_damaged_text_is_refused)
{
    fill();
    char *text = changed(damages[_i].what, damages[_i].with);
    ck_assert_msg(!study_record_read(&back, text), "%s", text);
    free(text);
}
END_TEST

/** Counts for which there might even be memory, and such as no product may be made of. */
static const char *const huge[] = {"100000000", "4611686018427387904", "18446744073709551615", "99999999999999999999",
                                   "-1"};

START_TEST(a_huge_count_asks_for_no_memory)
{
    char line[80];
    fill();
    snprintf(line, sizeof line, "series 2 %s\n", huge[_i]);
    char *text = changed("series 2 5\n", line);
    ck_assert(!study_record_read(&back, text));
    ck_assert_uint_eq(back.series_count, 1);
    ck_assert(back.series[0].time == NULL && back.series[0].values == NULL && back.series[0].count == 0);
    study_record_free(&back);
    free(text);

    snprintf(line, sizeof line, "series %s 5\n", huge[_i]);
    text = changed("series 2 5\n", line);
    ck_assert(!study_record_read(&back, text));
    ck_assert_uint_eq(back.series_count, 1);
    ck_assert(back.series[0].time == NULL && back.series[0].values == NULL);
    study_record_free(&back);
    free(text);

    snprintf(line, sizeof line, "samples 0 %s\n", huge[_i]);
    text = changed("samples 0 3\n", line);
    ck_assert(!study_record_read(&back, text));
    ck_assert_uint_eq(back.samples_count, 1); /* the one before it */
    free(text);
}
END_TEST

Suite *suite_study_record(void)
{
    Suite *suite = suite_create("study_record");
    TCase *records = tcase_create("records");
    tcase_add_checked_fixture(records, set_up, tear_down);
    tcase_add_test(records, a_record_comes_back_as_it_was);
    tcase_add_test(records, an_empty_record_comes_back_empty);
    tcase_add_test(records, every_end_and_code_comes_back);
    tcase_add_test(records, equal_records_are_equal_texts);
    tcase_add_test(records, a_reason_of_several_lines_becomes_one);
    tcase_add_test(records, a_reason_may_look_like_the_rest_of_a_record);
    tcase_add_test(records, series_that_were_read_can_grow_on);
    tcase_add_test(records, a_freed_record_is_empty_and_can_be_freed_again);
    tcase_add_test(records, a_text_that_ends_anywhere_is_refused);
    tcase_add_test(records, no_changed_byte_does_harm);
    tcase_add_loop_test(records, a_damaged_text_is_refused, 0, sizeof damages / sizeof *damages);
    tcase_add_loop_test(records, a_huge_count_asks_for_no_memory, 0, sizeof huge / sizeof *huge);
    suite_add_tcase(suite, records);
    return suite;
}
