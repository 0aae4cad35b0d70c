#!/usr/bin/python3
"""world_server with a language model behind an OpenAI-compatible server: this test is the server."""

import http.server
import json
import os
import pathlib
import subprocess
import tempfile
import threading
import unittest

import actionlib
import rospkg
import yaml
from actionlib_msgs.msg import GoalStatus
from diagnostic_msgs.msg import DiagnosticArray
from rosgraph_msgs.msg import Clock

from latticeworld.msg import (GenerateWorldTaskAction, GenerateWorldTaskGoal, GenerationProgress,
                              Status)
from server_process import Server
from world_client import TIMEOUT_S, Collector, World, run

KEY_VARIABLE = "LATTICEWORLD_TEST_KEY"
KEY = "sk-very-secret-7c1d"
ROWS = ["W" * 32] * 10 + ["G" * 32] * 22
LAYOUT = "A lake covers the north. The rest is grassland."


class LanguageServer:
    """Answers with whatever self.answers holds next: a list of texts, sent one by one, and of Events
    to wait for between them."""

    def __init__(self):
        self.answers = []
        self.requests = []  # (headers, body)
        self.asked = threading.Condition()
        test = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_POST(self):
                body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
                with test.asked:
                    test.requests.append((dict(self.headers), body))
                    answer = test.answers.pop(0)
                    test.asked.notify_all()
                self.close_connection = True
                self.send_response(200)
                self.send_header("Content-Type", "text/event-stream")
                self.end_headers()
                for piece in answer:
                    if isinstance(piece, threading.Event):
                        piece.wait(TIMEOUT_S)
                    else:
                        self.event({"choices": [{"index": 0, "delta": {"content": piece}}]})
                self.event({"choices": [{"index": 0, "delta": {}, "finish_reason": "stop"}],
                            "usage": {"prompt_tokens": 11, "completion_tokens": 22}})
                self.wfile.write(b"data: [DONE]\n\n")

            def event(self, value):
                self.wfile.write(b"data: " + json.dumps(value).encode() + b"\n\n")
                self.wfile.flush()

            def log_message(self, *_):
                pass

        self.http = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.http.daemon_threads = True
        threading.Thread(target=self.http.serve_forever, daemon=True).start()
        self.url = f"http://127.0.0.1:{self.http.server_address[1]}/v1"

    def wait_until_asked(self, times):
        with self.asked:
            assert self.asked.wait_for(lambda: len(self.requests) >= times, TIMEOUT_S)

    def close(self):
        self.http.shutdown()
        self.http.server_close()


