#!/usr/bin/env bash
# Does a wrong formula fail a test? Changes each constant and sign of the formulas once, builds, and runs the suites that
# run the changed line, but for their long tests: mutants.sh [FILE...]
#
# SHARE=3/10 takes the mutants whose number leaves 3 when divided by 10, less those that are known to live;
# SECONDS_EACH=20 tries suites that take so long together, at least one; SUITES='solvers projection' runs no others,
# JOBS=1 one at a time; RESULT=FILE keeps the table.
#
# Which suites run a line is measured first, by gcov; a line without counts, as that of a constant, is taken to be run by
# all suites that run its file. The suite that killed the last mutant of the file comes first, then those whose name is in
# the file's path, then the fastest. The first test that fails, crashes, or makes its suite take five times as long as it
# did and 4 s more kills the mutant, and the rest is left out. A mutant that the compiler refuses does not count, nor one
# of the same machine code. Survivors are compared with tests/mutants/survivors, which says of each why it may live; the
# script fails when another one lives, or more than LIVE=30 per cent of all.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
files=("$@")
[ $# -gt 0 ] || mapfile -t files < <(sed '/^#/d;/^$/d' tests/mutants/files | while read -r pattern; do
    compgen -G "$pattern" || echo "$pattern"
done | LC_ALL=C sort -u)
workers=${JOBS:-$(nproc)}
share=${SHARE:-0/1}
most=${SECONDS_EACH:-1000}
scratch=$(mktemp -d "${TMPDIR:-/tmp}/sph2d-mutants.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
result=${RESULT:-$scratch/result}
export CK_EXCLUDE_TAGS=long CK_FORK=no
unset MAKEFLAGS MFLAGS MAKEOVERRIDES CFLAGS CPPFLAGS LDFLAGS
SETTINGS=(BUILD=build SANITIZE= DEPS=skip RENDER=0 OPENMP=0 X86= PACKAGES_CHECKED=1 COUNTING=1)

# ---- the mutants ------------------------------------------------------------------------------------------------------
awk -f tests/mutants/list.awk "${files[@]}" | awk -v share="$share" 'BEGIN { split(share, p, "/") } NR % p[2] == p[1] % p[2]' \
    >"$scratch/all"
# Known survivors by file, change and text of the line: line numbers move.
if [ -n "${SHARE:-}" ]; then
    awk -F '\t' -v known=tests/mutants/survivors '
        BEGIN { while ((getline row <known) > 0) if (split(row, f, "\t") >= 3) skip[f[1] FS f[2] FS f[3]] = 1 }
        $1 != file { file = $1; n = 0; while ((getline row <file) > 0) { sub(/^ */, "", row); text[++n] = row } close(file) }
        !(($1 FS $5 " -> " $6 FS text[$2]) in skip)' "$scratch/all" >"$scratch/list"
else
    mv "$scratch/all" "$scratch/list"
fi

printf '%s mutants%s\n' "$(wc -l <"$scratch/list")" "${SHARE:+, share $SHARE; SHARE=$SHARE tests/mutants.sh runs them again}"

# ---- what runs what ---------------------------------------------------------------------------------------------------
make_tests() { make -s -C "$1" "${SETTINGS[@]}" "${@:2}" build/tests/check_all </dev/null >"$1.log" 2>&1; }
tree=$scratch/tree0
mkdir "$tree" "$scratch/suites"
git ls-files -z | xargs -0 tar cf - | tar xf - -C "$tree"
make_tests "$tree" -j"$workers" CFLAGS='-O1 --coverage' || { cat "$tree.log" >&2 && exit 1; }
mv "$tree/build" "$scratch/counts"
make_tests "$tree" -j"$workers" CFLAGS=-O1 || { cat "$tree.log" >&2 && exit 1; }
cp "$tree/build/tests/check_all" "$scratch/unchanged"

# The lines of a suite as FILE LINE 1, those that it leaves out as FILE LINE 0; its CPU time in ms. One that fails
# without a change, as some do without rendering, is left out.
# shellcheck disable=SC2317 # called by xargs
measure() {
    local to=$scratch/suites/$1 TIMEFORMAT=%U
    mkdir -p "$to/counts"
    { time GCOV_PREFIX=$to/counts GCOV_PREFIX_STRIP=$strip "$scratch/counts/tests/check_all" "$1" >"$to/log" 2>&1; } \
        2>"$to/seconds" || { rm -r "$to" && return; }
    awk '{ printf "%d\n", 1000 * $1 }' "$to/seconds" >"$to/ms"
    cp -rs "$scratch/notes/src" "$to/counts"
    find "$to/counts/src" -name '*.gcda' -print0 | xargs -0 -r gcov -t 2>/dev/null | awk -F : '
        /^ +-: +0:Source:/ { file = $4; next }
        $2 + 0 > 0 && $1 ~ /[0-9]\*?$/ { ran[file "\t" $2 + 0] = 1 }
        $2 + 0 > 0 && $1 ~ /#####|=====/ { left[file "\t" $2 + 0] = 1 }
        END { for (l in ran) print l "\t1"; for (l in left) if (!(l in ran)) print l "\t0" }' >"$to/lines"
    rm -r "$to/counts"
}
export -f measure
slashes=${tree//[^\/]/}
export scratch strip=$((${#slashes} + 3))
mkdir "$scratch/notes" && (cd "$scratch"/counts/obj/* && find src -name '*.gcno' -exec cp --parents -t "$scratch/notes" {} +)
printf '%s\n' "${SUITES:-$("$scratch/unchanged" --list)}" | tr -s ' ' '\n' | xargs -P "$workers" -I{} bash -c 'measure {}'
mapfile -t lines < <(cd "$scratch/suites" && for s in *; do echo "$(<"$s/ms") $PWD/$s/lines"; done | sort -n | cut -d ' ' -f 2)
# Each mutant with its suites, the fastest first: NUMBER SUITE...
awk -F '\t' -v list="$scratch/list" '
    function add(key, suite) { of[key] = of[key] " " suite }
    BEGIN { while ((getline row <list) > 0) { split(row, f, "\t"); wanted[f[1]] = 1; line[f[1] FS f[2]] = 1 } close(list) }
    FNR == 1 { suite = FILENAME; sub(/\/lines$/, "", suite); sub(/.*\//, "", suite) }
    $1 in wanted {
        if ($3 && last[$1] != suite) { last[$1] = suite; add($1, suite) }
        if (($1 FS $2) in line) { counted[$1 FS $2] = 1; if ($3) add($1 FS $2, suite) }
    }
    END {
        while ((getline row <list) > 0) {
            split(row, f, "\t"); key = f[1] FS f[2]
            print ++n (key in counted ? of[key] : of[f[1]])
        }
    }' "${lines[@]}" >"$scratch/runs"

# ---- one after the other ----------------------------------------------------------------------------------------------
killer() { # the first suite that kills: killer TREE FILE SUITE...
    local tree=$1 file=$2 suite ms limit spent=0 first=() second=() third=() words
    words=$(tr -cs 'a-z\n' ' ' <<<"${file#src/}")
    shift 2
    for suite in "$@"; do
        if [ "$suite" = "${last[$file]:-}" ]; then first+=("$suite")
        elif [[ " $words " == *" ${suite%%_*} "* || " $words " == *" ${suite%%_*}s "* ]]; then second+=("$suite")
        else third+=("$suite"); fi
    done
    for suite in "${first[@]}" "${second[@]}" "${third[@]}"; do
        ms=$(<"$scratch/suites/$suite/ms")
        [ $spent = 0 ] || [ $((spent + ms)) -le $((1000 * most)) ] || continue
        spent=$((spent + ms)) limit=$((4 + 5 * ms / 1000))
        (ulimit -t $limit -v 4000000 && cd "$tree" && CK_TAP_LOG_FILE_NAME=- CK_VERBOSITY=silent timeout -k 1 $((20 * limit)) \
            stdbuf -oL build/tests/check_all "$suite" </dev/null 2>/dev/null) | { ! grep -q '^not ok'; } || { echo "$suite" && return; }
    done
}
work() { # one scratch copy of the tree a worker
    local tree=$scratch/tree$1 n=0 verdict by start
    declare -A last=()
    while IFS=$'\t' read -r file line column length old new; do
        n=$((n + 1))
        [ $((n % workers)) = "$1" ] || continue
        start=${EPOCHREALTIME/./}
        awk -v l="$line" -v c="$column" -v n="$length" -v new="$new" \
            'NR == l { $0 = substr($0, 1, c - 1) new substr($0, c + n) } { print }' "$file" >"$tree/$file"
        by=-
        if ! make_tests "$tree" CFLAGS=-O1; then
            verdict=refused
        elif cmp -s "$tree/build/tests/check_all" "$scratch/unchanged"; then
            verdict=same
        else
            read -ra suites <<<"${runs[n]#* }"
            [[ ${runs[n]} == *' '* ]] || suites=()
            verdict=survived by=$(killer "$tree" "$file" "${suites[@]}")
            if [ -n "$by" ]; then verdict=killed last[$file]=$by
            elif [ ${#suites[@]} = 0 ]; then by='no suite runs it'
            else by="by ${#suites[@]} suites"; fi
        fi
        printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$verdict" "$file" "$line" "$column" "$old -> $new" \
            "$(sed -n "${line}s/^ *//p" "$file")" "$by" $(((${EPOCHREALTIME/./} - start) / 1000)) >>"$scratch/result$1"
        cp "$file" "$tree/$file"
    done <"$scratch/list"
}
mapfile -t -O 1 runs <"$scratch/runs"
for ((w = 1; w < workers; w++)); do cp -a "$tree" "$scratch/tree$w"; done
for ((w = 0; w < workers; w++)); do work $w & done
wait
sort -t $'\t' -k2,2 -k3,3n -k4,4n "$scratch"/result[0-9]* >"$scratch/sorted"
cp "$scratch/sorted" "$result"
awk -F '\t' '{ n[$1]++ } END {
    printf "%d mutants: %d killed, %d survived (%.1f %%), %d of the same code, %d refused by the compiler\n", NR, n["killed"],
        n["survived"], 100 * n["survived"] / (n["killed"] + n["survived"]), n["same"], n["refused"] }' "$result"

new=$(awk -F '\t' 'NR == FNR { if ($0 !~ /^#/ && NF >= 3) known[$1 FS $2 FS $3] = 1; next }
    $1 == "survived" && !(($2 FS $5 FS $6) in known) { print $2 FS $5 FS $6 FS $7 }' tests/mutants/survivors "$result")
[ -n "$new" ] || exit 0
printf 'These live, and tests/mutants/survivors does not say why:\n%s\n' "$new"
awk -F '\t' -v new="$(wc -l <<<"$new")" -v most="${LIVE:-0}" '
    $1 == "killed" || $1 == "survived" { ++n }
    END {
        printf "%.1f %% of the mutants; at most %g %% may\n", 100 * new / n, most
        exit 100 * new > most * n
    }' "$result"
