"""scripts/benchmarks.py: tables from what programs say, and that page, comparisons and programs fit."""

import collections
import os
import pathlib
import re
import subprocess
import sys
import types
import unittest
from unittest import mock

ROOT = pathlib.Path(os.environ["LATTICEWORLD_ROOT"])
PROGRAMS = pathlib.Path(os.environ.get("LATTICEWORLD_PROGRAMS", "nowhere"))
sys.path.insert(0, str(ROOT / "scripts"))
import benchmarks

COMPARISONS = """
- name: steps
  program: physics
  other: bare
  rows:
    - {for: [100, 20000], what: '{} robots', ours: 'BM_Robots/{} steps_ps', other: . bare_steps_ps,
       aim: at least 2.5, watched: steps_ps}
    - {what: a map, ours: BM_Map, other: BM_Grid cpu_time, aim: at most 2 ms}
    - {what: 'a map, alone', program: mapping, ours: BM_Map cpu_time, watched: cpu_time}
"""
# As google-benchmark 1.7 writes it.
RUN = """{"context": {"num_cpus": 2}, "benchmarks": [
 {"name": "BM_Robots/100/iterations:5/manual_time", "run_type": "iteration", "real_time": 19.0,
  "cpu_time": 80.0, "time_unit": "ms", "steps_ps": 540.0, "bare_steps_ps": 180.0},
 {"name": "BM_Robots/20000/iterations:5/manual_time", "run_type": "iteration", "real_time": 1.0,
  "cpu_time": 2.0, "time_unit": "s", "steps_ps": 12345.0, "bare_steps_ps": 6000.0},
 {"name": "BM_Map/process_time/real_time", "run_type": "iteration", "real_time": 2500.0,
  "cpu_time": 3000.0, "time_unit": "us"},
 {"name": "BM_Grid", "run_type": "iteration", "real_time": 9.0, "cpu_time": 8.0,
  "time_unit": "ms"}]}"""
OPTIONS = types.SimpleNamespace(turns=1, min_time=0.1, before=pathlib.Path("/before"))


def tables_on_page():
    return benchmarks.read_comparisons(benchmarks.COMPARISONS.read_text(encoding="utf-8"))


