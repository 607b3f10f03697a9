#!/usr/bin/env bash
# Do CMake's files find the libraries? cmake.sh FOLDER MAKE BUILD CC
#
# What is built in BUILD is installed; examples/embed.c is compiled by pkg-config there, and by examples/cmake after the
# installation has moved to another place: by shared and by static libraries it prints the same. So for a program that uses
# all libraries. Other versions and unknown components are refused with a sentence.
set -euo pipefail
if ! command -v cmake >/dev/null; then
    echo 'skip cmake (apt install cmake)'
    exit 0
fi
folder=$(realpath -m "$1") make=$2 build=$3 CC=$4
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
export CC
fail() { echo "cmake: $*" >&2 && exit 1; }
quietly() { "$@" >"$folder/log" 2>&1 || { tail -n 30 "$folder/log" >&2 && fail "$* fails"; }; }

rm -rf "$folder" && mkdir -p "$folder"
quietly "$make" -C "$source" BUILD="$build" DEPS=skip prefix="$folder/first" install
export PKG_CONFIG_PATH="$folder/first/lib/pkgconfig"
# shellcheck disable=SC2046,SC2086 # the compiler may have flags
quietly $CC "$source/examples/embed.c" -o "$folder/embed" $(pkg-config --cflags --libs sph2d)
expected=$(LD_LIBRARY_PATH="$folder/first/lib" "$folder/embed")
parts='io;contacts;study'
[ ! -e "$folder/first/lib/libsph2d-render.a" ] || parts+=';render'
unset PKG_CONFIG_PATH
mv "$folder/first" "$folder/moved here"

configure() { # SOURCE OPTION...: in FOLDER/out
    rm -rf "$folder/out"
    cmake -S "$source/$1" -B "$folder/out" -DCMAKE_PREFIX_PATH="$folder/moved here" "${@:2}"
}
for static in OFF ON; do
    for program in examples/cmake/embed tests/cmake/parts; do
        quietly configure "${program%/*}" -Dsph2d_STATIC=$static -DPARTS="$parts"
        quietly cmake --build "$folder/out"
        printed=$("$folder/out/${program##*/}") || fail "$program fails"
        ldd "$folder/out/${program##*/}" >"$folder/libraries"
        case $program in
        *embed) [ "$printed" = "$expected" ] || fail "by CMake it prints '$printed', by pkg-config '$expected'" ;;
        esac
        case $static-$(grep -c "$folder/moved here/.*libsph2d" "$folder/libraries" || true) in
        OFF-0 | ON-[1-9]) fail "sph2d_STATIC=$static is not heard: $program needs $(cat "$folder/libraries")" ;;
        esac
    done
done

refused() { # TEXT OPTION...
    ! configure tests/cmake "${@:2}" >"$folder/log" 2>&1 || fail "it is not refused: ${*:2}"
    tr -s '\n ' ' ' <"$folder/log" | grep -qF "$1" || fail "no '$1' in $folder/log"
}
version=$(sed -n 's/^#define SPH2D_VERSION "\(.*\)"/\1/p' "$source/include/sph2d/version.h")
for asked in "${version%.*}" "$version;EXACT" "${version%.*}...99"; do
    quietly configure tests/cmake -DVERSION="$asked" -DPARTS="$parts"
done
for asked in 99 "0.0.1" "99;EXACT" "0.0.1...<$version" 98...99; do
    refused "$version" -DVERSION="$asked"
done
refused 'no component sound: there are io, contacts, study and render' -DPARTS=sound
rm "$folder/moved here/lib/libsph2d-contacts".*
refused 'no component study: it uses contacts: it is not installed in' -DPARTS='io;study'
echo "cmake: ok, $expected"
