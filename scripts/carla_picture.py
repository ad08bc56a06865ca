"""Makes docs/carla.jpg: what CARLA's own client sees of a town that `endless serve` serves.

    endless serve --map Town05 &
    python scripts/carla_picture.py docs/carla.jpg [--port 2000]

Needs `pip install carla==0.9.16 numpy pillow`. Vehicles are driven by the client's TrafficManager.
"""

import argparse
import math
import os
import queue
import random

import carla
import numpy as np
from PIL import Image

from judge_carla import bgra, synchronous

KINDS = ("rgb", "depth", "instance_segmentation")


def colours(image):
    return bgra(image)[..., 2::-1]


def instances(image):
    pixels = bgra(image).astype(int)
    ids = pixels[..., 1] + 256 * pixels[..., 0]
    painted = np.random.RandomState(7).randint(60, 255, (65536, 3))[ids]
    painted[ids == 0] = (pixels[..., 2][ids == 0] * 5 + 20)[:, None]
    return painted.astype(np.uint8)


def depths(image):
    pixels = bgra(image).astype(float)
    metres = (pixels[..., 2] + 256 * pixels[..., 1] + 65536 * pixels[..., 0]) / 16777215 * 1000
    grey = 255 * (1 - np.clip(np.log(metres + 1) / math.log(300), 0, 1))
    return np.repeat(grey[..., None], 3, 2).astype(np.uint8)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("out")
    parser.add_argument("--port", type=int, default=2000)
    args = parser.parse_args()
    client = carla.Client("127.0.0.1", args.port)
    client.set_timeout(120)
    world, rng = client.get_world(), random.Random(5)
    synchronous(world)
    manager = client.get_trafficmanager(args.port + 6000)
    manager.set_synchronous_mode(True)
    manager.set_random_device_seed(3)
    library = world.get_blueprint_library()
    lights = list(world.get_actors().filter("traffic.traffic_light"))
    middle = lights[len(lights) // 2].get_location()
    places = []
    for place in sorted(world.get_map().get_spawn_points(), key=lambda p: p.location.distance(middle)):
        if len(places) < 45 and all(place.location.distance(other.location) > 11 for other in places):
            places.append(place)
    command = carla.command
    drive = command.SetAutopilot(command.FutureActor, True, manager.get_port())
    vehicles = list(library.filter("vehicle.*"))
    batch = [command.SpawnActor(rng.choice(vehicles), place).then(drive) for place in places]
    ids = [answer.actor_id for answer in client.apply_batch_sync(batch, True) if not answer.error]
    for _ in range(150):
        world.tick()
    near = sorted(world.get_actors(ids), key=lambda actor: actor.get_location().distance(middle))[:12]
    x, y = (sum(getattr(actor.get_location(), axis) for actor in near) / len(near) for axis in "xy")
    yaw = math.degrees(math.atan2(y - middle.y, x - middle.x))
    behind = carla.Location(middle.x - 10 * math.cos(math.radians(yaw)), middle.y - 10 * math.sin(math.radians(yaw)), middle.z + 8.5)
    views = {
        "pole": (carla.Transform(behind, carla.Rotation(pitch=-18, yaw=yaw)), None),
        "car": (carla.Transform(carla.Location(x=-6.5, z=2.9), carla.Rotation(pitch=-9)), near[0]),
    }
    queues, sensors = {}, []
    for view, (transform, parent) in views.items():
        for kind in KINDS:
            blueprint = library.find(f"sensor.camera.{kind}")
            for name, value in (("image_size_x", 640), ("image_size_y", 360), ("fov", 90)):
                blueprint.set_attribute(name, str(value))
            sensors.append(world.spawn_actor(blueprint, transform, attach_to=parent))
            queues[view, kind] = queue.Queue()
            sensors[-1].listen(queues[view, kind].put)
    world.tick()
    seen = {key: images.get(timeout=100) for key, images in queues.items()}
    upper = [colours(seen["pole", "rgb"]), instances(seen["pole", "instance_segmentation"])]
    lower = [colours(seen["car", "rgb"]), depths(seen["car", "depth"])]
    Image.fromarray(np.vstack([np.hstack(upper), np.hstack(lower)])).save(args.out, quality=88)
    # The server goes back to asynchronous mode when the client that ticked has gone.
    os._exit(0)


if __name__ == "__main__":
    main()
