"""Judges of exports: each opens what `endless export` wrote with the field's own reader, and compares it with the dataset's files."""
