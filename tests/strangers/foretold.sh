#!/usr/bin/env bash
# Does check foretell what runs of the examples find? foretold.sh SPH2D STRANGERS DIR
#
# Each scene with about 400 particles, for as much of its time as takes about a second by check, by the invariant `plan`
# of the strangers.
set -euo pipefail
sph2d=$1 strangers=$2 dir=$3
mkdir -p "$dir"
number() { sed -n "s/.*\"$1\": \([0-9.e+-]*\).*/\1/p" "$dir/told"; }
failed=0 count=0
# shellcheck disable=SC2013 # no blanks in their names
for scene in $(grep -lx 'blocks:\|sources:' examples/*/*.yaml); do
    set=()
    "$sph2d" check "$scene" --json -j 1 >"$dir/told" 2>/dev/null
    factor=$(awk -v n="$(number particles)" \
        'BEGIN { if (n > 500) printf "%.4g", sqrt(n / 400) }')
    if [ -n "$factor" ]; then
        own=$(sed -n 's/^spacing: \([0-9.e-]*\).*/\1/p' "$scene")
        wider=$(awk -v own="$own" -v k="$factor" 'BEGIN { printf "%.4g", own * k }')
        ! "$sph2d" check "$scene" --json -j 1 -s spacing="$wider" >"$dir/wider" 2>/dev/null ||
            { mv "$dir/wider" "$dir/told" && set+=(--set spacing="$wider"); }
    fi
    until=$(awk -v t="$(number until)" -v s="$(number cpu_seconds)" 'BEGIN { printf "%.4g", (s > 1 ? t / s : t) }')
    set+=(--set run.until="$until")
    count=$((count + 1))
    "$strangers" --command "$sph2d" --dir "$dir" --only plan --scene "$scene" "${set[@]}" >"$dir/verdict" ||
        { grep -v '^strangers' "$dir/verdict" && failed=$((failed + 1)); }
done
echo "foretold: $count examples, $failed of them otherwise than check foretells"
[ $failed = 0 ]
