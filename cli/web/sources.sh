#!/bin/sh
# sources.sh FOLDER: the sources of libfyaml and Chipmunk, of the versions that Debian's packages have here, unpacked into
# FOLDER/libfyaml and FOLDER/chipmunk. The signed lists of the system's own archives say what is right; the system's
# settings stay as they are.
set -eu
mkdir -p "$1"
folder=$(cd "$1" && pwd)
work=$folder/work
rm -rf "$work"
mkdir -p "$work/lists/partial" "$work/sources.d"
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
    test -f "$list" || continue
    sed -E 's/^deb[[:space:]]/deb-src /; s/^(Types:[[:space:]]*).*$/\1deb-src/' "$list" >"$work/sources.d/${list##*/}"
done
apt() {
    apt-get -q -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/sources.d" \
        -o Dir::State::Lists="$work/lists" "$@"
}
apt update >"$work/log" 2>&1 || : # archives without sources are no reason to stop: what is missing is told below
for package in libfyaml chipmunk; do
    mkdir "$work/$package"
    (cd "$work/$package" && apt source "$package") >>"$work/log" 2>&1 || {
        tail -n 3 "$work/log" >&2
        echo "sources.sh: the source of $package cannot be fetched by apt" >&2
        exit 1
    }
    rm -rf "${folder:?}/$package"
    mv "$work/$package"/*/ "$folder/$package"
done
rm -rf "$work"
