#!/usr/bin/env bash
# What libsph2d takes from other libraries: symbols.sh LIBRARY.so [OPENMP]
#
# Its threads are those of OpenMP (unless OPENMP is 0): it calls the runtime for its regions and tasks, and no function
# that starts, stops or wakes a thread. It needs no other library.
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
echo "symbols: ok"
