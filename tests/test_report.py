"""The ledger: it holds what it should, and a verdict that is not the one found is refused."""

import functools
import inspect
import re
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import matplotlib as mpl
import nbformat
import numpy as np
import pytest
import sympy as sp

from lynx_common import arm, dh
from lynx_common.course import execute, exercises, explorers, figures, report
from lynx_common.course.report.item import Item, differs
from lynx_common.errors import InputError, LedgerError, UnknownNameError

NOTEBOOKS = Path(__file__).parents[1] / "notebooks"
HOLDS = {"where": "1.1", "says": "so", "notebook": "A1_forward_kinematics", "verdict": "holds"}
WRONG = {"verdict": "wrong: the sign is +", "because": "at x = 0 it is 1"}
x, y = sp.symbols("x y", real=True)


@functools.cache
def code_cells(notebook: str) -> list[nbformat.NotebookNode]:
    cells = nbformat.read(NOTEBOOKS / f"{notebook}.ipynb", 4).cells
    return [cell for cell in cells if cell.cell_type == "code"]


def solved(notebook: str) -> list[str]:
    """Its source, with the worked solution in place of every answer's dots."""
    cells = [cell.source for cell in code_cells(notebook)]
    exercise = {answer: name for name, answer in re.findall(r'exercises\.check\("(.+)", (.+)\)', "\n".join(cells))}
    return [
        re.sub(
            r"^(answer_\d) = \.\.\.$",
            lambda answer: exercises.catalogue()[exercise[answer[1]]].code,
            cell,
            flags=re.M,
        )
        for cell in cells
    ]


class Run(NamedTuple):
    """What came of running every notebook of the ledger, all answers filled in."""

    checked: dict[str, object]  # by key: what was handed to ``report.check``
    said: dict[str, str]  # by exercise: what is said of the answer
    unlabelled: list[str]  # axes without a name and a unit
    failures: dict[str, str]  # by notebook that did not come to its end: why


@pytest.fixture(scope="module")
def run() -> Run:
    found = Run({}, {}, [], {})
    mpl.use("agg")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(report, "check", lambda key, derived: found.checked.update({key: derived}))
        patch.setattr(
            exercises,
            "check",
            lambda name, answer: found.said.update({name: exercises.catalogue()[name].judge(answer)}),
        )
        patch.setattr(figures, "show", lambda fig, caption: found.unlabelled.extend(unlabelled(fig, caption)))
        for name, _ in inspect.getmembers(
            explorers, inspect.isfunction
        ):  # nbval runs these, too, and they take time
            patch.setattr(explorers, name, lambda *_, **__: None)
        for notebook in sorted({item.notebook for item in report.LEDGER.values()}):
            namespace: dict[str, object] = {}
            try:
                for cell in solved(notebook):
                    exec(cell, namespace)
            except Exception as fault:
                found.failures[notebook] = repr(fault)
    return found


# What has no unit: counts, shares, names.
PURE = re.compile(r"share|part of|pose$|samples|cubes|\$\\det A\$ /")


NUMBER = r"[\N{MINUS SIGN}\d.]*"  # of a tick


def unlabelled(fig: mpl.figure.Figure, caption: str) -> list[str]:
    """Axes of a figure whose numbers have no name with a unit in brackets."""
    faults = []
    for ax in [ax for ax in fig.axes if ax.axison]:
        for name in {"x", "y", "z"} & {*ax._axis_map}:
            axis = getattr(ax, f"{name}axis")
            label, ticks = axis.get_label().get_text(), [text.get_text() for text in axis.get_majorticklabels()]
            numbers = any(ticks) and all(re.fullmatch(NUMBER, text) for text in ticks)
            if numbers and not re.search(r"\[.+\]$", label) and not PURE.match(label):
                faults.append(f"{name} = {label!r} in: {caption[:50]}")
    mpl.pyplot.close(fig)
    return faults


@pytest.fixture(scope="module")
def checked(run) -> dict[str, object]:
    return run.checked


def test_every_notebook_comes_to_its_end_with_all_answers_right(run):
    assert run.failures == {}
    assert run.said == dict.fromkeys(exercises.catalogue(), "correct.")


