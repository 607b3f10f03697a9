#!/usr/bin/env bash
# Does the core work where it is portable C? ports.sh CORE_SCENES FOLDER MAKE [PORT...]; ports.sh --needs [PORT...]
#
# For each port the core and its tests are built without packages, statically, and run: three scenes by all methods, which
# must end like those of CORE_SCENES, this machine's own, examples/embed.c, which must print the same line, and the suites of
# the core, by a stand-in for Check. Where their bits are the same it says so; nobody promises that. Windows has no fork()
# for the suites: there the scenes run by its best instruction set, too. What is for macOS is compiled and linked. What is not
# installed is skipped with a word; --needs prints the Debian packages that are missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
ports=(aarch64 i686 musl O0 windows macos macos-x86_64)
ZIG=ziglang==0.13.0 # of PyPI: Debian has no compiler for macOS

# All suites take half an hour of an emulated processor, or without optimisation: there it is these.
QUICK=(kernels smoothing store cells periodic scene_keys scene_check methods plan basin fields report state outlines sample
    muller variational fitted shared memory)
export OMP_WAIT_POLICY=passive CK_TIMEOUT_MULTIPLIER=20
export WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='

# describe PORT: its compiler, with flags, what runs its programs, settings of the build, and its packages.
describe() {
    emulator='' exe='' settings=(LDFLAGS=-static) suites=() programs=(check_core core_scenes embed) within=1e-6
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
    O0) compiler=clang packages=clang settings=(CFLAGS='-O0 -Wno-psabi' X86= OPENMP=0) suites=("${QUICK[@]}") ;;
    windows) # its hypot() rounds otherwise: such a one here moves a scene by 1.4e-5 where the solver stops an iteration later
        compiler=x86_64-w64-mingw32-gcc-posix packages='gcc-mingw-w64-x86-64-posix wine64' programs=(core_scenes embed) exe=.exe
        emulator=$(command -v wine64 || echo /usr/lib/wine/wine64) within=1e-4
        settings+=(AR=x86_64-w64-mingw32-ar CFLAGS=-Wno-float-conversion) # its isnan() has a branch for floats
        ;;
    macos*) # without OpenMP and, by zig, what tells instruction sets
        compiler="$zig cc -target aarch64-macos" packages="python3-pip, and $ZIG of PyPI" programs=(core_scenes embed)
        settings=(CFLAGS='-Wno-unused-command-line-argument -Wno-psabi' "AR=$zig ar" X86= OPENMP=0)
        [ "$1" = macos ] || compiler="$zig cc -target x86_64-macos"
        ;;
    *) echo "ports: no port '$1'; there are ${ports[*]}" >&2 && exit 2 ;;
    esac
}

links() {
    local out
    out=$(mktemp -d) && printf '#include <stdio.h>\nint main(void) { return puts("") < 0; }\n' | "$@" -x c - -o "$out/a.exe" 2>/dev/null &&
        { [ -z "${emulator-}" ] || "$emulator" "$out/a.exe" >/dev/null 2>&1; } && rm -r "$out"
}

# Gets the compiler for macOS, once.
get_zig() {
    [ -e "$folder/zig/whole" ] || {
        rm -rf "$folder/zig"
        python3 -m pip install -q --no-deps --target "$folder/zig" $ZIG >"$folder/zig.log" 2>&1 && : >"$folder/zig/whole"
    }
}

# shellcheck disable=SC2086 # the compiler may have flags
is_here() { links $compiler ${settings[0]#*=}; }

zig=zig
if [ "$1" = --needs ]; then
    [ "$(dpkg --print-architecture 2>/dev/null)" = amd64 ] || exit 0
    shift
    [ $# != 0 ] || set -- "${ports[@]}"
    for port; do
        describe "$port"
        case $port in macos*)
            python3 -m pip --version >/dev/null 2>&1 || echo python3-pip
            continue
            ;;
        esac
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
folder=$(realpath "$folder") zig=$folder/zig/ziglang/zig
export WINEPREFIX="$folder/wine" ZIG_GLOBAL_CACHE_DIR="$folder/zig-cache" ZIG_LOCAL_CACHE_DIR="$folder/zig-cache"
"$here" >"$folder/here"
"$here" auto >"$folder/here-auto"
line=$("${here%/*}/embed")

# Energies are apart by at most `within` of their sum, a millionth, compressions by that of 1 %.
compare() { # PORT FILE
    awk -v name="$1${2#here}" -v within="$within" '
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
              exit wrong || seen != lines || !(most <= within) }' "$folder/$2" "$folder/$1/$2"
}

judge() {
    local printed
    # The emulator may be none.
    run() { $emulator "$folder/$port/tests/$1$exe" "${@:2}" | tr -d '\r'; }
    case $1 in macos*)
        printed=$(od -An -N8 -t x4 "$folder/$1/tests/embed") # what this is, and for which processor
        case $1:$printed in
        macos:*feedfacf*0100000c | macos-x86_64:*feedfacf*01000007) echo "$1: compiled and linked; nothing here runs it" ;;
        *) echo "$1: embed is no program of it:$printed" && failed=1 ;;
        esac
        return
        ;;
    esac
    run core_scenes >"$folder/$1/here" && compare "$1" here || failed=1
    printed=$(run embed) || true
    [ "$printed" = "$line" ] || { echo "$1: embed prints '$printed', here '$line'" && failed=1; }
    if [ "$1" = windows ]; then
        run core_scenes auto >"$folder/$1/here-auto" && compare "$1" here-auto || failed=1
        return
    fi
    run check_core "${suites[@]}" >"$folder/$1/suites" 2>"$folder/$1/faults" ||
        { cat "$folder/$1/faults" && failed=1; }
    echo "$1: $(cat "$folder/$1/suites")"
}

failed=0
for port; do
    describe "$port"
    case $port in macos*)
        get_zig || { echo "$port: skipped, as pip cannot get $ZIG here: $(tail -n 1 "$folder/zig.log")" && continue; } ;;
    esac
    is_here || { echo "$port: skipped, as $compiler${emulator:+ or $emulator} is missing (Debian: $packages)" && continue; }
    programs=("${programs[@]/#/$folder/$port/tests/}")
    if ! "$make" -j"$(nproc)" BUILD="$folder/$port" CC="$compiler" DEPS=skip RENDER=0 "${settings[@]}" \
        "${programs[@]/%/$exe}" >"$folder/$port.log" 2>&1; then
        tail -n 20 "$folder/$port.log"
        echo "$port: the build fails, see $folder/$port.log" && failed=1
    elif grep 'warning:.*\[-W' "$folder/$port.log"; then # not the linker's, of libgomp's plugins
        echo "$port: the build warns" && failed=1
    else
        judge "$port"
    fi
done
exit $failed
