"""The examples of the documentation write their files where nobody keeps any."""

import pytest


@pytest.fixture(autouse=True)
def work_in_a_directory_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
