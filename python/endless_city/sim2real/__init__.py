"""Does a dataset teach a detector for your own cameras? Training on synthetic pictures, test on real ones.

    python -m endless_city.sim2real out --test my_camera

A small detector is trained from scratch on datasets of `endless generate`, on real folders (YOLO, COCO) or on both, and tested
on real folders: average precision with intervals, tables by class and size, a sheet of what it missed (docs/sim2real.md).

- `labelled`: pictures with boxes of three coarse classes, whatever they come from;
- `synthetic_set`, `yolo`, `coco`, `real_set`: readers of such sets; `class_names`: which names are which class;
- `detector`, `assignment`, `losses`, `augment`, `train`, `predict`: the detector; they need PyTorch;
- `average_precision`, `bootstrap`, `sizes`, `scores`: how well it does;
- `report`, `misses`: what is printed, written and drawn; `arguments`, `runs`: the command.

Needs `pip install endless-city[sim2real]`.
"""
