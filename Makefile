PYTHON ?= python3
DIR ?= work
VENV := .venv/bin

help:  ## list the targets
	@awk -F ':.*## ' '/^[a-z]+:.*## / {printf "  make %-10s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

lab: .venv/ready  ## open your own copy of the course, in work/ (DIR=notebooks: the originals)
	@mkdir -p $(DIR)
	@for notebook in notebooks/*.ipynb; do \
	  copy=$(DIR)/$${notebook##*/}; [ -e "$$copy" ] || cp "$$notebook" "$$copy"; done
	@$(VENV)/jupyter lab --log-level=WARN --LabApp.news_url=None --LabApp.default_url=/lab/tree/$(DIR)/00_index.ipynb \
	  $(if $(filter 0,$(shell id -u)),--allow-root)

test: .venv/ready  ## test the package; re-run every notebook and compare every output
	$(VENV)/pytest

figures: .venv/ready  ## write figures/*.pdf, .svg and .png (ONLY=A1: one notebook, ONLY=1.2: one figure)
	@$(VENV)/python -m lynx_common.course.execute figures $(ONLY)

notebooks: .venv/ready  ## execute the notebooks in place, to store their outputs
	@$(VENV)/python -m lynx_common.course.execute notebooks

site: .venv-site/ready  ## build the course as a web page that needs no server, in build/site
	.venv-site/bin/sphinx-build -q -W -E --keep-going -c site notebooks build/site
	@echo "Open build/site/index.html in a browser."

bench: .venv/ready  ## measure speed and memory
	$(VENV)/pytest -s -o addopts= -o python_files='bench_*.py' --benchmark-columns=median,iqr,rounds tests/benchmarks

browser: .venv/ready .venv-browser/ready site  ## move sliders in a real Chromium: of the notebooks, and of the site
	@for notebook in $$(grep -l 'explorers\.' notebooks/*.ipynb); do \
	  .venv-browser/bin/python tests/browser_check.py $$notebook || exit 1; done
	.venv-browser/bin/python tests/site_check.py

clean:  ## remove what was made here, except work/
	rm -rf .venv .venv-browser .venv-site figures build *.egg-info .pytest_cache .ruff_cache .hypothesis .benchmarks
	find lynx_common tests notebooks \( -name __pycache__ -o -name .ipynb_checkpoints \) -prune -exec rm -rf {} +

.venv/ready: requirements.txt pyproject.toml
.venv-browser/ready: requirements-browser.txt
.venv-site/ready: requirements-site.txt

%/ready:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { echo "Python 3.11 or" \
	  "newer is needed, but $(PYTHON) is $$($(PYTHON) --version 2>/dev/null || echo not here); name another," \
	  "as in: make $(or $(firstword $(MAKECMDGOALS)),lab) PYTHON=python3.12" >&2; exit 1; }
	@echo "Setting up $* (about a minute, once) ..."
	@if command -v uv >/dev/null; then \
	  uv venv -q --clear --python $(PYTHON) $* && uv pip install -q --compile-bytecode --python $* -r $<; \
	else \
	  $(PYTHON) -m venv --clear $* && $*/bin/python -m pip install -qq --disable-pip-version-check -r $<; fi
	@touch $@

.PHONY: help lab test figures notebooks site bench browser clean
