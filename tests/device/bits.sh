#!/usr/bin/env bash
# Does a device make the bits of the processor? bits.sh BUILD JOBS [DEVICE [STEPS [PARTICLES]]]
#
# Runs every scene of examples by every method that devices take, coarsely and for 20 steps, on the device and on the
# processor by instruction set baseline, and compares hashes of what particles carry and of the summary. DEVICE is a number of
# `sph2d devices`; without it the one of pocl, which is the processor by OpenCL (Debian: pocl-opencl-icd). What pocl compiles
# stays in BUILD.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=$(realpath -e "$1") jobs=$2 device=${3-} steps=${4-20} particles=${5-100}
export POCL_CACHE_DIR="${POCL_CACHE_DIR-$build/pocl}" LC_ALL=C
FEWEST=150 # runs; fewer have been left out by mistake
out=$build/device
rm -rf "$out" && mkdir -p "$out/lines"
"$build/sph2d" devices --json >"$out/devices"
if [ -z "$device" ]; then
    device=$(sed -n 's/^{"number": \([0-9]*\), .*"platform": "Portable Computing Language".*/\1/p' "$out/devices" | head -n 1)
    [ -n "$device" ] || {
        echo 'bits: no device of pocl, which these tests run on: apt install pocl-opencl-icd ocl-icd-libopencl1' >&2 && exit 1
    }
fi
about=$(grep "^{\"number\": $device, " "$out/devices") || { echo "bits: no device $device in 'sph2d devices'" >&2 && exit 1; }
name=${about#*'"name": "'} && name=${name%%\"*}
grep -q '"same_bits": true' <<<"$about" || { echo "bits: $name does not round as the processor does" >&2 && exit 1; }

code=0
export device particles build
# shellcheck disable=SC2016 # the inner shell expands them
grep -lx 'blocks:\|sources:' examples/*/*.yaml | while read -r scene; do
    short=${scene#examples/} && short=${short%.yaml}
    some=$steps
    [ "$short$particles" != burst/scene100 ] || some=2 # 16,384 particles, and not fewer
    printf '%s\0%s\0%s\0%s\0' "$scene" "$short" "$some" "$out/lines/${short/\//.}"
done | xargs -0 -n 4 -P "$jobs" \
    sh -c '"$build/tests/golden" --device "$device" "$0" "$1" "$2" "$particles" 1 >"$3"' || code=1
cat "$out"/lines/* | sort >"$out/runs"
runs=$(wc -l <"$out/runs")
if [ $code != 0 ]; then
    grep '; by the device' "$out/runs" >&2 || true
    echo "bits: of $runs runs on $name some differ, or did not end" >&2 && exit 1
fi
[ "$runs" -ge $FEWEST ] || { echo "bits: only $runs runs, not $FEWEST" >&2 && exit 1; }
echo "bits: $runs runs on $name, the same bits as the processor after $steps steps"
