#!/usr/bin/env bash
# A study of 32 rows as an array job of a real Slurm: slurm.sh SPH2D FOLDER
#
# Starts munged, slurmctld and slurmd for one node, this machine, which need neither systemd nor control groups, with
# keys, ports and state of their own, and ends them. Eight shards run, four at a time; one is killed in its second row,
# or on a busy machine a later one, and submitted again. The table must be that of one process, byte for byte, but for
# times. FOLDER keeps the results and the logs. Without Slurm it says so and ends with 0.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
SPH2D=$(realpath -e "$1")
rm -rf "$2" && mkdir -p "$2"
folder=$(cd "$2" && pwd)
cd "$folder"
PATH=$PATH:/usr/sbin:/sbin
unset OMP_NUM_THREADS LP_NUM_THREADS
export SPH2D LC_ALL=C
for tool in munged slurmctld slurmd sbatch; do
    command -v $tool >/dev/null || { echo "test-slurm: skipped, as there is no $tool (Debian: slurm-wlm, munge)" && exit 0; }
done

# ---- one node of Slurm -----------------------------------------------------------------------------------------------
own=$(mktemp -d /tmp/sph2d-slurm.XXXXXX) # short: a socket's name has 107 bytes at most
node=$(hostname -s) port=$((20000 + $$ % 20000)) user=$(id -un) daemons=()
chmod 755 "$own" && mkdir "$own/state" "$own/spool"
(umask 077 && head -c 1024 /dev/urandom >"$own/key")
cat >"$own/slurm.conf" <<END
ClusterName=sph2d
SlurmctldHost=$node(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$own/munge.socket
CredType=cred/munge
StateSaveLocation=$own/state
SlurmdSpoolDir=$own/spool
SlurmctldPidFile=$own/slurmctld.pid
SlurmdPidFile=$own/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
MpiDefault=none
SwitchType=switch/none
MailProg=/bin/true
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
NodeName=$node NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=main Nodes=$node Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$own/slurm.conf

# The last one started ends first: jobs, slurmd, slurmctld, munged.
end_slurm() {
    local i
    [ ${#daemons[@]} -lt 2 ] || scancel --user="$user" 2>/dev/null || true
    for ((i = ${#daemons[@]} - 1; i >= 0; --i)); do
        kill "${daemons[i]}" 2>/dev/null || true
        wait "${daemons[i]}" 2>/dev/null || true
    done
    rm -rf "$own"
}
trap end_slurm EXIT
fail() {
    printf 'test-slurm: %s; logs are in %s\n' "$*" "$folder" >&2
    tail -n 5 ./*.log >&2
    exit 1
}
# until_true SECONDS COMMAND...
until_true() {
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.1
    done
}
is_idle() { [ "$(sinfo --noheader --format=%T 2>/dev/null)" = idle ]; }

munged --foreground --key-file="$own/key" --socket="$own/munge.socket" --pid-file="$own/munged.pid" \
    --log-file="$own/munged.log" --seed-file="$own/seed" >munged.log 2>&1 &
daemons+=($!)
until_true 20 test -S "$own/munge.socket" || { cat "$own/munged.log" >>munged.log && fail 'munged does not start'; }
slurmctld -D -i >slurmctld.log 2>&1 &
daemons+=($!)
slurmd -D -N "$node" >slurmd.log 2>&1 &
daemons+=($!)
until_true 60 is_idle || fail 'the node does not become idle'

# ---- the study -------------------------------------------------------------------------------------------------------
cp "$root/tests/cli/tiny.scene" scene.yaml
cat >study.yaml <<END
scene: scene.yaml
vary: {spacing: [0.04, 0.034, 0.03, 0.028, 0.026, 0.024, 0.022, 0.02], fluid.dynamic_viscosity: [10, 11, 12, 13]}
measures:
  - {name: top, probe: energy, column: kinetic, take: max, scale: 1000, expect: 0.3, order: true}
  - {name: curve, probe: energy, column: potential, finest: true, norm: mean, relative: true, order: true}
  - {name: middle, probe: corner, column: speed, take: value, at: 1, finest: true}
END
options=(-s run.until=2)
now() { date +%s.%N; }
submit() { sbatch --parsable "$@" "$root/examples/study_array.sh" study.yaml many 8 "${options[@]}"; }
since() { awk "BEGIN { printf \"%.1f\", $(now) - $1 }"; }

begun=$(now)
"$SPH2D" study study.yaml -o one --threads 1 --progress never "${options[@]}" >one.txt 2>one.log || fail 'one process fails'
alone=$(since "$begun")

begun=$(now)
job=$(submit --array=1-8)
until_true 120 grep -qs '^sph2d: row 11 of 32' "study_${job}_3.log" || fail 'shard 3 has no second row'
scancel --signal=KILL --full "${job}_3"
no_jobs() { [ -z "$(squeue --noheader)" ]; }
until_true 300 no_jobs || fail 'the array does not end'
first=$(since "$begun")
[ ! -e many/study.csv ] || fail 'there is a table without the rows of shard 3'
grep -q 'no table yet: rows .*27 of shard 3 are missing$' "study_${job}_"*.log || fail 'no task says what is missing'

begun=$(now)
again=$(submit --array=3 --wait) || fail 'shard 3 fails when it is submitted again'
second=$(since "$begun")
grep -Eq '^sph2d: (1 row was|[23] rows were) there already' "study_${again}_3.log" || fail 'shard 3 runs again what it had done'
grep -q '^| spacing=0.02, dynamic_viscosity=13 ' "study_${again}_3.log" || fail 'shard 3 prints no table'

# ---- the same as one process -----------------------------------------------------------------------------------------
for results in one many; do awk -f "$root/tests/cli/without_times.awk" $results/study.csv >$results.csv; done
cmp one.csv many.csv || fail 'the table is another'
[ "$(wc -l <many.csv)" = 33 ] || fail 'the table has not 32 rows'
series=0
for file in one/series_*.csv; do
    cmp "$file" "many/${file#one/}" || fail 'a series is another'
    series=$((series + 1))
done
[ "$(find many -maxdepth 1 -name 'series_*' | wc -l)" = $series ] || fail 'there are other series'
[ -z "$(find many -name '.*')" ] || fail 'temporary files are left'
"$SPH2D" study study.yaml -o many --progress never "${options[@]}" >plain.txt 2>plain.log || fail 'a plain call fails'
! grep -q '^sph2d: row ' plain.log || fail 'a plain call runs rows again'
printf '%s\n' "slurm: $(slurmd -V | cut -d ' ' -f 2), 32 rows in 8 tasks, 4 at a time: $first s with one killed, $second s for it again;" \
    "slurm: one process: $alone s; the same table and $series series, byte for byte, but for times"
