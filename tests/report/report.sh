#!/usr/bin/env bash
# One page with what sph2d reaches and what that takes: report.sh SPH2D FOLDER [OPTION...]
#
# Runs the studies of tests/report/studies, or of the list $STUDIES, with the options given, and writes
# FOLDER/index.html, which opens from disk, FOLDER/cases.md, the same rows as a table for docs/validation.md, and a folder with
# the files of each study. A study that fails is a section that says so. Interrupted, it goes on where it stopped.
# Needs base64 and awk; gnuplot for the plots, and pictures where the build can draw.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
sph2d=$(realpath -e "$1") folder=$2
shift 2
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cd "$root"
page=$folder/.index.html.new
trap 'rm -f "$page" "$folder/.cases.md.new"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

picture() { # NAME SCENE TIME STYLE [FIELD]
    local size='size: [640, 480]' color=${5:+, color: $5}
    [ "$folder/$1/frame.png" -nt "$sph2d" ] && [ "$folder/$1/frame.png" -nt "$2" ] && return
    rm -f "$folder/$1/frame.png"
    "$sph2d" run "$2" -o "$folder/$1/run" --force -q --set "run.until=$3" --set 'run.snapshots={}' \
        --set "run.frames={every: $3, $size, style: $4$color}" || { echo "$1: no picture" >&2 && return; }
    mv "$(find "$folder/$1/run/frames" -name 'frame_*.png' | sort | tail -n 1)" "$folder/$1/frame.png"
    rm -r "$folder/$1/run"
}

embed() { # KIND FILE: the file as a data URI
    printf 'data:%s;base64,' "$1"
    base64 -w 0 "$2"
}

# The part of a study's own page that is about the study, with its plots inside and links to the files beside.
section() { # NAME TIME FOLDER-OF-THE-SCENE
    if [ ! -f "$folder/$1/study.html" ]; then
        printf '<section id="%s"><h2>%s</h2><p class="verdict">This study failed.</p></section>\n' "$1" "$1"
        return
    fi
    sed -n '/^<section>$/,/^<\/section>$/p' "$folder/$1/study.html" | while IFS= read -r line; do
        case $line in
        *'<img src="error_'*)
            local plot=${line#*<img src=\"}
            plot=${plot%%\"*}
            line=${line/href=\"/href=\"$1/}
            printf '%s' "${line%%<img src=*}<img src=\""
            embed image/svg+xml "$folder/$1/$plot"
            printf '%s\n' "${line#*<img src=\""$plot"}"
            ;;
        '<section>') printf '<section id="%s">\n' "$1" ;;
        '</section>')
            if [ -f "$folder/$1/frame.png" ]; then
                printf '<figure><img src="%s" alt="A frame of %s"><figcaption>%s/scene.yaml at t = %s s</figcaption></figure>\n' \
                    "$(embed image/png "$folder/$1/frame.png")" "$1" "$3" "$2"
            fi
            printf '</section>\n'
            ;;
        '<h2>'*) printf '<h2>%s</h2>\n' "$1" ;;
        *) printf '%s\n' "$line" ;;
        esac
    done
}

