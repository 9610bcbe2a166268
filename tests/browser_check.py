"""Open a notebook in a real JupyterLab and Chromium: its stages move before a cell is run, its explorer after.

Run by `make browser`, not by pytest: it needs Chromium and Playwright (requirements-browser.txt). It works on
a copy of the notebook's folder, and talks to this machine only.
"""

import argparse
import contextlib
import os
import secrets
import shutil
import signal
import socket
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path

from playwright.sync_api import Page, sync_playwright
from playwright.sync_api import TimeoutError as BrowserTimeout

ROOT = Path(__file__).parents[1]
PICTURES = ROOT / "build" / "jupyterlab"
PATIENCE = 180_000  # ms: for the notebook to run to its end
STEPS = 10
DRAG = 2.0  # s
BROWSER_FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
# Cells far down the page are there too, and no question about news covers the picture.
SETTINGS = {
    "@jupyterlab/notebook-extension/tracker.jupyterlab-settings": '{"windowingMode": "none"}',
    "@jupyterlab/apputils-extension/notification.jupyterlab-settings": '{"fetchNews": "false"}',
}
# Asked of the page. A picture is a blob, whose address is a new one each time it is drawn.
KERNEL_IDLE = "window.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel?.status === 'idle'"
RUN_ALL = "window.jupyterapp.commands.execute('notebook:run-all-cells')"
CELL_ERRORS = """[...window.jupyterapp.shell.currentWidget.content.model.cells]
    .flatMap((cell, number) => (cell.type === 'code' ? cell.toJSON().outputs : [])
        .filter(output => output.output_type === 'error')
        .map(error => `cell ${number + 1}: ${error.ename}: ${error.evalue}`))"""
STAGES = "[...document.querySelectorAll('iframe[srcdoc]')].length"
INK = "getComputedStyle(document.body).color"
DRAWN = "[...document.querySelectorAll('canvas')].map(c => c.toDataURL()).join()"
OVERFLOW = "document.documentElement.scrollWidth - innerWidth"
THEME = "name => window.jupyterapp.commands.execute('apputils:change-theme', {theme: name})"
ADDRESS = "css => document.querySelector(css)?.src"
BYTES = """async css => {
    const picture = await fetch(document.querySelector(css).src);
    return Array.from(new Uint8Array(await picture.arrayBuffer())).join();
}"""
COUNT_FRAMES = """css => {
    window.frames_seen = 0;
    let last = document.querySelector(css).src;
    setInterval(() => {
        const now = document.querySelector(css)?.src;
        if (now && now !== last) { window.frames_seen += 1; last = now; }
    }, 8);
}"""


def main() -> int:
    arguments = parse_arguments()
    with tempfile.TemporaryDirectory() as folder:
        copies = Path(folder, "notebooks")
        shutil.copytree(arguments.notebook.parent, copies)
        with jupyterlab(arguments.jupyter, copies) as (address, token), sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=arguments.chromium, args=BROWSER_FLAGS)
            page = browser.new_page(viewport={"width": 1400, "height": 1000})
            foreign, faults = listen(page, address)
            page.goto(f"{address}/lab/tree/{arguments.notebook.name}?token={token}")
            failures = check(page, arguments.picture)
            if arguments.screenshot:
                page.screenshot(path=arguments.screenshot)
            browser.close()
    say("page errors", faults or "none")
    say("requests to elsewhere", foreign or "none")
    for failure in failures:
        print(f"FAILED: {failure}", file=sys.stderr)
    return int(bool(failures))


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("notebook", type=Path)
    parser.add_argument("--picture", default=".jp-OutputArea .widget-image, img.widget-image", metavar="CSS")
    parser.add_argument("--screenshot", type=Path, metavar="FILE")
    parser.add_argument("--jupyter", type=Path, default=ROOT / ".venv/bin/jupyter")
    parser.add_argument("--chromium", default=chromium())
    arguments = parser.parse_args()
    if not arguments.chromium:
        parser.error("no Chromium on this machine; install one (apt install chromium) or name it with --chromium")
    if not arguments.notebook.is_file():
        parser.error(f"there is no notebook {arguments.notebook}")
    return arguments


def chromium() -> str | None:
    return shutil.which("chromium") or shutil.which("google-chrome")


@contextlib.contextmanager
def jupyterlab(jupyter: Path, folder: Path) -> Iterator[tuple[str, str]]:
    """A JupyterLab on the folder, with settings of its own; yields its address and token."""
    port, token = free_port(), secrets.token_hex(8)
    places = ("_CONFIG", "_DATA", "LAB_SETTINGS", "LAB_WORKSPACES")
    homes = {f"JUPYTER{place}_DIR": str(folder.parent / place) for place in places}
    for name, text in SETTINGS.items():
        file = folder.parent / "LAB_SETTINGS" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    options = [
        "--no-browser",
        "--allow-root",
        "--expose-app-in-browser",
        "--ip=127.0.0.1",
        f"--port={port}",
        "--ServerApp.port_retries=0",
        f"--ServerApp.root_dir={folder}",
        f"--IdentityProvider.token={token}",
        "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
        "--LabApp.extension_manager=readonly",
    ]
    notebooks = map(str, folder.glob("*.ipynb"))
    subprocess.run([jupyter, "trust", *notebooks], env=os.environ | homes, check=True, capture_output=True)
    with open(folder.parent / "lab.log", "w+") as log:
        server = subprocess.Popen(
            [jupyter, "lab", *options], env=os.environ | homes, stdout=log, stderr=log, start_new_session=True
        )
        try:
            wait_for(f"http://127.0.0.1:{port}/api?token={token}", server, Path(log.name))
            yield f"http://127.0.0.1:{port}", token
        finally:
            stop(server)


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_for(address: str, server: subprocess.Popen, log: Path) -> None:
    """Return when the server answers; where it never does, end with what it said."""
    for _ in range(300):
        with contextlib.suppress(OSError), urllib.request.urlopen(address, timeout=1):
            return
        if server.poll() is not None:
            break
        time.sleep(0.1)
    sys.exit(f"JupyterLab did not start:\n{log.read_text()}")


