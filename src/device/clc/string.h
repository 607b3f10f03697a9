/* SPDX-License-Identifier: MIT */
/** @file string.h
 *  OpenCL C copies by assignment. */
