#!/usr/bin/env bash
# Scenes that nobody tuned, each by the methods that suit it, judged by the bounds of its study: hard.sh SPH2D FOLDER [JOBS
# [NAME...]]
#
# A name is a folder of this one with a study.yaml; without names all run, and the studies of examples/ that LISTED has.
# Prints a table: study, row, measure, value, error, bound, verdict. `known` is a bound that is missed and listed in
# known_failures; `MISSED` is one that is not listed, `WORSE` an error of more than 1.2 times what is listed, `HOLDS` one
# that is listed and met: all three make this fail. FOLDER gets hard.txt and a folder with the files of each study.
set -euo pipefail
listed='viscous_wave/study viscous_wave/study_re20'
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
[ $# -ge 2 ] || { sed -n '2,3s/^# //p' "${BASH_SOURCE[0]}" >&2 && exit 64; }
sph2d=$(realpath -e "$1") jobs=${3:-1}
mkdir -p "$2"
folder=$(cd "$2" && pwd)
shift $(($# < 3 ? $# : 3))
export LC_ALL=C

names=("$@")
if [ $# -eq 0 ]; then
    for study in "$here"/*/study.yaml; do names+=("$(basename "$(dirname "$study")")"); done
    for study in $listed; do names+=("$study"); done
fi

# JSON of a study as lines: name|row|measure|value|error|bound, and for each row its end.
lines_of() { # lines_of NAME <JSON
    sed 's/{"row": /\n&/g; s/{"name": /\n&/g' | awk -v study="$1" '
        function text(key) { return match($0, "\"" key "\": \"[^\"]*\"") ? part(key, 1) : "" }
        function number(key) { return match($0, "\"" key "\": [-+0-9.a-z]+") ? part(key, 0) : "-" }
        function part(key, quotes) { return substr($0, RSTART + length(key) + 4 + quotes, RLENGTH - length(key) - 4 - 2 * quotes) }
        /^\{"row": / { row = text("name"); print study, row, "end", text("end"), text("end") == "finished" ? 0 : 1, 0 }
        /^\{"name": / { print study, row, text("name"), number("value"), number("error"), number("bound") }' OFS='|'
}

: >"$folder/lines"
for name in "${names[@]}"; do
    study=$here/$name/study.yaml
    [ -e "$study" ] || study=$here/../../examples/$name.yaml
    # A miss ends with 1 and is judged below; what could not be run at all is an error of its own.
    code=0
    "$sph2d" study "$study" -o "$folder/$name" -f --json --jobs "$jobs" --threads 1 --progress never \
        >"$folder/json" 2>"$folder/told" || code=$?
    if [ "$code" -gt 1 ] || ! grep -q '"rows"' "$folder/json"; then cat "$folder/told" >&2 && exit 1; fi
    lines_of "$name" <"$folder/json" >>"$folder/lines"
done
rm "$folder/json" "$folder/told"

# A listed failure: STUDY|ROW|MEASURE|its error.
grep -v '^#' "$here/known_failures" | awk -F '|' -v lines="$folder/lines" '
    { known[$1 "|" $2 "|" $3] = $4 + 0 }
    function shown(x) { return x ~ /^-?[0-9.]/ ? sprintf("%.4g", x) : x == "" ? "-" : x }
    END {
        while ((getline line <lines) > 0) {
            split(line, v, "|")
            key = v[1] "|" v[2] "|" v[3]
            missed = v[6] != "-" && (v[5] !~ /^-?[0-9]/ || v[5] + 0 > v[6] + 0)
            worse = key in known && (v[5] + 0 > 1.2 * known[key])
            verdict = v[6] == "-" ? "" : missed ? (!(key in known) ? "MISSED" : worse ? "WORSE" : "known") : \
                (key in known ? "HOLDS" : "ok")
            ++count[verdict]
            if (v[3] == "end" && verdict == "ok")
                continue
            printf "%-18s %-24s %-34s %12s %10s %8s  %s\n", v[1], v[2], v[3], shown(v[4]), shown(v[5]), shown(v[6]), verdict
        }
        printf "%d bounds are met, %d known failures, %d missed, %d worse than listed, %d listed that hold\n",
            count["ok"], count["known"], count["MISSED"], count["WORSE"], count["HOLDS"]
        exit count["MISSED"] + count["WORSE"] + count["HOLDS"] > 0
    }' | tee "$folder/hard.txt"
