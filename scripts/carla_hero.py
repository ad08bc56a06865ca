#!/usr/bin/env python3
"""Drives the vehicle of role `hero` on a CARLA server, wherever it comes from: along its lane, and not into what is ahead.

    python3 scripts/carla_hero.py PORT [SPEED]

SPEED: m/s, 8 unless told. For ScenarioRunner, whose scenarios wait for somebody to drive the ego vehicle. It goes on until it is
stopped, and follows every frame that the server tells of; it makes no time pass.
"""

import math
import sys
import time

import carla

# Half of the width of what counts as ahead, and what is kept free before it, metres.
BESIDE_M = 1.9
GAP_M = 6.0
BRAKES_MPS2 = 5.0


def along(transform, place):
    """How far ahead and how far to the right a place is, metres."""
    yaw = math.radians(transform.rotation.yaw)
    dx, dy = place.x - transform.location.x, place.y - transform.location.y
    return dx * math.cos(yaw) + dy * math.sin(yaw), dy * math.cos(yaw) - dx * math.sin(yaw)


def free_way(hero, others):
    """Metres until the next thing ahead."""
    nearest, pose = math.inf, hero.get_transform()
    for other in others:
        ahead, aside = along(pose, other.get_location())
        box = other.bounding_box.extent
        if ahead > 0 and abs(aside) < BESIDE_M + min(box.x, box.y):
            nearest = min(nearest, ahead - box.x - hero.bounding_box.extent.x)
    return nearest


def control(world, roads, hero, wanted):
    """The pedals and the steering wheel for this instant."""
    pose, speed = hero.get_transform(), hero.get_velocity().length()
    others = [a for a in world.get_actors() if a.id != hero.id and a.type_id.split(".")[0] in ("vehicle", "walker", "static")]
    free = max(0.0, free_way(hero, others) - GAP_M)
    light = hero.get_traffic_light_state() == carla.TrafficLightState.Red and hero.is_at_traffic_light()
    allowed = 0.0 if light else min(wanted, math.sqrt(2 * BRAKES_MPS2 * 0.5 * free) if free < 100 else wanted)
    here = roads.get_waypoint(pose.location)
    ways = here.next(4.0 + 0.6 * speed)
    steer = 0.0
    if ways:
        # The way that turns least; a circle through the point on it.
        target = min(ways, key=lambda way: abs((way.transform.rotation.yaw - pose.rotation.yaw + 180) % 360 - 180))
        ahead, aside = along(pose, target.transform.location)
        wheel = math.atan(2 * 2.9 * aside / max(ahead * ahead + aside * aside, 1.0))
        steer = max(-1.0, min(1.0, wheel / math.radians(hero.get_physics_control().wheels[0].max_steer_angle)))
    error = allowed - speed
    throttle = max(0.0, min(0.75, 0.25 * error + (0.2 if allowed > 0.5 else 0.0))) if error > -0.3 else 0.0
    brake = max(0.0, min(1.0, -0.4 * error)) if error < -0.3 else float(allowed < 0.1) * 0.5
    return carla.VehicleControl(throttle=throttle, brake=brake, steer=steer)


def main():
    port, wanted = int(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 8.0
    client = carla.Client("127.0.0.1", port)
    client.set_timeout(60.0)
    hero, roads, episode = None, None, None
    while True:
        try:
            world = client.get_world()
            if world.id != episode:
                hero, roads, episode = None, world.get_map(), world.id
            world.wait_for_tick(1.0)
            if hero is None or not hero.is_alive:
                heroes = [v for v in world.get_actors().filter("vehicle.*") if v.attributes.get("role_name") == "hero"]
                hero = heroes[0] if heroes else None
            if hero is not None:
                hero.apply_control(control(world, roads, hero, wanted))
        except RuntimeError:
            # No frame, another map, or the hero has gone: all of that is the other program's business.
            hero = None
            time.sleep(0.1)


if __name__ == "__main__":
    main()
