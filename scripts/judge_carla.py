"""Lets CARLA's own client judge `endless serve`.

    python scripts/judge_carla.py endless [--map Town03] [--frames 300] [--vehicles 30] [--size 320x180]

Needs the official client (`pip install carla==0.9.16 numpy`). Starts a server on a free port, drives vehicles by the client's
traffic manager and people by its crowd, records two cameras in synchronous mode, and fails with a line that says what is
wrong.
"""

import argparse
import queue
import random
import socket
import subprocess
import sys
import time

import carla
import numpy as np

KINDS = ("rgb", "depth", "semantic_segmentation", "instance_segmentation")


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Server:
    """A server that ends with the script."""

    def __init__(self, program, town):
        self.port = free_port()
        self.process = subprocess.Popen([program, "serve", "--map", town, "--port", str(self.port)])
        deadline = time.time() + 120
        while time.time() < deadline:
            if self.process.poll() is not None:
                sys.exit(f"the server ended with {self.process.returncode}")
            try:
                socket.create_connection(("127.0.0.1", self.port), 1).close()
                return
            except OSError:
                time.sleep(0.2)
        sys.exit("the server does not listen")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()


def check(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def bgra(image):
    return np.frombuffer(image.raw_data, np.uint8).reshape(image.height, image.width, 4)


def synchronous(world):
    """Time passes in steps of a twentieth of a second, by ticks; gives the settings."""
    settings = world.get_settings()
    settings.synchronous_mode, settings.fixed_delta_seconds = True, 0.05
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


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--map", default="Town03")
    parser.add_argument("--frames", type=int, default=300)
    parser.add_argument("--vehicles", type=int, default=30)
    parser.add_argument("--walkers", type=int, default=20)
    parser.add_argument("--size", default="320x180")
    parser.add_argument("--out", help="folder for some of the pictures")
    args = parser.parse_args()
    width, height = args.size.split("x")
    rng = random.Random(1)
    with Server(args.program, args.map) as server:
        client = carla.Client("127.0.0.1", server.port)
        client.set_timeout(60.0)
        check(client.get_server_version() == client.get_client_version(), "versions differ")
        world = client.get_world()
        settings = synchronous(world)
        manager = client.get_trafficmanager(free_port())
        manager.set_synchronous_mode(True)
        manager.set_random_device_seed(1)
        world.set_pedestrians_seed(1)
        vehicles = spawn_traffic(client, world, manager, args.vehicles, rng)
        walkers, controllers = spawn_walkers(client, world, args.walkers, rng) if args.walkers else ([], [])
        queues, sensors = {}, []
        ego = world.get_actor(vehicles[0])
        corner = ego.get_transform()
        views = {
            "fixed": (carla.Transform(corner.location + carla.Location(z=8), carla.Rotation(pitch=-25, yaw=corner.rotation.yaw)), None),
            "carried": (carla.Transform(carla.Location(x=1.5, z=2.4)), ego),
        }
        for view, (transform, parent) in views.items():
            for kind in KINDS:
                blueprint = world.get_blueprint_library().find(f"sensor.camera.{kind}")
                blueprint.set_attribute("image_size_x", width)
                blueprint.set_attribute("image_size_y", height)
                sensor = world.spawn_actor(blueprint, transform, attach_to=parent)
                queues[view, kind] = queue.Queue()
                sensor.listen(queues[view, kind].put)
                sensors.append(sensor)
        begin = {v.id: v.get_location() for v in world.get_actors(vehicles)}
        walked = {w.id: w.get_location() for w in world.get_actors(walkers)}
        driven = dict.fromkeys(vehicles, 0.0)
        ids_seen, ran_red, off_road = set(), 0, 0
        known = set(vehicles) | set(walkers)
        parked = {thing.id for thing in world.get_environment_objects(carla.CityObjectLabel.Any)}
        check(not known & parked, "actors and parked vehicles share ids")
        began = time.time()
        for _ in range(args.frames):
            frame = world.tick()
            snapshot = world.get_snapshot()
            check(snapshot.frame == frame, f"snapshot {snapshot.frame} in place of {frame}")
            images = {key: q.get(timeout=60) for key, q in queues.items()}
            for key, image in images.items():
                check(image.frame == frame, f"{key}: frame {image.frame} in place of {frame}")
            for view in views:
                semantic, instance = (bgra(images[view, k]) for k in ("semantic_segmentation", "instance_segmentation"))
                check((semantic[..., 2] == instance[..., 2]).all(), f"{view}: classes of two cameras differ")
                moving = np.isin(instance[..., 2], (12, 13, 14, 15, 16, 18, 19))
                ids = instance[..., 1].astype(int) + 256 * instance[..., 0].astype(int)
                shown = set(np.unique(ids[moving]).tolist())
                check(shown <= known | parked, f"{view}: ids of nobody: {sorted(shown - known - parked)[:5]}")
                ids_seen |= shown & known
            for id in vehicles:
                here = snapshot.find(id).get_transform().location
                driven[id] += here.distance(begin[id])
                begin[id] = here
        seconds = time.time() - began
        waypoints = world.get_map()
        for actor in world.get_actors(vehicles):
            place = waypoints.get_waypoint(actor.get_location(), lane_type=carla.LaneType.Any)
            at = waypoints.get_waypoint(actor.get_location())
            off_road += at.transform.location.distance(actor.get_location()) > 0.5 * at.lane_width + 1.0
        if args.out:
            import os
            os.makedirs(args.out, exist_ok=True)
            for (view, kind), image in images.items():
                image.save_to_disk(os.path.join(args.out, f"{view}_{kind}.png"))
        median = sorted(driven.values())[len(driven) // 2] if driven else 0.0
        moved = [w.get_location().distance(walked[w.id]) for w in world.get_actors(walkers)]
        print(
            f"{args.map}: {args.frames} frames of {len(queues)} sensors in {seconds:.1f} s; vehicles drove {median:.1f} m "
            f"(median), {off_road} off the road; {sum(m > 1 for m in moved)} of {len(walkers)} people walked; "
            f"{len(ids_seen)} actors in the pictures"
        )
        check(off_road == 0, f"{off_road} vehicles are off the road")
        check(not vehicles or median > 0.08 * args.frames * 0.05 * 13, f"the median vehicle drove {median:.1f} m")
        check(not walkers or sum(m > 1 for m in moved) > 0.7 * len(walkers), "people do not walk")
        for actor in [*sensors, *world.get_actors(controllers)]:
            actor.stop()
        gone = [sensor.id for sensor in sensors] + controllers + vehicles + walkers
        # Not with a tick: the client would hold Python's lock while it waits, which its own threads need to let go of
        # what listened.
        answers = client.apply_batch_sync([carla.command.DestroyActor(x) for x in gone], False)
        world.tick()
        check(not [a.error for a in answers if a.error], "not all actors could be destroyed")
        check(not world.get_actors().filter("vehicle.*"), "vehicles are left")
        settings.synchronous_mode, settings.fixed_delta_seconds = False, None
        # It looks at the world all the time, also while there is none.
        manager.shut_down()
        world.apply_settings(settings)
        check(client.load_world(client.get_available_maps()[0].rsplit("/", 1)[-1]).get_map() is not None, "no other map")
    print("all held")


if __name__ == "__main__":
    main()
