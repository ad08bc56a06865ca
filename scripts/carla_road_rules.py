"""Who stops at red lights and who leaves the road, for `judge_carla.py`.

A light that was green while a vehicle stood in its box is green to CARLA's TrafficManager until the vehicle leaves the box
(`SimulationState::UpdateTrafficLightState`): one that has come by green and is held up by others goes on when it can.
"""

import collections

import carla

# A light that is red for so long has been seen by all who pass it, seconds.
SEEN_S = 2.0
STANDS_MPS = 0.2
BESIDE_M = 1.0


class RoadRules:
    """Watches vehicles frame after frame."""

    def __init__(self, world, vehicles, step_s):
        self.roads, self.step_s = world.get_map(), step_s
        self.vehicles = list(world.get_actors(vehicles))
        self.lights = {light.id: light for light in world.get_actors().filter("traffic.traffic_light")}
        self.red_s = collections.Counter()
        # The light at which each vehicle was in the last frame, and who has seen it green since they came there.
        self.at, self.let_by = {}, set()
        self.stood, self.ran, self.left = set(), set(), set()

    def frame(self, number):
        for light in self.lights.values():
            is_red = light.get_state() == carla.TrafficLightState.Red
            self.red_s[light.id] = self.red_s[light.id] + self.step_s if is_red else 0.0
        for vehicle in self.vehicles:
            light = vehicle.get_traffic_light() if vehicle.is_at_traffic_light() else None
            before, self.at[vehicle.id] = self.at.get(vehicle.id), light.id if light else None
            let_by = vehicle.id in self.let_by
            if self.at[vehicle.id] != before:
                self.let_by.discard(vehicle.id)
            if light and light.get_state() == carla.TrafficLightState.Green:
                self.let_by.add(vehicle.id)
            if light and self.red_s[light.id] > 0 and vehicle.get_velocity().length() < STANDS_MPS:
                self.stood.add(vehicle.id)
            if before and not light and not let_by and self.red_s[before] > SEEN_S:
                if self.roads.get_waypoint(vehicle.get_location()).is_junction:
                    self.ran.add(vehicle.id)
            if number % 10 == 0:
                here = vehicle.get_location()
                lane = self.roads.get_waypoint(here)
                if lane.transform.location.distance(here) > 0.5 * lane.lane_width + BESIDE_M:
                    self.left.add(vehicle.id)
