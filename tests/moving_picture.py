"""Draw the README's moving picture, .github/arm.gif, from a stage of B2, in a real Chromium.

Run as `.venv-browser/bin/python tests/moving_picture.py`; with the same Chromium it draws the same bytes.
"""

import base64
import io

from browser_check import BROWSER_FLAGS, ROOT, chromium
from PIL import Image
from playwright.sync_api import sync_playwright
from stage_check import stages

FRAMES, SIZE, COLOURS = 72, {"width": 560, "height": 420}, 48
PICTURE = "document.querySelector('canvas').toDataURL()"


def main() -> None:
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium(), args=BROWSER_FLAGS)
        page = browser.new_page(viewport=SIZE)
        page.set_content(f"<!doctype html><body style='margin:0;background:#ffffff'>{stages()['B2-1']}")
        page.wait_for_timeout(500)
        stage = page.frames[1]
        stage.evaluate("stop()")
        seconds = stage.evaluate("motion.seconds")
        drawn = [stage.evaluate(f"show({number / FRAMES}), {PICTURE}") for number in range(FRAMES)]
        browser.close()
    frames = [on_white(url) for url in drawn]
    palette = frames[FRAMES // 4].quantize(COLOURS, dither=Image.Dither.NONE)
    frames = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    file, pause = ROOT / ".github" / "arm.gif", round(1000 * seconds / FRAMES)
    frames[0].save(file, save_all=True, append_images=frames[1:], duration=pause, loop=0)
    print(f"{file}: {file.stat().st_size / 1000:.0f} kB, {frames[0].size}")


def on_white(url: str) -> Image.Image:
    """A picture of the canvas, without the empty strip above the arm."""
    picture = Image.open(io.BytesIO(base64.b64decode(url.partition(",")[2])))
    white = Image.new("RGBA", picture.size, "white")
    white.alpha_composite(picture)
    return white.convert("RGB").crop((0, 60, *picture.size))


if __name__ == "__main__":
    main()
