#!/usr/bin/env bash
# The source archive and the Debian packages that are made of it, each in a fresh bookworm: package.sh ARCHIVE FOLDER
#
# The archive has the same bytes when a clone makes it. In a root with nothing but what debian/control asks for the
# packages are built by an ordinary user, and lintian finds nothing; in another one they are installed by apt, and the
# command, its pages and completions, and programs that use the libraries work; in the end nothing of them is left.
# FOLDER/base, which debootstrap makes, is kept from time to time. Needs root; MIRROR=http://deb.debian.org/debian.
# `package.sh --needs` says in a sentence what is missing.
set -euo pipefail
MIRROR=${MIRROR:-http://deb.debian.org/debian}

needs() {
    local lacks=''
    if [ "$(id -u)" != 0 ]; then
        lacks='root, for roots of other systems'
    elif ! unshare --mount --pid --fork true 2>/dev/null; then
        lacks='the right to make name spaces (CAP_SYS_ADMIN)'
    fi
    for tool in debootstrap git xz; do
        command -v $tool >/dev/null || lacks=${lacks:-"$tool (Debian: debootstrap git xz-utils)"}
    done
    [ -z "$lacks" ] || { echo "test-package: this needs $lacks" >&2 && exit 2; }
}
needs
[ "$1" != --needs ] || exit 0

tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
archive=$(realpath -e "$1")
mkdir -p "$2" && cd "$2"
name=$(basename "$archive" .tar.xz)
version=${name#sph2d-}

fail() {
    echo "test-package: $*" >&2
    exit 1
}

# quietly LOG COMMAND...: its last lines only if it fails.
quietly() {
    local log=$1
    shift
    "$@" >"$log" 2>&1 </dev/null || { tail -n 30 "$log" >&2 && fail "see $PWD/$log"; }
}

# inside ROOT COMMAND...: in a root, with /proc and /dev of its own, which end with the command.
inside() {
    # shellcheck disable=SC2016 # the inner shell expands it
    unshare --mount --pid --fork --kill-child sh -c '
        mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" &&
        exec chroot "$0" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
            DEBIAN_FRONTEND=noninteractive http_proxy="$http_proxy" https_proxy="$https_proxy" "$@"' "$@"
}
export http_proxy=${http_proxy-} https_proxy=${https_proxy-}
install_in() { # ROOT LOG PACKAGE...
    local root=$1 log=$2
    shift 2
    quietly "$log" inside "$root" apt-get -q -y -o Acquire::Retries=3 --no-install-recommends install "$@"
}
fresh() { # ROOT
    rm -rf "$1" && cp -a base "$1"
}

# ---- the archive -----------------------------------------------------------------------------------------------------
[ "$(cd "$tree" && sed -n '1s/.*(\(.*\)).*/\1/p' debian/changelog)" = "$version" ] ||
    fail "debian/changelog has another version than $name"
rm -rf clone && git clone -q --no-hardlinks "$tree" clone
(cd clone && umask 077 && MAKEFLAGS='' make -s DEPS=skip dist >/dev/null)
cmp "clone/build/$name.tar.xz" "$archive" || fail 'the archive of a clone has other bytes'
rm -rf clone
echo "archive: ok, $(sha256sum <"$archive" | cut -c 1-16)"

# ---- the packages ----------------------------------------------------------------------------------------------------
if [ ! -d base ]; then
    rm -rf base.new
    quietly debootstrap.log debootstrap --variant=minbase bookworm "$PWD/base.new" "$MIRROR"
    mv base.new base
fi
fresh builder
quietly update.log inside builder apt-get -q update
install_in builder tools.log dpkg-dev build-essential
inside builder useradd -m builder
tar xf "$archive" -C builder/home/builder
quietly needed.log inside builder sh -c "cd /home/builder/$name &&
    apt-get -q -y -o Acquire::Retries=3 --no-install-recommends build-dep ./ && chown -R builder: /home/builder"
as_builder() {
    inside builder su builder -c "cd /home/builder/$name && $1"
}
quietly build.log as_builder "dpkg-buildpackage -us -uc -b -j$(nproc)"
! grep -n 'warning: ' build.log || fail 'the compiler warns'
grep -q '^ok   cli/run ' build.log || fail 'the smoke test did not run'
quietly nocheck.log as_builder 'rm debian/debhelper-build-stamp && DEB_BUILD_OPTIONS=nocheck debian/rules build'
! grep 'cli/run' nocheck.log || fail 'nocheck does not keep the tests from running'
for file in builder/home/builder/"$name"/debian/{libsph2d0/usr/lib/*/*.so.*.*.*,sph2d/usr/bin/sph2d}; do
    inside builder readelf -SW "/${file#builder/}" >sections
    grep -q ' \.dynsym ' sections || fail "no sections in $file"
    ! grep -q ' \.\(symtab\|debug_info\) ' sections || fail "$file is not stripped"
done
echo "packages: ok, $(cd builder/home/builder && du -ch ./*sph2d*"_$version"_*.deb | tail -n 1 | cut -f 1)"

install_in builder lintian.log lintian
quietly lintian.txt as_builder "lintian --fail-on error,warning ../sph2d_${version}_*.changes"
! grep '^[EW]:' lintian.txt || fail 'lintian'
echo 'lintian: ok'

# ---- their use -------------------------------------------------------------------------------------------------------
fresh user
mkdir user/packages && cp builder/home/builder/*"_$version"_*.deb user/packages
package() { # NAME: its file in the root
    local file
    for file in user/packages/"$1"_*.deb; do echo "${file#user}"; done
}
inside user useradd -m user
as_user() {
    quietly use.log inside user su user -c "cd && set -e; $1"
}
page() { # SECTION NAME TEXT
    as_user "MANPAGER=cat MANWIDTH=200 man $1 $2 | grep -q '$3'"
}
quietly update.log inside user apt-get -q update
install_in user install.log "$(package sph2d)" "$(package libsph2d0)" man-db

inside user ldd /usr/bin/sph2d >libraries
for library in sph2d sph2d-io sph2d-study sph2d-contacts sph2d-render; do
    grep -q "lib$library.so.0 => /.*/lib$library.so.0" libraries || fail "the command does not use lib$library"
done
as_user 'sph2d init tank -q --template drop && sph2d check tank/scene.yaml -q
    sph2d run tank/scene.yaml -o out -q --set run.until=0.1 && test -s out/frames/frame_000003.png
    sph2d run - -o piped -q --no-frames --set run.until=0.1 <tank/scene.yaml
    cmp out/snapshot_000006.h5 piped/snapshot_000006.h5
    sph2d resume out -q --set run.until=0.15 && sph2d info out | grep -q "^state  *finished"
    sph2d render out/snapshot_000001.h5 -o drawn -q --style points --color speed
    sph2d run /usr/share/doc/sph2d/examples/sprinkler/scene.yaml -o example -q --no-frames --set run.until=0.05'
# shellcheck disable=SC2016 # the inner shell expands it
as_user 'code=0; sph2d play tank/scene.yaml 2>said || code=$?
    test $code = 69 && grep -q "no window can be opened" said' # there is no display
page 1 sph2d 'simulate liquids in two dimensions' && page 5 sph2d-scene 'dynamic_viscosity'
! inside user man -w 3 libsph2d 2>/dev/null || fail 'the page of the libraries is in the wrong package'
echo 'command: ok'

install_in user shells.log bash-completion zsh python3
cp "$tree/tests/cli/terminal.py" "$tree/tests/package/complete.py" user/home/user
as_user 'touch scene.yaml && python3 complete.py'
echo 'completions: ok'

install_in user python.log "$(package python3-sph2d)"
as_user 'python3 /usr/share/doc/sph2d/examples/embed.py && python3 -c "import sph2d; sph2d.Renderer(64, 64)"'
echo 'python: ok'

install_in user dev.log "$(package libsph2d-dev)" gcc libc6-dev pkgconf
page 3 libsph2d 'libsph2d-study'
# shellcheck disable=SC2016 # the inner shell expands it
as_user 'pkg-config --exists --print-errors "sph2d = '"$version"'" sph2d-io sph2d-study sph2d-contacts sph2d-render
    for program in embed engine; do
        source=/usr/share/doc/sph2d/examples/$program.c
        used=$(sed -n "s/^#include <sph2d.\(io\|contacts\|render\)\.h>.*/sph2d-\1/p" $source)
        gcc -o $program $source $(pkg-config --cflags --libs ${used:-sph2d}) && ./$program && ldd $program | grep -q libsph2d
        gcc -o $program $source $(pkg-config --static --cflags --libs ${used:-sph2d} |
            sed "s/-l\(sph2d[a-z-]*\)/-l:lib\1.a/g") && ./$program
        if ldd $program | grep libsph2d; then exit 1; fi
    done'
echo 'programs: ok'
install_in user cmake.log cmake make
as_user './embed >expected && cmake -S /usr/share/doc/sph2d/examples/cmake -B out && cmake --build out && out/embed | cmp - expected
    ldd out/embed | grep -q libsph2d'
echo 'cmake: ok'

quietly purge.log inside user apt-get -q -y purge sph2d libsph2d0 libsph2d-dev python3-sph2d
left=$(cd user && find . -name '*sph2d*' ! -path './packages/*' ! -path './home/*')
[ -z "$left" ] || fail "purge leaves $left"
rm -rf builder user
echo 'test-package: ok'
