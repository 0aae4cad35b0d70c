"""A 2D lidar by its figures."""

import dataclasses
import json


@dataclasses.dataclass(frozen=True)
class Scanner:
    """What robots carry instead of a suite by name; as a suite file has it (docs/sensors.md).

    rate_hz: a revolution takes 1 / rate_hz of simulated time, and what an observation shows is the
    last whole one. Where only the moment matters, a rate of one fixed step (100) costs least.
    """

    beams: int = 360
    max_range_m: float = 30.0
    rate_hz: float = 100.0
    field_of_view_deg: float = 360.0
    min_range_m: float = 0.1
    noise_m: float = 0.0
    dropout_probability: float = 0.0
    max_range_reflectivity: float = 0.01  # of the darkest that it sees from max_range_m
    above_top_m: float = 0.06

    name = "scanner of its own"

    def sensor_file(self):
        """The text of a file of sensors that has the suite `name`."""
        lidar = {"name": self.name, "source": "figures given", "columns": self.beams,
                 "first_azimuth_deg": -0.5 * self.field_of_view_deg,
                 "field_of_view_deg": self.field_of_view_deg, "min_range_m": self.min_range_m,
                 "max_range_m": self.max_range_m, "noise_m": self.noise_m,
                 "max_range_reflectivity": self.max_range_reflectivity,
                 "dropout_probability": self.dropout_probability}
        sensor = {"name": "scan", "rate_hz": self.rate_hz, "on_top": True,
                  "position_m": [0, 0, self.above_top_m], "lidar": {"model": self.name}}
        return json.dumps({"lidars": [lidar], "suites": [{"name": self.name, "sensors": [sensor]}]})
