"""Read the built site in a real Chromium that reaches no other machine: each page, link and slider; on paper, too.

Run by `make browser`, not by pytest. It opens build/site, as `make site` leaves it, without a server. What is
printed of the pages goes to build/paper.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from urllib.parse import unquote, urlsplit

from browser_check import BROWSER_FLAGS, ROOT, chromium, listen, say
from playwright.sync_api import Browser, Frame, Page, sync_playwright
from playwright.sync_api import TimeoutError as BrowserTimeout

SITE, PAPER = ROOT / "build" / "site", ROOT / "build" / "paper"
ADDRESS = SITE.as_uri()
SEARCHED = ("elbow", "jacobian", "theta", "pitch", "determinant", "clearance")
PAPER_WIDTH = 680  # pixels between the margins of A4
# Asked of a page, or of a stage on it.
MATHEMATICS = "document.querySelectorAll('mjx-container').length"
MATHEMATICS_WANTED = "document.querySelectorAll('.math').length"
FAULTY_MATHEMATICS = "document.querySelectorAll('mjx-merror, [data-mjx-error]').length"
BROKEN_PICTURES = "[...document.images].filter(i => !(i.complete && i.naturalWidth)).map(i => i.src)"
WITHOUT_WORDS = (
    r"[...document.images].filter(i => !i.alt.includes(' ') || /[$\\*]|_images|\.png/.test(i.alt)).map(i => i.src)"
)
LINKS = "[...document.querySelectorAll('a[href]')].map(a => a.href)"
ALL_TYPESET = f"{MATHEMATICS} >= {MATHEMATICS_WANTED}"
DRAWN = "[...document.querySelectorAll('canvas')].map(c => c.toDataURL()).join()"
OVERFLOW = "document.documentElement.scrollWidth - innerWidth"
# What is wider than its place and cannot be scrolled; on paper nothing can.
CUT_OFF = """onPaper => [...document.querySelectorAll("article *:not(iframe):not(mjx-container *)")].filter(e => {
    const {overflowX} = getComputedStyle(e), {right, width} = e.getBoundingClientRect();
    const cut = onPaper ? overflowX !== "visible" : overflowX === "hidden" || overflowX === "clip";
    const inside = !onPaper && e.parentNode.closest("pre, .highlight, .math, .table-wrapper");
    return cut && e.scrollWidth > e.clientWidth + 1 || !inside && width > 1 && right > innerWidth + 10;
}).map(e => e.tagName + " " + e.textContent.trim().slice(0, 60))"""
OVERLAP = """[...document.querySelectorAll("article section > *, .cell > *")].filter(e => {
    const next = e.nextElementSibling?.getBoundingClientRect(), own = e.getBoundingClientRect();
    return next?.height && own.height && getComputedStyle(e).float === "none" && next.top < own.bottom - 2;
}).map(e => e.textContent.trim().slice(0, 60))"""
STILLS = """[...document.querySelectorAll(".still")].map(still => [...still.querySelectorAll("img")]
    .filter(i => i.src.length > 4000 && i.alt && i.getBoundingClientRect().height > 50).length)"""
STAGES = "[...document.querySelectorAll('iframe[srcdoc]')]"
CODE = "[...document.querySelectorAll('.cell_input')].filter(e => e.checkVisibility()).length"
DRAWINGS = "document.querySelectorAll('.tag_drawing').length"
CELLS = "document.querySelectorAll('.cell_input').length"
INK = "getComputedStyle(document.body).color"
TIME = "document.getElementById('time').value"
TO_THE_PLAYER = "document.getElementById('views').scrollIntoView({behavior: 'instant'})"
TO_THE_END = "top.scrollTo({top: top.document.body.scrollHeight, behavior: 'instant'})"
HAS_ID = "id => document.getElementById(decodeURIComponent(id)) !== null"
REFUSE = (
    "Object.defineProperty(window, 'localStorage', {configurable: true, get() { throw new Error('refused'); }})"
)


def main() -> int:
    if not (SITE / "index.html").exists():
        sys.exit(f"There is no site in {SITE}; run `make site` first.")
    if not chromium():
        sys.exit("There is no Chromium on this machine; install one (apt install chromium).")
    PAPER.mkdir(parents=True, exist_ok=True)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium(), args=BROWSER_FLAGS)
        page = browser.new_page(viewport={"width": 1400, "height": 1000})
        page.route(lambda url: url.startswith("http"), lambda route: route.abort())
        foreign, faults = listen(page, ADDRESS)
        failures = check(page) + front(page) + searched(page) + taken_away(page) + refused(browser)
        browser.close()
    failures += [f"asks for {url}" for url in foreign] + [f"error in a page: {fault}" for fault in faults]
    failures += [f"not for readers: {path}" for path in SITE.rglob("*") if ".doctrees" in path.parts]
    failures += binder()
    for failure in failures:
        print(f"FAILED: {failure}", file=sys.stderr)
    return int(bool(failures))


def check(page: Page) -> list[str]:
    """What fails on any page, a sentence each."""
    failures, links, moved = [], set(), 0
    for path in sorted(SITE / name for name in sys.argv[1:]) or sorted(SITE.glob("*.html")):
        page.goto(path.as_uri())
        page.wait_for_load_state("load")
        found = mathematics(page)
        found += [f"no picture at {source}" for source in page.evaluate(BROKEN_PICTURES)]
        found += [f"no words for the picture {source}" for source in page.evaluate(WITHOUT_WORDS)]
        explorers = [frame for frame in page.frames[1:] if frame.query_selector("input[type=range]")]
        found += [fault for frame in explorers for fault in still(frame)] + dressed(page, explorers)
        found += hidden(page) if page.evaluate(CELLS) else []
        found += printed(page, path.stem)
        moved += len(explorers)
        links.update(page.evaluate(LINKS))
        failures += [f"{path.name}: {fault}" for fault in found]
        say(path.name, f"{page.evaluate(MATHEMATICS)} formulas, {len(explorers)} stages")
    local = sorted(link for link in links if link.startswith(ADDRESS))
    say("links", len(local))
    return failures + dead_links(page, local) + ["no stage moves"] * (moved == 0)


def front(page: Page) -> list[str]:
    """Whether the front page's robots move by themselves, and lead on."""
    page.goto(f"{ADDRESS}/index.html")
    stages = page.frames[1:]
    rest = []
    for number, stage in enumerate(stages, start=1):
        stage.evaluate(TO_THE_PLAYER)
        page.wait_for_timeout(300)
        before = stage.evaluate(DRAWN)
        page.wait_for_timeout(500)
        rest += [f"stage {number} of the front page rests"] * (stage.evaluate(DRAWN) == before)
    paths = [section.locator("ol a").count() for section in page.locator(".paths section").all()]
    return rest + ["the front page has no stage"] * (not stages) + [f"two paths: {paths}"] * (paths != [4, 8])


