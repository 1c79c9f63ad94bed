#!/usr/bin/env bash
# How a student gets better with more episodes, and what augmented ones bring, after runs/student.sh:
# for each number of episodes two trainings, each evaluated on tasks for validation. One reads the
# episodes alone, six times; the other each of them once in six ways (as it went, mirrored, asked in
# other words, with options under other letters, with other names, with other object_ids), so that both
# make about as many updates. The tasks have objects of the pool for training, as episodes have, and
# seeds of their own, in the same light, so nothing is chosen here by a suite. Each step goes on where
# it was stopped: run it again, with the same settings. SIZES and WAYS may grow.
#
#   runs/student.sh && runs/scaling.sh     # 75 and 150 episodes, into outputs/scaling
#   SIZES="75 150 200" WAYS=augmented STUDENT=outputs/teacher OUT=there runs/scaling.sh
#
# On two cores with bfloat16, a training on 75 episodes takes two hours, and one on twice
# as many twice as long; each evaluation takes some 20 minutes. Tables: ladder.md and table.md.
set -euo pipefail
cd "$(dirname "$0")/.."

STUDENT=${STUDENT:-outputs/student}     # has collected/
OUT=${OUT:-outputs/scaling}
SIZES=${SIZES:-75 150}
WAYS=${WAYS:-plain augmented}
VALIDATION=${VALIDATION:---lighting ambient --looks 1 --counts.count 16 --counts.find 16 --counts.size 12 --counts.compare 7 --counts.reduce 6}
CHOOSE=${CHOOSE:---slack 3 --least 1}   # more options of probe select
DATASET=${DATASET:---no-find}           # and of probe dataset
AUGMENT=${AUGMENT:-mirrored wordings options names ids}
TUNE=${TUNE:---learning-rate 2e-4 --global-batch 1 --warmup 0.1 --save-every 100 --no-save-memory}
SERVE=${SERVE:---cpu-bfloat16 --most-tokens 400 --at-once 2}
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
# With more to choose from, a small choice wouldn't be a part of a large one.
collected=$(cat "$STUDENT"/collected/batches/*/grades.json | sha256sum | cut -c 1-16)
same_settings "$OUT" "STUDENT=$STUDENT" "COLLECTED=$collected" "VALIDATION=$VALIDATION" \
    "CHOOSE=$CHOOSE" "DATASET=$DATASET" "AUGMENT=$AUGMENT" "TUNE=$TUNE" "SERVE=$SERVE" "BASE=$BASE"

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

for size in $SIZES; do
    chosen=$OUT/$size/selected
    step "select: $size episodes"
    [ -e "$chosen/selection.json" ] ||
        $probe select "$STUDENT/collected" --out "$chosen" --direct-share 0 --total "$size" \
            --against "$SUITE" $CHOOSE
    for way in $WAYS; do
        name=$way-$size here=$OUT/$size/$way
        case $way in
            plain) augment="" epochs=$((1 + $(wc -w <<< "$AUGMENT"))) ;;
            augmented) augment="--augment $AUGMENT" epochs=1 ;;
            *) echo "WAYS has plain and augmented, not $way." >&2; exit 1 ;;
        esac
        step "$name: data set, training, evaluation"
        [ -e "$here/data/manifest.json" ] ||
            $probe dataset "$chosen" "$here/data" --setting text-only --graphs short --no-others $DATASET $augment
        $probe train "$here/data" --model "$BASE" --out "$here/trained" --cpu-bfloat16 \
            $TUNE --epochs "$epochs"
        runs/serve_and_run.sh "$name" "$here/trained/model"
    done
done

step "what they are compared with: the model as it was, and the teacher"
runs/serve_and_run.sh base "$BASE"
$probe run "$SUITE" --agent scripted --out "$OUT/runs/scripted" --workers "$WORKERS"

step "at which step of using the tools each fails, and what is right"
$probe ladder "$OUT"/runs/* --out "$OUT/ladder.md"
$probe held-out "$OUT"/runs/* --out "$OUT/table.md"
