"""Stands in for a module that CARLA's benchmark imports and does not use."""

tr = None
