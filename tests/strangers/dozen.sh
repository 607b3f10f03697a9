#!/usr/bin/env bash
# A dozen scenes as a stranger would write them, each by the default and by every method: energy made from nothing,
# compression, level, particles lost, time. dozen.sh SPH2D STRANGERS DIR [JOBS [SCENE...]]
#
# Leaves dozen.csv and dozen.txt in DIR, and a picture of each in the middle of its run, DIR/SCENE-METHOD.png. Numbers:
# rise: largest rise of kinetic + potential + elastic energy above an earlier moment, per cent of the scene's scale
# (energy.c), of closed scenes; p99, mean, max: compression, per cent, as reported; counted: mean density inside the liquid
# at the end by counting, and reported: as reported, both less 1, per cent; level: of the settled liquid over the exact one
# less 1, per cent, from elevations at five places over the last quarter of the time; lost: particles through open
# sides; cpu: seconds of stepping on one thread.
set -euo pipefail
methods='default muller wcsph pcisph constraint'
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# What a scene is known by: the level at rest [m], and the range of x over which it is measured.
level_of() {
    case $1 in
    falling_block) echo 0.18 0 2 ;;
    pool) echo 0.5 0 1 ;;
    wave) echo 0.4 0 2 ;;
    jet) echo 0.12 0 3 ;;
    drop) echo 0.370686 0 1 ;;                  # 0.3 + pi 0.15^2
    slope) echo 0.134847 0.9 2 ;;               # y + y^2/1.2 = 0.15
    two_columns) echo 0.32 0 2 ;;
    obstacle) echo 0.2 0 2 ;;
    thin_film) echo 0.05 0 2 ;;
    *) echo nan 0 1 ;;
    esac
}

# Elevations of five places as the probes of a scene: probes_of LEFT RIGHT EVERY
probes_of() {
    awk -v a="$1" -v b="$2" -v every="$3" 'BEGIN {
        printf "probes=[{name: energy, kind: energy, every: %g}", every
        for (i = 0; i < 5; ++i)
            printf ", {name: level%d, kind: elevation, at: [%g, 0], every: %g}", i, a + (b - a) * (i + 0.5) / 5, every
        print "]" }'
}

number() { # number KEY FILE: the first one with that key in a line of JSON
    sed -n "s/.*\"$1\": \([-+0-9.e]*\|nan\|null\)[,}].*/\1/p" "$2" | head -n 1
}

# The mean elevation after three quarters of the time, over the exact one less 1, in per cent.
level_error() {
    cat "$1"/level?.csv 2>/dev/null | awk -F, -v exact="$2" -v from="$3" \
        '$1 ~ /^[0-9]/ && $1 + 0 >= from { sum += $2 ~ /[0-9]/ ? $2 : 0; ++n } # none: dry, down to the floor at 0
         END { if (n && exact != "nan") printf "%.3g", 100 * (sum / n / exact - 1); else printf "-" }'
}

row() { # row SCENE METHOD
    local scene=$here/scenes/$1.yaml name=$1-$2 until level left right status=0
    until=$(sed -n 's/^run: {until: \([0-9.]*\)}/\1/p' "$scene")
    read -r level left right <<<"$(level_of "$1")"
    local set=()
    [ "$2" = default ] || set=(-s "method={name: $2}")
    "$here/../limit.sh" 900 "$SPH2D" run "$scene" -o "$OUT/$name" -f --json --threads 1 "${set[@]}" \
        -s "$(probes_of "$left" "$right" "$(awk "BEGIN { print $until / 400 }")")" \
        -s "run.frames={every: $(awk "BEGIN { print $until / 2 }"), size: [800, 500], style: points, color: speed}" \
        >"$OUT/$name.json" 2>"$OUT/$name.err" || status=$?
    [ ! -e "$OUT/$name/frames/frame_000001.png" ] || cp "$OUT/$name/frames/frame_000001.png" "$OUT/$name.png"
    "$STRANGERS" --library --isa auto --scene "$scene" "${set[@]/-s/--set}" --dir "$OUT/$name" >"$OUT/$name.log" || true
    awk -F, -v scene="$1" -v method="$2" -v status="$status" -v cpu="$(number step_cpu_seconds "$OUT/$name.json")" \
        -v level="$(level_error "$OUT/$name" "$level" "$(awk "BEGIN { print 0.75 * $until }")")" '
        function percent(x) { return x == "nan" || x == "-nan" || x == "" ? "-" : sprintf("%.3g", 100 * x) }
        function excess(x) { return x ~ /nan/ ? "-" : percent(x - 1) }
        NR == 2 { print scene, method, status, $2, $3, percent($5), percent($7), percent($8), percent($9), excess($10),
            excess($11), level, $14, cpu == "" ? "-" : sprintf("%.2f", cpu) }' OFS=, "$OUT/$name/$1/figures.csv" \
        >"$OUT/$name.row"
}

if [ "${1:-}" = --row ]; then
    row "$2" "$3"
    exit
fi
[ $# -ge 3 ] || { sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" >&2 && exit 64; }
SPH2D=$(realpath -e "$1") STRANGERS=$(realpath -e "$2")
mkdir -p "$3"
OUT=$(cd "$3" && pwd) jobs=${4:-1}
export SPH2D STRANGERS OUT LC_ALL=C
shift $(($# < 4 ? $# : 4))
[ $# -gt 0 ] || set -- falling_block pool wave jet drop slope two_columns obstacle source_drain moving_wall spin thin_film
for scene; do
    for method in $methods; do echo "$scene $method"; done
done | xargs -P "$jobs" -L 1 "${BASH_SOURCE[0]}" --row
{
    echo 'scene,method,exit,particles,steps,rise %,p99 %,mean %,max %,counted %,reported %,level %,lost,cpu s'
    for scene; do
        for method in $methods; do cat "$OUT/$scene-$method.row"; done
    done
} >"$OUT/dozen.csv"
awk -F, '{ printf "%-14s %-11s", $1, $2; for (i = 3; i <= NF; ++i) printf " %9s", $i; print "" }' "$OUT/dozen.csv" |
    tee "$OUT/dozen.txt"
