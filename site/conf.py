"""The course as a static site, from the notebooks as they are committed: `make site`.

Nothing is executed, and nothing is asked of another machine, now or when the site is read.
"""

import importlib.util
from pathlib import Path

import nbformat
from docutils import nodes

project = "Robot kinematics"
html_title = "Robot kinematics, a course in notebooks"
extensions = ["myst_nb"]
root_doc = "00_index"
exclude_patterns = [".ipynb_checkpoints"]

nb_execution_mode = "off"
nb_render_markdown_format = "myst"  # captions and tables hold mathematics, too
myst_enable_extensions = ["dollarmath", "amsmath"]
myst_heading_anchors = 3

MATHJAX = Path(importlib.util.find_spec("sphinx-mathjax-offline").origin).parent / "static/mathjax"
html_static_path = [str(MATHJAX / "tex-svg-full.js")]
mathjax_path = "tex-svg-full.js"
mathjax3_config = {"options": {"enableMenu": False}}  # whose entries would load more

html_theme = "furo"
html_extra_path = ["index.html"]
html_show_sphinx = html_copy_source = html_use_index = False


def prepare(app, docname, source):
    """Give a notebook what a page needs: the menu, anchors for its cells, words for pictures."""
    notebook = nbformat.reads(source[0], as_version=4)
    for cell in notebook.cells:
        cell.metadata["anchor"] = f"cell-id={cell.id}"  # as in JupyterLab's links
        for output in cell.get("outputs", []):
            if alt := output.get("metadata", {}).get("image/png", {}).get("alt"):
                cell.metadata["mystnb"] = {"image": {"alt": alt}}
    if docname == root_doc:
        menu = "```{toctree}\n:hidden:\n:glob:\n\n*\n```"
        notebook.cells.append(nbformat.v4.new_markdown_cell(menu))
    source[0] = nbformat.writes(notebook)


def anchor(app, doctree):
    """Let links lead to the very cell."""
    places = app.env.metadata[app.env.docname].setdefault("myst_slugs", {})
    for node in doctree.findall(nodes.container):
        if node.get("nb_element") == "cell_code":
            name = node["cell_metadata"]["anchor"]
            node["ids"].append(name)
            places[name] = None, name, ""


def setup(app):
    app.connect("source-read", prepare)
    app.connect("doctree-read", anchor)
