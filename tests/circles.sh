#!/usr/bin/env bash
# Do files use each other in circles? circles.sh OBJECT...
#
# A file comes before those whose functions or tables it uses, and of all of them there must be such an order. The objects
# of a file for several instruction sets are one.
set -euo pipefail
nm -A -g "$@" | awk '
    { file = $1; sub(/\.o:.*/, "", file); sub(/.*\/obj\/[0-9]*\//, "", file); sub(/\.(baseline|avx2|avx512)$/, "", file) }
    $(NF - 1) == "U" { uses[file " " $NF]; next }
    { of[$NF] = file }
    END { for (use in uses) { split(use, at, " "); if (of[at[2]] && of[at[2]] != at[1]) print at[1], of[at[2]] } }
' | sort -u | tsort >/dev/null || { echo 'circles: these files use each other' >&2 && exit 1; }
echo 'circles: ok'
