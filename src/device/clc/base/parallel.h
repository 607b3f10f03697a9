/* SPDX-License-Identifier: MIT */
/** @file parallel.h
 *  The host's threads. */
