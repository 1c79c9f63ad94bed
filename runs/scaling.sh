#!/usr/bin/env bash
# What more examples and augmented ones bring, after runs/student.sh. Trains one student, from the
# untrained model, for each number in EXAMPLES, with one update an example, and evaluates each on tasks
# for validation. The examples are drawn from episodes told in many ways, those of rare types in more of
# them; for each number in UNAUGMENTED from the same episodes told once, as they went, which are read
# several times if there are fewer. The tasks have objects of the pool for training, as episodes have,
# and seeds of their own, in the same light, so nothing is chosen here by a suite. It goes on where it
# was stopped: run it again, with the same settings. EXAMPLES and UNAUGMENTED may grow.
#
#   runs/student.sh && SERVERS=2 WORKERS=8 runs/scaling.sh   # into outputs/scaling
#   EXAMPLES="75 150" UNAUGMENTED= STUDENT=outputs/teacher OUT=there runs/scaling.sh
#
# On two cores with bfloat16 an example takes some 7 s, the default five and a half hours, and each
# evaluation some 20 minutes. Tables: ladder.md and table.md.
set -euo pipefail
cd "$(dirname "$0")/.."

STUDENT=${STUDENT:-outputs/student}     # has collected/
OUT=${OUT:-outputs/scaling}
EXAMPLES=${EXAMPLES-75 150 300 600 1200}
UNAUGMENTED=${UNAUGMENTED-600}
VALIDATION=${VALIDATION:---lighting ambient --looks 1 --counts.count 16 --counts.find 16 --counts.size 12 --counts.compare 7 --counts.reduce 6}
SELECT=${SELECT:---slack 3 --least 1 --no-near}  # more options of probe select
DATASET=${DATASET:---no-find --plain}   # and of probe dataset
AUGMENT=${AUGMENT:---balance --augment mirrored wordings options names ids colours sizes fewer refused}
TUNE=${TUNE:---learning-rate 4e-4 --warmup 0.04 --save-every 100 --no-save-memory}
SERVE=${SERVE:---cpu-bfloat16 --most-tokens 400 --at-once 8}
BASE=${BASE:-}                          # a folder to start from; by default SmolLM2's
WORKERS=${WORKERS:-2}
PORT=${PORT:-8001}
probe=${PROBE:-.venv/bin/probe}
[ -n "${PROBE:-}" ] || make --silent driver .venv/.torch .venv/.student

if [ ! -d "$STUDENT/collected/batches" ]; then
    echo "$STUDENT has no collected/: run runs/student.sh first, or set STUDENT." >&2
    exit 1
fi
. runs/common.sh
check_port "$PORT"
# From more episodes others would be drawn.
collected=$(cat "$STUDENT"/collected/batches/*/grades.json | sha256sum | cut -c 1-16)
same_settings "$OUT" "STUDENT=$STUDENT" "COLLECTED=$collected" "VALIDATION=$VALIDATION" \
    "SELECT=$SELECT" "DATASET=$DATASET" "AUGMENT=$AUGMENT" "TUNE=$TUNE" "SERVE=$SERVE" "BASE=$BASE"

export SUITE=$OUT/validation.json WORKERS PORT OUT SERVE PROBE="$probe" ARMS=text-only RUN="--graphs short"
step "validation: tasks that no episode is of"
if [ ! -e "$SUITE" ]; then
    $probe suite build "$SUITE" --public --first 2900000 --unchecked --pool train --workers "$WORKERS" \
        $VALIDATION || [ -e "$SUITE" ]  # some may lack; tables say how many there are
fi
if [ -z "$BASE" ]; then
    BASE=$OUT/base
    [ -d "$BASE" ] || $probe unpack-model "$BASE"
fi

step "select, and what is told of it once and in many ways"
[ -e "$OUT/selected/selection.json" ] ||
    $probe select "$STUDENT/collected" --out "$OUT/selected" --direct-share 0 --against "$SUITE" $SELECT
for way in augmented unaugmented; do
    [ "$way" = augmented ] && augment=$AUGMENT || augment=""
    [ -e "$OUT/$way/manifest.json" ] ||
        $probe dataset "$OUT/selected" "$OUT/$way" --setting text-only --graphs short --no-others \
            $DATASET $augment
done

point() { # WAY EXAMPLES
    local name=$1-$2
    step "$name: training, evaluation"
    $probe train "$OUT/$1" --model "$BASE" --out "$OUT/trained/$name" --cpu-bfloat16 \
        --global-batch 1 --steps "$2" $TUNE
    runs/serve_and_run.sh "$name" "$OUT/trained/$name/model"
}
for examples in $EXAMPLES; do point augmented "$examples"; done
for examples in $UNAUGMENTED; do point unaugmented "$examples"; done

step "what they are compared with: the model as it was, and the teacher"
runs/serve_and_run.sh base "$BASE"
$probe run "$SUITE" --agent scripted --out "$OUT/runs/scripted" --workers "$WORKERS"

step "at which step of using the tools each fails, and what is right"
$probe ladder "$OUT"/runs/* --out "$OUT/ladder.md"
$probe held-out "$OUT"/runs/* --out "$OUT/table.md"
