"""What stands in docstrings, stubs, the README and the chapter holds."""

import doctest
import inspect
import re
import subprocess
import sys
from pathlib import Path

import pytest
import tumbling

HERE = Path(__file__).resolve().parent
PUBLIC = [getattr(tumbling, name) for name in tumbling.__all__]
MEMBERS = [
    (f"{one.__name__}.{name}", member)
    for one in PUBLIC
    if inspect.isclass(one)
    for name, member in vars(one).items()
    if not name.startswith("_") and one is not tumbling.Error
]
DOCUMENTED = [(one.__name__, one) for one in PUBLIC] + MEMBERS


@pytest.mark.parametrize("name,one", DOCUMENTED, ids=[name for name, _ in DOCUMENTED])
def test_each_public_name_is_explained_and_its_example_holds(name, one):
    text = inspect.getdoc(one)
    assert text, name
    test = doctest.DocTestParser().get_doctest(text, {}, name, None, None)
    assert doctest.DocTestRunner().run(test).failed == 0


def test_every_class_and_function_has_an_example():
    assert [one.__name__ for one in PUBLIC if one not in [tumbling.Verdict, tumbling.Comparison] and ">>>" not in one.__doc__] == []


def test_the_stubs_say_what_the_module_has():
    run = [sys.executable, "-m", "mypy.stubtest", "tumbling", "--ignore-disjoint-bases"]
    told = subprocess.run(run, cwd=HERE, capture_output=True, text=True)
    assert told.returncode == 0, told.stdout + told.stderr


def test_the_chapters_cell_runs():
    chapter = (HERE.parents[2] / "book/chapters/test-your-engine.md").read_text()
    cells = re.findall(r"^```python\n(.*?)^```", chapter, re.M | re.S)
    assert cells
    for cell in cells:
        exec(cell, {})
