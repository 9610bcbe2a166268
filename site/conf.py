"""The course as a static site, from the notebooks as they are committed: `make site`.

Nothing is executed, and nothing is asked of another machine, now or when the site is read.
"""

import importlib.util
import json
import os
import re
import unicodedata
from pathlib import Path

import nbformat
from docutils import nodes
from myst_nb.sphinx_ import HideCodeCellNode

# "owner/name" on GitHub, which its workflows set; where there is one, every page can be opened in Binder.
REPOSITORY = os.environ.get("GITHUB_REPOSITORY", "")
# The robots that move on the front page: a notebook, and the title of one of its stages.
ON_STAGE = {
    "B2_animation": "The arm in motion",
    "Part2_parallel_robot": "The parallel robot in motion; its needle draws a circle",
    "Part3_singularity_avoidance": "The arm and the falling ball",
}

project = "Robot kinematics"
html_title = "Robot kinematics, a course in notebooks"
extensions = ["myst_nb", "sphinx_copybutton"]
root_doc = "00_index"
exclude_patterns = [".ipynb_checkpoints"]

nb_execution_mode = "off"
nb_render_markdown_format = "myst"  # captions and tables hold mathematics, too
myst_enable_extensions = ["dollarmath", "amsmath"]
myst_heading_anchors = 3
copybutton_selector = "div.cell_input div.highlight pre"

MATHJAX = Path(importlib.util.find_spec("sphinx-mathjax-offline").origin).parent / "static/mathjax"
html_static_path = [str(MATHJAX / "tex-svg-full.js"), "static"]
mathjax_path = "tex-svg-full.js"
mathjax3_config = {"options": {"enableMenu": False}}  # whose entries would load more

html_theme = "furo"
pygments_dark_style = "github-dark"
html_theme_options = {"top_of_page_buttons": []}
templates_path = ["templates"]
html_additional_pages = {"index": "front.html"}
html_css_files = ["course.css"]
html_js_files = [("course.js", {"defer": "defer"})]
html_sourcelink_suffix = ""  # the notebooks themselves are what can be taken away
html_show_sphinx = html_show_copyright = html_use_index = False


def prepare(app, docname, source):
    """Give a notebook what a page needs: the menu, anchors for its cells, code that can be hidden."""
    notebook = nbformat.reads(source[0], as_version=4)
    for cell in notebook.cells:
        cell.metadata["anchor"] = f"cell-id={cell.id}"  # as in JupyterLab's links
        cell.metadata["tags"] = [*cell.metadata.get("tags", []), "hide-input"]
        outputs = [output.get("metadata", {}) for output in cell.get("outputs", [])]
        cell.metadata["alts"] = [words["image/png"]["alt"] for words in outputs if "image/png" in words]
    if docname == root_doc:
        menu = "```{toctree}\n:hidden:\n:glob:\n\nself\n*\n```"
        notebook.cells.append(nbformat.v4.new_markdown_cell(menu))
    source[0] = nbformat.writes(notebook)


def finish(app, doctree):
    """Let links lead to the very cell, and give each picture its words."""
    places = app.env.metadata[app.env.docname].setdefault("myst_slugs", {})
    for node in doctree.findall(nodes.container):
        if node.get("nb_element") == "cell_code":
            name = node["cell_metadata"]["anchor"]
            node["ids"].append(name)
            places[name] = None, name, ""
            for image, alt in zip(node.findall(nodes.image), node["cell_metadata"]["alts"], strict=True):
                image["alt"] = in_words(alt)


def in_words(markdown):
    """A caption without its marks, its formulas as plain text."""
    return re.sub(r"\$(.*?)\$", lambda formula: plain(formula[1]), markdown.replace("**", ""))


