"""Endless annotated urban datasets."""