def searched(page: Page) -> list[str]:
    """Whether what is found has an excerpt in words."""
    faults = []
    for word in SEARCHED:
        page.goto(f"{ADDRESS}/search.html?q={word}")
        page.wait_for_selector("#search-results li", timeout=10_000)
        page.wait_for_timeout(400)
        excerpts = page.locator("#search-results p.context").all_inner_texts()
        faults += [f"no excerpt for {word!r}"] * (
            len(excerpts) < page.locator("#search-results li.kind-text").count()
        )
        faults += [f"an excerpt for {word!r} is not in words: {e}" for e in excerpts if set("\\{}$") & set(e)]
        say(f"found for {word!r}", len(excerpts))
    return faults


def taken_away(page: Page) -> list[str]:
    """Whether each page gives its own notebook, copies its code, and leads to its neighbours."""
    faults, names = [], sorted(path.stem for path in (ROOT / "notebooks").glob("*.ipynb"))
    for place, name in enumerate(names):
        page.goto(f"{ADDRESS}/{name}.html")
        path = SITE / page.locator(".take a[download]").get_attribute("href")
        given = path.name == f"{name}.ipynb" and path.read_bytes() == (ROOT / "notebooks" / path.name).read_bytes()
        faults += [f"{name} gives another notebook: {path}"] * (not given)
        faults += [f"{name} leads to Binder, where no repository is set"] * page.locator(
            "a[href*=mybinder]"
        ).count()
        for css, neighbour in ((".prev-page", place - 1), (".next-page", place + 1)):
            if 0 <= neighbour < len(names):
                faults += [f"{name} has no {css}"] * (
                    page.locator(css).get_attribute("href") != names[neighbour] + ".html"
                )
        code, box = page.locator(".cell_input").first, page.locator(".sidebar-search")
        code.hover()
        code.locator("button.copybtn").click()
        box.fill("")
        box.press("Control+v")
        wanted = code.locator("pre").inner_text().split("\n")[0]
        faults += [f"{name} copies {box.input_value()!r}"] * (not box.input_value().startswith(wanted))
    return faults


