#!/bin/sh
# Prints the number that the device of pocl has in `sph2d devices`. pocl.sh SPH2D
number=$("$1" devices --json | sed -n 's/^{"number": \([0-9]*\), .*"platform": "Portable Computing Language".*/\1/p' | head -n 1)
[ -n "$number" ] || { echo 'no device of pocl, which tests run on: apt install pocl-opencl-icd ocl-icd-libopencl1' >&2 && exit 1; }
echo "$number"
