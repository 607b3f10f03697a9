/* SPDX-License-Identifier: MIT */
/** @file test_study_record.c
 *  What a row of a study leaves behind comes back as it was, and what is damaged is refused. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "common.h"
#include "study/parts.h"

static sph2d_study_record record, back;

static void set_up(void)
{
    record = back = (sph2d_study_record){0};
}

static void tear_down(void)
{
    sph2d_study_record_free(&record);
    sph2d_study_record_free(&back);
}

/* ---- making ------------------------------------------------------------------------------------------------------ */

/** Adds a series of `count` rows; its numbers go through whatever a double can be. */
static sph2d_study_series *add_series(const char *probe, size_t columns, size_t count)
{
    static const double odd[] = {0.1,    -0.0,     NAN,     INFINITY,   -INFINITY, 5e-324, 1 / 3.,
                                 1e-300, -1.5e308, 0x1p-30, 12345678.9, 2,         -7e22};
    enum { ODD = sizeof odd / sizeof *odd };
    sph2d_study_series *series = sph2d__record_add(&record, columns, 2);
    ck_assert_ptr_nonnull(series);
    snprintf(series->probe, sizeof series->probe, "%s", probe);
    double values[SPH2D_PROBE_MAX_COLUMNS];
    for (size_t i = 0; i < count; ++i) {
        for (size_t k = 0; k < columns; ++k)
            values[k] = odd[(i * columns + k) % ODD];
        ck_assert(sph2d__series_add(series, 0.1 * (double)i, values));
    }
    return series;
}

