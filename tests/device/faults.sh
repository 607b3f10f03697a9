#!/usr/bin/env bash
# What if a device is lost? faults.sh GOLDEN FAULTY OUT [FIRST TIMES]
#
# Runs five steps of a scene on the first device with a libOpenCL.so.1 (FAULTY, tests/device/faulty.c) whose call number N
# fails, and all after it, and where nothing is done before the host waits for it: the FIRST calls (default 60), and TIMES more
# (default 40) spread over the rest. A run may end with the status of a device, or with none found, or as it should where the
# call does not matter, but not by a signal, and never with other numbers: where the device is lost after the last step there
# is no state, whose hash is 0.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
golden=$1 faulty=$2 out=$3 first=${4-60} times=${5-40}
rm -rf "$out" && mkdir -p "$out"
ln -s "$(realpath "$faulty")" "$out/libOpenCL.so.1"
FAULTY_REAL=$(ldconfig -p | awk '/libOpenCL\.so\.1 / && !n++ { print $NF }')
export FAULTY_REAL FAULTY_LATE=1 FAULTY_COUNT=$out/count POCL_CACHE_DIR=${POCL_CACHE_DIR:-$out/cache}
mkdir -p "$POCL_CACHE_DIR"
run() {
    FAULTY_AT=$1 LD_LIBRARY_PATH=$out "$golden" --device 1 --own examples/stir/scene.yaml stir 5 100 1
}
run 0 >"$out/good"
calls=$(cat "$FAULTY_COUNT")
seq 1 "$first" >"$out/calls"
awk -v n="$calls" -v f="$first" -v t="$times" 'BEGIN { for (k = 0; k < t; ++k) print int(f + 1 + k * (n - f - 1) / t) }' >>"$out/calls"
faults=0 same=0
while read -r at; do
    code=0
    run "$at" >"$out/said" 2>"$out/errors" || code=$?
    if [ "$code" = 0 ] && cmp -s "$out/said" "$out/good"; then
        same=$((same + 1))
    elif [ "$code" != 1 ] || ! grep -q '; by the device \(DEVICE\|INVALID\|OK 5 100 0000000000000000\)' "$out/said"; then
        echo "call $at of $calls: code $code, $(cat "$out/said" "$out/errors")"
        faults=$((faults + 1))
    fi
done <"$out/calls"
[ "$faults" = 0 ] && [ "$same" -lt "$first" ] && echo "device faults: $(wc -l <"$out/calls") of $calls calls failed, $same without effect"
