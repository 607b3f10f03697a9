#!/usr/bin/env bash
# Scenes run whole on one thread, and stopped and resumed on two: the same folder and the same exit code.
#
# restarts.sh SPH2D STRANGERS DIR JOBS FIRST..LAST | FOLDER
# A seed gives a scene of tests/strangers with more drives, probes and outputs, and its stops: by a signal, by
# --max-wall, after single steps, or by an earlier run.until. Where a signal hits depends on the machine; DIR/SEED/log
# says where. A FOLDER has scenes that are stopped as they are, after single steps and by run.until: together they use
# every key of a scene, but those that FOLDER/unused_keys lists with a reason.
# DEVICE=N: whole by instruction set baseline, in parts by it or by this device of `sph2d devices`. Scenes that devices do not
# take, or whose whole run takes more than a second, are left out.
set -euo pipefail
if [ "$1" = --one ]; then shift && one=yes; else one=; fi
SPH2D=$(realpath -e "$1") strangers=$(realpath -e "$2") jobs=$4 seeds=$5
mkdir -p "$3"
dir=$(realpath -e "$3")
unset LP_NUM_THREADS
export LC_ALL=C

# ---- the scene -------------------------------------------------------------------------------------------------------

# chance PERCENT, by the generator that the seed has set.
chance() { [ $((RANDOM % 100)) -lt "$1" ]; }
pick() { shift $((RANDOM % $#)) && echo "$1"; }
number() { awk "BEGIN { printf \"%.6g\", $1 }"; }
# between A B: both may be expressions.
between() { number "$1 + ($2 - ($1)) * $RANDOM / 32768"; }
add() { changes+=(-s "$1"); }

# read_scene: sets the corners of its domain, its spacing and its end.
read_scene() {
    local numbers
    numbers=$(sed -n 's/^domain: {min: \[\(.*\), \(.*\)\], max: \[\(.*\), \(.*\)\]}$/\1 \2 \3 \4/p' scene.yaml)
    read -r x0 y0 x1 y1 <<<"$numbers"
    spacing=$(sed -n 's/^spacing: //p' scene.yaml)
    until=$(sed -n 's/^run: {until: \(.*\)}$/\1/p' scene.yaml)
}

# A point that has room for a gauge.
inside() { between "0.8 * $1 + 0.2 * $2" "0.2 * $1 + 0.8 * $2"; }
point() { echo "$(inside "$x0" "$x1"), $(inside "$y0" "$y1")"; }
gauge() {
    awk "BEGIN { a = 0.2 * ($x1 - $x0); b = 0.2 * ($y1 - $y0); c = 3 * $spacing
        printf \"%.6g\", a < b && a < c ? a : b < c ? b : c }"
}

change_method() {
    local step
    if chance 20 && ! grep -q 'fitted\|hybrid' scene.yaml; then
        add "fluid.surface_tension=$(between 0.01 0.1)"
    fi
    if chance 25; then # some of them too long, for a guard
        step=$("$SPH2D" check scene.yaml -j 1 --json 2>>log | sed -n 's/.*"time_step": \([0-9.e+-]*\).*/\1/p')
        [ -z "$step" ] || add "method.time_step=$(number "$step * $(pick 0.5 0.9 2 4)")"
    fi
    if chance 25; then
        add "run.max_energy_rise=$(pick 1e-6 1e-5 1e-4 1e-3)"
    fi
}

change_drives() {
    if chance 30; then
        add "sources=[{at: [$(point)], direction: [$(between -1 1), -1], width: $(number "3 * $spacing"),
            speed: $(number "40 * $spacing / $until"), spread: $(pick 0 0.1), start: $(between 0 "$until / 2")}]"
    fi
    if chance 30; then
        add "drains=[{disc: {center: [$(point)], radius: $(number "4 * $spacing")}}]"
    fi
    if chance 30; then
        add "interactions=[{path: [[0, $(point)], [$until, $(point)]], radius: $(number "8 * $spacing"),
            acceleration: $(between -50 50)}]"
    fi
    if chance 20; then
        add "absorbers=[{side: $(pick left bottom), length: $(number "10 * $spacing"), rate: $(between 1 20)}]"
    fi
}

