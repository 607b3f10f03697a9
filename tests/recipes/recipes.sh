#!/bin/sh
# Runs the recipes of docs/recipes.md as they stand there, one line each: recipes.sh [--all] COMMAND PYTHONS FOLDER
#
# PYTHONS are interpreters, of which each recipe takes the first that has its modules. What is not installed is left out
# with a word; with --all that is a failure.
set -eu
all=
[ "$1" != --all ] || { all=1 && shift; }
SPH2D=$(realpath "$1") pythons=$2 folder=$3
page=$(realpath "$(dirname "$0")/../../docs/recipes.md")
export SPH2D LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 MPLBACKEND=agg
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder"
failed=0

# section HEADING: its lines. block HEADING KIND [N]: the Nth fenced block of a kind in it. commands HEADING: its lines of
# a shell, by the command that is tested.
section() { awk -v heading="## $1" '/^## /{on = $0 == heading} on' "$page"; }
block() {
    section "$1" | awk -v kind="^\`\`\`$2\$" -v wanted="${3:-1}" \
        '/^```$/{on = 0} on && n == wanted; $0 ~ kind{on = 1; n++}'
}
commands() { section "$1" | sed -n 's/^    //p' | sed "s|build/sph2d|\"\$SPH2D\"|g"; }

bad() { # NAME WHY: it fails, with what it printed
    echo "FAIL recipes/$1: $2"
    sed 's/^/     | /' printed
    failed=$((failed + 1))
}
skip() { # NAME WHY
    [ -z "$all" ] || failed=$((failed + 1))
    echo "skip recipes/$1 ($2)"
}
# checked NAME PATTERN: the recipe has run, and what it printed has a line like that.
checked() {
    if grep -qE -- "$2" printed; then echo "ok   recipes/$1"; else bad "$1" "prints nothing like '$2'"; fi
}
# with MODULES: sets `python` to the first that has them, or fails.
with() {
    for python in $pythons; do
        for module in "$@"; do
            "$python" -c "import $module" 2>/dev/null || continue 2
        done
        return 0
    done
    return 1
}
# program NAME HEADING MODULES HINT PATTERN [N]: runs a program of the page.
program() {
    # shellcheck disable=SC2086 # modules are words
    with $3 || { skip "$1" "no Python with $3: $4" && return 0; }
    block "$2" python "${6:-1}" >program.py
    [ -s program.py ] || { : >printed && bad "$1" "the page has no program in '$2'" && return 0; }
    if timeout 300 "$python" program.py >printed 2>&1; then checked "$1" "$5"; else bad "$1" 'ends with an error'; fi
}

block 'The run' yaml >scene.yaml
commands 'The run' >commands.sh
"$SPH2D" --version | grep -q '^rendering *none' && sed -i 's/$/ --no-frames/' commands.sh
sh -e commands.sh >printed 2>&1 || { bad run 'ends with an error' && exit 1; }
"$SPH2D" info out >about
liquid=$(sed -n 's/^particles *\([0-9]*\) in the liquid.*/\1/p' about)
walls=$(sed -n 's/^particles .* \([0-9]*\) in walls.*/\1/p' about)

program vtk 'ParaView and VTK' vtkmodules 'pip install vtk' \
    "^$liquid particles, $walls boundary particles, 1 wall, 2 solids and bodies; the raft is at 1\.[5-9][0-9]* m\$"

[ $failed = 0 ] || { echo "$failed of the recipes failed" >&2 && exit 1; }
