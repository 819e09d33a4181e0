#!/bin/sh
# SPDX-License-Identifier: MIT
# scripts/fuzz.sh N TARGET: runs one fuzzer N times. Keeps inputs that reach new code for the next run, and
# those that fail in build/fuzz/findings.
set -eu
kept=build/fuzz/kept/$2
log=build/fuzz/findings/$2.log
mkdir -p "$kept" build/fuzz/findings
begin=$(date +%s)
if POLYDEC_ENGINES='' "build/dev/tests/fuzz/fuzz_$2" -runs="$1" -max_len=2048 -timeout=10 -rss_limit_mb=1024 \
    -malloc_limit_mb=256 -artifact_prefix="build/fuzz/findings/$2-" \
    "$kept" "tests/fuzz/corpus/$2" >"$log" 2>&1; then
    echo "$2: passed, $(($(date +%s) - begin)) s"
else
    tail -n 30 "$log"
    echo "$2: FAILED"
    exit 1
fi
