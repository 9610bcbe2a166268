PYTHON ?= python3
DIR ?= work
VENV := .venv/bin

# Whatever somebody has set for Python and Jupyter at large does not reach what runs here.
unexport PYTHONHOME PYTHONPATH PYTHONOPTIMIZE PYTHONSTARTUP JUPYTER_PATH MPLCONFIGDIR MATPLOTLIBRC VIRTUAL_ENV
export PYTHONUTF8 := 1

# Another arm, as in ARM="L_1=0.25 L_3=0.12": its figures and its site have folders of their own.
comma := ,
export LYNX_ARM := $(strip $(subst $(comma), ,$(ARM)))
OWN := $(if $(ARM),-$(subst $() $(),_,$(LYNX_ARM)))

help:  ## list the targets
	@awk -F ':.*## ' '/^[a-z]+:.*## / {printf "  make %-10s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

lab: .venv/ready  ## open your own copy of the course, in work/ (DIR=...: in another folder; DIR=notebooks: the originals)
	@$(VENV)/python -m lynx_common.course.lab "$(DIR)"

test: .venv/ready  ## test the package; re-run every notebook and compare every output
	@$(VENV)/python -m pytest $(if $(ARM),tests)

lint: .venv/ready  ## ask ruff about code and notebooks and whether the code is formatted, and mypy about types
	@$(VENV)/ruff check && $(VENV)/ruff format --check && $(VENV)/mypy

figures: .venv/ready  ## write figures/*.pdf, .svg and .png (ONLY="A1 2.4": some; ARM="L_3=0.12": another arm)
	@$(VENV)/python -m lynx_common.course.execute figures $(ONLY)

notebooks: .venv/ready  ## execute the notebooks in place, to store their outputs
	@$(VENV)/python -m lynx_common.course.execute notebooks

site: .venv-site/ready $(if $(ARM),.venv/ready)  ## build the course as a web page that needs no server, in build/site
	@$(if $(ARM),$(VENV)/python -m lynx_common.course.execute copies "build/notebooks$(OWN)")
	@rm -rf "build/site$(OWN)"
	.venv-site/bin/python -m sphinx -q -W -E --keep-going -c site -d "build/doctrees$(OWN)" \
	  "$(if $(ARM),build/)notebooks$(OWN)" "build/site$(OWN)"
	@echo "Open build/site$(OWN)/index.html in a browser."

bench: .venv-bench/ready  ## measure speed and memory, also against other packages
	.venv-bench/bin/python -m pytest -s -o addopts= -o python_files='bench_*.py' \
	  --benchmark-columns=median,iqr,rounds tests/benchmarks

browser: .venv/ready .venv-browser/ready site  ## move stages in a real Chromium: alone, in the notebooks, on the site
	.venv-browser/bin/python tests/stage_check.py
	@for notebook in $$(grep -l 'explorers\.' notebooks/*.ipynb); do \
	  .venv-browser/bin/python tests/browser_check.py $$notebook || exit 1; done
	.venv-browser/bin/python tests/site_check.py

assignment: .venv/ready  ## write the course as nbgrader's source notebooks, in build/assignment
	@$(VENV)/python -m lynx_common.course.classroom.assignment

grade: .venv/ready  ## grade notebooks without nbgrader: DIR=submissions, one folder a student; to build/grades.csv
	@$(VENV)/python -m lynx_common.course.classroom.grade "$(DIR)"

key: .venv/ready  ## write the answers to all exercises to build/key.csv (NAMES=names.txt: for these students)
	@$(VENV)/python -m lynx_common.course.classroom.key "$(NAMES)"

nbgrader: .venv-nbgrader/ready  ## set two notebooks to a class with the real nbgrader, and compare the scores
	.venv-nbgrader/bin/python tests/nbgrader_check.py

clean:  ## remove what was made here, except work/
	rm -rf .venv* figures build *.egg-info .pytest_cache .ruff_cache .hypothesis .benchmarks
	find lynx_common tests notebooks \( -name __pycache__ -o -name .ipynb_checkpoints \) -prune -exec rm -rf {} +

.venv/ready: requirements.txt pyproject.toml
.venv-browser/ready: requirements-browser.txt
.venv-bench/ready: requirements-bench.txt requirements.txt pyproject.toml
.venv-nbgrader/ready: requirements-nbgrader.txt requirements.txt pyproject.toml
.venv-site/ready: requirements-site.txt

# An environment that was moved, or whose Python is gone, is made anew: `ready` holds the place where it was made.
$(foreach ready,$(wildcard .venv*/ready),$(shell \
  [ "$$(cat $(ready))" = "$$PWD" ] && $(ready:ready=bin/python) -c "" 2>/dev/null || rm -f $(ready) 2>/dev/null))

%/ready:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { echo "Python 3.11 or" \
	  "newer is needed, but $(PYTHON) is $$($(PYTHON) --version 2>/dev/null || echo not here); name another," \
	  "as in: make $(or $(firstword $(MAKECMDGOALS)),lab) PYTHON=python3.12" >&2; exit 1; }
	@echo "Setting up $* (about a minute, once) ..."
	@if command -v uv >/dev/null; then uv venv -q --clear --python $(PYTHON) $*; \
	  else $(PYTHON) -m venv --clear $*; fi
	@{ if command -v uv >/dev/null; then uv pip install -q --compile-bytecode --python $* -r $<; \
	  else $*/bin/python -m pip install -q --disable-pip-version-check -r $<; fi; } >$*/log 2>&1 || { \
	  echo "The packages could not be installed; is there a network? The whole story is in $*/log, its last line" \
	  "is: $$(tail -n 1 $*/log)" >&2; exit 1; }
	@[ $* != .venv ] || MPLCONFIGDIR=$*/matplotlib $*/bin/python -c "import matplotlib.font_manager"
	@printf %s "$$PWD" >$@

.PHONY: help lab test lint figures notebooks site bench browser assignment grade key nbgrader clean
