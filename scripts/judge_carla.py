"""Lets CARLA's own client judge `endless serve`.

    python scripts/judge_carla.py endless [--map Town03 | --towns all] [--frames 300] [--seconds 60] [--size 320x180]

Needs the official client (`pip install carla==0.9.16 numpy`). Starts a server on a free port, drives vehicles by the client's
traffic manager and people by its crowd, records two views in synchronous mode, and fails with a line that says what is wrong:
frames, ids, classes, boxes that do not hold what is seen, vehicles that run a red light or leave the road, traffic that stands.
With `--seconds` it lets time pass on after the last picture: in a minute the median vehicle drives 100 m.
"""

import argparse
import os
import queue
import random
import sys
import time

import carla
import numpy as np

from carla_projection import OUT_PX, out_of_box, projected, seen
from carla_road_rules import RoadRules
from carla_server import Server
from ports import free_port

STEP_S = 0.05
KINDS = ("rgb", "depth", "semantic_segmentation", "instance_segmentation")


def check(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def bgra(image):
    return np.frombuffer(image.raw_data, np.uint8).reshape(image.height, image.width, 4)


def synchronous(world):
    """Time passes in steps of a twentieth of a second, by ticks; gives the settings."""
    settings = world.get_settings()
    settings.synchronous_mode, settings.fixed_delta_seconds = True, STEP_S
    world.apply_settings(settings)
    return settings


def spawn_traffic(client, world, manager, count, rng):
    library = world.get_blueprint_library().filter("vehicle.*")
    points = list(world.get_map().get_spawn_points())
    check(len(points) >= count, f"only {len(points)} spawn points")
    rng.shuffle(points)
    future = carla.command.FutureActor
    batch = [
        carla.command.SpawnActor(rng.choice(library) if number else library.find("vehicle.tesla.model3"), point).then(
            carla.command.SetAutopilot(future, True, manager.get_port())
        )
        for number, point in enumerate(points[:count])
    ]
    answers = client.apply_batch_sync(batch, True)
    errors = [a.error for a in answers if a.error]
    check(not errors, f"{len(errors)} of {count} vehicles were not spawned: {errors[:1]}")
    return [a.actor_id for a in answers]


def spawn_walkers(client, world, count, rng):
    library = world.get_blueprint_library().filter("walker.pedestrian.*")
    places = [world.get_random_location_from_navigation() for _ in range(count)]
    check(all(places), "the navigation mesh gives no places")
    batch = [carla.command.SpawnActor(rng.choice(library), carla.Transform(p + carla.Location(z=1))) for p in places]
    walkers = [a.actor_id for a in client.apply_batch_sync(batch, True) if not a.error]
    check(len(walkers) >= 0.8 * count, f"only {len(walkers)} of {count} people were spawned")
    controller = world.get_blueprint_library().find("controller.ai.walker")
    batch = [carla.command.SpawnActor(controller, carla.Transform(), walker) for walker in walkers]
    controllers = [a.actor_id for a in client.apply_batch_sync(batch, True)]
    world.tick()
    for actor in world.get_actors(controllers):
        actor.start()
        actor.go_to_location(world.get_random_location_from_navigation())
        actor.set_max_speed(1.4)
    return walkers, controllers


class Pictures:
    """Two views, each by four cameras: from a pole, and from a vehicle."""

    def __init__(self, world, ego, size):
        corner = ego.get_transform()
        above = corner.location + carla.Location(z=8)
        views = {
            "fixed": (carla.Transform(above, carla.Rotation(pitch=-25, yaw=corner.rotation.yaw)), None),
            "carried": (carla.Transform(carla.Location(x=1.5, z=2.4)), ego),
        }
        self.views, self.queues, self.sensors = list(views), {}, []
        for view, (transform, parent) in views.items():
            for kind in KINDS:
                blueprint = world.get_blueprint_library().find(f"sensor.camera.{kind}")
                blueprint.set_attribute("image_size_x", size[0])
                blueprint.set_attribute("image_size_y", size[1])
                sensor = world.spawn_actor(blueprint, transform, attach_to=parent)
                self.queues[view, kind] = queue.Queue()
                sensor.listen(self.queues[view, kind].put)
                self.sensors.append(sensor)
        self.ego, self.shown, self.boxes, self.worst_px = ego.id, set(), 0, 0.0

    def frame(self, frame):
        images = {key: q.get(timeout=60) for key, q in self.queues.items()}
        for key, image in images.items():
            check(image.frame == frame, f"{key}: frame {image.frame} in place of {frame}")
        return images

    def judge(self, images, snapshot, actors, parked):
        """Classes of all cameras, ids, and boxes of those that are seen."""
        for view in self.views:
            semantic, instance = (bgra(images[view, k]) for k in ("semantic_segmentation", "instance_segmentation"))
            check((semantic[..., 2] == instance[..., 2]).all(), f"{view}: classes of two cameras differ")
            moving = np.isin(instance[..., 2], (12, 13, 14, 15, 16, 18, 19))
            ids = np.where(moving, instance[..., 1].astype(int) + 256 * instance[..., 0].astype(int), 0)
            shown = set(np.unique(ids[moving]).tolist())
            nobody = shown - actors.keys() - parked
            check(not nobody, f"{view}: ids of nobody: {sorted(nobody)[:5]}")
            self.shown |= shown & actors.keys()
            # Who carries a camera is around it.
            for actor in shown & actors.keys() - {self.ego if view == "carried" else 0}:
                image = images[view, "instance_segmentation"]
                box = projected(actors[actor].bounding_box, snapshot.find(actor).get_transform(), image)
                out_px = out_of_box(seen(ids, actor), box) if box else float("inf")
                what = f"{view}, frame {image.frame}: {actors[actor].type_id} {actor}"
                check(out_px <= OUT_PX, f"{what} reaches {out_px:.1f} pixels out of its box")
                self.boxes, self.worst_px = self.boxes + 1, max(self.worst_px, out_px)


def save(images, folder):
    os.makedirs(folder, exist_ok=True)
    for (view, kind), image in images.items():
        image.save_to_disk(os.path.join(folder, f"{view}_{kind}.png"))


def judge_town(client, world, town, args):
    """Everything on one town."""
    rng = random.Random(1)
    settings = synchronous(world)
    manager = client.get_trafficmanager(free_port())
    manager.set_synchronous_mode(True)
    manager.set_random_device_seed(1)
    world.set_pedestrians_seed(1)
    vehicles = spawn_traffic(client, world, manager, args.vehicles, rng)
    walkers, controllers = spawn_walkers(client, world, args.walkers, rng) if args.walkers else ([], [])
    actors = {actor.id: actor for actor in world.get_actors(vehicles + walkers)}
    parked = {thing.id for thing in world.get_environment_objects(carla.CityObjectLabel.Any)}
    check(not actors.keys() & parked, "actors and parked vehicles share ids")
    pictures = Pictures(world, actors[vehicles[0]], args.size.split("x"))
    rules = RoadRules(world, vehicles, STEP_S)
    last = {v: actors[v].get_location() for v in vehicles}
    walked = {w: actors[w].get_location() for w in walkers}
    driven = dict.fromkeys(vehicles, 0.0)
    began = time.time()
    frames = max(args.frames, round(args.seconds / STEP_S))
    for number in range(frames):
        frame = world.tick()
        snapshot = world.get_snapshot()
        check(snapshot.frame == frame, f"snapshot {snapshot.frame} in place of {frame}")
        if number < args.frames:
            images = pictures.frame(frame)
            pictures.judge(images, snapshot, actors, parked)
        elif number == args.frames:
            for sensor in pictures.sensors:
                sensor.stop()
        rules.frame(number)
        for v in vehicles:
            here = snapshot.find(v).get_transform().location
            driven[v] += here.distance(last[v])
            last[v] = here
    if args.out:
        save(images, os.path.join(args.out, town))
    median = sorted(driven.values())[len(driven) // 2] if driven else 0.0
    gone = [actors[w].get_location().distance(walked[w]) for w in walkers]
    print(
        f"{town}: {args.frames} frames of {len(pictures.queues)} sensors, {frames * STEP_S:.0f} s in {time.time() - began:.1f} s; "
        f"vehicles drove {median:.1f} m (median), {len(rules.stood)} stood at red, {len(rules.ran)} ran it, {len(rules.left)} off "
        f"the road; {sum(m > 1 for m in gone)} of {len(walkers)} people walked; {len(pictures.shown)} actors in the pictures, "
        f"{pictures.boxes} boxes, what is seen at most {pictures.worst_px:.1f} pixels out of them",
        flush=True,
    )
    check(not rules.ran, f"{len(rules.ran)} vehicles ran a red light: {sorted(rules.ran)[:5]}")
    check(not rules.left, f"{len(rules.left)} vehicles left the road: {sorted(rules.left)[:5]}")
    least = 100.0 if args.seconds >= 60 else 0.08 * frames * STEP_S * 13
    check(not vehicles or median > least, f"the median vehicle drove {median:.1f} m")
    check(args.seconds < 60 or not rules.lights or rules.stood, "nobody stood at a red light")
    check(not walkers or sum(m > 1 for m in gone) > 0.7 * len(walkers), "people do not walk")
    for actor in [*pictures.sensors, *world.get_actors(controllers)]:
        actor.stop()
    ended = [sensor.id for sensor in pictures.sensors] + controllers + vehicles + walkers
    # Not with a tick: the client would hold Python's lock while it waits, which its own threads need to let go of
    # what listened.
    answers = client.apply_batch_sync([carla.command.DestroyActor(x) for x in ended], False)
    world.tick()
    check(not [a.error for a in answers if a.error], "not all actors could be destroyed")
    check(not world.get_actors().filter("vehicle.*"), "vehicles are left")
    settings.synchronous_mode, settings.fixed_delta_seconds = False, None
    # It looks at the world all the time, also while there is none.
    manager.shut_down()
    world.apply_settings(settings)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--map", default="Town03")
    parser.add_argument("--towns", help="these one after the other in place of --map: names with commas between, or 'all'")
    parser.add_argument("--frames", type=int, default=300, help="frames with pictures")
    parser.add_argument("--seconds", type=float, default=0.0, help="how long to drive, if longer than that")
    parser.add_argument("--vehicles", type=int, default=30)
    parser.add_argument("--walkers", type=int, default=20)
    parser.add_argument("--size", default="320x180")
    parser.add_argument("--out", help="folder for some of the pictures")
    args = parser.parse_args()
    first = args.map if not args.towns or args.towns == "all" else args.towns.split(",")[0]
    with Server(args.program, first) as server:
        client = carla.Client("127.0.0.1", server.port)
        client.set_timeout(60.0)
        check(client.get_server_version() == client.get_client_version(), "versions differ")
        maps = [name.rsplit("/", 1)[-1] for name in client.get_available_maps()]
        towns = maps if args.towns == "all" else args.towns.split(",") if args.towns else [args.map]
        for town in towns:
            world = client.get_world()
            if world.get_map().name.rsplit("/", 1)[-1] != town:
                world = client.load_world(town)
            judge_town(client, world, town, args)
        check(client.load_world(maps[0]).get_map() is not None, "no other map")
    print("all held")


if __name__ == "__main__":
    main()
