#!/usr/bin/env bash
# Does the core work where it is portable C? ports.sh CORE_SCENES FOLDER MAKE [PORT...]; ports.sh --needs
#
# For each port the core and its tests are built without packages, statically, and run: three scenes by all methods, which
# must end like those of CORE_SCENES, this machine's own, and the suites of the core, by a stand-in for Check. Where their
# bits are the same it says so; nobody promises that. What is not installed is skipped with a word; --needs prints the
# Debian packages that are missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
ports=(aarch64 i686 musl O0)

# All suites take half an hour of an emulated processor, or without optimisation: there it is these.
QUICK=(kernels smoothing store cells periodic scene_keys scene_check methods plan basin fields report state outlines sample
    muller wcsph fitted shared memory)
export OMP_WAIT_POLICY=passive CK_TIMEOUT_MULTIPLIER=20

# describe PORT: its compiler, with flags, what runs its programs, settings of the build, and its packages.
describe() {
    emulator='' settings=(LDFLAGS=-static) suites=()
    case $1 in
    aarch64)
        compiler=aarch64-linux-gnu-gcc emulator=qemu-aarch64 suites=("${QUICK[@]}")
        packages='gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user'
        ;;
    i686) # gcc-multilib and cross compilers cannot be installed side by side
        compiler=i686-linux-gnu-gcc packages='gcc-i686-linux-gnu libc6-dev-i386-cross'
        ! links gcc -m32 -static || { compiler='gcc -m32 -msse2 -mfpmath=sse' && settings+=(X86=); }
        ;;
    musl) compiler=musl-gcc packages=musl-tools settings+=(OPENMP=0) ;;
    O0) compiler=clang packages=clang settings=(CFLAGS=-O0 X86= OPENMP=0) suites=("${QUICK[@]}") ;;
    *) echo "ports: no port '$1'; there are ${ports[*]}" >&2 && exit 2 ;;
    esac
}

links() {
    local out
    out=$(mktemp) && printf '#include <stdio.h>\nint main(void) { return puts("") < 0; }\n' | "$@" -x c - -o "$out" 2>/dev/null &&
        { [ -z "${emulator-}" ] || "$emulator" "$out" >/dev/null 2>&1; } && rm "$out"
}

# shellcheck disable=SC2086 # the compiler may have flags
is_here() { links $compiler "${settings[0]#*=}"; }

if [ "$1" = --needs ]; then
    [ "$(dpkg --print-architecture 2>/dev/null)" = amd64 ] || exit 0
    for port in "${ports[@]}"; do
        describe "$port"
        # shellcheck disable=SC2086 # a list
        is_here || { [ "${compiler%-gcc}" != "$compiler" ] && dpkg -s gcc-multilib >/dev/null 2>&1; } ||
            printf '%s\n' $packages
    done
    exit
fi
here=$(realpath -e "$1") folder=$2 make=$3
shift 3
[ $# != 0 ] || set -- "${ports[@]}"
mkdir -p "$folder"
"$here" >"$folder/here"

# Energies are apart by at most a millionth of their sum, compressions by a millionth of 1 %.
compare() {
    awk -v name="$1" '
        NR == FNR { ++lines; for (k = 3; k <= NF; ++k) here[$1, $2, k] = $k; next }
        { ++seen; same += $NF == here[$1, $2, NF]
          wrong += $3 != "OK" || $4 != here[$1, $2, 4]
          energy = here[$1, $2, 5] + here[$1, $2, 6]
          for (k = 5; k < NF; ++k) {
              apart = ($k - here[$1, $2, k]) / (k < 7 ? energy : 0.01); apart = apart < 0 ? -apart : apart
              if (!(apart <= most)) { most = apart; where = $1 " by " $2 }
          } }
        END { printf "%s: %d of %d scenes have the same bits as here", name, same, lines
              print (most > 0 ? sprintf("; the others are apart by %.1g at most, %s", most, where) : "")
              exit wrong || seen != lines || !(most <= 1e-6) }' "$folder/here" "$folder/$1/here"
}

judge() {
    # The emulator may be none.
    $emulator "$folder/$1/tests/core_scenes" >"$folder/$1/here" && compare "$1" || failed=1
    $emulator "$folder/$1/tests/check_core" "${suites[@]}" >"$folder/$1/suites" 2>"$folder/$1/faults" ||
        { cat "$folder/$1/faults" && failed=1; }
    echo "$1: $(cat "$folder/$1/suites")"
}

failed=0
for port; do
    describe "$port"
    is_here || { echo "$port: skipped, as $compiler${emulator:+ or $emulator} is missing (Debian: $packages)" && continue; }
    if ! "$make" BUILD="$folder/$port" CC="$compiler" DEPS=skip RENDER=0 "${settings[@]}" \
        "$folder/$port/tests/check_core" "$folder/$port/tests/core_scenes" >"$folder/$port.log" 2>&1; then
        tail -n 20 "$folder/$port.log"
        echo "$port: the build fails, see $folder/$port.log" && failed=1
    elif grep 'warning:.*\[-W' "$folder/$port.log"; then # not the linker's, of libgomp's plugins
        echo "$port: the build warns" && failed=1
    else
        judge "$port"
    fi
done
exit $failed
