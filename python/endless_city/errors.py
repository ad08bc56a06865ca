"""What can go wrong. Every message is one line that says what to do."""

from __future__ import annotations

__all__ = ["DatasetError", "EndlessError", "RecipeError", "SimulationError"]


class EndlessError(Exception):
    """Something that endless cannot do. The message says what to do. The base of all other exceptions of the package."""


class RecipeError(EndlessError, ValueError):
    """A recipe or an argument that cannot be: an unknown map, a number outside its range."""


class DatasetError(EndlessError):
    """A dataset that cannot be read, written or resumed: no dataset, another recipe, another build, a full disk."""


class SimulationError(EndlessError):
    """A simulation that failed: a scene that cannot be made, a CARLA server that is gone."""