def stop(server: subprocess.Popen) -> None:
    """End the server and the kernels it started, which share its process group or end with it."""
    os.killpg(server.pid, signal.SIGTERM)
    try:
        server.wait(15)
    except subprocess.TimeoutExpired:
        os.killpg(server.pid, signal.SIGKILL)


def listen(page: Page, address: str) -> tuple[list[str], list[str]]:
    """Two lists that fill as the page works: requests to other machines, and errors in the page."""
    foreign, faults = [], []

    def note_foreign(request):
        if request.url.startswith("http") and not request.url.startswith(address):
            foreign.append(request.url)

    page.on("request", note_foreign)
    page.on("pageerror", lambda error: faults.append(str(error)[:200]))
    return foreign, faults


def check(page: Page, picture: str) -> list[str]:
    """Move what the notebook holds, before and after it is run; returns what failed, a sentence each."""
    page.wait_for_selector(".jp-Notebook .jp-Cell", timeout=60_000)
    page.wait_for_function(KERNEL_IDLE, timeout=60_000)
    failures = alive(page)
    if errors := run_notebook(page):
        return failures + errors
    if page.locator(".jupyter-widgets .noUi-handle").count():
        failures += explored(page, picture)
    return failures


def alive(page: Page) -> list[str]:
    """Whether the stages, as they are stored, move at all widths, and follow the theme."""
    stages = [frame for frame in page.frames[1:] if frame.query_selector("#views")]
    say("stages", len(stages))
    failures = [] if len(stages) == page.evaluate(STAGES) else ["not every stage has come to life"]
    for number, stage in enumerate(stages, start=1):
        stage.evaluate("stop()")
        slider = stage.locator("input[type=range]:visible").first
        before = stage.evaluate(DRAWN)
        slider.press("ArrowLeft" if slider.evaluate("i => +i.value + +i.step > +i.max") else "ArrowRight")
        failures += [f"stage {number} does not move"] * (stage.evaluate(DRAWN) == before)
        for width in (390, 768, 1400):
            page.set_viewport_size({"width": width, "height": 844})
            page.wait_for_timeout(150)
            failures += [f"stage {number} is too wide at {width}"] * (stage.evaluate(OVERFLOW) > 0)
    inks = {}
    for theme in ("JupyterLab Dark", "JupyterLab Light"):
        page.evaluate(THEME, theme)
        page.wait_for_timeout(1500)
        inks[theme] = {stage.evaluate(INK) for stage in stages}
        page.screenshot(path=PICTURES / f"{page.url.split('/')[-1].split('_')[0]}-{theme.split()[1]}.png")
    dark, light = inks.values()
    return failures + ["a stage does not follow the theme"] * bool(dark & light or len(dark) > 1)


def explored(page: Page, picture: str) -> list[str]:
    """Whether the picture of the first explorer follows its slider, and how fast."""
    handle = page.locator(".jupyter-widgets .noUi-handle").first
    try:
        page.locator(picture).first.wait_for(timeout=10_000)
    except BrowserTimeout:
        return [f"no picture {picture!r} on the page"]
    before = page.evaluate(BYTES, picture)
    handle.focus()
    latencies = [latency(page, handle, picture) for _ in range(STEPS)]
    if None in latencies:
        return ["the picture did not follow the slider"]
    say(
        "a step",
        f"{statistics.median(latencies):.0f} ms (median), {max(latencies):.0f} ms (worst of {STEPS})",
    )
    say(f"frames in a drag of {DRAG:g} s", drag(page, handle, picture))
    return [] if page.evaluate(BYTES, picture) != before else ["the picture is the same as before"]


def run_notebook(page: Page) -> list[str]:
    """Run all cells and wait for the kernel; returns the errors of cells."""
    start = time.perf_counter()
    page.evaluate(RUN_ALL)  # its promise is kept when the last cell has run
    page.wait_for_function(KERNEL_IDLE, timeout=PATIENCE)
    say("opened and run in", f"{time.perf_counter() - start:.1f} s")
    return page.evaluate(CELL_ERRORS)


def latency(page: Page, handle, picture: str) -> float | None:
    """Milliseconds from a press of the arrow key to another picture; None if none comes in ten seconds."""
    before, start = page.evaluate(ADDRESS, picture), time.perf_counter()
    handle.press("ArrowRight")
    while page.evaluate(ADDRESS, picture) in (before, None):
        if time.perf_counter() - start > 10:
            return None
        time.sleep(0.003)
    elapsed = 1000 * (time.perf_counter() - start)
    time.sleep(0.15)  # let the page come to rest
    return elapsed


def drag(page: Page, handle, picture: str) -> int:
    """How many pictures the reader sees while dragging the slider's handle."""
    page.evaluate(COUNT_FRAMES, picture)
    handle.scroll_into_view_if_needed()
    box = handle.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    start, moves = time.perf_counter(), 40
    for move in range(1, moves + 1):
        page.mouse.move(x + 45 * move / moves, y)
        time.sleep(max(0, start + DRAG * move / moves - time.perf_counter()))
    page.mouse.up()
    frames = page.evaluate("window.frames_seen")
    time.sleep(1)  # the last picture
    return frames


def say(what: str, finding) -> None:
    print(f"{what}: {finding}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
