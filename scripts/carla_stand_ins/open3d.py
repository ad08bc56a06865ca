"""Stands in for Open3D where a script of CARLA's only needs a window to exist: it keeps points and shows nothing."""

import types


class PointCloud:
    def __init__(self):
        self.points, self.colors = [], []


class LineSet(PointCloud):
    def __init__(self):
        super().__init__()
        self.lines = []


class Visualizer:
    """Fails where a window would show a cloud without points or with other colours than points."""

    def __init__(self):
        self.shown, self.options = [], types.SimpleNamespace()

    def create_window(self, **_):
        return True

    def get_render_option(self):
        return self.options

    def add_geometry(self, geometry):
        self.shown.append(geometry)

    def update_geometry(self, _geometry):
        return True

    def poll_events(self):
        return True

    def update_renderer(self):
        for geometry in self.shown:
            points, colours = len(geometry.points), len(geometry.colors)
            # Another thread gives points and colours one after the other, and each sweep has its own number of them.
            if not points or not colours:
                raise ValueError("the point cloud is empty")

    def destroy_window(self):
        print(f"points: {sum(len(geometry.points) for geometry in self.shown)}")


def vector(values):
    return values


geometry = types.SimpleNamespace(PointCloud=PointCloud, LineSet=LineSet)
utility = types.SimpleNamespace(Vector3dVector=vector, Vector2iVector=vector)
visualization = types.SimpleNamespace(Visualizer=Visualizer)
