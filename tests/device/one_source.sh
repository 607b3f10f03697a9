#!/usr/bin/env bash
# Is the physics of devices that of the processor, written once? one_source.sh BUILD [DEVICE]
#
# Changes one sign or factor at a time in a copy of the sources, and builds it: what the processor computes changes, and the device
# computes the same. A term that stood twice would leave one of the two as it was. DEVICE as in bits.sh.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=$(realpath -e "$1") device=${2-}
export POCL_CACHE_DIR="${POCL_CACHE_DIR-$build/pocl}" LC_ALL=C
[ -n "$device" ] || device=$(tests/device/pocl.sh "$build/sph2d")
copy=$build/one_source
rm -rf "$copy" && mkdir -p "$copy"
cp -R Makefile src include shaders cli tests examples "$copy"
cd "$copy"

# What golden prints for an example by its own method: 20 steps with 100 particles.
runs() {
    make -j "$(nproc)" DEPS=skip X86= RENDER= CFLAGS=-O1 BUILD=build build/tests/golden >make.log 2>&1 ||
        { tail -n 20 make.log >&2 && return 2; }
    build/tests/golden --device "$device" --own "examples/$1.yaml" "$1" 20 100 1
}

count=0
declare -A unchanged
for example in drop/scene dam_break/scene mixer/scene report/realtime; do
    unchanged[$example]=$(runs "$example") ||
        { echo "one_source: $example differs without any change: ${unchanged[$example]}" >&2 && exit 1; }
done
# mutant EXAMPLE FILE FROM TO: FROM, once in a line of the file, becomes TO.
mutant() {
    local after
    cp "$2" original
    FROM=$3 TO=$4 awk '{ at = done ? 0 : index($0, ENVIRON["FROM"]) }
        at { $0 = substr($0, 1, at - 1) ENVIRON["TO"] substr($0, at + length(ENVIRON["FROM"])); done = 1 }
        { print } END { exit !done }' original >"$2" || { echo "one_source: no '$3' in $2" >&2 && exit 1; }
    after=$(runs "$1") || { echo "one_source: with '$4' in $2 the device computes something else: $after" >&2 && exit 1; }
    [ "$after" != "${unchanged[$1]}" ] || { echo "one_source: '$4' in $2 changes nothing in $1" >&2 && exit 1; }
    cp original "$2"
    count=$((count + 1))
}
mutant drop/scene src/methods/muller/muller_pair.h 'press * dy' '0.5 * press * dy'
mutant drop/scene src/methods/muller/leapfrog.h 'dt / 2 * f->ay' 'dt / 4 * f->ay'
mutant dam_break/scene src/methods/wcsph/wcsph_force.h 'q.b * gx + q.c * gy' 'q.b * gx - q.c * gy'
mutant dam_break/scene src/methods/wcsph/wcsph_pair.h 'SPH2D__DIFFUSION = 0.03' 'SPH2D__DIFFUSION = 0.04'
mutant dam_break/scene src/kernels/kernel.h '(4 * q + 1)' '(4 * q + 1.5)'
mutant dam_break/scene src/sim/balance.h 'v2 / 2' 'v2 / 3'
mutant mixer/scene src/methods/wcsph/implicit_sweeps.h 'v.y + dt * a.y' 'v.y - dt * a.y'
mutant report/realtime src/methods/hybrid/transfer.h 'u + p->u_y' 'u - p->u_y'
echo "one_source: $count changes, each the same on the device as on the processor"
