"""The environment check sees a version that is not the locked one."""

from importlib.metadata import version

from lynx_common.course import environment


def test_the_locked_versions_are_installed():
    assert environment.check() == "All 6 packages have the locked versions."


def test_another_version_and_a_missing_package_are_named(tmp_path, monkeypatch):
    lock = tmp_path / "requirements.txt"
    lock.write_text(environment.LOCK.read_text().replace(f"numpy=={version('numpy')}", "numpy==1.0"))
    assert (
        environment.check(lock)
        == f"Not as locked: numpy is {version('numpy')}, not 1.0. `make lab` sets it right."
    )
    monkeypatch.setattr(environment, "PACKAGES", ("numpy", "nothing_of_this_name"))
    lock.write_text(f"numpy=={version('numpy')}\nnothing_of_this_name==2.0 ; python_version > '3'\n")
    assert "nothing_of_this_name is missing, not 2.0" in environment.check(lock)


def test_markers_are_obeyed(tmp_path, monkeypatch):
    lock = tmp_path / "requirements.txt"
    lock.write_text(f"numpy==1.0 ; python_version < '3'\nnumpy=={version('numpy')} ; python_version >= '3'\n")
    monkeypatch.setattr(environment, "PACKAGES", ("numpy",))
    assert environment.check(lock) == "All 1 packages have the locked versions."


def test_a_course_without_its_lock_says_so(tmp_path):
    assert "There is no lock" in environment.check(tmp_path / "requirements.txt")
