#!/usr/bin/env bash
# What libsph2d takes from other libraries, and what all of them give: symbols.sh LIBRARY.so [OPENMP]
#
# Its threads are those of OpenMP (unless OPENMP is 0): it calls the runtime for its regions and tasks, and no function
# that starts, stops or wakes a thread. It needs no other library. What it and the libraries beside it export is in the list of
# the Debian package, which fails its build otherwise.
set -euo pipefail
library=$1 openmp=${2-1}
wanted=$(nm -D --undefined-only "$library" | sed -n 's/^ *U \([^@]*\).*/\1/p')
fail() { echo "symbols: $library $1" >&2 && exit 1; }

if own=$(grep -E '^(pthread_(create|join|detach|kill|cond_.*|mutex_.*|barrier_.*|spin_.*|setaffinity_np)|thrd_.*|cnd_.*|mtx_.*|sem_.*|clone3?|syscall|sched_setaffinity)$' \
    <<<"$wanted"); then
    fail "has threads of its own: $(tr '\n' ' ' <<<"$own")"
fi
if [ "$openmp" != 0 ]; then
    grep -qxE 'GOMP_parallel|__kmpc_fork_call' <<<"$wanted" || fail 'opens no parallel region of OpenMP'
    grep -qxE 'GOMP_taskloop(_ull)?|__kmpc_taskloop' <<<"$wanted" || fail 'shares no loop by OpenMP'
fi
needed=$(readelf -d "$library" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p')
others=$(grep -Ev "^(lib(c|m|pthread$([ "$openmp" = 0 ] || echo '|gomp|omp'))\.so|ld-linux)" <<<"$needed") ||
    others=
[ -z "$others" ] || fail "needs $others"
list=$(dirname "${BASH_SOURCE[0]}")/../debian/libsph2d0.symbols
for library in "${library%/*}"/libsph2d*.so; do
    name=$(basename "$library") version=$(basename "$(realpath "$library")" | sed 's/.*\.so\.//')
    diff <(sed -n "/^$name/,/^lib/s/^ \(.*@[A-Z0-9_]*\) .*/\1/p" "$list" | LC_ALL=C sort) \
        <(nm -D --defined-only "$library" | sed -n 's/^[0-9a-f]* [A-Z] //; s/@@/@/; s/^SPH2D_0$/&@&/; p' | LC_ALL=C sort) ||
        fail "exports other symbols (>) than $list has (<): each is a line ' symbol@SPH2D_0 $version'"
done
echo "symbols: ok"
