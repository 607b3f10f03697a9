#!/usr/bin/env bash
# Instructions that a particle takes in a step, counted by callgrind: instructions.sh BENCH [SCENE...]
#
# A count does not mind what else a machine does, so that two commits can be compared on a busy one. One line a scene, in
# the AVX2 loops (valgrind knows no AVX-512), or those of ISA. What starting takes is in two runs of different length
# alike: their difference is that of the steps.
set -euo pipefail
bench=$1
shift
[ $# -gt 0 ] || set -- wcsph muller pcisph constraint fitted
particles=${PARTICLES:-4000} few=2 many=12
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

count() { # SCENE STEPS
    valgrind --tool=callgrind --callgrind-out-file="$folder/out" \
        --toggle-collect=sph2d_sim_step "$bench" --scenes "$1" --isa "${ISA:-avx2}" --particles "$particles" \
        --threads 1 --runs 1 --steps "$2" --json >"$folder/row" 2>"$folder/log" || { cat "$folder/log" >&2 && exit 1; }
    sed -n 's/^totals: *\([0-9]*\).*/\1/p' "$folder/out"
}

for scene in "$@"; do
    short=$(count "$scene" $few) long=$(count "$scene" $many)
    actual=$(grep -o '"particles": *[0-9]*' "$folder/row" | tail -n 1 | grep -o '[0-9]*$')
    awk -v scene="$scene" -v count="$((long - short))" -v steps=$((many - few)) -v particles="$actual" \
        'BEGIN { printf "%-14s %8.0f instructions a particle and step (%d particles)\n", scene, count / steps / particles, particles }'
done
