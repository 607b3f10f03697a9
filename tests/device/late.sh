#!/usr/bin/env bash
# Runs a command on devices that are far behind: nothing is done before the host waits for it. late.sh FAULTY OUT COMMAND...
#
# FAULTY is a libOpenCL.so.1 made of tests/device/faulty.c, which lies in OUT under that name.
set -euo pipefail
faulty=$(realpath -e "$1") out=$(realpath -m "$2")
rm -rf "$out" && mkdir -p "$out"
ln -s "$faulty" "$out/libOpenCL.so.1"
FAULTY_REAL=$(ldconfig -p | awk '/libOpenCL\.so\.1 / && !n++ { print $NF }')
export FAULTY_REAL FAULTY_LATE=1 LD_LIBRARY_PATH=$out
exec "${@:3}"