change_outputs() {
    local walls=
    if ! grep -q 'fitted\|hybrid' scene.yaml; then
        walls=", {name: push, kind: $(pick force work), every: $(number "$until / 30")}"
    fi
    if grep -q 'name: body1' scene.yaml; then
        walls+=", {name: body1, kind: body, on: body1, every: $(number "$until / 30")},
            {name: push1, kind: $(pick force work), on: body1, every: $(number "$until / 30")}"
    fi
    add "probes=[{name: energy, kind: energy, every: $(number "$until / 50")},
        {name: face, kind: pressure, at: [$(point)], size: $(gauge),
         rise_time: $(number "$until / 20"), every: $(number "$until / 30")},
        {name: slow, kind: pressure, at: [$(point)],
         rise_time: $(number "$until / 3"), every: $(number "$until / 20")},
        {name: often, kind: $(pick speed volume extent momentum axes), every: $(number "$until / 100000")},
        {name: seldom, kind: $(pick quality level elevation), every: $(number "$until / 4")}$walls]"
    if chance 85; then
        add "run.snapshots={every: $(number "$until / $(pick 3 8 20 1000)"), compress: $(pick 0 0 4)}"
    fi
    if [ -z "$cannot_draw" ] && chance 20; then
        add "run.frames={every: $(number "$until / 4"), size: [64, 48], style: $(pick points metaballs)}"
    fi
}

# ---- stops -----------------------------------------------------------------------------------------------------------

# session ARGUMENTS...: run or resume by $stop, leaves its exit code in $code.
session() {
    local pid
    echo "--- $stop $delay: sph2d $*" >>log
    code=0
    case $stop in
    steps | wall) "$SPH2D" "$@" -q "${draw[@]}" --max-wall "${delay}s" >>log 2>&1 || code=$? ;;
    until | end) "$SPH2D" "$@" -q "${draw[@]}" >>log 2>&1 || code=$? ;;
    *)
        # A shell switches SIGINT off for what it runs in the background.
        env --default-signal=INT,TERM,HUP "$SPH2D" "$@" -q "${draw[@]}" >>log 2>&1 &
        pid=$!
        sleep "$delay"
        kill -"$stop" $pid 2>/dev/null || true
        { wait $pid || code=$?; } 2>>log # the shell tells of those that are killed
        ;;
    esac
    echo "--- ends with $code, $(find parts -name '*.h5' 2>>log | sort | tr '\n' ' ')" >>log
}

# How the next session stops: $stop, and $delay in the unit that it needs.
choose_stop() {
    stop=$1 delay=0
    case $stop in
    steps) delay=0.000001 ;;
    until)
        if [ -n "$given" ]; then delay=$(number "$until / 2"); else delay=$(between "$reached" "$until"); fi
        reached=$delay
        ;;
    wall | INT | TERM | HUP | KILL) delay=$(between 0.005 "$seconds") ;;
    esac
}

# Starts anew where a stop has left nothing to go on from.
go_on() {
    local to=("${end[@]}") by on
    if [ "$stop" = until ]; then to=(-s "run.until=$delay"); fi
    by=(-j 2)
    if [ -n "${DEVICE-}" ]; then
        on=$(pick cpu "$DEVICE" "$DEVICE")
        by=(-j 2 --device "$on")
        if [ "$on" = cpu ] && [ ! -e parts/checkpoint.h5 ] && [ ! -e parts/snapshot_000000.h5 ]; then by+=(--isa baseline); fi
    fi
    if [ -e parts/checkpoint.h5 ] || [ -e parts/snapshot_000000.h5 ]; then
        session resume parts "${by[@]}" "${to[@]}"
    else
        session run scene.yaml -o parts "${by[@]}" -f "${changes[@]}" "${to[@]}"
    fi
}

is_stop() { case $code in 75 | 129 | 130 | 137 | 143) return 0 ;; *) return 1 ;; esac; }

run_in_parts() {
    local kinds kind
    reached=0 stops=0
    case ${given:+given}$((RANDOM % 5)) in
    given*) kinds=(steps steps until steps) ;;
    0) kinds=(steps steps steps wall) ;;
    1) kinds=(until until steps) ;;
    2) kinds=(KILL "$(pick KILL TERM wall)" "$(pick KILL steps)") ;;
    3) kinds=(wall wall wall wall wall wall wall wall) ;;
    4) kinds=("$(pick INT TERM HUP)" "$(pick INT TERM HUP wall)" "$(pick KILL HUP wall steps)") ;;
    esac
    code=75
    for kind in "${kinds[@]}" end; do
        choose_stop "$kind"
        go_on
        if [ "$stop" = until ]; then
            if [ $code = 0 ]; then code=75; fi
            find parts -name 'snapshot_*.h5' -o -name guard.h5 >>shortened
        fi
        is_stop || return 0
        stops=$((stops + 1))
    done
}

# ---- one seed --------------------------------------------------------------------------------------------------------

