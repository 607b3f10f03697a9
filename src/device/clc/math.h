/* SPDX-License-Identifier: MIT */
/** @file math.h
 *  OpenCL C has these functions built in. */