class BenchmarksTest(unittest.TestCase):
    def test_a_table_has_both_sides_their_ratio_and_the_aim(self):
        with mock.patch.object(benchmarks, "run", return_value=RUN) as run:
            table, how = benchmarks.compare(benchmarks.read_comparisons(COMPARISONS)["steps"],
                                            OPTIONS)
        self.assertEqual(["| what | LatticeWorld | bare | times as fast | aim |",
                          "|---|---|---|---|---|",
                          "| 100 robots | 540/s | 180/s | 3.00 | at least 2.5 |",
                          "| 20,000 robots | 12,300/s | 6,000/s | 2.06 | at least 2.5, **missed** |",
                          "| a map | 2.50 ms | 8.00 ms | 3.20 | at most 2.00 ms, **missed** |",
                          "| a map, alone | 3.00 ms |  |  |  |"], table.splitlines())
        self.assertEqual("medians of 1", how)
        pattern = run.call_args_list[0].args[0][-1].split("=")[1]
        self.assertTrue(re.search(pattern, "BM_Robots/100/iterations:5/manual_time"))
        self.assertFalse(re.search(pattern, "BM_Robots/1000/iterations:5/manual_time"))

    def test_what_got_slower_stands_out(self):
        def run(command):
            slower = "/before" in str(command[0])  # the rate there was higher, the time was less
            return RUN.replace("540.0", "800.0").replace("3000.0", "2950.0") if slower else RUN

        with mock.patch.object(benchmarks, "run", side_effect=run), \
                mock.patch.object(benchmarks, "commit_of", return_value="commit abc"):
            table, how = benchmarks.compare_before(benchmarks.read_comparisons(COMPARISONS),
                                                   OPTIONS)
        self.assertEqual("medians of 1; before: commit abc", how)
        self.assertEqual(["| what | before | after | times as long |", "|---|---|---|---|",
                          "| 100 robots | 800/s | 540/s | **1.48** |",
                          "| 20,000 robots | 12,300/s | 12,300/s | 1.00 |",
                          "| a map, alone | 2.95 ms | 3.00 ms | 1.02 |"], table.splitlines())

    def test_figures_are_medians_of_turns_that_change_sides(self):
        times = iter("3195")
        with mock.patch.object(benchmarks, "run", side_effect=lambda _: RUN.replace(
                '"cpu_time": 8.0', f'"cpu_time": {next(times)}')) as run:
            options = types.SimpleNamespace(turns=2, min_time=0.1)
            sides = [("one", "BM_Grid", "cpu_time"), ("two", "BM_Grid", "cpu_time")]
            runs = benchmarks.measured(sides, [pathlib.Path("d")], options)
        self.assertEqual(["one", "two", "two", "one"],
                         [call.args[0][0].name.split("_")[0] for call in run.call_args_list])
        self.assertAlmostEqual(0.004, benchmarks.median_of(runs, pathlib.Path("d"), sides[0]).value)

    def test_what_a_program_prints_is_read(self):
        table = {"command": "x", "unit": "ms", "rows": [
            {"what": "a call", "ours": r"^server ([\d.]+)", "other": r"client ([\d.]+)"}]}
        with mock.patch.object(benchmarks, "run", return_value="first\nserver 0.5, client 2 ms\n"):
            self.assertIn("| a call | 500 us | 2.00 ms | 4.00 |",
                          benchmarks.compare(table, OPTIONS)[0])
            table["rows"][0]["ours"] = "nothing ([0-9])"
            with self.assertRaisesRegex(benchmarks.Failed, "nothing"):
                benchmarks.compare(table, OPTIONS)

    def test_a_benchmark_that_is_not_there_or_fails_is_told(self):
        with self.assertRaisesRegex(benchmarks.Failed, "no BM_None"):
            benchmarks.median_of(collections.defaultdict(list), ROOT, ("one", "BM_None", ""))
        with self.assertRaisesRegex(benchmarks.Failed, "BM_Grid: no file"):
            benchmarks.read_run(RUN.replace('"BM_Grid",', '"BM_Grid", "error_occurred": true, '
                                                          '"error_message": "no file",'))

    def test_the_text_between_the_marks_of_a_table_is_replaced_and_no_other(self):
        page = ("a\n<!-- scripts/benchmarks.py one -->\nold\n<!-- end -->\nb\n"
                "<!-- scripts/benchmarks.py two -->\n<!-- end -->\nc\n"
                "<!-- scripts/benchmarks.py four -->\n<!-- end -->\n")
        self.assertEqual(page.replace("old\n", "new\n"), benchmarks.replaced(page, "one", "new\n"))
        self.assertIn("two -->\nnew\n<!-- end -->\nc\n", benchmarks.replaced(page, "two", "new\n"))
        with self.assertRaisesRegex(benchmarks.Failed, "0 tables"):
            benchmarks.replaced(page, "three", "new\n")

    def test_machine_and_commit_are_told(self):
        with mock.patch.object(benchmarks, "compiler", return_value="g++ 12, -O3"):
            self.assertRegex(benchmarks.machine(), r"\d+ CPUs.* \d+ GiB; .*; g\+\+ 12, -O3$")
        self.assertRegex(benchmarks.commit_of(ROOT), "^commit [0-9a-f]{7,}")

    def test_the_page_has_a_place_for_every_table_and_no_other(self):
        marks = re.findall(r"^<!-- scripts/benchmarks.py (\S+) -->$",
                           benchmarks.PAGE.read_text(encoding="utf-8"), re.MULTILINE)
        self.assertCountEqual([*tables_on_page(), benchmarks.BEFORE], marks)

    def test_sources_have_every_benchmark_and_counter(self):
        sources = "".join(path.read_text(encoding="utf-8")
                          for path in (ROOT / "benchmarks").rglob("*.cc"))
        for side in sides_of_programs():
            self.assertIn(side[1].split("/")[0], sources, side)

    def test_built_programs_have_every_benchmark(self):
        names, built = collections.defaultdict(set), 0
        for program, benchmark, _ in sides_of_programs():
            names[program].add(benchmark)
        for program, wanted in names.items():
            path = PROGRAMS / f"{program}_benchmark"
            if path.exists():
                built += 1
                listed = subprocess.run([path, "--benchmark_list_tests"], text=True, check=True,
                                        stdout=subprocess.PIPE).stdout.split()
                self.assertLessEqual(wanted, {re.sub(f"{benchmarks.TIMED}$", "", name)
                                              for name in listed}, program)
        if not built:
            self.skipTest("no benchmark is built")


def sides_of_programs():
    return [row[side] for table in tables_on_page().values() if "program" in table
            for row in table["rows"] for side in benchmarks.SIDES if side in row]


if __name__ == "__main__":
    unittest.main()