/** A record with something in every field. */
static void fill(void)
{
    record = (sph2d_study_record){.end = SPH2D_STUDY_GUARD,
                                  .status = SPH2D_GUARD,
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
    for (int i = 0; i < SPH2D_SUMMARY_VALUES; ++i)
        record.summary[i] = i == 3 ? NAN : 1.5 * i;
    add_series("energy", 2, 5)->kind = SPH2D_PROBE_ENERGY;
    add_series("empty", 1, 0)->kind = SPH2D_PROBE_ELEVATION;
    add_series("wide", SPH2D_PROBE_MAX_COLUMNS, 3);
    sph2d_study_series *profile = add_series("", 1, 3);
    profile->quantity = SPH2D_QUANTITY_DENSITY;
    profile->ends[0] = (sph2d_vec2){-0.0, 0.1};
    profile->ends[1] = (sph2d_vec2){1 / 3., -1e-9};
}

/** A record as bytes in memory of its very size, so that a look behind its end is seen; the caller frees it. */
static char *pack(const sph2d_study_record *of, size_t *size)
{
    *size = sph2d_study_record_pack(of, NULL, 0);
    char *block = malloc(*size);
    ck_assert_ptr_nonnull(block);
    ck_assert_uint_eq(sph2d_study_record_pack(of, block, *size), *size);
    return block;
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

static void check_parts(const sph2d_study_record *a, const sph2d_study_record *b)
{
    ck_assert_uint_eq(a->series_count, b->series_count);
    for (size_t i = 0; i < a->series_count; ++i) {
        const sph2d_study_series *s = &a->series[i], *t = &b->series[i];
        ck_assert_str_eq(s->probe, t->probe);
        ck_assert_int_eq(s->kind, t->kind);
        ck_assert_int_eq(s->quantity, t->quantity);
        check_numbers(&s->ends[0].x, &t->ends[0].x, 2);
        check_numbers(&s->ends[1].x, &t->ends[1].x, 2);
        ck_assert_uint_eq(s->columns, t->columns);
        ck_assert_uint_eq(s->count, t->count);
        check_numbers(s->rows, t->rows, s->count * (s->columns + 1));
    }
}

static void check_equal(const sph2d_study_record *a, const sph2d_study_record *b)
{
    ck_assert_int_eq(a->end, b->end);
    ck_assert_int_eq(a->status, b->status);
    ck_assert_str_eq(a->reason, b->reason);
    ck_assert_str_eq(a->isa, b->isa);
    ck_assert_uint_eq(a->particles, b->particles);
    ck_assert_uint_eq(a->left, b->left);
    ck_assert_uint_eq(a->steps, b->steps);
    ck_assert_uint_eq(a->particle_steps, b->particle_steps);
    ck_assert_uint_eq(a->repeats, b->repeats);
    ck_assert(same(a->spacing, b->spacing) && same(a->time, b->time) && same(a->cpu, b->cpu));
    ck_assert(same(a->wall, b->wall) && same(a->start, b->start) && same(a->probes, b->probes));
    check_numbers(a->summary, b->summary, SPH2D_SUMMARY_VALUES);
    check_parts(a, b);
}

/** Packs the record and reads it into `back`. */
static void pass(void)
{
    size_t size;
    char *block = pack(&record, &size);
    sph2d_study_record_free(&back);
    ck_assert_int_eq(sph2d_study_record_unpack(&back, block, size), SPH2D_OK);
    free(block);
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
    ck_assert(back.series == NULL);
}
END_TEST

START_TEST(every_end_comes_back)
{
    static const sph2d_status statuses[] = {SPH2D_OK, SPH2D_GUARD, SPH2D_NOMEM, SPH2D_OK, SPH2D_IO};
    for (int end = SPH2D_STUDY_FINISHED; end <= SPH2D_STUDY_DIED; ++end) {
        record.end = (sph2d_study_end)end;
        record.status = statuses[end];
        pass();
        check_equal(&record, &back);
    }
}
END_TEST

START_TEST(equal_records_are_equal_bytes)
{
    size_t size, again;
    fill();
    char *first = pack(&record, &size);
    pass();
    char *second = pack(&back, &again);
    ck_assert_uint_eq(size, again);
    ck_assert_mem_eq(first, second, size);
    free(first);
    free(second);
}
END_TEST

START_TEST(a_block_needs_all_its_room)
{
    fill();
    size_t size = sph2d_study_record_pack(&record, NULL, 0);
    char *part = malloc(size - 1);
    ck_assert_ptr_nonnull(part);
    ck_assert_uint_eq(sph2d_study_record_pack(&record, part, size - 1), size);
    free(part);
}
END_TEST

START_TEST(series_that_were_read_can_grow_on)
{
    add_series("long", 2, 1000); /* more than the first room */
    add_series("empty", 2, 0);
    pass();
    check_equal(&record, &back);
    for (int i = 0; i < 300; ++i) {
        ck_assert(sph2d__series_add(&back.series[0], i, (const double[2]){i, 7}));
        ck_assert(sph2d__series_add(&back.series[1], i, (const double[2]){i, 8}));
    }
    ck_assert(back.series[0].count == 1300 && back.series[1].count == 300);
    ck_assert(back.series[0].rows[3 * 1299] == 299 && back.series[0].rows[3 * 1299 + 2] == 7);
    ck_assert(back.series[1].rows[3 * 299 + 1] == 299);
    check_numbers(back.series[0].rows, record.series[0].rows, 3000);
}
END_TEST

START_TEST(a_freed_record_is_empty_and_can_be_freed_again)
{
    fill();
    sph2d_study_record_free(&record);
    ck_assert(record.series == NULL && record.series_count == 0 && record.reason[0] == '\0');
    sph2d_study_record_free(&record);
}
END_TEST

/* ---- damage ------------------------------------------------------------------------------------------------------ */

/** Whether a block is refused, with nothing left behind. */
static bool is_refused(const char *block, size_t size)
{
    bool refused = sph2d_study_record_unpack(&back, block, size) == SPH2D_FORMAT;
    refused = refused && back.series == NULL && back.series_count == 0;
    sph2d_study_record_free(&back);
    return refused;
}

START_TEST(a_block_that_ends_anywhere_is_refused)
{
    size_t size;
    fill();
    char *block = pack(&record, &size);
    for (size_t length = 0; length < size; ++length) {
        char *part = malloc(length + 1); /* of nearly its very size, so that a look behind its end is seen */
        ck_assert_ptr_nonnull(part);
        memcpy(part + 1, block, length);
        ck_assert_msg(is_refused(part + 1, length), "cut to %zu bytes", length);
        free(part);
    }
    free(block);
}
END_TEST

START_TEST(a_block_with_more_behind_it_is_refused)
{
    size_t size;
    fill();
    char *block = pack(&record, &size), *longer = calloc(1, size + 1);
    ck_assert_ptr_nonnull(longer);
    memcpy(longer, block, size);
    ck_assert(is_refused(longer, size + 1));
    free(longer);
    free(block);
}
END_TEST

START_TEST(no_changed_byte_is_overlooked)
{
    size_t size;
    fill();
    char *block = pack(&record, &size);
    for (size_t i = 0; i < size; ++i)
        for (int bit = 0; bit < 8; bit += 7) {
            block[i] = (char)(block[i] ^ 1 << bit);
            ck_assert_msg(is_refused(block, size), "byte %zu", i);
            block[i] = (char)(block[i] ^ 1 << bit);
        }
    free(block);
}
END_TEST

/** Puts the checksum right again, behind the mark and the length, as if the damage had been written. */
static void seal(char *block, size_t size)
{
    uint64_t length = size - 32, checksum = sph2d__hash(SPH2D__HASH_START, block + 32, length);
    memcpy(block + 16, &length, sizeof length);
    memcpy(block + 24, &checksum, sizeof checksum);
}

/** Where something stands in a block: behind its head, in the record or in the first series. */
#define IN_RECORD(member) (32 + offsetof(sph2d_study_record, member))
#define IN_SERIES(member) (32 + sizeof(sph2d_study_record) + offsetof(sph2d_study_series, member))

START_TEST(a_huge_count_asks_for_no_memory)
{
    static const size_t wheres[] = {IN_RECORD(series_count), IN_SERIES(columns), IN_SERIES(count)};
    static const uint64_t counts[] = {100000000, 1 + UINT64_MAX / 8, 1 + UINT64_MAX / 24, UINT64_MAX / 2, UINT64_MAX};
    size_t size;
    fill();
    char *block = pack(&record, &size);
    for (size_t i = 0; i < sizeof counts / sizeof *counts; ++i) {
        uint64_t kept;
        memcpy(&kept, block + wheres[_i], sizeof kept);
        memcpy(block + wheres[_i], &counts[i], sizeof kept);
        seal(block, size);
        ck_assert_msg(is_refused(block, size), "%llu", (unsigned long long)counts[i]);
        memcpy(block + wheres[_i], &kept, sizeof kept);
    }
    seal(block, size);
    ck_assert_int_eq(sph2d_study_record_unpack(&back, block, size), SPH2D_OK);
    free(block);
}
END_TEST

START_TEST(no_byte_that_was_written_wrong_does_harm)
{
    size_t size;
    fill();
    char *block = pack(&record, &size);
    for (size_t i = 32; i < size; ++i)
        for (int wrong = -1; wrong <= 1; ++wrong) {
            char kept = block[i];
            block[i] = (char)wrong;
            seal(block, size);
            if (sph2d_study_record_unpack(&back, block, size) == SPH2D_OK)
                ck_assert(strlen(back.reason) < sizeof back.reason && strlen(back.isa) < sizeof back.isa);
            sph2d_study_record_free(&back);
            block[i] = kept;
        }
    free(block);
}
END_TEST

Suite *suite_study_record(void)
{
    Suite *suite = suite_create("study_record");
    TCase *records = tcase_create("records");
    tcase_add_checked_fixture(records, set_up, tear_down);
    tcase_add_test(records, a_record_comes_back_as_it_was);
    tcase_add_test(records, an_empty_record_comes_back_empty);
    tcase_add_test(records, every_end_comes_back);
    tcase_add_test(records, equal_records_are_equal_bytes);
    tcase_add_test(records, a_block_needs_all_its_room);
    tcase_add_test(records, series_that_were_read_can_grow_on);
    tcase_add_test(records, a_freed_record_is_empty_and_can_be_freed_again);
    tcase_add_test(records, a_block_that_ends_anywhere_is_refused);
    tcase_add_test(records, a_block_with_more_behind_it_is_refused);
    tcase_add_test(records, no_changed_byte_is_overlooked);
    tcase_add_loop_test(records, a_huge_count_asks_for_no_memory, 0, 3);
    tcase_add_test(records, no_byte_that_was_written_wrong_does_harm);
    suite_add_tcase(suite, records);
    return suite;
}