# Rows for docs/validation.md: case, row, errors by name, their first order, particles, steps, seconds, speed.
rows() { # NAME
    awk -v name="$1" '
        function cells(line, out,    n, quoted, c, i) {
            n = 1; out[1] = ""; quoted = 0
            for (i = 1; i <= length(line); i++) {
                c = substr(line, i, 1)
                if (c == "\"") quoted = !quoted
                else if (c == "," && !quoted) out[++n] = ""
                else out[n] = out[n] c
            }
            return n
        }
        NR == 1 { count = cells($0, head); for (i = 1; i <= count; i++) at[head[i]] = i; next }
        {
            cells($0, row); errors = ""; order = ""
            for (i = at["particle-steps/s"] + 1; i <= count; i++) {
                if (head[i] ~ / error$/ && row[i] != "nan") {
                    label = head[i]; sub(/ error$/, "", label)
                    errors = errors (errors == "" ? "" : "; ") label " " sprintf("%.2g", row[i])
                }
                if (head[i] ~ / order$/ && order == "" && row[i] != "nan") order = sprintf("%.2f", row[i])
            }
            if (row[at["end"]] != "finished") errors = row[at["end"]]
            cpu = row[at["cpu [s]"]]
            printf "| %s | %s | %s | %s | %d | %d | %.2f | %.2g |\n", NR == 2 ? "`" name "`" : "", row[at["name"]],
                errors, order, row[at["particles"]], row[at["steps"]], cpu,
                (cpu > 0 ? row[at["particle-steps"]] / cpu / 1e6 : 0)
        }' "$folder/$1/study.csv"
}

names=() times=() scenes=() failed=0
while read -r study time style; do
    name=${study%/study} name=${name/\/study_/_}
    echo "$name"
    code=0
    "$sph2d" study "examples/$study.yaml" -o "$folder/$name" --progress never "$@" >"$folder/$name.md" \
        2>"$folder/$name.log" || code=$?
    case $code in
    0) ;;
    130 | 143) exit $code ;; # somebody asked to stop
    1) # where no bound is set, as in a sweep of settings, a row that a guard stopped is a row that says so
        ! grep -q 'bound:' "examples/$study.yaml" || { failed=$((failed + 1)) && tail -n 5 "$folder/$name.log" >&2; }
        ;;
    *) failed=$((failed + 1)) && tail -n 5 "$folder/$name.log" >&2 ;;
    esac
    # shellcheck disable=SC2086 # style and field are two words
    [ "$time" = - ] || [ ! -d "$folder/$name" ] || picture "$name" "examples/${study%/*}/scene.yaml" "$time" $style
    names+=("$name") times+=("$time") scenes+=("examples/${study%/*}")
done < <(sed '/^#/d' "${STUDIES:-tests/report/studies}")

{
    pages=("$folder"/*/study.html)
    sed -n '1,/<\/head>/p' "${pages[0]}" | sed 's|<title>.*|<title>sph2d: error and time</title>|'
    printf '<body>\n<h1>sph2d: what an error costs</h1>\n'
    printf '<p>%s</p>\n' \
        'Every table comes from the command above it, run in the root of the source; DIR is any new folder. A picture is of
the scene as its file has it, which may be finer than the rows.' \
        'CPU s are of stepping alone; beside other work they can double. Front: no other row has a smaller error in
less time. Errors are parts of one unless the heading says otherwise; "-" has no value. c0 is the speed of sound, dx the
spacing, H a support radius or the depth, t* a time times sqrt(g/H); L1 is a mean error, Linf a largest one.'
    sed -n '/^<p class="conditions">/p' "${pages[0]}"
    printf '<p class="conditions">%s</p>\n<ul>\n' "$(date -u '+%F %R UTC')"
    for name in "${names[@]}"; do printf '<li><a href="#%s">%s</a></li>\n' "$name" "$name"; done
    printf '</ul>\n'
    for i in "${!names[@]}"; do section "${names[i]}" "${times[i]}" "${scenes[i]}"; done
    printf '</body>\n</html>\n'
} >"$page"
mv "$page" "$folder/index.html"

{
    echo '| case | row | errors | order | particles | steps | CPU s | million particle-steps per CPU second |'
    echo '|---|---|---|--:|--:|--:|--:|--:|'
    for name in "${names[@]}"; do
        [ "$name" = taylor_green_settings ] || [ ! -f "$folder/$name/study.csv" ] || rows "$name"
    done
} >"$folder/.cases.md.new"
mv "$folder/.cases.md.new" "$folder/cases.md"
echo "$folder/index.html"
[ $failed = 0 ] || { echo "studies that failed or missed a bound: $failed" >&2 && exit 1; }
