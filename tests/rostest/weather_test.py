#!/usr/bin/python3
"""Weather that changes while a world runs."""

import math
import subprocess

from geometry_msgs.msg import Point

from latticeworld.msg import AgentEvent, Status, Weather
from latticeworld.srv import SetWeather
from world_client import Collector, WorldTest, run, service

POINTS = [Point(x=x, y=y) for x in range(-60, 61, 15) for y in range(-60, 61, 15)]
PAVED_OR_SOIL = ("grass", "forest floor", "farmland", "barren", "road", "building", "rock")


class WeatherTest(WorldTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.set_weather = service("set_weather", SetWeather)

    def ground(self):
        return self.assert_ok(self.world.query_terrain(points=POINTS)).samples

    def test_rain_makes_the_ground_slippery_until_the_reset(self):
        weather = Collector("world/weather", Weather)
        events = Collector("agent_events", AgentEvent)
        events.wait_until_connected()
        self.assertEqual("sunny", weather.wait_for(lambda m: True).weather)
        dry = self.ground()
        answer = self.assert_ok(self.set_weather(weather="rain"))
        self.assertEqual(self.world.get_world().info.world_id, answer.world_id)
        self.assertEqual("rain", answer.weather.weather)
        wet = self.ground()
        compared = 0
        for before, after in zip(dry, wet):
            self.assertLessEqual(after.friction, before.friction)
            self.assertGreaterEqual(after.rolling_resistance, before.rolling_resistance)
            if before.surface in PAVED_OR_SOIL:
                self.assertLess(after.friction, before.friction)
                compared += 1
            if before.water_depth > 0.0:
                self.assertAlmostEqual(before.water_depth + answer.weather.water_rise,
                                       after.water_depth)
        self.assertGreater(compared, 20)
        rain = weather.wait_for(lambda m: m.weather == "rain")
        self.assertGreater(rain.rain, 2.5)
        self.assertEqual(0.0, rain.remaining)
        told = events.wait_for(lambda m: m.kind == "weather_changed")
        self.assertEqual(("", "rain"), (told.agent, told.other))
        self.assertEqual(rain.header.stamp, told.header.stamp)

        self.assert_ok(self.world.reset_world())
        weather.wait_for(lambda m: m.weather == "sunny" and m.header.stamp > rain.header.stamp)
        self.assertEqual(str(dry), str(self.ground()))  # where there is no deck, NaN is like NaN
        weather.close()
        events.close()

    def test_a_transition_moves_and_says_when_it_is_there(self):
        weather = Collector("world/weather", Weather)
        events = Collector("agent_events", AgentEvent)
        events.wait_until_connected()
        self.assertTrue(self.world.pause().success)
        self.assert_ok(self.set_weather(weather="fog", intensity=[1.0], hour=[20.5],
                                        transition=3.0))
        begun = weather.wait_for(lambda m: m.remaining == 3.0)
        self.assert_ok(self.world.step(steps=301))
        there = weather.wait_for(lambda m: m.weather == "fog" and m.remaining == 0.0)
        self.assertLess(there.visibility, 50.0)
        self.assertLess(there.visibility, begun.visibility)
        self.assertAlmostEqual(20.5, there.hour)
        between = [m for m in weather.messages() if 0.0 < m.remaining < 3.0]
        self.assertGreater(len(between), 0)
        events.wait_for(lambda m: m.other == "fog")
        self.assertEqual(["fog begins", "fog"],
                         [m.other for m in events.messages() if m.kind == "weather_changed"])
        # A late subscriber hears the last word.
        late = Collector("world/weather", Weather)
        self.assertEqual(there, late.wait_for(lambda m: True))
        for collector in (weather, events, late):
            collector.close()

    def test_the_same_change_at_the_same_step_gives_the_same_run(self):
        self.assertTrue(self.world.pause().success)
        hashes = []
        for _ in range(2):
            self.assert_ok(self.world.reset_world())
            self.assert_ok(self.world.step(steps=50))
            self.assert_ok(self.set_weather(weather="sandstorm", transition=0.5))
            hashes.append(self.assert_ok(self.world.step(steps=150, hash=True)).state_hash)
        self.assertEqual(hashes[0], hashes[1])
        self.assert_ok(self.world.reset_world())
        self.assertNotEqual(hashes[0], self.world.step(steps=200, hash=True).state_hash)

    def test_what_is_unusable_is_named_and_changes_nothing(self):
        self.assertTrue(self.world.pause().success)
        before = self.world.get_world().state_hash
        self.assert_refused(self.set_weather(weather="hail"), Status.INVALID_ARGUMENT, "hail",
                            "sunny", "cloudy", "rain", "snow", "fog", "sandstorm")
        self.assert_refused(
            self.set_weather(weather="hail", intensity=[2.0], hour=[24.0], snow_depth=[0.1, 0.2],
                             wind_speed=[math.inf], transition=-1.0),
            Status.INVALID_ARGUMENT, "hail", "intensity", "hour", "snow_depth", "wind_speed",
            "transition")
        self.assertEqual(before, self.world.get_world().state_hash)

    def test_nothing_said_changes_nothing(self):
        self.assertTrue(self.world.pause().success)
        before = self.world.get_world().state_hash
        answer = subprocess.run(["rosservice", "call", "/set_weather", "{}"], check=True,
                                capture_output=True, text=True)
        self.assertIn("weather: \"sunny\"", answer.stdout)
        self.assertIn("code: 0", answer.stdout)
        nan = [math.nan]
        self.assert_ok(self.set_weather(intensity=nan, wind_speed=nan, hour=nan, snow_depth=nan,
                                        transition=math.nan))
        self.assertEqual(before, self.world.get_world().state_hash)
        answer = subprocess.run(["rosservice", "call", "/set_weather", "{weather: snow}"],
                                check=True, capture_output=True, text=True)
        self.assertIn("weather: \"snow\"", answer.stdout)
        self.assertNotEqual(before, self.world.get_world().state_hash)


if __name__ == "__main__":
    run("weather_test", WeatherTest)
