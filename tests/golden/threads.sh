#!/usr/bin/env bash
# Does any number of threads give the same bits? threads.sh GOLDEN OUT JOBS [STEPS [PARTICLES]]
#
# Runs every scene of examples by every method and instruction set by 1, 2, 3, 5 and 8 threads, and compares
# hashes of all particles: after 100 steps of about 1200 particles, enough slabs for loops to be shared. The lines of
# all runs are in OUT/lines.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
golden=$1 out=$2 jobs=$3 steps=${4-100} particles=${5-1200}
export OMP_WAIT_POLICY=passive # as there are more threads than processors
rm -rf "$out" && mkdir -p "$out/lines"
code=0
# shellcheck disable=SC2016 # the inner shell expands them
grep -lx 'blocks:\|sources:' examples/*/*.yaml | while read -r scene; do
    name=${scene#examples/} && name=${name%.yaml}
    printf '%s\0%s\0%s\0' "$scene" "$name" "$out/lines/${name/\//.}"
done | STEPS=$steps PARTICLES=$particles xargs -0 -n 3 -P "$jobs" \
    sh -c '"$0" "$1" "$2" "$STEPS" "$PARTICLES" 1 2 3 5 8 >"$3"' "$golden" || code=1
runs=$(cat "$out"/lines/* | wc -l)
if [ $code != 0 ]; then
    grep -h '; by ' "$out"/lines/* >&2 || true
    echo "threads: of $runs runs some differ, or did not end" >&2 && exit 1
fi
echo "threads: $runs runs by 1, 2, 3, 5 and 8 threads, the same bits after $steps steps"
