/* SPDX-License-Identifier: MIT */
/** @file test_quantity.c
 *  What is advised for numbers with units, decimal commas and the like. */
#include "common.h"
#include "files/quantity.h"

static const struct {
    const char *text, *unit, *advice; /**< NULL: none */
} texts[] = {
    /* numbers */
    {"0,05", "m", "0,05: write 0.05 [m]"},
    {"-0,05", "m", "-0,05: write -0.05 [m]"},
    {"0,050", "m", "0,050: write 0.05 [m]"},
    {"1,5e-3", "", "1,5e-3: write 0.0015"},
    {"1.000,5", "m", "1.000,5: write 1000.5 [m]"},
    {"1,000.5", "m", "1,000.5: write 1000.5 [m]"},
    {"1.000.000", "m", "1.000.000: write 1000000 [m]"},
    {"1,000,000", "m", "1,000,000: write 1000000 [m]"},
    {"1,000", "m", "1,000: write 1 or 1000 [m]"},
    {"-1,000 mm", "m", "-1,000 mm: write -0.001 or -1 [m]"},
    {"1234,567", "m", "1234,567: write 1234.567 [m]"},
    {"1 000", "m", "1 000: write 1000 [m]"},
    {"1_000", "m", "1_000: write 1000 [m]"},
    {"1'000.5", "m", "1'000.5: write 1000.5 [m]"},
    {"", "m", NULL},
    {"abc", "m", NULL},
    {"-", "m", NULL},
    {"cm", "m", NULL},
    {"1.2.3", "m", NULL},
    {"1,2,3", "m", NULL},
    {"1,00,000", "m", NULL},
    {"1e400 m", "m", NULL},
    {"1e308 km", "m", NULL},
    {"1e", "m", "write a number in [m]: e is no unit that is known here"},
    {"1/2", "", NULL},
    {"0000000000000000000000000000000000000000000000000000000000001", "m", NULL}, /* longer than any that is read */
    /* units */
    {"5 cm", "m", "5 cm: write 0.05 [m]"},
    {"5cm", "m", "5cm: write 0.05 [m]"},
    {"1e3 mm", "m", "1e3 mm: write 1 [m]"},
    {"2 \xc2\xb5m", "m", "2 \xc2\xb5m: write 2e-06 [m]"},
    {"2 \xce\xbcm", "m", "2 \xce\xbcm: write 2e-06 [m]"},
    {"1 in", "m", "1 in: write 0.0254 [m]"},
    {"10ms", "s", "10ms: write 0.01 [s]"},
    {"2 min", "s", "2 min: write 120 [s]"},
    {"0.5 h", "s", "0.5 h: write 1800 [s]"},
    {"1 g/cm3", "kg/m^3", "1 g/cm3: write 1000 [kg/m^3]"},
    {"1 g/cm\xc2\xb3", "kg/m^3", "1 g/cm\xc2\xb3: write 1000 [kg/m^3]"},
    {"0,998 g cm^-3", "kg/m^3", "0,998 g cm^-3: write 998 [kg/m^3]"},
    {"1 kg/l", "kg/m^3", "1 kg/l: write 1000 [kg/m^3]"},
    {"1 t/m3", "kg/m^3", "1 t/m3: write 1000 [kg/m^3]"},
    {"1 mPa s", "Pa s", "1 mPa s: write 0.001 [Pa s]"},
    {"1 mPa*s", "Pa s", "1 mPa*s: write 0.001 [Pa s]"},
    {"1 mPa\xc2\xb7s", "Pa s", "1 mPa\xc2\xb7s: write 0.001 [Pa s]"},
    {"1 cP", "Pa s", "1 cP: write 0.001 [Pa s]"},
    {"1 kg/m/s", "Pa s", "1 kg/m/s: write 1 [Pa s]"},
    {"1 cSt", "m^2/s", "1 cSt: write 1e-06 [m^2/s]"},
    {"72 mN/m", "N/m", "72 mN/m: write 0.072 [N/m]"},
    {"1 J/m2", "N/m", "1 J/m2: write 1 [N/m]"},
    {"1 W/m2", "kg/s^3", "1 W/m2: write 1 [kg/s^3]"},
    {"2 bar", "Pa", "2 bar: write 200000 [Pa]"},
    {"1 MPa", "Pa", "1 MPa: write 1000000 [Pa]"},
    {"9.81 m/s2", "m/s^2", "9.81 m/s2: write 9.81 [m/s^2]"},
    {"9.81 m s-2", "m/s^2", "9.81 m s-2: write 9.81 [m/s^2]"},
    {"36 km/h", "m/s", "36 km/h: write 10 [m/s]"},
    {"30 Hz", "1/s", "30 Hz: write 30 [1/s]"},
    {"30 1/s", "1/s", "30 1/s: write 30 [1/s]"},
    {"180 deg", "rad", "180 deg: write 3.14159265359 [rad]"},
    {"180\xc2\xb0/s", "rad/s", "180\xc2\xb0/s: write 3.14159265359 [rad/s]"},
    {"50 %", "", "50 %: write 0.5"},
    {"50%", "", "50%: write 0.5"},
    /* what has another dimension, or none that is known, is not converted */
    {"5 kg", "m", "write a number in [m]: kg is a unit of something else"},
    {"1 m2/s", "Pa s", "write a number in [Pa s]: m2/s is a unit of something else"},
    {"2 Hz", "rad/s", "write a number in [rad/s]: Hz is a unit of something else"},
    {"5 cm", "", "write a number without a unit: cm is a unit of something else"},
    {"50 %", "m", "write a number in [m]: % is a unit of something else"},
    {"5 furlong", "m", "write a number in [m]: furlong is no unit that is known here"},
    {"5 kmin", "s", "write a number in [s]: kmin is no unit that is known here"},
    {"5 m/", "m", "write a number in [m]: m/ is no unit that is known here"},
    {"5 m//s", "m", "write a number in [m]: m//s is no unit that is known here"},
    {"5 m^0", "m", "write a number in [m]: m^0 is no unit that is known here"},
    {"5 m^", "m", "write a number in [m]: m^ is no unit that is known here"},
    {"5 m22", "m", "write a number in [m]: m22 is no unit that is known here"},
    {"5 m", "spacings", "write a number in [spacings]: m is a unit of something else"},
};

START_TEST(numbers_are_advised)
{
    char advice[160] = "";
    const bool advised = sph2d__quantity_advice(texts[_i].text, texts[_i].unit, advice, sizeof advice);
    ck_assert_msg(advised == !!texts[_i].advice, "%s: %s", texts[_i].text, advice);
    if (advised)
        ck_assert_str_eq(advice, texts[_i].advice);
}
END_TEST

Suite *suite_quantity(void)
{
    Suite *suite = suite_create("quantity");
    TCase *tests = tcase_create("advice");
    tcase_add_loop_test(tests, numbers_are_advised, 0, sizeof texts / sizeof *texts);
    suite_add_tcase(suite, tests);
    return suite;
}
