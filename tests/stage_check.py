"""Open every stage in a real Chromium: at three widths, on a light and on a dark page; keep a picture of each.

Run by `make browser`, not by pytest. The stages are those that the notebooks hold. Pictures go to build/stages.
"""

import json
import statistics
import sys

from browser_check import BROWSER_FLAGS, ROOT, chromium, listen, say
from playwright.sync_api import Page, sync_playwright

PICTURES = ROOT / "build" / "stages"
WIDTHS = (320, 390, 768, 1400)
PAGES = {"light": "#ffffff", "dark": "#131416"}
# Asked within a stage.
OVERFLOW = "document.documentElement.scrollWidth - innerWidth"
IN_VIEW = """Math.max(...[...document.querySelectorAll('canvas, #controls, #player')]
    .map(part => part.getBoundingClientRect().bottom))"""
TOO_HIGH = "frameElement.clientHeight - Math.ceil(document.getElementById('main').getBoundingClientRect().height)"
CUT_OFF = """[...document.querySelectorAll("#words > *")].filter(e => e.scrollWidth > e.clientWidth + 1)
    .map(e => e.textContent).join("; ")"""
NAMELESS = """[...document.querySelectorAll('input, button')]
    .filter(e => !(e.getAttribute('aria-label') || e.labels?.length || e.textContent)).length"""
INK = "getComputedStyle(document.body).color"
# From an input to what is drawn of it, in milliseconds: the work, and until the frame with it has been painted.
LATENCY = """async () => {
    const slider = document.querySelector("#controls input[type=range]") || document.getElementById("time");
    const times = [];
    for (let i = 0; i < 12; i++) {
        await new Promise(requestAnimationFrame);
        const start = performance.now();
        slider.value = +slider.value + (i % 2 ? -1 : 1) * slider.step * 3;
        slider.dispatchEvent(new Event("input"));
        const work = performance.now() - start;
        await new Promise(done => requestAnimationFrame(() => setTimeout(done)));
        times.push([work, performance.now() - start]);
    }
    return times;
}"""


def main() -> int:
    if not chromium():
        sys.exit("There is no Chromium on this machine; install one (apt install chromium).")
    PICTURES.mkdir(parents=True, exist_ok=True)
    failures = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium(), args=BROWSER_FLAGS)
        for name, shown in stages().items():
            for width in WIDTHS:
                page = browser.new_page(viewport={"width": width, "height": 844 if width < 500 else 768})
                foreign, faults = listen(page, "about:")
                failures += [f"{name} at {width}: {fault}" for fault in check(page, name, shown, width)]
                failures += [f"{name} at {width}: {fault}" for fault in foreign + faults]
                page.close()
        browser.close()
    for failure in failures:
        print(f"FAILED: {failure}", file=sys.stderr)
    return int(bool(failures))


def stages() -> dict[str, str]:
    """The stages of all notebooks, by notebook and number."""
    found = {}
    for path in sorted((ROOT / "notebooks").glob("*.ipynb")):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        texts = ["".join(o.get("data", {}).get("text/html", "")) for c in cells for o in c.get("outputs", [])]
        shown = [text for text in texts if "<iframe srcdoc=" in text]
        found |= {f"{path.stem.split('_')[0]}-{i}": text for i, text in enumerate(shown, start=1)}
    return found


def check(page: Page, name: str, shown: str, width: int) -> list[str]:
    """What is wrong with a stage at one width, a phrase each."""
    page.set_content(f"<!doctype html><body style='margin:0;background:{PAGES['light']}'>{shown}")
    page.wait_for_timeout(300)
    stage, faults, inks = page.frames[1], [], []
    for theme, colour in PAGES.items():
        page.evaluate(f"document.body.style.background = '{colour}'")
        page.wait_for_timeout(450)
        inks.append(stage.evaluate(INK))
        page.locator("iframe").screenshot(path=PICTURES / f"{name}-{width}-{theme}.png")
    faults += ["it does not follow the page's colours"] * (inks[0] == inks[1])
    if (over := stage.evaluate(OVERFLOW)) > 0:
        faults.append(f"{over} pixels too wide")
    if abs(gap := stage.evaluate(TOO_HIGH)) > 1:
        faults.append(f"the frame is {gap} pixels too high")
    if width >= 390 and (bottom := stage.evaluate(IN_VIEW)) > page.viewport_size["height"]:
        faults.append(f"picture and sliders need {bottom:.0f} pixels")
    if cut := stage.evaluate(CUT_OFF):
        faults.append(f"words are cut off at the right: {cut}")
    if nameless := stage.evaluate(NAMELESS):
        faults.append(f"{nameless} controls have no name")
    faults += touched(page, stage)
    if width == WIDTHS[-1]:
        work, seen = map(statistics.median, zip(*stage.evaluate(LATENCY), strict=True))
        say(name, f"{len(shown) / 1000:.0f} kB; {work:.1f} ms of work, {seen:.0f} ms to the picture")
    return faults


def touched(page: Page, stage) -> list[str]:
    """Whether handles move sliders, and arrow keys turn space."""
    faults = []
    stage.evaluate("stop()")
    handles = stage.evaluate("""views.flatMap((view, k) => view.handles.map(handle => {
        const at = numbersAt(inputs).slice(handle.at[0], handle.at[0] + handle.at[1]);
        const box = canvases[k].getBoundingClientRect();
        const [x, y] = cameraOf(view, k).place(at);
        return [x + box.left, y + box.top];
    }))""")
    for x, y in handles:
        before = stage.evaluate("[...document.querySelectorAll('output')].map(o => o.textContent).join()")
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x - 12, y + 9, steps=3)
        page.mouse.up()
        if stage.evaluate("[...document.querySelectorAll('output')].map(o => o.textContent).join()") == before:
            faults.append("a handle moves no slider")
        stage.evaluate("document.getElementById('reset').click()")
    for canvas in stage.query_selector_all("canvas[tabindex='0']"):
        before = canvas.evaluate("c => c.toDataURL()")
        canvas.press("ArrowRight")
        if canvas.evaluate("c => c.toDataURL()") == before:
            faults.append("an arrow key turns nothing")
    return faults


if __name__ == "__main__":
    sys.exit(main())
