#!/bin/sh
# Follows docs/tutorial.md as it stands there, in an empty folder: tutorial.sh COMMAND PYTHON FOLDER MAKE
#
# A block of ``` says what it is: a file's language and name, `+` before it to be added to that file; `sh` for commands,
# with what they need behind it: a program, or `installed`, for which sph2d is installed into FOLDER/prefix.
set -eu
bin=$(dirname "$(realpath "$1")") python=$2 folder=$3 make=$4
root=$(realpath "$(dirname "$0")/../..")
rm -rf "$folder" && mkdir -p "$folder/here" && folder=$(realpath "$folder")
PATH=$bin:$PATH PYTHONDONTWRITEBYTECODE=1
export PATH PYTHONDONTWRITEBYTECODE LC_ALL=C.UTF-8
awk -v to="$folder" '
    /^```$/ && on { on = 0; close(file); next }
    on { print >(file); next }
    /^```./ { on = 1; file = sprintf("%s/%02d", to, ++n); print substr($0, 4) >(to "/kinds") }
' "$root/docs/tutorial.md"

install() { # once
    [ ! -e "$folder/prefix" ] || return 0
    "$make" -s -C "$root" DEPS=skip prefix="$folder/prefix" pythondir="$folder/prefix/python" install
    export PKG_CONFIG_PATH="$folder/prefix/lib/pkgconfig" LD_LIBRARY_PATH="$folder/prefix/lib" \
        PYTHONPATH="$folder/prefix/python"
}

cd "$folder/here"
number=0
while read -r kind name; do
    number=$((number + 1))
    block=$folder/$(printf %02d $number)
    what="block $number ($kind $name)"
    case $kind:$name in
    sh: | sh:installed) ;;
    sh:*)
        command -v "$name" >/dev/null || { echo "tutorial: $what is left out, without $name" && continue; }
        ;;
    python:*) [ -n "$python" ] || { echo "tutorial: $what is left out, without NumPy" && continue; } ;;
    esac
    [ "$name" != installed ] || install
    case $kind:$name in
    sh:*) set -- sh -e "$block" ;;
    python:installed) set -- "$python" "$block" ;;
    *:+*) cat "${name#+}" "$block" >"$folder/both" && set -- cp "$folder/both" "${name#+}" ;;
    *) set -- cp "$block" "$name" ;;
    esac
    "$@" >"$folder/printed" 2>&1 </dev/null || { sed 's/^/     | /' "$folder/printed" && echo "FAIL tutorial: $what" && exit 1; }
    [ "$name" != installed ] || cat "$folder/printed" >>"$folder/said"
done <"$folder/kinds"

for file in first.png pictures/frame_000045.png third/leaf.csv study/study.csv; do
    [ -s "$file" ] || { echo "FAIL tutorial: there is no $file; there are $(find . -type f | tr '\n' ' ')" && exit 1; }
done
# C and Python say the same.
[ "$(sort -u "$folder/said" | wc -l)" = 1 ] ||
    { cat "$folder/said" && echo 'FAIL tutorial: the two programs do not agree' && exit 1; }
echo "tutorial: all $number blocks do what the page says"
