#!/usr/bin/env bash
# Serves a model on this machine for as long as a suite is run with it.
#
#   runs/serve_and_run.sh NAME FOLDER
#   OUT=elsewhere SUITE=v1 ARMS=direct runs/serve_and_run.sh NAME FOLDER
#   ARMS=text-only RUN="--graphs short" SERVE="--cpu-bfloat16" runs/serve_and_run.sh NAME FOLDER
#
# FOLDER has the model; the runs go to $OUT/runs/NAME-ARM.
set -euo pipefail
cd "$(dirname "$0")/.."

name=$1 folder=$2
OUT=${OUT:-outputs/served}
SUITE=${SUITE:-demo}
ARMS=${ARMS:-agentic direct}
WORKERS=${WORKERS:-2}
PORT=${PORT:-8001}
SERVE=${SERVE:-}                        # more options of probe serve-model
RUN=${RUN:-}                            # and of probe run
probe=${PROBE:-.venv/bin/probe}

if (: < "/dev/tcp/127.0.0.1/$PORT") 2>/dev/null; then
    echo "Something else listens at port $PORT and would answer for $name: set PORT to a free one." >&2
    exit 1
fi

# Whether the server has the model.
serves() {
    { printf 'GET /v1/models HTTP/1.0\r\n\r\n' >&3; grep -q "\"id\":\"$name\"" <&3; } \
        2>/dev/null 3<> "/dev/tcp/127.0.0.1/$PORT"
}

$probe serve-model "$folder" --name "$name" --port "$PORT" $SERVE &
server=$!
trap 'kill $server 2>/dev/null || true' EXIT
until serves; do
    kill -0 "$server" || exit 1
    sleep 0.5
done
kill -0 "$server" || exit 1
for arm in $ARMS; do
    $probe run "$SUITE" --model "$name" --endpoint "http://127.0.0.1:$PORT/v1" --setting "$arm" \
        --points 0-1000 --epochs 1 --workers "$WORKERS" $RUN \
        --out "$OUT/runs/$name-$arm"
done
kill "$server"
wait "$server" || true
trap - EXIT
