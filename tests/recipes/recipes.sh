#!/bin/sh
# Runs the recipes of docs/recipes.md as they stand there, one line each: recipes.sh [--all] COMMAND PYTHONS FOLDER
#
# PYTHONS are interpreters, of which each recipe takes the first that has its modules. What is not installed is left out
# with a word; with --all that is a failure.
set -eu
all=
[ "$1" != --all ] || { all=1 && shift; }
SPH2D=$(realpath "$1") pythons='' folder=$3
for python in $2; do
    case $python in */*) python=$(realpath -s "$python") ;; esac
    pythons="$pythons $python"
done
page=$(realpath "$(dirname "$0")/../../docs/recipes.md")
limit=$(realpath "$(dirname "$0")/../limit.sh")
export SPH2D LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 MPLBACKEND=agg
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder"
failed=0

# section HEADING: its lines. block HEADING KIND: the first fenced block of a kind in it. commands HEADING: its lines of
# a shell, by the command that is tested.
section() { awk -v heading="## $1" '/^## /{on = $0 == heading} on' "$page"; }
block() {
    section "$1" | awk -v kind="^\`\`\`$2\$" '/^```$/ { on = 0 } on && n == 1; $0 ~ kind { on = 1; ++n }'
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
# with MODULES: sets `python` to the first that has them, or fails. vtk>=9.3 is VTK from that version on.
with() {
    for python in $pythons; do
        for module in "$@"; do
            case $module in
            'vtk>='*)
                "$python" -c "from vtkmodules.vtkCommonCore import vtkVersion as v
assert (v.GetVTKMajorVersion(), v.GetVTKMinorVersion()) >= tuple(map(int, '${module#*=}'.split('.')))" 2>/dev/null
                ;;
            *) "$python" -c "import $module" 2>/dev/null ;;
            esac || continue 2
        done
        return 0
    done
    return 1
}
is_whole() { # FILE
    case $1 in
    *.png) tail -c 8 "$1" | od -An -tx1 | grep -q '49 45 4e 44 ae 42 60 82' ;;
    *.svg) grep -q '</svg>' "$1" ;;
    *.csv) [ "$(wc -l <"$1")" = $((liquid + 1)) ] ;;
    *) [ -s "$1" ] ;;
    esac
}
# program NAME HEADING MODULES HINT PATTERN: runs a program of the page.
program() {
    # shellcheck disable=SC2086 # modules are words
    with $3 || { skip "$1" "no Python with $3: $4" && return 0; }
    block "$2" python >program.py
    [ -s program.py ] || { : >printed && bad "$1" "the page has no program in '$2'" && return 0; }
    "$limit" 300 "$python" program.py >printed 2>&1 || { bad "$1" 'ends with an error' && return 0; }
    echo >>printed
    checked "$1" "$5"
}

block 'The run' yaml >scene.yaml
commands 'The run' >commands.sh
"$SPH2D" --version | grep -q '^rendering *none' && sed -i 's/$/ --no-frames/' commands.sh
sh -e commands.sh >printed 2>&1 || { bad run 'ends with an error' && exit 1; }
"$SPH2D" info out >about
liquid=$(sed -n 's/^particles *\([0-9]*\) in the liquid.*/\1/p' about)
walls=$(sed -n 's/^particles .* \([0-9]*\) in walls.*/\1/p' about)

program h5py 'Snapshots with h5py' h5py 'apt install python3-h5py' \
    '^1\.00[0-9] s: front at (1\.9[0-9]*|2\.0[0-9]*) m, largest pressure [1-9][0-9]{3,4} Pa$'
program pandas 'Time series with pandas' pandas 'apt install python3-pandas' \
    '^of 1570 J/m [1-9][0-9]{2} are left$'
program matplotlib 'Pictures with Matplotlib' 'h5py matplotlib' 'apt install python3-matplotlib python3-h5py' '^$'
if with h5py matplotlib && ! is_whole picture.png; then bad matplotlib 'picture.png is not whole'; fi
program swiftsimio swiftsimio swiftsimio 'pip install swiftsimio' \
    "^$liquid particles, at most [1-9][0-9.]* kPa .*after 1000\.[0-9]* ms\$"
program vtk 'ParaView and VTK' 'vtk>=9.3' 'pip install vtk' \
    "^$liquid particles, $walls boundary particles, 1 wall, 2 solids and bodies; the raft is at 1\.[5-9][0-9]* m\$"

commands 'Older ParaView and VTK, VisIt' >commands.sh
sh -e commands.sh >printed 2>&1 || bad export 'ends with an error'
program vtp 'Older ParaView and VTK, VisIt' vtkmodules 'apt install python3-vtk9' \
    "^$liquid particles after 1\.00 s, at most [1-9][0-9]{3,4} Pa, 2 solids and bodies\$"

# files NAME FILE...: the commands of commands.sh run, and these files come out, whole.
files() {
    name=$1
    shift
    sh -e commands.sh >printed 2>&1 || { bad "$name" 'ends with an error' && return 0; }
    for file in "$@"; do
        is_whole "$file" || { bad "$name" "$file is not whole" && return 0; }
    done
    echo "ok   recipes/$name"
}
commands Plots | grep '^"' >commands.sh
commands Plots | grep '^gnuplot' >>commands.sh
if command -v gnuplot >/dev/null; then
    files plots out/plot.svg raft.png particles.csv gauge.svg
else
    skip plots 'no gnuplot: apt install gnuplot-nox'
fi
if [ ! -d out/frames ]; then
    skip 'pictures and film' 'this build draws no frames'
else
    commands 'Pictures for slides and papers' >commands.sh
    files pictures slide/frame_000000.png paper/frame_000000.png flow/frame_000010.png eddies/frame_000010.png
    # The animations in the README come last, from other scenes.
    commands 'A film' | sed '/ffmpeg/{s/$/ -loglevel error/;q}' >commands.sh
    if command -v ffmpeg >/dev/null; then
        files film film.mp4 film.gif speed.mp4 png/frame_000010.png frames.mp4
    else
        skip film 'no ffmpeg: apt install ffmpeg'
    fi
fi

[ $failed = 0 ] || { echo "$failed of the recipes failed" >&2 && exit 1; }
