#!/usr/bin/env bash
# From a teacher's episodes to a small language model that was pretrained, top to bottom, in the
# setting text-only: collect, select, dataset, train, serve, evaluate, where it fails. Weights come
# from the package index (SmolLM2-135M-Instruct, 98 MB). Each step goes on where it was stopped: run
# it again, with the same settings.
#
#   runs/student.sh                     # everything into outputs/student, at a small setting
#   OUT=elsewhere SUITE=v1 SELECT="--slack 3 --least 1" \
#       DATASET="--no-find --plain --balance --augment mirrored wordings options names ids colours sizes fewer refused" \
#       TRAIN="--learning-rate 4e-4 --global-batch 1 --steps 1400 --warmup 0.04 --no-save-memory --save-every 100" \
#       SERVERS=2 WORKERS=8 SERVE="--cpu-bfloat16 --most-tokens 400 --at-once 8" runs/student.sh  # hours
#   TEACHER= COUNTS="--total 40" runs/student.sh              # nothing is taken over
#   SERVERS=8 runs/student.sh           # on many cores or a GPU: see runs/serve_and_run.sh
#
# It starts from episodes that are here (runs/data/README.md), and collects what is lacking of COUNTS.
set -euo pipefail
cd "$(dirname "$0")/.."

OUT=${OUT:-outputs/student}
SUITE=${SUITE:-demo}                    # what models are evaluated on
WORKERS=${WORKERS:-2}
PORT=${PORT:-8001}
TEACHER=${TEACHER-runs/data/teacher.tar.xz runs/data/reduce.tar.xz}
COUNTS=${COUNTS:---counts.count 6 --counts.find 6 --counts.size 4 --counts.reduce 2 --counts.compare 4}
SELECT=${SELECT:---slack 3 --least 1 --no-near --counts count 6 find 6 size 4 reduce 2 compare 4}
DATASET=${DATASET:---no-find}           # more options of probe dataset
TRAIN=${TRAIN:---learning-rate 3e-4 --global-batch 2 --epochs 1 --warmup 0.1 --no-save-memory}
SERVE=${SERVE:---cpu-bfloat16 --most-tokens 400 --at-once 2}
BASE=${BASE:-}                          # a folder to start from; by default SmolLM2's
HELD_OUT=${HELD_OUT:-}                  # types without examples, if COUNTS has others than usual
probe=${PROBE:-.venv/bin/probe}
[ -n "${PROBE:-}" ] || make --silent driver .venv/.torch .venv/.student

. runs/common.sh
check_port "$PORT"
same_settings "$OUT" "SUITE=$SUITE" "TEACHER=$TEACHER" "COUNTS=$COUNTS" "SELECT=$SELECT" \
    "DATASET=$DATASET" "TRAIN=$TRAIN" "SERVE=$SERVE" "BASE=$BASE"

step "collect: the scripted teacher answers training tasks, with tools alone"
if [ -n "$TEACHER" ] && [ ! -d "$OUT/collected" ]; then
    mkdir -p "$OUT/.teacher"
    for archive in $TEACHER; do tar xf "$archive" -C "$OUT/.teacher"; done
    mv "$OUT/.teacher/collected" "$OUT/collected"  # whole or not at all
    rmdir "$OUT/.teacher"
fi
$probe collect --out "$OUT/collected" --settings agentic $COUNTS --counts.beneath 0 \
    --points 0-1000 --workers "$WORKERS"

step "select: what was right and efficient, and of no evaluation"
[ -e "$OUT/selected/selection.json" ] ||
    $probe select "$OUT/collected" --out "$OUT/selected" --direct-share 0 $SELECT

step "dataset: conversations without pictures, lists in short"
[ -e "$OUT/data/manifest.json" ] ||
    $probe dataset "$OUT/selected" "$OUT/data" --setting text-only --graphs short --no-others $DATASET

step "train: a pretrained language model"
if [ -z "$BASE" ]; then
    BASE=$OUT/base
    [ -d "$BASE" ] || $probe unpack-model "$BASE"
fi
$probe train "$OUT/data" --model "$BASE" --out "$OUT/trained" --cpu-bfloat16 $TRAIN

step "question-only learns from the same tasks"
[ -e "$OUT/question_only.json" ] ||
    $probe suite learn "$OUT"/collected/batches/*/suite.json --out "$OUT/question_only.json"

step "serve and evaluate: as it was and as it is now, the teacher beside them"
export SUITE WORKERS PORT OUT SERVE PROBE="$probe" ARMS=text-only RUN="--graphs short"
runs/serve_and_run.sh base "$BASE"
runs/serve_and_run.sh student "$OUT/trained/model"
$probe run "$SUITE" --agent scripted --out "$OUT/runs/scripted" --workers "$WORKERS"

step "at which step of using the tools each fails"
$probe ladder "$OUT"/runs/* --out "$OUT/ladder.md"

step "in one table, what nobody learnt apart"
$probe held-out "$OUT"/runs/* ${HELD_OUT:+--types $HELD_OUT} --learnt "$OUT/question_only.json" \
    --out "$OUT/table.md"
