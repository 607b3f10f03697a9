#!/bin/sh
# Installs what the goals of make need and this machine lacks: as root, or by passwordless sudo, elsewhere it prints the one
# line that does and ends with 2. packages.sh GOAL...
#
# The Makefile sets CC, PKG_CONFIG, OPENMP, RENDER, PYTHONS, CHROMIUM, BUILD, and PACKAGES and HEADER_PACKAGES, pairs of what
# is looked for and Debian's packages.
asked() { # whether one of these goals is
    for goal; do case " $goals " in *" $goal "*) return 0 ;; esac; done
    return 1
}
has() { command -v "$1" >/dev/null; }
with_module() {
    for p in $PYTHONS; do ! "$p" -c "import $1" 2>/dev/null || return 0; done
    return 1
}
missing_tools() {
    has "$PKG_CONFIG" || echo pkgconf
    echo '#include <stdio.h>' | $CC -E - >/dev/null 2>&1 || echo libc6-dev
    [ "$OPENMP" = 0 ] || echo '#include <omp.h>' | $CC -fopenmp -E - >/dev/null 2>&1 || echo libomp-dev
    ! asked report report-full test test-full test-variants || has gnuplot || echo gnuplot-nox
    ! asked test test-full test-variants || has cmake || echo cmake
    ! asked test test-full test-variants test-sanitize || [ -e /etc/OpenCL/vendors/pocl.icd ] || echo pocl-opencl-icd
    ! asked test test-full test-variants test-sanitize || PATH=$PATH:/sbin ldconfig -p | grep -q 'libOpenCL\.so\.1 ' || echo ocl-icd-libopencl1
    ! asked test test-full test-variants || has hunspell || printf 'hunspell\nhunspell-en-gb\n'
    if asked test test-full test-variants && [ "$RENDER" != 0 ]; then
        has Xvfb || echo xvfb
        has xdotool || echo xdotool
        has ffmpeg || echo ffmpeg
    fi
    ! asked check-lint || for tool in clang-format clang-tidy shellcheck; do has $tool || echo $tool; done
    ! asked test-slurm || [ "$(id -u)" != 0 ] || has sbatch || printf 'slurm-wlm\nmunge\n'
    ! asked test-variants test-ports || tests/ports/ports.sh --needs
    ! asked test-full || tests/ports/ports.sh --needs windows macos
    ! asked web test-web || has emcc || printf '%s\n' emscripten node-acorn xz-utils dpkg-dev ca-certificates
    ! asked test-web || has "${CHROMIUM:-chromium}" || echo chromium
    ! asked test test-full test-variants test-sanitize || for module in numpy h5py; do
        with_module $module || echo python3-$module
    done
    ! asked test test-full test-variants || with_module 'ensurepip, hatchling, numpy' ||
        printf 'python3-%s\n' hatchling numpy venv
    ! asked test test-full test-variants test-sanitize || with_module 'numpy, jsonschema, yaml' || printf 'python3-jsonschema\npython3-yaml\n'
}
# shellcheck disable=SC2153 # the Makefile's
missing_libraries() {
    for pair in $PACKAGES; do
        $PKG_CONFIG --exists "${pair%%=*}" 2>/dev/null || echo "${pair#*=}" | tr + '\n'
    done
    for pair in $HEADER_PACKAGES; do
        echo "#include <${pair%%=*}>" | $CC -E - >/dev/null 2>&1 || echo "${pair#*=}"
    done
}
# Mesa 25.1 dropped OSMesa: where Debian no longer has it, EGL alone will do.
without_osmesa() { ! apt-cache show libosmesa6-dev >/dev/null 2>&1 && $PKG_CONFIG --exists egl 2>/dev/null; }
stop() {
    printf '%s\n' "$1" "    apt install --no-install-recommends $packages" >&2
    exit 2
}

goals=$*
has "${CC%% *}" || {
    echo "sph2d: the compiler \"${CC%% *}\" is not installed" >&2
    exit 2
}
packages=$({ missing_tools && missing_libraries; } | tr '\n' ' ')
[ "$packages" != 'libosmesa6-dev ' ] || ! without_osmesa || packages=
[ -n "$packages" ] || exit 0
if [ "$(id -u)" = 0 ]; then root=; else root='sudo -n'; fi
# Without NumPy the tests of the Python module are left out, without jsonschema and PyYAML those of schemas, without hatchling
# and venv that of its wheel, without h5py and gnuplot those of recipes, without GLFW there is no `play`, without a display no
# test of it, without ffmpeg none of films, without CMake none of its files, without compilers for other machines and systems
# none of these: nobody is stopped for them.
optional='python3-(numpy|h5py|hatchling|venv|jsonschema|yaml)|gnuplot-nox|libglfw3-dev|xvfb|xdotool|ffmpeg|cmake|gcc-.*-linux-gnu|libc6-dev-.*-cross|gcc-mingw-w64-.*|wine64|python3-pip|qemu-user|musl-tools|clang|clang-format|clang-tidy|shellcheck'
needed=$(echo "$packages" | tr ' ' '\n' | grep -vxE "$optional|") || true
if ! has apt-get || ! $root true 2>/dev/null; then
    [ -n "$needed" ] || exit 0
    stop 'sph2d: packages are missing and cannot be installed from here. As root, run:'
fi
echo "Installing the packages that are missing (a minute or two): $packages"
mkdir -p "$BUILD"
{
    $root apt-get -q update
    apt-cache show libosmesa6-dev >/dev/null 2>&1 || packages=$(echo "$packages" | sed 's/libosmesa6-dev//')
    # shellcheck disable=SC2086 # a list
    $root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=120 install --no-install-recommends $packages
} </dev/null >"$BUILD/packages.log" 2>&1 || [ -z "$needed" ] || {
    tail -n 20 "$BUILD/packages.log" >&2
    stop "sph2d: the installation failed ($BUILD/packages.log). As root, run:"
}