# compare: the same files with the same bytes; snapshots of a run with another run.until say so, and must only be there.
compare() {
    local file
    diff <(cd whole && find . | sort) <(cd parts && find . | sort) >difference || return 1
    (cd whole && find . -type f) | while read -r file; do
        grep -qx "parts/${file#./}" shortened || cmp "whole/$file" "parts/$file" >>difference 2>&1 || return 1
    done
}

run_one() {
    local seed=$1 begun whole
    given=
    case $seed in *.yaml) given=$(realpath -e "$seed") && seed=$(basename "$seed" .yaml) ;; esac
    rm -rf "${dir:?}/$seed" && mkdir "$dir/$seed" && cd "$dir/$seed"
    changes=()
    if [ -n "$given" ]; then
        cp "${given%/*}"/*.csv "${given%/*}"/*.svg "$dir/before.h5" .
        cp "$given" scene.yaml
        until=$(sed -n 's/.*\<until: \([0-9.]*\).*/\1/p' scene.yaml)
    else
        RANDOM=$seed
        "$strangers" --seeds "$seed" --print >scene.yaml
        read_scene
    fi
    : >log
    : >shortened
    end=(-s "run.until=$until")
    if [ -z "$given" ] && [ -n "$until" ]; then change_method && change_drives && change_outputs; fi
    printf '%s\n' "${changes[@]}" >changes
    if [ -n "${DEVICE-}" ] && ! "$SPH2D" check scene.yaml -q --device "$DEVICE" "${changes[@]}" >>log 2>&1; then
        echo "refused $seed: $(grep -m 1 error log)" && return
    fi
    begun=$EPOCHREALTIME whole=0
    "$SPH2D" run scene.yaml -o whole -q -j 1 ${DEVICE:+--isa baseline} "${draw[@]}" "${changes[@]}" "${end[@]}" >>log 2>&1 || whole=$?
    seconds=$(number "$EPOCHREALTIME - $begun")
    if [ -n "${DEVICE-}" ]; then
        case $seconds in 0.*) seconds=$(number "20 * $seconds") ;; *) echo "refused $seed: long" && return ;; esac # pocl is slow
    fi
    case $whole in
    0 | 1) ;;
    65 | 66) echo "${given:+FAIL }refused $seed: $(grep -m 1 error log)" && return ;;
    *) echo "FAIL $seed: a whole run ends with $whole" && return ;;
    esac
    run_in_parts
    if [ "$code" != $whole ]; then
        echo "FAIL $seed: a whole run ends with $whole, one in parts with $code; $dir/$seed/log"
    elif ! compare; then
        echo "FAIL $seed: $(head -n 1 difference); $dir/$seed/log"
    else
        echo "ok $seed: ends with $whole after $stops stops"
        rm -rf whole parts
    fi
}

if "$SPH2D" --version | grep -q '^rendering *none'; then cannot_draw=yes draw=(--no-frames); else cannot_draw='' draw=(); fi
if [ -n "$one" ]; then
    run_one "$seeds"
    exit
fi

# prepare FOLDER: the snapshot that its scenes start with; and are all keys used?
prepare() {
    local file scenes=()
    "$SPH2D" run "$1/before.yaml" -o "$dir/before" -f -q
    cp "$dir/before/snapshot_000000.h5" "$dir/before.h5"
    rm -rf "$dir/scenes" && cp -r "$1" "$dir/scenes" && cp "$dir/before.h5" "$dir/scenes"
    for file in "$dir"/scenes/*.yaml; do scenes+=(--scene "$file"); done
    "$strangers" --unused "${scenes[@]}" | sort >"$dir/unused"
    if ! diff <(sed 's/[ \t].*//' "$1/unused_keys" | sort) "$dir/unused" >"$dir/difference"; then
        echo "FAIL: keys that no scene of $1 uses (>), or that $1/unused_keys lists and one uses (<):" >&2
        cat "$dir/difference" >&2
        return 1
    fi
}

if [ -d "$seeds" ]; then
    prepare "$seeds"
    printf '%s\n' "$seeds"/*.yaml
else
    seq "${seeds%..*}" "${seeds#*..}"
fi >"$dir/list"
xargs <"$dir/list" \
    -P "$jobs" -I{} bash "$0" --one "$SPH2D" "$strangers" "$dir" 1 {} >"$dir/results" ||
    { echo 'restarts: a test broke off' >&2 && exit 1; }
grep '^FAIL' "$dir/results" || true
awk '/^ok/ { ++ok; stops += $(NF - 1); guards += $5 == 1 } /^refused/ { ++refused } /^FAIL/ { ++failed }
    END {
        printf "restarts: %d scenes in one run and by %d stops, %d to a guard; %d differ; %d are refused\n",
            ok + failed, stops, guards, failed, refused
        exit failed > 0 || ok == 0
    }' "$dir/results"
