#!/usr/bin/env bash
# Does a wrong formula fail a test? Changes each constant and sign of the formulas once, builds, and runs the suites of
# physics: mutants.sh [FILE...]; SUITES='solvers projection' JOBS=1 for others, one at a time
#
# A mutant is killed when a suite fails, crashes, or takes longer than ten seconds. Survivors are compared with
# tests/mutants/survivors, which says of each why it may live; the script fails when another one lives. Takes about an hour
# on two processors. A mutant that the compiler refuses does not count.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
files=("$@")
[ $# -gt 0 ] || mapfile -t files < <(sed '/^#/d;/^$/d' "$root/tests/mutants/files")
usual="kernels smoothing projection solvers variational variational_loads friction muller muller_energy tension fitted fitted_walls
    cells periodic leapfrog layers walls invariance tunnelling conservation symmetry flows flows_channels
    flows_free pose barrier"
read -ra suites -d "" <<<"${SUITES:-$usual}" || true
workers=${JOBS:-$(nproc)}
scratch=$(mktemp -d "${TMPDIR:-/tmp}/sph2d-mutants.XXXXXX")
trap 'rm -rf "$scratch"' EXIT

(cd "$root" && awk -f tests/mutants/list.awk "${files[@]}") >"$scratch/list"
make_tests() { make -s -C "$1" DEPS=skip RENDER=0 OPENMP=0 X86= CFLAGS=-O1 build/tests/check_all >"$1.log" 2>&1; }
lives() { # a suite at a time, up to the first that fails
    local suite
    for suite in "${suites[@]}"; do
        (cd "$1" && CK_FORK=no timeout -k 1 10 build/tests/check_all "$suite") >/dev/null 2>&1 || return 1
    done
}

# One scratch copy of the tree a worker.
work() {
    local tree=$scratch/tree$1 n=0
    mkdir "$tree" && (cd "$root" && git ls-files -z | xargs -0 tar cf -) | tar xf - -C "$tree"
    make_tests "$tree" || { cat "$tree.log" >&2 && return 1; }
    while IFS=$'\t' read -r file line column length old new; do
        n=$((n + 1))
        [ $((n % workers)) = "$1" ] || continue
        awk -v l="$line" -v c="$column" -v n="$length" -v new="$new" \
            'NR == l { $0 = substr($0, 1, c - 1) new substr($0, c + n) } { print }' "$root/$file" >"$tree/$file"
        verdict=survived
        if ! make_tests "$tree"; then
            verdict=refused
        elif ! lives "$tree"; then
            verdict=killed
        fi
        printf '%s\t%s\t%s\t%s\t%s\t%s\n' $verdict "$file" "$line" "$column" "$old -> $new" \
            "$(sed -n "${line}s/^ *//p" "$root/$file")" >>"$scratch/result$1"
        cp "$root/$file" "$tree/$file"
    done <"$scratch/list"
}
for ((w = 0; w < workers; w++)); do work $w & done
wait
sort -t $'\t' -k2,2 -k3,3n -k4,4n "$scratch"/result* >"${RESULT:-$scratch/result}"
awk -F '\t' '{ n[$1]++ } END {
    printf "%d mutants: %d killed, %d survived (%.1f %%), %d refused by the compiler\n", NR, n["killed"], n["survived"],
        100 * n["survived"] / (n["killed"] + n["survived"]), n["refused"] }' "${RESULT:-$scratch/result}"

# Survivors by file, change and text of the line: line numbers move.
new=$(awk -F '\t' 'NR == FNR { if ($0 !~ /^#/ && NF >= 3) known[$1 FS $2 FS $3] = 1; next }
    $1 == "survived" && !(($2 FS $5 FS $6) in known) { print $2 FS $5 FS $6 }' \
    "$root/tests/mutants/survivors" "${RESULT:-$scratch/result}")
[ -z "$new" ] || { printf 'These live, and tests/mutants/survivors does not say why:\n%s\n' "$new" >&2 && exit 1; }
