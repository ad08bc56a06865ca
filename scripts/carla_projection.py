"""3D boxes of CARLA's client in its pictures, for `judge_carla.py`."""

import numpy as np

# Nearer than this nothing is seen, metres.
NEAR_M = 0.05
# How far what is seen may reach out of its projected box, pixels.
OUT_PX = 2.0
# Corners of `BoundingBox.get_world_vertices` that differ in one coordinate.
EDGES = [(a, b) for a in range(8) for b in range(a + 1, 8) if bin(a ^ b).count("1") == 1]


def projected(box, transform, image):
    """The rectangle around a box in a picture (left, top, right, bottom; pixels); none if it is behind the camera."""
    corners = np.array([[v.x, v.y, v.z, 1.0] for v in box.get_world_vertices(transform)])
    camera = corners @ np.array(image.transform.get_inverse_matrix()).T
    ahead = camera[:, 0] > NEAR_M
    points = list(camera[ahead])
    for a, b in EDGES:
        if ahead[a] != ahead[b]:
            share = (NEAR_M - camera[a, 0]) / (camera[b, 0] - camera[a, 0])
            points.append(camera[a] + share * (camera[b] - camera[a]))
    if not points:
        return None
    points = np.array(points)
    focal = image.width / (2.0 * np.tan(np.radians(image.fov) / 2.0))
    across = image.width / 2.0 + focal * points[:, 1] / points[:, 0]
    down = image.height / 2.0 - focal * points[:, 2] / points[:, 0]
    return across.min(), down.min(), across.max(), down.max()


def seen(ids, actor):
    """The rectangle around an actor's pixels."""
    rows, columns = np.nonzero(ids == actor)
    return columns.min(), rows.min(), columns.max() + 1, rows.max() + 1


def out_of_box(mask, box):
    """By how many pixels what is seen reaches out of its box."""
    return max(box[0] - mask[0], box[1] - mask[1], mask[2] - box[2], mask[3] - box[3])
