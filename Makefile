# Each target does all of its own set-up: virtual environment, pinned packages, Vulkan driver.
PYTHON ?= $(shell command -v python3.11 || command -v python3)
BIN := .venv/bin
WORKERS ?= 2

.PHONY: help demo test test-slow check bench mutants format driver browser
.DELETE_ON_ERROR:

help:
	@echo "make demo | test | test-slow | check | bench | mutants | format"

demo: .venv/.ready driver
	$(BIN)/probe demo

test: .venv/.ready driver
	$(BIN)/pytest -m "not slow and not gpu" -n $(WORKERS)

test-slow: .venv/.ready driver browser .venv/.blender .venv/.torch
	$(BIN)/pytest -m "slow and not gpu" -n $(WORKERS)

check: .venv/.ready
	$(BIN)/ruff format --check
	$(BIN)/ruff check
	$(BIN)/pyright
	$(BIN)/lint-imports

bench: .venv/.ready driver
	@for script in benchmarks/*.py; do echo "== $$script"; $(BIN)/python "$$script" || exit 1; done

mutants: .venv/.mutmut
	$(BIN)/mutmut run --max-children $(WORKERS)
	$(BIN)/mutmut results

format: .venv/.ready
	$(BIN)/ruff format
	$(BIN)/ruff check --fix

.venv/.ready: requirements.lock pyproject.toml
	@PYTHON="$(PYTHON)" scripts/make-venv

.venv/.blender: .venv/.ready
	@scripts/add-blender

.venv/.torch: .venv/.ready
	@PYTHON="$(PYTHON)" scripts/add-torch

.venv/.mutmut: .venv/.ready
	@PYTHON="$(PYTHON)" scripts/add-mutmut

driver: .venv/.ready
	@PYTHON="$(BIN)/python" scripts/ensure-driver

browser:
	@scripts/ensure-browser
