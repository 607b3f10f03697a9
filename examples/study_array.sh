#!/bin/bash
# A study as an array job of Slurm, one shard a task:
#
#     sbatch --array=1-8 examples/study_array.sh study.yaml out 8
#
# The folder, here `out`, must be on a file system that all nodes share. Options of `sph2d study` may follow the number of
# shards, such as --all, or --isa avx2 where nodes differ. The task that finds all rows writes the table into its log and
# the folder. Tasks that were killed are submitted again, with the same number of shards; what they had done stays:
#
#     sbatch --array=3,7 examples/study_array.sh study.yaml out 8
#
#SBATCH --job-name=study
#SBATCH --output=study_%A_%a.log
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --time=04:00:00
set -eu
: "${3:?usage: sbatch --array=1-SHARDS study_array.sh STUDY FOLDER SHARDS [OPTION...]}"
# In place of the shell, so that the signal at the limit of time comes to it.
exec "${SPH2D:-sph2d}" study "$1" -o "$2" --shard "$SLURM_ARRAY_TASK_ID/$3" \
    --threads "${SLURM_CPUS_PER_TASK:-1}" --progress never "${@:4}"
