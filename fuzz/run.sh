#!/usr/bin/env bash
# Builds a libFuzzer target without cargo-fuzz and runs it: fuzz/run.sh cdt -max_total_time=60
# Stable Rust and a C++ compiler are enough. What it finds is a file of bytes, crash-*, that the same command replays.
set -euo pipefail
cd "$(dirname "$0")"
target=$1
shift
export RUSTFLAGS="--cfg fuzzing -Clink-dead-code -Ccodegen-units=1 -Cpasses=sancov-module \
-Cllvm-args=-sanitizer-coverage-level=4 -Cllvm-args=-sanitizer-coverage-inline-8bit-counters \
-Cllvm-args=-sanitizer-coverage-pc-table -Cllvm-args=-sanitizer-coverage-trace-compares"
host=$(rustc -vV | sed -n 's/^host: //p')
# With --target, build scripts and macros are not instrumented.
cargo build --release --target "$host" --bin "$target"
mkdir -p "corpus/$target"
exec "target/$host/release/$target" -max_len=512 -len_control=0 "$@" "corpus/$target"
