"""Read the built site in a real Chromium that reaches no other machine: every page, every link, every slider.

Run by `make browser`, not by pytest. It looks at build/site, as `make site` leaves it.
"""

import functools
import sys
import threading
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

from browser_check import BROWSER_FLAGS, ROOT, chromium, listen, say
from playwright.sync_api import Frame, Page, sync_playwright
from playwright.sync_api import TimeoutError as BrowserTimeout

SITE = ROOT / "build" / "site"
WORD = "elbow"  # searched for
# Asked of a page, or of a stage on it.
MATHEMATICS = "document.querySelectorAll('mjx-container').length"
MATHEMATICS_WANTED = "document.querySelectorAll('.math').length"
FAULTY_MATHEMATICS = "document.querySelectorAll('mjx-merror, [data-mjx-error]').length"
BROKEN_PICTURES = "[...document.images].filter(i => !(i.complete && i.naturalWidth)).map(i => i.src)"
WITHOUT_WORDS = "[...document.images].filter(i => !i.alt || i.alt.includes('_images/')).map(i => i.src)"
LINKS = "[...document.querySelectorAll('a[href]')].map(a => a.href)"
ALL_TYPESET = f"{MATHEMATICS} >= {MATHEMATICS_WANTED}"
DRAWN = "[...document.querySelectorAll('canvas')].map(c => c.toDataURL()).join()"
OVERFLOW = "document.documentElement.scrollWidth - innerWidth"
INK = "getComputedStyle(document.body).color"
TIME = "document.getElementById('time').value"
TO_THE_PLAYER = "document.getElementById('views').scrollIntoView({behavior: 'instant'})"
TO_THE_END = "top.scrollTo({top: top.document.body.scrollHeight, behavior: 'instant'})"
HAS_ID = "id => document.getElementById(decodeURIComponent(id)) !== null"


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def main() -> int:
    if not (SITE / "index.html").exists():
        sys.exit(f"There is no site in {SITE}; run `make site` first.")
    if not chromium():
        sys.exit("There is no Chromium on this machine; install one (apt install chromium).")
    server = ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=SITE))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}"
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium(), args=BROWSER_FLAGS)
        page = browser.new_page(viewport={"width": 1400, "height": 1000})
        page.route(lambda url: not url.startswith((address, "data:", "about:")), lambda route: route.abort())
        foreign, faults = listen(page, address)
        failures = check(page, address)
        browser.close()
    server.shutdown()
    failures += [f"asks for {url}" for url in foreign] + [f"error in a page: {fault}" for fault in faults]
    for failure in failures:
        print(f"FAILED: {failure}", file=sys.stderr)
    return int(bool(failures))


def check(page: Page, address: str) -> list[str]:
    """What fails on any page, a sentence each."""
    failures, links, moved = [], set(), 0
    pages = sorted(path.name for path in SITE.glob("*_*.html"))
    for name in pages:
        page.goto(f"{address}/{name}")
        page.wait_for_load_state("load")
        found = mathematics(page)
        found += [f"no picture at {source}" for source in page.evaluate(BROKEN_PICTURES)]
        found += [f"no words for the picture {source}" for source in page.evaluate(WITHOUT_WORDS)]
        explorers = [frame for frame in page.frames[1:] if frame.query_selector("input[type=range]")]
        found += [fault for frame in explorers for fault in still(frame)] + dressed(page, explorers)
        moved += len(explorers)
        links.update(page.evaluate(LINKS))
        failures += [f"{name}: {fault}" for fault in found]
        say(name, f"{page.evaluate(MATHEMATICS)} formulas, {len(explorers)} stages")
    local = sorted(link for link in links if link.startswith(address))
    failures += dead_links(page, local)
    page.goto(f"{address}/search.html?q={WORD}")
    page.wait_for_selector("#search-results li", timeout=10_000)
    say(f"found for {WORD!r}", page.locator("#search-results li").count())
    say("links", len(local))
    return failures + ["no stage moves"] * (moved == 0)


def mathematics(page: Page) -> list[str]:
    """Whether some formula is not typeset, or with a fault."""
    try:
        page.wait_for_function(ALL_TYPESET, timeout=30_000)
    except BrowserTimeout:
        return ["not all formulas are typeset"]
    faulty = page.evaluate(FAULTY_MATHEMATICS)
    return [f"{faulty} faulty formulas"] if faulty else []


def still(frame: Frame) -> list[str]:
    """The sliders of a stage that leave its drawing as it is; and a motion that runs out of sight."""
    failures = []
    play = frame.query_selector("#play")
    if play.is_visible() and not frame.evaluate("challenges.length"):
        failures = runs_where_seen(frame)
        play.click()
    sliders = [slider for slider in frame.query_selector_all("input[type=range]") if slider.is_visible()]
    for number, slider in enumerate(sliders, start=1):
        slider.scroll_into_view_if_needed()
        before = frame.evaluate(DRAWN)
        at_end = slider.evaluate("input => +input.value + +input.step > +input.max")
        slider.press("ArrowLeft" if at_end else "ArrowRight")
        if frame.evaluate(DRAWN) == before:
            failures.append(f"slider {number} of {frame.frame_element().get_attribute('title')!r} moves nothing")
    return failures


def dressed(page: Page, stages: list[Frame]) -> list[str]:
    """Stages that are too wide for the page at some width, or do not take its colours at once."""
    faults, inks = [], []
    for width in (390, 768, 1400):
        page.set_viewport_size({"width": width, "height": 844})
        page.wait_for_timeout(150)
        faults += [f"a stage is too wide at {width}" for stage in stages if stage.evaluate(OVERFLOW) > 0]
    for theme in ("dark", "light"):
        page.evaluate(f"document.body.dataset.theme = '{theme}'")
        inks.append({stage.evaluate(INK) for stage in stages})
    return faults + ["a stage does not follow the theme"] * bool(inks[0] & inks[1])


def runs_where_seen(frame: Frame) -> list[str]:
    """Whether a motion runs while it is in sight, and rests, so that it costs nothing, while it is not."""
    running = []
    for scroll in (TO_THE_PLAYER, TO_THE_END):
        frame.evaluate(scroll)
        frame.page.wait_for_timeout(300)
        before = frame.evaluate(TIME)
        frame.page.wait_for_timeout(500)
        running.append(frame.evaluate(TIME) != before)
    return [] if running == [True, False] else [f"a motion runs in sight, out of sight: {running}"]


def dead_links(page: Page, links: list[str]) -> list[str]:
    """Links within the site that lead to no page, or to no place on it."""
    dead = []
    for link in links:
        path, _, place = link.partition("#")
        if page.url.partition("#")[0] != path and not page.goto(path).ok:
            dead.append(f"no page at {link}")
        elif place and not page.evaluate(HAS_ID, place):
            dead.append(f"no such place: {link}")
    return dead


if __name__ == "__main__":
    sys.exit(main())
