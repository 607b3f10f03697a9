#!/usr/bin/env bash
# Does a device make the bits of the processor? bits.sh BUILD [NAME=VALUE...]
#
# Runs scenes of examples by every method that devices take, coarsely, on the device and on the processor by instruction set
# baseline, and compares hashes of what particles carry and of the summary. What pocl compiles stays in BUILD.
#   device=      a number of `sph2d devices`; without it the one of pocl, which is the processor by OpenCL (Debian: pocl-opencl-icd)
#   scenes=      'drop/scene report/realtime', say; without it all that have blocks or sources
#   methods=own  each scene by its own method alone
#   steps=20 particles=100 jobs=1
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=$(realpath -e "$1") device='' scenes='' methods=all steps=20 particles=100 jobs=1
for word in "${@:2}"; do
    case $word in
    device=* | scenes=* | methods=own | steps=* | particles=* | jobs=*) declare "$word" ;;
    *) echo "bits: what is '$word'?" >&2 && exit 2 ;;
    esac
done
export POCL_CACHE_DIR="${POCL_CACHE_DIR-$build/pocl}" LC_ALL=C
# Runs; fewer have been left out by mistake.
case $methods,$scenes in
all,) fewest=150 ;;
own,) fewest=35 ;;
*) fewest=$(wc -w <<<"$scenes") ;;
esac
out=$build/device
rm -rf "$out" && mkdir -p "$out/lines"
"$build/sph2d" devices --json >"$out/devices"
[ -n "$device" ] || device=$(tests/device/pocl.sh "$build/sph2d")
about=$(grep "^{\"number\": $device, " "$out/devices") || { echo "bits: no device $device in 'sph2d devices'" >&2 && exit 1; }
name=${about#*'"name": "'} && name=${name%%\"*}
grep -q '"same_bits": true' <<<"$about" || { echo "bits: $name does not round as the processor does" >&2 && exit 1; }

code=0
own=$([ $methods = all ] || echo own)
[ -n "$scenes" ] || scenes=$(grep -lx 'blocks:\|sources:' examples/*/*.yaml | sed 's/^examples.//; s/.yaml$//')
export device particles build own
# shellcheck disable=SC2016 # the inner shell expands them
for short in $scenes; do
    some=$steps
    [ "$short$particles" != burst/scene100 ] || some=$((steps / 10)) # 16,384 particles, and not fewer
    printf '%s\0%s\0%s\0%s\0' "examples/$short.yaml" "$short" "$some" "$out/lines/${short/\//.}"
done | xargs -0 -n 4 -P "$jobs" \
    sh -c '"$build/tests/golden" --device "$device" ${own:+--own} "$0" "$1" "$2" "$particles" 1 >"$3"' || code=1
cat "$out"/lines/* | sort >"$out/runs"
runs=$(wc -l <"$out/runs")
if [ $code != 0 ]; then
    grep '; by the device' "$out/runs" >&2 || true
    echo "bits: of $runs runs on $name some differ, or did not end" >&2 && exit 1
fi
[ "$runs" -ge "$fewest" ] || { echo "bits: only $runs runs, not $fewest" >&2 && exit 1; }
echo "bits: $runs runs on $name, the same bits as the processor after $steps steps"
