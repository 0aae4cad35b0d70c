#!/usr/bin/python3
"""How world_viewer starts and ends, and who may control, without a world_server."""

import pathlib
import subprocess
import unittest

import rospkg
import yaml

from viewer_client import Socket, Viewer
from world_client import TIMEOUT_S, run

PACKAGE = pathlib.Path(rospkg.RosPack().get_path("latticeworld"))
DEFAULTS = PACKAGE / "launch_cfg/world_viewer.yaml"
LAUNCH = PACKAGE / "launch_cfg/viewer.launch"


class ViewerStartTest(unittest.TestCase):
    def test_the_shipped_parameters_are_legal_and_it_ends_when_told(self):
        parameters = yaml.safe_load(DEFAULTS.read_text(encoding="utf-8"))
        self.assertGreater(len(parameters), 7)
        with Viewer(**{**parameters, "port": 0}) as viewer, Socket(viewer) as client:
            self.assertIsNone(client.wait_for_type("hello")["world"])
            self.assertEqual(0, viewer.stop(), viewer.text())

    def test_the_shipped_launch_file_has_both_nodes_and_every_parameter(self):
        def roslaunch(what):
            return subprocess.check_output(["roslaunch", what, str(LAUNCH), "port:=0"], text=True)

        self.assertEqual({"/world_server", "/world_viewer"}, set(roslaunch("--nodes").split()))
        given = yaml.safe_load(roslaunch("--dump-params"))
        for name in yaml.safe_load(DEFAULTS.read_text(encoding="utf-8")):
            self.assertIn(f"/world_viewer/{name}", given)
        self.assertEqual(0, given["/world_viewer/port"])

    def test_bad_parameters_are_all_named(self):
        with Viewer(prot=1, host="somewhere", max_clients=0, state_rate="fast",
                    require_token=True) as viewer:
            self.assertEqual(1, viewer.process.wait(TIMEOUT_S))
            for word in ("prot", "somewhere", "max_clients", "state_rate", "require_token"):
                self.assertIn(word, viewer.text())

    def test_who_has_no_token_may_look_only(self):
        secret = "a-token-for-tests"
        with Viewer(environment={"LATTICEWORLD_VIEWER_TOKEN": secret},
                    require_token=True) as viewer, Socket(viewer) as client:
            self.assertEqual("viewer", client.wait_for_type("hello")["role"])
            self.assertEqual("PERMISSION_DENIED", client.ask(type="pause")["code"])
            self.assertEqual("UNAUTHENTICATED",
                             client.ask(type="authenticate", token="wrong")["code"])
            self.assertTrue(client.ask(type="authenticate", token=secret)["ok"])
            self.assertEqual("UNAVAILABLE", client.ask(type="pause")["code"])
            viewer.stop()
            self.assertNotIn(secret, viewer.text())


if __name__ == "__main__":
    run("viewer_start_test", ViewerStartTest)
