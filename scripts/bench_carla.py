"""Times `endless serve` through CARLA's own client.

    python scripts/bench_carla.py endless [--map Town03] [--quality-level Epic] [--seconds 10] [--minutes 0 [--pace 20]]

Needs `pip install carla==0.9.16 numpy`. Prints: answers a second to one client that waits for each, to one that does not, and to
eight that wait; frames a second of a camera on a pole and of one on a moving car, in synchronous mode, with thirty vehicles that
the client's TrafficManager drives; memory before and after a hundred clients, and while time passes for some minutes with a
small camera, at a pace of so many ticks a second.
"""

import argparse
import multiprocessing
import queue
import random
import socket
import sys
import time

import carla

from carla_server import Server
from ports import free_port
from judge_carla import spawn_traffic, synchronous


def resident_mb(process):
    with open(f"/proc/{process.pid}/status") as status:
        return next(int(line.split()[1]) / 1024 for line in status if line.startswith("VmRSS"))


def answers_a_second(port, seconds, at_once, method=b"version"):
    """Of the raw protocol: what Python's msgpack or CARLA's client take is left out."""
    request = bytes([0x94, 0, 1, 0xA0 + len(method)]) + method + bytes([0x91, 0x91, 0xC2])
    with socket.create_connection(("127.0.0.1", port)) as client:
        client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        client.sendall(request)
        # All answers are as long as the first, which arrives whole.
        size = len(client.recv(65536))
        count, end = 0, time.time() + seconds
        while time.time() < end:
            client.sendall(request * at_once)
            left = size * at_once
            while left:
                left -= len(client.recv(left))
            count += at_once
    return count / seconds


def answers_to_all(port, seconds, clients):
    """That wait for each, together."""
    with multiprocessing.get_context("spawn").Pool(clients) as pool:
        return sum(pool.starmap(answers_a_second, [(port, seconds, 1)] * clients))


def frames_a_second(world, blueprint, transform, parent, seconds):
    images = queue.Queue()
    sensor = world.spawn_actor(blueprint, transform, attach_to=parent)
    sensor.listen(images.put)
    for _ in range(3):
        world.tick()
        images.get(timeout=60)
    count, begin = 0, time.time()
    while time.time() < begin + seconds:
        world.tick()
        images.get(timeout=60)
        count += 1
    rate = count / (time.time() - begin)
    sensor.stop()
    sensor.destroy()
    return rate


def camera(world, kind, width, height):
    blueprint = world.get_blueprint_library().find(f"sensor.camera.{kind}")
    blueprint.set_attribute("image_size_x", str(width))
    blueprint.set_attribute("image_size_y", str(height))
    return blueprint


def as_time_passes(server, world, pole, args):
    """Prints the server's memory, a tenth of the time after another."""
    images = queue.Queue()
    sensor = world.spawn_actor(camera(world, "rgb", 160, 90), pole)
    sensor.listen(images.put)
    ticks = round(60 * args.minutes * args.pace)
    began = time.time()
    for number in range(ticks + 1):
        if number % max(ticks // 10, 1) == 0:
            minutes = (time.time() - began) / 60
            print(f"memory after {minutes:.1f} minutes, {number} ticks: {resident_mb(server.process):.0f} MB", flush=True)
        world.tick()
        images.get(timeout=60)
        time.sleep(max(0.0, began + number / args.pace - time.time()))
    sensor.stop()
    sensor.destroy()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--map", default="Town03")
    parser.add_argument("--quality-level", default="Epic", choices=("Low", "Epic"))
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--minutes", type=float, default=0)
    parser.add_argument("--pace", type=float, default=20, help="ticks a second in those minutes")
    args = parser.parse_args()
    with Server(args.program, args.map, flags=("--quality-level", args.quality_level)) as server:
        client = carla.Client("127.0.0.1", server.port)
        client.set_timeout(60)
        world = client.get_world()
        settings = synchronous(world)
        for at_once in (1, 100):
            print(f"answers a second, {at_once} at a time: {answers_a_second(server.port, 3, at_once):.0f}", flush=True)
        rate = answers_a_second(server.port, 3, 1, b"get_weather_parameters")
        print(f"answers a second of the world's own, 1 at a time: {rate:.0f}", flush=True)
        print(f"answers a second, to 8 clients: {answers_to_all(server.port, 3, 8):.0f}", flush=True)
        before = resident_mb(server.process)
        for _ in range(100):
            other = carla.Client("127.0.0.1", server.port)
            other.get_world().get_actors()
            del other
        print(f"memory before and after a hundred clients: {before:.0f} and {resident_mb(server.process):.0f} MB", flush=True)
        manager = client.get_trafficmanager(free_port())
        manager.set_synchronous_mode(True)
        manager.set_random_device_seed(1)
        vehicles = spawn_traffic(client, world, manager, 30, random.Random(1))
        for _ in range(20):
            world.tick()
        begin, ticks = time.time(), 0
        while time.time() < begin + args.seconds:
            world.tick()
            ticks += 1
        print(f"frames a second without sensors: {ticks / (time.time() - begin):.0f}", flush=True)
        car = world.get_actor(vehicles[0])
        place = car.get_transform()
        pole = carla.Transform(place.location + carla.Location(z=8), carla.Rotation(pitch=-25, yaw=place.rotation.yaw))
        roof = carla.Transform(carla.Location(x=1.5, z=2.4))
        for name, size, transform, parent in (("on a pole", (1280, 720), pole, None), ("on a car", (640, 360), roof, car)):
            rate = frames_a_second(world, camera(world, "rgb", *size), transform, parent, args.seconds)
            print(f"frames a second, RGB {size[0]}x{size[1]} {name}: {rate:.1f}", flush=True)
        if args.minutes:
            as_time_passes(server, world, pole, args)
        manager.shut_down()
        settings.synchronous_mode, settings.fixed_delta_seconds = False, None
        world.apply_settings(settings)


if __name__ == "__main__":
    sys.exit(main())