def test_the_axes_of_every_figure_have_a_name_and_a_unit(run):
    assert run.unlabelled == []


@pytest.mark.parametrize(("label", "fault"), [("r [m]", 0), ("share of time", 0), ("r", 1), ("", 1), ("r, m", 1)])
def test_an_axis_without_a_unit_is_seen(label, fault):
    fig, ax = mpl.pyplot.subplots()
    ax.set(xlabel=label, ylabel="z [m]")
    assert len(unlabelled(fig, "a figure")) == fault


def test_every_numbered_item_of_the_report_is_there():
    counts = {"eq.": (38, 13, 4), "Table": (5, 4, 1), "Fig.": (12, 4, 2)}  # in Parts I, II and III
    keys = {
        f"{kind} {part}.{number}"
        for kind, parts in counts.items()
        for part, count in enumerate(parts, start=1)
        for number in range(1, count + 1)
    }
    assert {key for key in report.LEDGER if not key.startswith("claim")} == keys


def test_claims_are_numbered_without_a_gap():
    numbered = [(key.split(".")[0], int(key.split(".")[1])) for key in report.LEDGER if key.startswith("claim")]
    for section in {section for section, _ in numbered}:
        numbers = sorted(number for where, number in numbered if where == section)
        assert numbers == [*range(1, len(numbers) + 1)], section


def test_each_item_is_checked_by_an_executed_cell_of_its_notebook():
    for key, item in report.LEDGER.items():
        cells = [cell for cell in code_cells(item.notebook) if f'report.check("{key}"' in cell.source]
        assert len(cells) == 1, key
        printed = "".join(output.get("text", "") for output in cells[0].outputs)
        assert re.search(rf"^{re.escape(key)} (\(.+\): )?{re.escape(item.verdict)}$", printed, re.M), key


def test_each_call_that_publishes_a_figure_is_found_by_make_figures():
    for path in NOTEBOOKS.glob("*.ipynb"):
        source = "\n".join(cell.source for cell in code_cells(path.stem))
        shown = set(re.findall(r"""figures\.publish\(.*?["'](\d+\.\d+\w?|[a-z]+)["'],""", source))
        assert shown <= set(execute.published(path)), path.stem
        assert source.count("figures.publish(") == len(shown), path.stem


def test_each_figure_is_published_by_its_notebook():
    for key in [key for key in report.LEDGER if key.startswith("Fig.")]:
        published = execute.published(NOTEBOOKS / f"{report.LEDGER[key].notebook}.ipynb")
        assert any(execute.is_called(number, key[5:]) for number in published), key


def test_a_flipped_verdict_is_refused(checked, monkeypatch):
    """What the notebook derived passes with the recorded verdict, and with neither of the other two kinds."""
    verdicts = {"holds": "holds", "holds, if": "holds, if so", "wrong": "wrong: not so"}
    for key, derived in checked.items():
        item = report.LEDGER[key]
        report.check(key, derived)
        for verdict in (verdict for kind, verdict in verdicts.items() if kind != item.kind):
            flipped = replace(item, verdict=verdict, because="it is", condition={x: y}, right=item.value)
            monkeypatch.setitem(report.LEDGER, key, flipped)
            with pytest.raises(LedgerError):
                report.check(key, derived)
        monkeypatch.setitem(report.LEDGER, key, item)
    assert checked.keys() == report.LEDGER.keys()


def test_a_wrong_derivation_is_refused_for_every_kind_of_verdict(checked):
    T = dh.chain(arm.dh_table())[-1]
    wrong = T.copy()
    wrong[0, 3] = -wrong[0, 3]
    with pytest.raises(LedgerError, match=r"entry \(0, 3\)"):
        report.check("eq. 1.2", wrong)
    with pytest.raises(LedgerError, match="off by"):
        report.check("Fig. 1.2", checked["Fig. 1.2"] + [0, 0, 1e-6])
    with pytest.raises(LedgerError, match="off by"):
        report.check("Fig. 1.2", checked["Fig. 1.2"] + 1e-3j)
    with pytest.raises(LedgerError, match="entry"):
        report.check("Table 1.1", checked["Table 1.1"].subs(arm.Q[3], -arm.Q[3]))
    with pytest.raises(InputError, match="True or False"):
        report.check("claim A1.1", sp.Integer(0))


