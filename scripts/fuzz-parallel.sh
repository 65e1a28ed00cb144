#!/usr/bin/env bash
# The same campaign with GNU parallel, on this machine or over ssh: scripts/fuzz-parallel.sh cdt 1000000 1 runs 8 [options of parallel]
# for target, cases of all shards together, seed, folder, and number of shards. Afterwards: delone fuzz cdt --merge runs
set -euo pipefail
target=$1 cases=$2 seed=$3 folder=$4 shards=$5
shift 5
seq 0 $((shards - 1)) | parallel "$@" \
    "${DELONE:-delone}" fuzz "$target" --cases "$cases" --seed "$seed" --state "$folder" --quiet --shard "{}/$shards" "||" test '$?' = 1
