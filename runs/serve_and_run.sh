#!/usr/bin/env bash
# Serves a model on this machine for as long as a suite is run with it.
#
#   runs/serve_and_run.sh NAME FOLDER
#   OUT=elsewhere SUITE=v1 ARMS=direct runs/serve_and_run.sh NAME FOLDER
#   ARMS=text-only RUN="--graphs short" SERVE="--cpu-bfloat16" runs/serve_and_run.sh NAME FOLDER
#   SERVERS=8 WORKERS=2 runs/serve_and_run.sh NAME FOLDER     # 8 servers, 2 processes ask each
#
# FOLDER has the model; the runs go to $OUT/runs/NAME-ARM. A server replies to one request at a time,
# or to a few (SERVE="--at-once 4"), so a machine with many cores, or a GPU, should have several: at
# ports from $PORT on. What each has answered stays in $OUT/shards.
set -euo pipefail
cd "$(dirname "$0")/.."

name=$1 folder=$2
OUT=${OUT:-outputs/served}
SUITE=${SUITE:-demo}
ARMS=${ARMS:-agentic direct}
WORKERS=${WORKERS:-2}
SERVERS=${SERVERS:-1}
PORT=${PORT:-8001}
SERVE=${SERVE:-}                        # more options of probe serve-model
RUN=${RUN:-}                            # and of probe run
probe=${PROBE:-.venv/bin/probe}

ports=$(seq "$PORT" $((PORT + SERVERS - 1)))
servers=() runs=()
. runs/common.sh
for port in $ports; do check_port "$port"; done

# Whether the server at a port has the model.
serves() {
    { printf 'GET /v1/models HTTP/1.0\r\n\r\n' >&3; grep -q "\"id\":\"$name\"" <&3; } \
        2>/dev/null 3<> "/dev/tcp/127.0.0.1/$1"
}

ask() { # ARM PORT OUT, and more options
    $probe run "$SUITE" --model "$name" --endpoint "http://127.0.0.1:$2/v1" --setting "$1" \
        --points 0-1000 --epochs 1 --workers "$WORKERS" $RUN --out "$3" "${@:4}"
}

threads=$(($(nproc) / SERVERS))
for port in $ports; do
    # Servers that all want all cores wait for each other.
    OMP_NUM_THREADS=${OMP_NUM_THREADS:-$((threads > 0 ? threads : 1))} \
        $probe serve-model "$folder" --name "$name" --port "$port" $SERVE &
    servers+=($!)
done
trap 'kill "${servers[@]}" "${runs[@]}" 2>/dev/null || true' EXIT
for i in "${!servers[@]}"; do
    until serves $((PORT + i)); do
        kill -0 "${servers[i]}" || exit 1
        sleep 0.5
    done
    kill -0 "${servers[i]}" || exit 1
done
for arm in $ARMS; do
    out=$OUT/runs/$name-$arm
    # What each number of servers has played is of its own.
    for other in "$OUT/shards/$name-$arm"-of-*; do
        if [ -d "$other" ] && [ "$other" != "$OUT/shards/$name-$arm-of-$SERVERS" ]; then
            echo "$other was begun with another number of servers: set SERVERS to that, or remove it." >&2
            exit 1
        fi
    done
    if [ "$SERVERS" = 1 ]; then
        ask "$arm" "$PORT" "$out"
        continue
    fi
    runs=() shards=$OUT/shards/$name-$arm-of-$SERVERS
    if [ -d "$out" ] && [ ! -d "$shards" ]; then
        echo "$out was begun with another number of servers: set SERVERS to that, or remove it." >&2
        exit 1
    fi
    for i in "${!servers[@]}"; do
        ask "$arm" $((PORT + i)) "$shards/$i" --shard "$i/$SERVERS" &
        runs+=($!)
    done
    for run in "${runs[@]}"; do wait "$run"; done
    if [ ! -d "$out" ]; then
        rm -rf "$OUT/shards/.merging"
        $probe merge "$shards"/* --out "$OUT/shards/.merging"
        mkdir -p "$OUT/runs"
        mv "$OUT/shards/.merging" "$out"  # whole or not at all
    fi
done
kill "${servers[@]}"
wait "${servers[@]}" || true
trap - EXIT