class LanguageTest(unittest.TestCase):
    def setUp(self):
        os.environ[KEY_VARIABLE] = KEY
        self.model = LanguageServer()
        self.addCleanup(self.model.close)

    def server(self, **parameters):
        return Server(**{"remote_url": self.model.url, "remote_model": "parrot", "generator": "grounded",
                         "remote_api_key_variable": KEY_VARIABLE, "remote_max_retries": 0,
                         **parameters})

    def test_the_launch_file_names_the_model_of_the_server(self):
        launch = pathlib.Path(rospkg.RosPack().get_path("latticeworld")) / "launch_cfg/world.launch"
        dumped = subprocess.check_output(
            ["roslaunch", "--dump-params", str(launch), f"remote_url:={self.model.url}",
             "remote_model:=qwen3:8b"], text=True)
        self.assertEqual("qwen3:8b", yaml.safe_load(dumped)["/world_server/remote_model"])

    def test_a_model_makes_a_world_and_the_bundle_keeps_what_it_said(self):
        with tempfile.TemporaryDirectory() as worlds, self.server(worlds_directory=worlds) as server:
            world = World()
            environment = world.generate(seed=3, layout=LAYOUT).environment
            seen = threading.Event()
            self.addCleanup(seen.set)
            half = ["\n".join(ROWS[:16]) + "\n", seen, "\n".join(ROWS[16:]) + "\n"]
            self.model.answers = [half, [environment]]
            progress = Collector("world/progress", GenerationProgress)
            progress.wait_until_connected()
            diagnostics = Collector("diagnostics", DiagnosticArray)

            answers = []
            caller = threading.Thread(target=lambda: answers.append(
                world.generate(seed=4, layout=LAYOUT, generator="remote")))
            caller.start()
            # Rows show as they arrive.
            progress.wait_for(lambda m: m.stage == "layout" and m.fraction == 0.5)
            seen.set()
            caller.join(TIMEOUT_S)
            answer, = answers
            self.assertEqual("remote", answer.generator)
            self.assertEqual(ROWS, answer.layout.split())
            claims = [claim for claim in answer.fidelity if claim.part == "layout"]
            self.assertTrue(claims)
            for claim in claims:
                self.assertTrue(claim.satisfied, claim.explanation)
                self.assertIn(claim.words, LAYOUT)
            self.assertEqual(answer.fidelity, world.get_world().fidelity)

            # It was asked with the key, and the key went nowhere else.
            self.assertEqual({f"Bearer {KEY}"},
                             {headers.get("Authorization") for headers, _ in self.model.requests})
            saved = pathlib.Path(world.save_world(name="kept").path)
            replies = json.loads((saved / "replies.json").read_text(encoding="utf-8"))
            self.assertEqual(["layout", "environment"], [reply["purpose"] for reply in replies])
            self.assertEqual(ROWS, replies[0]["text"].split())
            for file in saved.rglob("*"):
                if file.is_file():
                    self.assertNotIn(KEY.encode(), file.read_bytes(), file)
            self.assertNotIn(KEY, server.text())
            health = diagnostics.wait_for(lambda m: self.value(m, "requests") == "2")
            self.assertEqual("44", self.value(health, "completion tokens"))
            self.assertEqual("0", self.value(health, "failures"))

            # The bundle gives the same world without the model.
            self.assertEqual(Status.OK, world.load_world(name="kept").status.code)
            self.assertEqual(answer.world_id, world.get_world().info.world_id)

    def test_a_model_that_hangs_stops_neither_clock_nor_cancel(self):
        hang = threading.Event()
        self.addCleanup(hang.set)
        with self.server():
            world = World()
            before = world.generate(seed=3)
            self.model.answers = [[hang]]
            client = actionlib.SimpleActionClient("generate_world_action", GenerateWorldTaskAction)
            self.assertTrue(client.wait_for_server())
            client.send_goal(GenerateWorldTaskGoal(layout_instruction=LAYOUT, generator="remote"))
            self.model.wait_until_asked(1)
            # A second of simulated time passes while the model says nothing.
            clock = Collector("/clock", Clock)
            first = clock.wait_for_next().clock
            clock.wait_for(lambda m: (m.clock - first).to_sec() > 1.0)
            # Nor is a second request kept waiting for it.
            refused = world.generate_world(layout_instruction=LAYOUT)
            self.assertEqual(Status.RESOURCE_EXHAUSTED, refused.status.code)
            client.cancel_goal()
            self.assertTrue(client.wait_for_result())
            self.assertFalse(hang.is_set())
            self.assertEqual(GoalStatus.PREEMPTED, client.get_state())
            self.assertEqual(before.world_id, world.get_world().info.world_id)

    def test_a_server_that_is_not_there_is_an_error_or_the_grounded_back_end(self):
        self.model.close()
        with self.server():
            world = World()
            before = world.generate(seed=3)
            answer = world.generate_world(layout_instruction=LAYOUT, generator="remote")
            self.assertEqual(Status.UNAVAILABLE, answer.status.code, answer.status.message)
            self.assertIn(self.model.url.rsplit("/", 1)[0], answer.status.message)
            self.assertEqual(before.world_id, world.get_world().info.world_id)
        with self.server(remote_fallback=True, generator="remote"):
            answer = World().generate(seed=3)
            self.assertTrue(any("grounded" in warning for warning in answer.warnings),
                            answer.warnings)
            self.assertEqual(before.world_id, answer.world_id)

    def test_a_model_reads_for_the_grounded_generator(self):
        def words(*sentences):
            return [json.dumps({"sentences": sentences})]

        lake = words("Water fills the southern third.", "No houses.")
        night = words("Time: night.", "2 goblins attacking.")
        with self.server():
            world = World()
            self.model.answers = [lake, night]
            answer = world.generate(seed=4, layout="somewhere to swim where the sun stands at noon",
                                    environment="moonlight and a brawl", reader="remote")
            self.assertEqual(("remote", "grounded"), (answer.reading.reader, answer.generator))
            self.assertEqual(["Water fills the southern third", "No houses"], answer.reading.layout)
            self.assertEqual(["Time: night", "2 goblins attacking"], answer.reading.environment)
            south = "".join(answer.layout.split()[-10:])
            self.assertGreater(south.count("W"), len(south) // 2, answer.layout)
            self.assertNotIn("B", answer.layout)
            self.assertEqual("night", json.loads(answer.environment)["coarse"]["time_of_day"])
            # What the rules read in the person's words is measured beside what was made of them.
            said = {claim.words: claim.satisfied for claim in answer.reading.second if claim.part == "environment"}
            self.assertTrue(said.get("moonlight"), said)
            self.assertGreater(answer.reading.words, answer.reading.words_read)
            shown = self.model.requests[0][1]["messages"][0]["content"]
            self.assertIn("{x} surrounds|surround {y}", shown)

    def test_what_a_model_says_wrongly_never_becomes_a_world(self):
        with self.server(remote_repair_turns=1):
            world = World()
            before = world.generate(seed=3)
            self.model.answers = [["Here is your map:\n" + "X" * 32 + "\n"], ["No."]]
            answer = world.generate_world(layout_instruction=LAYOUT, generator="remote")
            self.assertEqual(Status.DATA_LOSS, answer.status.code, answer.status.message)
            self.assertEqual(2, len(self.model.requests))
            self.assertEqual(before.world_id, world.get_world().info.world_id)

    @staticmethod
    def value(diagnostics, key):
        """Of the language entry; None when it is not there."""
        for status in diagnostics.status:
            if status.name == "world_server: language":
                return {entry.key: entry.value for entry in status.values}.get(key)
        return None


if __name__ == "__main__":
    run("language_test", LanguageTest)
