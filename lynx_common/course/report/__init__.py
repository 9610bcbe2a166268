"""The ledger: what the report prints, as data, and whether it holds.

Every equation, table and figure of the report, and every sentence of it that can be true or false, is an
``Item`` with the place where it stands and a verdict. A notebook derives the same thing on its own and hands
it to ``check``, which raises if the recorded verdict is not the one that it finds. Nothing here is computed
with the robots' modules, so that nothing can be compared with itself.
"""

import json
import re
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from importlib import import_module
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp
from IPython.display import Markdown

from ...errors import LedgerError, UnknownNameError
from ...symbolic import TASK
from .item import Item, differs, judged_otherwise

MODULES = ("a1", "a2", "a3", "b1", "b2", "b3", "part2", "part2_results", "part3")
LETTERS = {TASK[3]: r"\varphi"}  # the pitch, as the notebooks write it
CHECKED = re.compile(r'report\.check\("([^"]+)"')
NAME = re.compile(r"\b(?:(theta|[A-Za-z])_(\d+|[A-Za-z]|base|platform)|alpha|theta)\b")


def _items(name: str) -> Iterator[Item]:
    """What module ``name`` says: its notebook, and at each place of the report the facts of each item, by key."""
    module = import_module(f".{name}", __name__)
    for where, group in module.PRINTED.items():
        yield from (Item(key, where, module.NOTEBOOK, **facts) for key, facts in group.items())


LEDGER = {item.key: item for name in MODULES for item in _items(name)}


def printed(key: str) -> np.ndarray | sp.Basic | bool:
    """What the report prints as item ``key``, e.g. "Fig. 1.2": an array, or the right side of an equation."""
    return _find(key).value


def check(key: str, derived: np.ndarray | sp.Basic | bool | tuple[bool, bool]) -> None:
    """Compare what was ``derived`` with what is printed as item ``key``, and print the verdict.

    Parameters
    ----------
    key : "eq. 1.1", "Table 1.3", "Fig. 1.2" or "claim A1.1"
    derived : expression or matrix (compared symbolically), numbers (to the digits printed), or for a claim
        whether it was found true; for one that *holds, if*: whether as it stands, and whether as it may be meant

    Raises LedgerError unless the recorded verdict is the one found. An item *holds* where both agree;
    *holds, if* where they do not agree in general, but under the recorded condition; it is *wrong* where they
    do not agree and ``derived`` is what is recorded as right.
    """
    item = _find(key)
    if found := _contradiction(item, derived):
        raise LedgerError(key, item.verdict, found)
    print(f"{key} ({item.says}): {item.verdict}" if item.printed is True else f"{key} {item.verdict}")


def _contradiction(item: Item, derived: Any) -> str:
    """In which way ``derived`` contradicts the recorded verdict; empty where it does not."""
    if item.printed is True:
        return judged_otherwise(item.kind, derived)
    difference = differs(item.value, derived, item.digits)
    if item.kind == "holds":
        return difference
    if not difference:
        return "it agrees with what is printed"
    if item.kind == "wrong":
        return differs(item.right, derived, item.digits)
    if isinstance(item.value, np.ndarray):
        return "numbers hold or not, without conditions"
    return differs(item.value, derived.xreplace(item.condition), item.digits)


def summary(notebook: str) -> Markdown:
    """The items of the ledger that ``notebook`` (its stem) checks, as a table."""
    items = [item for item in LEDGER.values() if item.notebook == notebook]
    if not items:
        raise UnknownNameError("notebook in the ledger", notebook, sorted({i.notebook for i in LEDGER.values()}))
    return _table(items)


def ledger() -> Markdown:
    """All items, by notebook; each links to the cell that checks it, in a notebook beside the one that asks."""
    return _folded(LEDGER.values(), lambda items: _table(items, linked=True), "item")


def errata() -> Markdown:
    """The items that do not hold as printed, each with a link to the cell that shows it, and what holds."""
    return _folded((item for item in LEDGER.values() if item.kind != "holds"), _corrections, "correction")


def _folded(items: Iterable[Item], table: Callable, noun: str) -> Markdown:
    """One table a notebook, each shown when its name is clicked."""
    parts = []
    for notebook, group in groupby(sorted(items, key=_reading_order), key=lambda item: item.notebook):
        listed = list(group)
        number, *words = notebook.replace("Part", "Part ").split("_")
        heading = f"{number}. {' '.join(words).capitalize()}: {len(listed)} {noun}{'s' * (len(listed) > 1)}"
        parts.append(f"<details><summary>{heading}</summary>\n\n{table(listed).data}\n\n</details>\n")
    return Markdown("\n".join(parts))


def _corrections(items: Iterable[Item]) -> Markdown:
    rows = (
        (_link(item), _as_printed(item), _typeset(item.because), _typeset(item.verdict.removeprefix("wrong: ")))
        for item in items
    )
    return _markdown(("item", "printed", "why it cannot be", "what holds"), rows)


def _table(items: Iterable[Item], linked: bool = False) -> Markdown:
    rows = (
        (_link(item) if linked else _name(item), item.where, _typeset(item.says), _typeset(item.verdict))
        for item in sorted(items, key=_reading_order)
    )
    return _markdown(("item", "report", "what it says", "verdict"), rows)


def _markdown(header: Iterable[str], rows: Iterable[Iterable[str]]) -> Markdown:
    head, *body = (f"| {' | '.join(cells)} |" for cells in (header, *rows))
    return Markdown("\n".join([head, "|:--|:--|:--|:--|", *body]))


def _name(item: Item) -> str:
    return item.key.replace(" ", "&nbsp;")


def _link(item: Item) -> str:
    return f"[{_name(item)}]({item.notebook}.ipynb#cell-id={_checking_cells(item.notebook)[item.key]})"


def _as_printed(item: Item) -> str:
    """What the item says; an equation also in the course's symbols."""
    if not isinstance(item.printed, sp.Eq):
        return _typeset(item.says)
    formula = sp.latex(item.printed, symbol_names=LETTERS, fold_func_brackets=True, order="none")
    return f"{_typeset(item.says)}: ${formula}$"


@cache
def _checking_cells(notebook: str) -> dict[str, str]:
    """Identifiers of the cells that call ``check``, by key."""
    cells = json.loads(Path(f"{notebook}.ipynb").read_text(encoding="utf-8"))["cells"]
    calls = ((key, cell["id"]) for cell in cells for key in CHECKED.findall("".join(cell["source"])))
    return dict(calls)


def _typeset(text: str) -> str:
    """``text`` with names such as alpha, theta_4, S_A and r_base as mathematics."""
    return NAME.sub(_symbol, text)


def _symbol(name: re.Match) -> str:
    letter, index = name.groups()
    letter = {"theta": r"\theta", None: f"\\{name[0]}"}.get(letter, letter)
    return f"${letter}_{{{index}}}$" if index else f"${letter}$"


def _reading_order(item: Item) -> tuple:
    kind = ("eq.", "Table", "Fig.", "claim").index(item.key.split()[0])
    return item.notebook, kind, [int(n) for n in re.findall(r"\d+", item.key)]


def _find(key: str) -> Item:
    if key not in LEDGER:
        raise UnknownNameError("item of the report", key, list(LEDGER))
    return LEDGER[key]
