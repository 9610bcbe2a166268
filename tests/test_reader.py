"""The reader's name: numbers drawn from it, and what is kept under it."""

import json
import re
from functools import cache

import numpy as np
import pytest

from lynx_common import rrr, screws
from lynx_common.course import exercises
from lynx_common.course.exercises import part2, reader
from lynx_common.course.exercises.exercise import RIGHT, TOLERANCE
from lynx_common.errors import InputError, LynxError, UnknownNameError, WrongAnswerError

CATALOGUE = exercises.catalogue()
OWN = [name for name, exercise in CATALOGUE.items() if exercise.numbers]
NAMES = [
    f"{first} {last}" for first in ("Ada", "Émile", "Lì", "李", "Mary", "Noé", "Olu", "Zoë") for last in range(25)
]
own = pytest.mark.parametrize("name", OWN)


@pytest.fixture(autouse=True)
def nobody(tmp_path, monkeypatch):
    """No name, and a folder of its own, before each test and after it."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(reader, "name", "")
    monkeypatch.setattr(reader, "_record", {})


@cache
def for_all_names(name):
    return [exercises.find(name, student) for student in NAMES]


def entry(name):
    return exercises._of(name.partition(".")[0].lower().replace("p", "part"))[name]


def test_every_notebook_has_an_exercise_that_takes_its_numbers_from_the_name():
    notebooks = {name.partition(".")[0] for name in CATALOGUE}
    assert {name.partition(".")[0] for name in OWN} == notebooks


@own
def test_for_200_names_the_key_passes_and_no_misconception_is_taken_for_it(name):
    for exercise in for_all_names(name):
        assert exercise.judge(exercise.right) == RIGHT, exercise.numbers
        for answer, said in exercise.misconceptions:
            if not callable(answer):
                assert exercise.judge(answer) == f"not yet: {said}", exercise.numbers


# By exercise: how far its numbers are from where the task has no answer, or two; each has to be positive.
def whole_arm(d_1, L_1, L_2):
    return min(L_1, L_2) - 0.1, d_1 - 0.2


def ring_with_a_gap(L_1, L_2, first, second, slide):
    """The first joint does not close the ring, and the second leaves a hole in it."""
    hole = np.sqrt(L_1**2 + L_2**2 + 2 * L_1 * L_2 * np.cos(np.deg2rad(second)))
    return 150 - first, first - 100, hole - 0.08, slide - 0.05


def targets_on_both_sides_of_the_column(d_1, L_1, L_2):
    return L_2 - L_1 - 0.03, L_1 - 0.15, 0.95 - L_1 / L_2


def below_and_within_reach(boom, stick, bucket, joint, depth):
    return 0.5 - (joint + depth - bucket) / (boom + stick), joint + depth - bucket - 1, depth - bucket - 0.4


def neither_folded_nor_stretched(link, start):
    return 0.85 - start / (2 * link), start / (2 * link) - 0.52


def in_the_way_but_not_at_the_ends(distance, pillar, robot, margin, aside):
    keep = pillar + robot + margin
    return keep - aside - 0.2, np.hypot(distance / 2, aside) - keep - 0.25


def one_loose_pose(r_base, r_platform, S_A, L):
    """At this turn A is singular in one working mode, and with distal links that point outward in none."""
    geometry, turn = rrr.Geometry(S_A, L, r_platform, r_base), part2.corner(r_base, r_platform, S_A, L)
    pose = [0, 0, turn]
    loose = [np.linalg.det(rrr.jacobians(pose, q, geometry)[0]) for q in rrr.inverse_kinematics(pose, geometry)]
    return r_base - abs(r_platform - L) - 1.05 * S_A, 0.9 - np.cos(turn), 1e-6 - min(map(abs, loose))


def moments_that_count(f_x, f_y, f_z, x, y, z):
    m = np.cross([x, y, z], [f_x, f_y, f_z])
    axes = screws.revolute([0, 0, 1], [[0, 0, 0], [0.3, 0, 0], [0.5, 0.2, 0]])
    twists = np.column_stack([*axes, screws.prismatic([0, 0, 1])])
    return np.abs(m).min() - 0.02 * np.abs(m).max(), 1e-9 - np.abs(twists.T @ [0, 0, 0, *m[:2], 0]).max()


def a_share_that_is_small(limit, sigma):
    return 0.9 - 1 / (2 * limit), sigma - 1.5


MARGINS = {
    "A1.3": whole_arm,
    "A2.3": ring_with_a_gap,
    "A3.3": targets_on_both_sides_of_the_column,
    "B1.3": below_and_within_reach,
    "B2.3": neither_folded_nor_stretched,
    "B3.3": in_the_way_but_not_at_the_ends,
    "P2.7": one_loose_pose,
    "P3.2": moments_that_count,
    "P3.6": a_share_that_is_small,
}


@own
def test_the_task_is_well_posed_for_200_names_and_as_printed(name):
    for exercise in [CATALOGUE[name], *for_all_names(name)]:
        assert min(MARGINS[name](*exercise.numbers)) > 0, exercise.numbers


APART = 3  # tolerances, for every name; as printed 2.3 (B3.3)


@own
def test_for_200_names_every_misconception_is_well_beyond_the_tolerance(name):
    for exercise in for_all_names(name):
        right = exercise._right[0]
        for answer, said in exercise._wrong:
            away = np.abs(answer - right)
            parts = (away[part].max() / np.abs(right[part]).max() for part in exercise.parts.values())
            assert max(parts) > APART * TOLERANCE, (exercise.numbers, said)


@own
def test_numbers_are_readable_and_names_mostly_have_different_ones(name):
    drawn = [exercise.numbers for exercise in for_all_names(name)]
    assert all(float(f"{number:.3g}") == number for numbers in drawn for number in numbers)
    assert len({*drawn}) > 0.75 * len(NAMES)
    for numbers in drawn:
        for number, (_, least, largest, _) in zip(numbers, entry(name).drawn.values(), strict=True):
            assert least <= number <= largest


@own
def test_without_a_name_the_numbers_are_those_that_are_printed(name):
    printed = tuple(number for number, *_ in entry(name).drawn.values())
    assert exercises.numbers(name) == exercises.find(name, "").numbers == printed
    with pytest.raises(InputError, match="name is text; an object of type int"):
        exercises.find(name, 5)
    assert CATALOGUE[name].numbers == printed


def test_numbers_are_the_same_everywhere_and_for_ever():
    assert exercises.find("A1.3", "Ada Lovelace").numbers == (0.6, 0.25, 0.2)


def test_capitals_and_blanks_do_not_make_another_name():
    for student in ("ada lovelace", " Ada  LOVELACE\n", "ADA\tLovelace", "\uff21da Lovelace"):
        assert exercises.find("A1.3", student).numbers == exercises.find("A1.3", "Ada Lovelace").numbers
    assert exercises.find("A1.3", "STRASSE").numbers == exercises.find("A1.3", "straße").numbers


def test_hints_and_solutions_use_the_readers_numbers(capsys):
    exercises.student("Ada")
    for name in OWN:
        answer, student = exercises.find(name).right, exercises.find(name, "")
        exercises.check(name, answer)
        assert f"{name}: correct." in capsys.readouterr().out
        assert student.judge(answer) != RIGHT
        assert exercises.solution(name).data != f"{student.explanation}\n\n```python\n{student.code}\n```"
        exercises.assert_right(name, answer)


def test_a_name_is_text_and_short(capsys):
    class Text(str):
        pass

    for given in (5, None, ["Ada"], b"Ada", "x" * 81, "\ufdfa" * 10, "\ud800", "a\x00b", "x" * 10**7):
        exercises.student("Ada")
        exercises.student(given)
        said = capsys.readouterr().out.splitlines()[1:]
        assert len(said) == 1
        assert said[0].startswith("A name is expected")
        assert reader.name == "ada"
    exercises.student(Text(" Ada\nLovelace "))
    assert capsys.readouterr().out.startswith("Ada Lovelace: ")
    exercises.student("  ")
    assert "printed, and nothing is stored" in capsys.readouterr().out
    assert reader.name == ""


def test_only_what_takes_numbers_has_numbers():
    assert exercises.numbers(" a1.3 ") == CATALOGUE["A1.3"].numbers
    for name in ("A1.1", "A1.9", 5):
        with pytest.raises(UnknownNameError, match="There is no exercise"):
            exercises.numbers(name)


def test_what_is_not_right_raises_with_the_sentence_of_check(capsys):
    exercises.student("Ada")
    for answer in (..., "x", [0, 0, 0], np.zeros((2000, 2000))):
        capsys.readouterr()
        exercises.check("A1.3", answer)
        with pytest.raises(WrongAnswerError) as caught:
            exercises.assert_right("A1.3", answer)
        assert f"{caught.value}\n" == capsys.readouterr().out
    assert isinstance(caught.value, AssertionError)
    assert isinstance(caught.value, LynxError)
    assert exercises.assert_right("a1.1", [np.pi / 2, 0, 0, np.pi / 2, 0]) is None
    with pytest.raises(UnknownNameError):
        exercises.assert_right("A1.9", 0)


# What is kept.

RIGHT_1 = [np.pi / 2, 0, 0, np.pi / 2, 0]


def table():
    return re.findall(r"^\| (\S+) \| (yes|no) \| (\d+) \| (\d+) \|$", exercises.progress().data, re.M)


def work():
    """Three tries, the third of which is right, and a hint."""
    exercises.check("A1.1")
    for answer in (1, [0] * 5, RIGHT_1, RIGHT_1, 2):
        exercises.check("A1.1", answer)
    exercises.hint("a2.1", 2)
    exercises.hint("a2.1", 7)


WORKED = [("A1.1", "yes", "3", "0"), ("A2.1", "no", "0", "2")]


def test_what_was_tried_is_kept_and_read_by_the_next_process(tmp_path, monkeypatch):
    exercises.student("Ada")
    assert table() == []
    assert [*tmp_path.iterdir()] == []
    work()
    assert table() == WORKED
    monkeypatch.setattr(reader, "_record", {})  # as in another kernel
    assert table() == WORKED
    exercises.student("Bob")
    assert table() == []
    exercises.check("A2.1", 0.2)
    exercises.student(" ADA ")
    assert table() == WORKED
    assert [path.name for path in tmp_path.iterdir()] == [reader.FILE]


def test_without_a_name_nothing_is_read_or_stored(tmp_path):
    (tmp_path / reader.FILE).write_text('{"": {"A1.1": {"done": true, "tries": 1, "hints": 0}}}')
    before = (tmp_path / reader.FILE).read_bytes()
    work()
    assert exercises.progress().data.startswith("No name is set")
    assert [path.name for path in tmp_path.iterdir()] == [reader.FILE]
    assert (tmp_path / reader.FILE).read_bytes() == before


FOREIGN = {
    "empty": "",
    "half": '{"ada": {"A1.1": {"done": tr',
    "another": '{"exercises": [1, 2, 3]}',
    "list": "[1, 2]",
    "numbers": '{"ada": {"A1.1": {"done": 1, "tries": 1, "hints": 0}}}',
    "text": '{"ada": {"A1.1": {"done": true, "tries": "1", "hints": 0}}}',
    "deep": "[" * 100_000,
    "long number": '{"ada": {"A1.1": {"done": true, "tries": ' + "9" * 10_000 + ', "hints": 0}}}',
    "large": " " * 2_000_000,
    "bytes": b"\xff\xfe\x00",
}


@pytest.mark.parametrize("kind", FOREIGN)
def test_a_file_that_is_not_ours_is_left_as_it_is(kind, tmp_path):
    content = FOREIGN[kind] if isinstance(FOREIGN[kind], bytes) else FOREIGN[kind].encode()
    (tmp_path / reader.FILE).write_bytes(content)
    exercises.student("Ada")
    work()
    assert table() == WORKED
    assert reader.UNREAD in exercises.progress().data
    assert (tmp_path / reader.FILE).read_bytes() == content


def test_a_folder_in_its_place_or_one_that_cannot_be_written_gets_a_sentence(tmp_path, monkeypatch):
    exercises.student("Ada")
    (tmp_path / reader.FILE).mkdir()
    work()
    assert table() == WORKED
    assert reader.UNREAD in exercises.progress().data
    (tmp_path / reader.FILE).rmdir()
    (tmp_path / reader.FILE).symlink_to("nowhere")
    assert reader.UNREAD in exercises.progress().data
    (tmp_path / reader.FILE).unlink()
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    work()
    assert table() == WORKED
    assert reader.UNWRITTEN in exercises.progress().data
    monkeypatch.chdir(tmp_path)
    assert table() == WORKED
    assert json.loads((tmp_path / reader.FILE).read_text())["ada"]["A1.1"]["done"] is True
