#!/usr/bin/env bash
# From a teacher's episodes to a smaller model, top to bottom, at toy size and without a download:
# collect, select, dataset, train, serve, evaluate. What it trains is a proof that all parts fit
# together, no useful model. Each step goes on where it was stopped: run it again.
#
#   runs/distill.sh                     # everything into outputs/distill
#   OUT=elsewhere SUITE=v1 runs/distill.sh
set -euo pipefail
cd "$(dirname "$0")/.."

OUT=${OUT:-outputs/distill}
SUITE=${SUITE:-demo}                    # what models are evaluated on
ARMS=${ARMS:-agentic direct}
WORKERS=${WORKERS:-2}
PORT=${PORT:-8001}
COUNTS=${COUNTS:---counts.count 4 --counts.find 4 --counts.size 2 --counts.reduce 1 --counts.compare 1}
SELECT=${SELECT:---slack 3}
TINY=${TINY:---width 96 --layers 2 --heads 2}  # how small: probe init-tiny --help
TRAIN=${TRAIN:---learning-rate 2e-3 --global-batch 2 --epochs 2 --no-save-memory --loaders 1}
probe=${PROBE:-.venv/bin/probe}
[ -n "${PROBE:-}" ] || make --silent driver .venv/.torch

. runs/common.sh
check_port "$PORT"
same_settings "$OUT" "SUITE=$SUITE" "ARMS=$ARMS" "COUNTS=$COUNTS" "SELECT=$SELECT" "TINY=$TINY" \
    "TRAIN=$TRAIN"

step "collect: the scripted teacher answers training tasks"
$probe collect --out "$OUT/collected" $COUNTS --counts.beneath 0 --points 0-1000 --workers "$WORKERS"

step "select: what was right and efficient, and of no evaluation"
[ -e "$OUT/selected/selection.json" ] ||
    $probe select "$OUT/collected" --out "$OUT/selected" $SELECT

step "dataset: conversations and pictures"
[ -e "$OUT/data/manifest.json" ] ||
    $probe dataset "$OUT/selected" "$OUT/data" --side 256 --no-others --workers "$WORKERS"

step "train: a very small model, from nothing"
[ -d "$OUT/untrained" ] || $probe init-tiny "$OUT/data" "$OUT/untrained" $TINY
$probe train "$OUT/data" --model "$OUT/untrained" --out "$OUT/trained" $TRAIN

step "question-only learns from the same tasks"
[ -e "$OUT/question_only.json" ] ||
    $probe suite learn "$OUT"/collected/batches/*/suite.json --out "$OUT/question_only.json"

step "serve and evaluate: untrained and trained, the teacher beside them"
export SUITE ARMS WORKERS PORT OUT PROBE="$probe"
runs/serve_and_run.sh untrained "$OUT/untrained"
runs/serve_and_run.sh trained "$OUT/trained/model"
$probe run "$SUITE" --agent scripted --out "$OUT/runs/scripted" --workers "$WORKERS"

step "in one table, what nobody learnt apart"
$probe held-out "$OUT"/runs/* --types beneath --learnt "$OUT/question_only.json" \
    --out "$OUT/table.md"
