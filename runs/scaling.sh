#!/usr/bin/env bash
# How a student gets better with more examples, and what augmented ones bring, after runs/student.sh:
# for each number of examples two trainings, each evaluated on practice tasks. One reads the examples
# alone, three times; the other each of them once in three ways (as it went, mirrored, in other words), so
# that both make as many updates where all can be mirrored. Practice tasks have objects of the pool for
# training, as examples have, and seeds of their own, so nothing is chosen here by a suite.
# Each step goes on where it was stopped: run it again.
#
#   runs/scaling.sh                     # 75 and 150 examples from outputs/student, into outputs/scaling
#   SIZES="75 150 300 600" STUDENT=elsewhere OUT=there runs/scaling.sh
set -euo pipefail
cd "$(dirname "$0")/.."

STUDENT=${STUDENT:-outputs/student}     # has collected/, and base/ unless BASE is set
OUT=${OUT:-outputs/scaling}
SIZES=${SIZES:-75 150}
WAYS=${WAYS:-plain augmented}
PRACTICE=${PRACTICE:---counts.count 16 --counts.find 16 --counts.size 12 --counts.compare 10 --counts.reduce 6}
SELECT=${SELECT:---slack 3}
TRAIN=${TRAIN:---learning-rate 3e-4 --global-batch 2 --warmup 0.1 --no-save-memory}
SERVE=${SERVE:---cpu-bfloat16 --most-tokens 200}
BASE=${BASE:-$STUDENT/base}
WORKERS=${WORKERS:-2}
PORT=${PORT:-8001}
probe=${PROBE:-.venv/bin/probe}
[ -n "${PROBE:-}" ] || make --silent driver .venv/.torch .venv/.student

step() { echo; echo "== $*"; }

step "practice: tasks that no example is of"
[ -e "$OUT/practice.json" ] ||
    $probe suite build "$OUT/practice.json" --public --first 2900000 --unchecked --pool train \
        --workers "$WORKERS" $PRACTICE
export SUITE=$OUT/practice.json WORKERS PORT OUT SERVE PROBE="$probe" ARMS=text-only RUN="--graphs short"
runs/serve_and_run.sh base "$BASE"
$probe run "$SUITE" --agent scripted --out "$OUT/runs/scripted" --workers "$WORKERS"

for size in $SIZES; do
    chosen=$OUT/$size/selected
    step "select: $size examples"
    [ -e "$chosen/selection.json" ] ||
        $probe select "$STUDENT/collected" --out "$chosen" --direct-share 0 --total "$size" \
            --against "$SUITE" $SELECT
    for way in $WAYS; do
        name=$way-$size here=$OUT/$size/$way
        case $way in
            plain) augment="" epochs=3 ;;
            augmented) augment="--augment mirrored wordings" epochs=1 ;;
            *) echo "WAYS has plain and augmented, not $way." >&2; exit 1 ;;
        esac
        step "$name: data set, training, evaluation"
        [ -e "$here/data/manifest.json" ] ||
            $probe dataset "$chosen" "$here/data" --setting text-only --graphs short --no-others $augment
        $probe train "$here/data" --model "$BASE" --out "$here/trained" --cpu-bfloat16 \
            --epochs "$epochs" $TRAIN
        runs/serve_and_run.sh "$name" "$here/trained/model"
    done
done

step "at which step of using the tools each fails, and what is right"
$probe ladder "$OUT"/runs/* --out "$OUT/ladder.md"
$probe held-out "$OUT"/runs/* --out "$OUT/table.md"
