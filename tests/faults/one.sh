#!/usr/bin/env bash
# One fault in one command: one.sh CASE FAULT, FAULT as shim.c wants it. Prints a line for each thing that is wrong.
#
# SPH2D, SHIM, LIBRARY and REFERENCE (a folder of faults.sh: what the commands give without faults) come from outside.
# What must hold: the command ends by itself, within the limit and by no signal; not with 0, unless all is as without
# the fault; with a sentence; every file under a final name is one of those without the fault, or the beginning of a
# series with whole rows; no temporary file is left, unless the command broke down; and then the same command, or
# `resume`, comes to the same bytes.
set -u
case=$1 fault=$2
: "${SPH2D:?}" "${SHIM:?}" "${LIBRARY:?}" "${REFERENCE:?}"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scene=$here/scene.yaml study=$here/study.yaml
work=$(mktemp -d "${TMPDIR:-/tmp}/sph2d-fault.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

wrong() {
    printf '%s %s: %s (ended with %s)\n' "$case" "$fault" "$*" "$code"
    [ -z "${VERBOSE:-}" ] || { head -c 2000 err && ls -la out; }
}

# The command of a case, with the fault.
run_command() {
    case $case in
    run) set -- "$SPH2D" run "$scene" -q -j 2 --no-frames -o out ;;
    run_frames) set -- "$SPH2D" run "$scene" -q -j 2 -o out ;;
    run_over) set -- "$SPH2D" run "$scene" -q -j 2 --no-frames -f -o out ;;
    resume) set -- "$SPH2D" resume out -q -j 2 --no-frames ;;
    render) set -- "$SPH2D" render "$REFERENCE/run/snapshot_000001.h5" -q -j 1 -o out ;;
    check) set -- "$SPH2D" check "$scene" -j 1 ;;
    preview) set -- "$SPH2D" check "$scene" -j 1 --preview out/first.png ;;
    init) set -- "$SPH2D" init out --template drop ;;
    info) set -- "$SPH2D" info "$REFERENCE/run/snapshot_000001.h5" ;;
    info_run) set -- "$SPH2D" info "$REFERENCE/run" ;;
    plot) set -- "$SPH2D" plot "$REFERENCE/run" -o picture.svg ;;
    export) set -- "$SPH2D" export "$REFERENCE/run/snapshot_000001.h5" -q -o out/particles.csv ;;
    export_series) set -- "$SPH2D" export "$REFERENCE/run" -q -o out/flow.pvd ;;
    study) set -- "$SPH2D" study "$study" -q -j 1 -J 2 -o out ;;
    shard) set -- "$SPH2D" study "$study" -q --shard 2/2 -o out ;;
    library) set -- "$LIBRARY" ;;
    esac
    code=0
    # Not for the programs that the command calls: gnuplot would count its own.
    "$here/../limit.sh" 30 env PATH='' LD_PRELOAD="$SHIM" FAULTS="$fault" "$@" >printed 2>err </dev/null || code=$?
}

prepare() {
    case $case in
    resume) mkdir out && cp "$REFERENCE"/run/*.csv "$REFERENCE"/run/snapshot_00000[01].h5 out ;;
    run_over) cp -r "$REFERENCE/run" out ;;
    preview | export | export_series) mkdir out ;;
    shard) "$SPH2D" study "$study" -q --shard 1/2 -o out ;;
    esac
}

# What the command gives without faults.
expected=$REFERENCE/$case
case $case in resume | run_over) expected=$REFERENCE/run ;; esac

# Every file under a final name is whole.
check_files() {
    [ -d out ] || return 0
    find out -type f -name '.*' | grep -q . && leftover=1
    [ "$leftover" = 0 ] || grep -q 'broke down\|ended the command' err || wrong 'a temporary file is left'
    find out -type f ! -name '.*' -printf '%P\n' | while read -r file; do
        case $case/$file in
        study/*.csv | study/plots.* | study/study.html | shard/*.csv | shard/plots.* | shard/study.html)
            [ -z "$(tail -c 1 "out/$file")" ] || wrong "$file does not end with its line"
            ;;
        study/* | shard/*) ;;
        export/* | export_series/*) cmp -s "out/$file" "$expected/$file" || wrong "$file is not what it should be" ;;
        *.csv)
            cmp -s -n "$(stat -c %s "out/$file")" "out/$file" "$expected/$file" || wrong "$file is not what it should be"
            [ -z "$(tail -c 1 "out/$file")" ] || [ "$fault" != "${fault#truncate}" ] ||
                wrong "$file ends with part of a row"
            ;;
        *) cmp -s "out/$file" "$expected/$file" || wrong "$file is not what it should be" ;;
        esac
    done
}

# The same without faults comes to the same end.
check_recovery() {
    case $case in
    run | run_frames | run_over | resume)
        if ls out/snapshot_*.h5 >/dev/null 2>&1; then
            frames=--no-frames
            [ "$case" != run_frames ] || frames=-q
            "$SPH2D" resume out -q -j 2 $frames >printed 2>again </dev/null || wrong "resume fails: $(head -n 1 again)"
            diff -r "$expected" out >/dev/null || wrong 'the resumed run is another'
        fi
        ;;
    render)
        "$SPH2D" render "$REFERENCE/run/snapshot_000001.h5" -f -q -j 1 -o out >/dev/null 2>&1 </dev/null || wrong 'fails again'
        diff -r "$expected" out >/dev/null || wrong 'it draws another picture'
        ;;
    preview)
        "$SPH2D" check "$scene" -j 1 --preview out/first.png >/dev/null 2>again </dev/null || wrong 'fails again'
        diff -r "$expected" out >/dev/null || wrong 'it draws another picture'
        ;;
    init)
        "$SPH2D" init out --template drop -f >/dev/null 2>again </dev/null || wrong "fails again: $(head -n 1 again)"
        diff -r "$expected" out >/dev/null || wrong 'it writes another scene'
        ;;
    study | shard)
        [ ! -d out ] || "$SPH2D" study "$study" -q -j 1 -f -o out >/dev/null 2>again </dev/null ||
            wrong "fails again: $(head -n 1 again)"
        ;;
    esac
}

leftover=0
prepare
run_command
case $code in
0)
    case $case in
    info | info_run | library) cmp -s printed "$REFERENCE/$case.txt" || wrong 'it prints something else' ;;
    check | study | shard) ;;
    *) diff -r "$expected" out >/dev/null || wrong 'the results are others' ;;
    esac
    ;;
64 | 65 | 66 | 69 | 70 | 73 | 74) grep -q 'sph2d: \|error\[' err || wrong 'it says nothing' ;;
124) wrong "$(tail -n 1 err)" ;;
*) wrong "no exit code of sph2d: $(head -n 1 err)" ;;
esac
check_files
[ "$code" = 0 ] || check_recovery
[ -z "${CODES:-}" ] || printf '%s %s %s\n' "$case" "${fault%%:*}" "$code" >>"$CODES"
exit 0
