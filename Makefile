# Each target does all of its own set-up: virtual environment, pinned packages, Vulkan driver.
PYTHON ?= $(shell command -v python3.11 || command -v python3)
BIN := .venv/bin
# One more than cores: many tests wait, for an arm that moves by the clock or a process that hangs.
WORKERS ?= 3

.PHONY: help demo docs test test-slow every-object check bench mutants format driver browser
.DELETE_ON_ERROR:
# Where this is set, each of the many processes that tests start compiles all of its modules again.
unexport PYTHONDONTWRITEBYTECODE

help:
	@echo "make demo       a scripted agent solves a task of each of seven types; outputs/demo/index.html"
	@echo "make test       the fast tests"
	@echo "make test-slow  the slow ones; installs PyTorch, Blender, Ray, Rerun and a Chromium"
	@echo "make every-object   checks all built-in objects; the slow tests check a share of them"
	@echo "make docs       the pages as a site; outputs/site/index.html"
	@echo "make check      format, lint, types, architecture"
	@echo "make bench      what things cost"
	@echo "make mutants    whether tests notice errors in grading and statistics"
	@echo "make format     let ruff put it right"

demo: .venv/.ready driver
	$(BIN)/probe demo

# A core for each worker: threads of several that share one wait for each other in loops.
test test-slow: export OMP_NUM_THREADS = 1

test: .venv/.ready driver
	$(BIN)/pytest -m "not slow and not gpu" -n $(WORKERS) --dist loadfile --no-loadscope-reorder

test-slow: .venv/.ready driver browser .venv/.blender .venv/.torch
test-slow: .venv/.docs .venv/.openenv .venv/.ray .venv/.rerun
	$(BIN)/pytest -m "slow and not gpu" --durations 40 -n $(WORKERS) --dist loadfile --no-loadscope-reorder

# Minutes. What passed is noted with a hash of what decides the objects, for you to commit; until
# that changes, the slow tests go through a share of the objects alone.
every-object: .venv/.ready driver
	state=$$($(BIN)/python tests/deciding.py) && \
		OMP_NUM_THREADS=1 $(BIN)/pytest -m every_object -n $(WORKERS) && \
		echo "$$state" > tests/every_object.sha256

check: .venv/.ready
	$(BIN)/ruff format --check
	$(BIN)/ruff check
	$(BIN)/pyright
	$(BIN)/lint-imports

# A dead link is a warning, and a warning is an error. Every page is read again, because Sphinx
# warns of a page only when it reads it.
docs: .venv/.docs
	$(BIN)/sphinx-build -q -W --keep-going -E -a -c docs/site -d outputs/.doctrees . outputs/site
	@echo "outputs/site/index.html"

# Those that take minutes and need nothing; the others say in their first lines what they take.
BENCHMARKS ?= $(addprefix internals/,episode looks observation report scores)

bench: .venv/.ready driver browser
	@for name in $(BENCHMARKS); do echo "== $$name"; $(BIN)/python "benchmarks/$$name.py" || exit 1; done

mutants: .venv/.mutants
	$(BIN)/mutmut run --max-children $(WORKERS)
	$(BIN)/mutmut results

format: .venv/.ready
	$(BIN)/ruff format
	$(BIN)/ruff check --fix

.venv/.ready: requirements.lock pyproject.toml
	@PYTHON="$(PYTHON)" scripts/make-venv

.venv/.blender: .venv/.ready requirements-blender.lock
	@PYTHON="$(PYTHON)" scripts/add-blender

.venv/.torch: .venv/.ready requirements-torch.lock requirements-torch-cpu.lock requirements-cuda.lock
	@PYTHON="$(PYTHON)" scripts/add-torch

# What is just a lock: Sphinx (docs), mutmut (mutants), Ray and an object store (ray), Rerun (rerun),
# a small language model's weights (student), OpenEnv (openenv).
.venv/.%: requirements-%.lock .venv/.ready
	@PYTHON="$(PYTHON)" scripts/install-locked $<
	@touch $@

driver: .venv/.ready
	@PYTHON="$(BIN)/python" scripts/ensure-driver

browser:
	@scripts/ensure-browser