def plain(latex):
    """A formula as text: letters, signs and lower indices; an ellipsis for what only typesetting can show."""
    text = re.sub(r"\\(?:math\w+|text|operatorname)\{(\w+)\}", r"\1", latex)
    text = re.sub(r"\\([A-Za-z]+)", sign, re.sub(r"\\[,;:! ]|\\q?quad", " ", text))
    text = re.sub(r"_\{?(\d+)\}?", lambda digits: digits[1].translate(LOW), text)
    text = re.sub(r"_\{([^{}]*)\}", r"_\1", text)
    return "…" if re.search(r"[\\{}&]", text) else " ".join(text.split())


LOW = {ord("0") + digit: chr(ord("₀") + digit) for digit in range(10)}
SIGNS = {"cdot": "·", "pm": "±", "le": "≤", "ge": "≥", "leq": "≤", "geq": "≥", "circ": "°", "in": "∈", "to": "→"}
SIGNS |= {"infty": "∞", "approx": "≈", "ne": "≠", "varphi": "φ"}
SIGNS |= {"times": "\N{MULTIPLICATION SIGN}", "left": "", "right": ""}
SIGNS |= {name: f"{name} " for name in ("sin", "cos", "tan", "atan", "det", "max", "min")}


def sign(macro):
    """The sign or letter that a macro stands for; the macro where there is none."""
    for capital in ("SMALL", "CAPITAL")[macro[1][0].isupper() :]:
        if letter := LETTERS.get(f"GREEK {capital} LETTER {macro[1].upper()}"):
            return letter
    return SIGNS.get(macro[1], macro[0])


LETTERS = {unicodedata.name(chr(code)): chr(code) for code in (*range(0x391, 0x3A2), *range(0x3A3, 0x3CA))}


class Words(nodes.GenericNodeVisitor):
    """The words of a page, without code and stages, its formulas as plain text."""

    def __init__(self, document):
        super().__init__(document)
        self.found = []

    def default_visit(self, node):
        if isinstance(node, nodes.literal_block | nodes.raw | nodes.image):
            raise nodes.SkipNode
        if isinstance(node, nodes.math | nodes.math_block):
            self.found.append(plain(node.astext()))
            raise nodes.SkipNode
        if isinstance(node, nodes.Text):
            self.found.append(str(node))
        elif isinstance(node, nodes.TextElement) and not isinstance(node, nodes.Inline):
            self.found.append(" ")

    unknown_visit = default_visit

    def default_departure(self, node):
        pass

    unknown_departure = default_departure


def fill(app, pagename, templatename, context, doctree):
    """What the pages hold besides their notebook."""
    context.update(repository=REPOSITORY, master_doc="index")
    if pagename == "index":
        context["stages"] = [
            (name, app.env.titles[name].astext(), on_stage(app.srcdir / f"{name}.ipynb", title))
            for name, title in ON_STAGE.items()
        ]
    if doctree:
        doctree.walkabout(words := Words(doctree))
        app.env.words[pagename] = " ".join("".join(words.found).split())


def on_stage(path, title):
    """A stage as it is stored: it needs nothing but itself."""
    outputs = [output for cell in nbformat.read(path, as_version=4).cells for output in cell.get("outputs", [])]
    return next(page for o in outputs if f'title="{title}"' in (page := o.get("data", {}).get("text/html", "")))


def keep_words(app, _):
    """Excerpts for the search, which has to find them without a server, too."""
    text = json.dumps(app.env.words, ensure_ascii=False)
    (app.outdir / "_static" / "words.js").write_text(f"const WORDS = {text};\n", encoding="utf-8")


def open_code(self, node):
    """Code that draws is there for those who ask for it; all other code, until somebody hides it."""
    drawing = "tag_drawing" in node.parent["classes"]
    kind = 'class="code drawing"' if drawing else 'class="code" open'
    self.body.append(f"<details {kind}><summary>Code</summary>")


def close_code(self, node):
    self.body.append("</details>\n")


def setup(app):
    app.connect("builder-inited", lambda app: setattr(app.env, "words", getattr(app.env, "words", {})))
    app.connect("source-read", prepare)
    app.connect("doctree-read", finish)
    app.connect("html-page-context", fill)
    app.connect("build-finished", keep_words)
    app.add_node(HideCodeCellNode, override=True, html=(open_code, close_code))