def test_digits_are_compared_to_half_a_unit_of_the_last_one():
    printed = np.array([0.2156])
    assert not differs(printed, [0.21564], 4)
    assert not differs(printed, [0.21555], 4)
    assert differs(printed, [0.21566], 4)
    assert differs(printed, [np.nan], 4)
    assert differs(printed, [0.2156, 0], 4) == "the shape is (2,), not (1,)"


def test_expressions_are_compared_by_what_they_mean():
    assert not differs(sp.sin(x) ** 2, 1 - sp.cos(x) ** 2)
    assert not differs(sp.Matrix([x + x, 0]), sp.Matrix([2 * x, 0]))
    assert not differs(sp.Eq(y, x).rhs, sp.Eq(y, x))
    assert differs(sp.sin(x), sp.cos(x)) == "entry (0, 0) is cos(x), not sin(x)"
    assert differs(sp.Matrix([x, 0]), sp.Matrix([x])) == "the shape is (1, 1), not (2, 1)"
    assert differs(sp.sqrt(x**2), x)  # equal for positive x only


def test_a_wrong_item_passes_only_with_what_is_recorded_as_right(monkeypatch):
    item = Item("eq. 9.9", printed=sp.Eq(y, x - 1), right=x + 1, **HOLDS | WRONG)
    monkeypatch.setitem(report.LEDGER, item.key, item)
    report.check("eq. 9.9", 1 + x)
    for derived in (x - 1, x + 2):
        with pytest.raises(LedgerError):
            report.check("eq. 9.9", derived)


def test_a_conditional_item_passes_only_where_the_condition_is_needed_and_enough(monkeypatch):
    verdict = {"verdict": "holds, if y = 0", "because": "at y = 1 it is x + 1"}
    item = Item("eq. 9.9", printed=x, condition={y: sp.Integer(0)}, **HOLDS | verdict)
    monkeypatch.setitem(report.LEDGER, item.key, item)
    report.check("eq. 9.9", x + y)
    for derived in (x, x + y + 1):
        with pytest.raises(LedgerError):
            report.check("eq. 9.9", derived)


def test_a_claim_under_a_condition_passes_only_where_it_is_needed_and_enough(monkeypatch):
    item = Item("claim A9.9", printed=True, **HOLDS | {"verdict": "holds, if y = 0", "because": "at y = 1 not"})
    monkeypatch.setitem(report.LEDGER, item.key, item)
    report.check("claim A9.9", (False, np.bool_(True)))
    for derived in (True, False, (True, True), (False, False), (False, True, True)):
        with pytest.raises(LedgerError, match="it is "):
            report.check("claim A9.9", derived)
    for kind, derived in {"holds": (False, True), "wrong: not so": (False, True)}.items():
        monkeypatch.setitem(report.LEDGER, item.key, replace(item, verdict=kind))
        with pytest.raises(LedgerError, match="it is False, and under a condition True"):
            report.check("claim A9.9", derived)


@pytest.mark.parametrize(
    ("verdict", "lacks"),
    [("fine", "begins with"), ("holds, if so", "substitution"), ("wrong: so", "what is right")],
)
def test_a_verdict_without_what_makes_it_one_cannot_be_recorded(verdict, lacks):
    with pytest.raises(ValueError, match=rf"eq. 9.9: .*{lacks}"):
        Item("eq. 9.9", printed=x, **HOLDS | {"verdict": verdict, "because": "it is"})


@pytest.mark.parametrize(("verdict", "kind"), [("holds, if y = 0", "holds, if"), ("wrong: so", "wrong")])
def test_an_item_that_does_not_hold_says_why(verdict, kind):
    facts = HOLDS | {"verdict": verdict, "printed": x, "condition": {y: sp.Integer(0)}, "right": y}
    with pytest.raises(ValueError, match=r"eq. 9.9: .* says why"):
        Item("eq. 9.9", **facts)
    assert Item("eq. 9.9", because="at y = 1 it is another", **facts).kind == kind


