/* SPDX-License-Identifier: MIT */
/** @file fuzz.h
 *  What a harness is: a function that takes any bytes, as libFuzzer and AFL++ call it, too. It must return, in time and
 *  with bounded memory, whatever they are. A harness writes into the working directory only. */
#ifndef SPH2D_TESTS_FUZZ_FUZZ_H
#define SPH2D_TESTS_FUZZ_FUZZ_H

#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#endif
