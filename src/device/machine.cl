/* SPDX-License-Identifier: MIT */
/* What a device can do at most: its bandwidth, and its multiply-adds of doubles (tests/bench). */
#pragma OPENCL EXTENSION cl_khr_fp64 : enable

/* a = b + 3 c over arrays one after another at the start of the arena, of so many doubles each. */
__kernel void triad(__global double *arena, __global const uchar *numbers, const ulong system_at, const ulong own_at,
                    const ulong count, __global uchar *results, const ulong results_at)
{
    const ulong each = *(__global const ulong *)(numbers + own_at), i = get_global_id(0);
    if (i < count)
        arena[i] = arena[each + i] + 3 * arena[2 * each + i];
}

/* Eight chains of 1000 multiply-adds each. */
__kernel void multiply_add(__global double *arena, __global const uchar *numbers, const ulong system_at,
                           const ulong own_at, const ulong count, __global uchar *results, const ulong results_at)
{
    const ulong i = get_global_id(0);
    double a = i, b = a + 1, c = a + 2, d = a + 3, e = a + 4, f = a + 5, g = a + 6, h = a + 7;
    const double x = 1e-9, y = 1 - 1e-9;
    for (int k = 0; k < 1000; ++k) {
        a = fma(a, y, x);
        b = fma(b, y, x);
        c = fma(c, y, x);
        d = fma(d, y, x);
        e = fma(e, y, x);
        f = fma(f, y, x);
        g = fma(g, y, x);
        h = fma(h, y, x);
    }
    if (i < count)
        arena[i] = a + b + c + d + e + f + g + h;
}