def test_a_reason_is_one_short_clause_that_the_verdict_does_not_repeat():
    for item in (item for item in report.LEDGER.values() if item.because):
        assert item.kind != "holds", item.key
        assert len(item.because.split()) <= 24, item.key
        assert not item.because.endswith("."), item.key
        assert item.because not in item.verdict, item.key


def test_an_unknown_key_gets_the_list_of_known_ones():
    near = re.escape("no item of the report 'Table 1.6'. Near it there is: Table 1.1, Table 1.2")
    with pytest.raises(UnknownNameError, match=near):
        report.check("Table 1.6", x)


def test_tables_hold_one_row_an_item():
    section = [item for item in report.LEDGER.values() if item.notebook == "A1_forward_kinematics"]
    table = report.summary("A1_forward_kinematics").data.splitlines()
    assert len(table) == 2 + len(section)
    assert all(line.count("|") == 5 for line in table)
    assert "$\\theta_{4}$ of Table 1.2" in report.summary("A1_forward_kinematics").data
    with pytest.raises(UnknownNameError):
        report.summary("A9")


def test_the_ledger_links_to_the_cell_that_checks_an_item(monkeypatch):
    monkeypatch.chdir(NOTEBOOKS)
    links = re.findall(r"\[([^]]+)\]\(([^)]+)\.ipynb#cell-id=([^)]+)\)", report.ledger().data)
    assert len(links) == len(report.LEDGER)
    for name, notebook, cell_id in links:
        key = name.replace("&nbsp;", " ")
        assert report.LEDGER[key].notebook == notebook
        (cell,) = [cell for cell in code_cells(notebook) if cell.id == cell_id]
        assert f'report.check("{key}"' in cell.source


def test_the_errata_are_what_is_printed_why_it_cannot_be_and_what_holds(monkeypatch):
    monkeypatch.chdir(NOTEBOOKS)
    lines = [line for line in report.errata().data.splitlines() if line.startswith("| ")]
    rows = [line for line in lines if line != "| item | printed | why it cannot be | what holds |"]
    assert len(lines) - len(rows) == 8  # notebooks
    assert all(row.count("|") == 5 for row in rows)
    cells = {row.split("]")[0][3:].replace("&nbsp;", " "): row.strip("| ").split(" | ")[1:] for row in rows}
    assert cells.keys() == {key for key, item in report.LEDGER.items() if item.verdict != "holds"}
    printed, because, holds = cells["eq. 1.10"]
    assert printed.endswith(r": $\theta_{4} = \operatorname{atan}\frac{R_{23}}{R_{13}}$")
    assert because.startswith("$R_{13}$ is sin($\\theta_{4}$)")
    assert holds == "it is atan2($R_{13}$, -$R_{23}$)"
    assert cells["eq. 1.4"][2].startswith("holds, if ")
    assert cells["claim A1.3"][0] == "Fig. 1.2 shows position and orientation of the gripper"
    (link,) = re.findall(r"eq.&nbsp;1.10\]\(([^)]+)\)", report.errata().data)
    assert f"({link})" in report.ledger().data


@pytest.mark.parametrize("listed", [report.ledger, report.errata])
def test_the_index_folds_its_lists_by_notebook_in_their_order(listed, monkeypatch):
    """A blank line around each table, or it is not one."""
    monkeypatch.chdir(NOTEBOOKS)
    folded = re.findall(
        r"<details><summary>([^:]+): (\d+) \w+</summary>\n\n(.+?)\n\n</details>", listed().data, re.S
    )
    assert [name for name, _, _ in folded] == sorted(name for name, _, _ in folded)
    assert folded[-1][0] == "Part 3. Singularity avoidance"
    for _, number, table in folded:
        assert len(table.splitlines()) == 2 + int(number)


def test_names_of_lengths_and_angles_are_typeset():
    table = report.summary("Part2_parallel_robot").data
    for words in ("$r_{platform}$ and $r_{base}$ in mm", "with $\\alpha$ the workspace", "t = tan($\\theta$ / 2)"):
        assert words in table
