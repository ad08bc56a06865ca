"""Datumaro, which reads formats for CVAT and for itself."""

import pathlib


def with_datumaro(folder: pathlib.Path, kind: str, labels: int) -> str:
    """Opens a folder; what it finds must be as many labels as there are."""
    try:
        import datumaro
    except ImportError:
        return "Datumaro is not installed"
    dataset = datumaro.Dataset.import_from(str(folder), kind)
    kinds = {"coco_instances": "mask", "coco_panoptic": "mask"}
    wanted = datumaro.AnnotationType[kinds.get(kind, "bbox")]
    found = sum(1 for item in dataset for annotation in item.annotations if annotation.type == wanted)
    if found != labels:
        raise SystemExit(f"error: Datumaro finds {found} of {labels} in {folder}")
    return f"Datumaro finds all of them in {len(dataset)} pictures"