def hidden(page: Page) -> list[str]:
    """Code starts shown, but for drawings; hidden, it stays so on the next visit, until it is asked for."""
    button, states = page.locator("#hide"), [page.evaluate(CODE)]
    for _ in range(2):
        button.click()
        states.append(page.evaluate(CODE))
        page.reload()
        states.append(page.evaluate(CODE))
    shown = page.evaluate(CELLS) - page.evaluate(DRAWINGS)
    return (
        [] if states == [shown, 0, 0, shown, shown] else [f"of {shown} cells are seen, hidden and shown: {states}"]
    )


def refused(browser: Browser) -> list[str]:
    """Where the browser refuses to remember anything, code can still be hidden."""
    page = browser.new_page()
    page.add_init_script(REFUSE)
    _, faults = listen(page, ADDRESS)
    page.goto(f"{ADDRESS}/A1_forward_kinematics.html")
    page.locator("#hide").click()
    if page.evaluate(CODE):
        faults.append("code stays")
    return [f"without storage: {fault}" for fault in faults]


def printed(page: Page, name: str) -> list[str]:
    """Whether paper has a picture of every stage, nothing cut off, and no thing upon another."""
    page.set_viewport_size({"width": PAPER_WIDTH, "height": 1000})
    page.evaluate(
        "document.body.dataset.theme = 'dark'; addEventListener('beforeprint', () => { window.told = true; })"
    )
    page.pdf(path=PAPER / f"{name}.pdf", format="A4", prefer_css_page_size=True)
    faults = [] if page.evaluate("window.told") else ["the page is not told that it is printed"]
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    page.wait_for_timeout(200)
    stills, stages = page.evaluate(STILLS), page.evaluate(f"{STAGES}.length")
    faults += [f"pictures of {stages} stages on paper: {stills}"] * (len(stills) != stages or 0 in stills)
    faults += ["a stage is printed as it is"] * page.evaluate(f"{STAGES}.some(stage => stage.checkVisibility())")
    faults += [f"cut off on paper: {what}" for what in page.evaluate(CUT_OFF, True)]
    faults += [f"something lies upon another on paper: {what}" for what in page.evaluate(OVERLAP)]
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    faults += ["pictures of stages stay after printing"] * len(page.evaluate(STILLS))
    page.emulate_media(media="null")
    page.set_viewport_size({"width": 1400, "height": 1000})
    return faults


def binder() -> list[str]:
    """Whether every notebook leads to Binder where a repository is named."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            ROOT / ".venv-site/bin/python",
            "-m",
            "sphinx",
            "-q",
            "-c",
            ROOT / "site",
            "-d",
            f"{folder}/doctrees",
        ]
        environment = os.environ | {"GITHUB_REPOSITORY": "owner/name"}
        subprocess.run([*command, ROOT / "notebooks", f"{folder}/site"], check=True, env=environment)
        pages = [path.stem for path in (ROOT / "notebooks").glob("*.ipynb")]
        address = "https://mybinder.org/v2/gh/owner/name/HEAD?labpath=notebooks%2F{}.ipynb"
        texts = {name: Path(folder, "site", f"{name}.html").read_text(encoding="utf-8") for name in pages}
        return [f"{name} does not lead to Binder" for name in pages if address.format(name) not in texts[name]]


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
    if play.is_visible() and not frame.evaluate("challenges.length") and frame.page.query_selector("#hide"):
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
    """What is too wide for the page at some width; stages that do not take its colours at once."""
    faults, inks = [], []
    for width in (320, 390, 768, 1400):
        page.set_viewport_size({"width": width, "height": 844})
        page.wait_for_timeout(150)
        faults += [f"the page is too wide at {width}"] * (page.evaluate(OVERFLOW) > 0)
        faults += [f"cut off at {width}: {what}" for what in page.evaluate(CUT_OFF, False)]
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
        if not Path(unquote(urlsplit(path).path)).is_file():
            dead.append(f"no page at {link}")
        elif place:
            if page.url.partition("#")[0] != path:
                page.goto(path)
            dead += [f"no such place: {link}"] * (not page.evaluate(HAS_ID, place))
    return dead


if __name__ == "__main__":
    sys.exit(main())
