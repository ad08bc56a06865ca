"""The package itself: documented, typed, light to import."""

from __future__ import annotations

import inspect
import subprocess
import sys
from types import ModuleType
from typing import Any, get_type_hints

import pytest

import endless_city
import endless_city.errors

MODULES: list[ModuleType] = [endless_city, endless_city.errors]
try:
    import endless_city.torch

    MODULES.append(endless_city.torch)
except ImportError:
    pass


def members(name: str, value: Any) -> list[tuple[str, Any]]:
    if not inspect.isclass(value):
        return [(name, value)]
    own = [(f"{name}.{key}", member) for key, member in vars(value).items() if not key.startswith("_")]
    return [(name, value), *own]


PUBLIC = [
    (f"{module.__name__}.{full}", member)
    for module in MODULES
    for name in module.__all__
    for full, member in members(name, getattr(module, name))
    if callable(member) or isinstance(member, property)
]


@pytest.mark.parametrize(("name", "member"), PUBLIC, ids=[name for name, _ in PUBLIC])
def test_every_public_name_is_documented_and_typed(name: str, member: Any) -> None:
    assert inspect.getdoc(member), f"{name} says nothing of itself"
    function = member.fget if isinstance(member, property) else member
    if not inspect.isfunction(function):
        return
    signature = inspect.signature(function)
    assert signature.return_annotation is not inspect.Signature.empty, f"{name} does not say what it returns"
    for parameter in signature.parameters.values():
        typed = parameter.annotation is not inspect.Parameter.empty
        assert typed or parameter.name in ("self", "cls"), f"{name}: {parameter.name} has no type"


def test_the_package_is_documented_and_marked_as_typed() -> None:
    assert endless_city.__doc__ and endless_city.__version__
    assert get_type_hints(endless_city.Generated)["videos"] is int
    from importlib.resources import files

    assert (files("endless_city") / "py.typed").is_file() and (files("endless_city") / "_native.pyi").is_file()


def test_importing_loads_little() -> None:
    """No other package, and few modules of Python's own: `scripts/bench_python_overhead.py` times what that takes."""
    code = "import sys; before = set(sys.modules); import endless_city; print(*set(sys.modules) - before)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "endless_city._native" in loaded
    assert {name.partition(".")[0] for name in loaded} - sys.stdlib_module_names == {"endless_city"}
    assert len(loaded) < 80, sorted(loaded)
