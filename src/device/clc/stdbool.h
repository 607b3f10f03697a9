/* SPDX-License-Identifier: MIT */
/** @file stdbool.h
 *  bool is a type of OpenCL C. */
