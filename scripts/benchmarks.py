#!/usr/bin/python3
"""Makes the tables of docs/benchmarks.md anew: machine, flags, and both sides of each ratio.

What is compared with what stands in benchmarks/comparisons.yaml; a table of the page lies between
`<!-- scripts/benchmarks.py NAME -->` and `<!-- end -->`. Programs take turns, their benchmarks in
random order, and figures are medians of the turns. A table whose needs are not there is left as it
is, and that is said; so is one that fails, and the exit status is 1 then.

Usage: scripts/benchmarks.py [--only NAME ...] [--before DEVEL] [--turns N] [--min-time S]
       (after scripts/build.sh --with benchmarks, with nothing else running)
  --before DEVEL  the devel folder of an earlier build: the table "before" says what got slower
"""

import argparse
import collections
import datetime
import json
import os
import pathlib
import platform
import re
import shlex
import statistics
import subprocess
import sys
import textwrap
import time
import typing

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[1]
DEVEL = ROOT / "devel"
PAGE = ROOT / "docs/benchmarks.md"
COMPARISONS = ROOT / "benchmarks/comparisons.yaml"
BEFORE = "before"  # the table of what must not get slower
SLOWER = 1.03  # times as long: in bold
SIDES = ("ours", "other")
# What a benchmark's name ends in that says how it is timed.
TIMED = "(/(iterations|repeats|min_time|manual_time|real_time|process_time)[^/]*)*"
# What a name ends in, and what that is of a second or of one a second.
UNITS = {"ns": (1e-9, "s"), "us": (1e-6, "s"), "ms": (1e-3, "s"), "s": (1, "s"), "ps": (1, "/s"),
         "second": (1, "/s")}


class Failed(Exception):
    """A table cannot be made."""


class Figure(typing.NamedTuple):
    value: float
    unit: str  # "s": a time; "/s": a rate; "": neither

    def __str__(self):
        value, unit = self.value, self.unit
        if unit == "s":
            unit = next((unit for unit in ("s", "ms", "us") if value >= UNITS[unit][0]), "ns")
            value /= UNITS[unit][0]
        text = digits(value / 1e6) + " million" if value >= 1e6 else digits(value)
        return text + (unit if unit == "/s" else f" {unit}" if unit else "")


def digits(value):
    """Three digits that count."""
    rounded = float(f"{value:.3g}")
    return f"{rounded:,.0f}" if rounded >= 1000 else f"{rounded:#.3g}".rstrip(".")


def figure_of(value, unit):
    scale, base = UNITS.get(unit, (1, ""))
    return Figure(scale * float(value), base)


def times_as_fast(ours, other):
    return other.value / ours.value if ours.unit == "s" else ours.value / other.value


def read_comparisons(text):
    """{name: table}. A row with `for` becomes a row for each value, written where {} is; a side of
    google-benchmark's programs becomes (program, benchmark, field)."""
    tables = {}
    for table in yaml.safe_load(text):
        rows = []
        for row in table["rows"]:
            for value in row.get("for", [""]):
                shown = f"{value:,}" if isinstance(value, int) and value >= 10000 else str(value)
                rows.append({key: str(cell).replace("{}", shown if key == "what" else str(value))
                             for key, cell in row.items() if key != "for"})
        for row in rows if "program" in table else ():
            program = row.get("program", table["program"])
            row["ours"] = (program, *f"{row['ours']} ".split(" "))[:3]
            if "other" in row:
                name, field = f"{row['other']} ".split(" ")[:2]
                row["other"] = (table.get("other_program", program),
                                row["ours"][1] if name == "." else name, field)
        tables[table["name"]] = dict(table, rows=rows)
    return tables


# What programs say.

def run(command):
    done = subprocess.run(command, cwd=ROOT, text=True, stdout=subprocess.PIPE, check=False)
    if done.returncode != 0:
        raise Failed(f"{command} answers {done.returncode}")
    return done.stdout


def read_run(text):
    """{benchmark without how it is timed: what google-benchmark says of it as JSON}."""
    found = {}
    for one in json.loads(text)["benchmarks"] if text.strip() else ():
        if one.get("error_occurred"):
            raise Failed(f"{one['name']}: {one['error_message']}")
        found[re.sub(f"{TIMED}$", "", one["name"])] = one
    return found


def measured(sides, devels, options):
    """{(devel, program, benchmark): its run of each turn}."""
    programs = collections.defaultdict(set)
    for program, benchmark, _ in sides:
        programs[program].add(benchmark)
    order = [(devel, program) for program in programs for devel in devels]
    runs = collections.defaultdict(list)
    for turn in range(options.turns):
        for devel, program in order if turn % 2 == 0 else reversed(order):
            said = run([devel / f"lib/latticeworld/{program}_benchmark",
                        "--benchmark_format=json", f"--benchmark_min_time={options.min_time}",
                        "--benchmark_enable_random_interleaving=true",
                        f"--benchmark_filter=^({'|'.join(sorted(programs[program]))}){TIMED}$"])
            for benchmark, one in read_run(said).items():
                runs[devel, program, benchmark].append(one)
    return runs


def field_of(one, field):
    """A field of a run; by default the time that google-benchmark goes by."""
    field = field or ("real_time" if re.search("/(real|manual)_time", one["name"]) else "cpu_time")
    if field not in one:
        raise Failed(f"{one['name']} has no {field}")
    is_time = field in ("real_time", "cpu_time")
    return figure_of(one[field], one["time_unit"] if is_time else field.split("_")[-1])


def median_of(runs, devel, side):
    program, benchmark, field = side
    if not runs[devel, program, benchmark]:
        raise Failed(f"{program}_benchmark of {devel} has no {benchmark}")
    figures = [field_of(one, field) for one in runs[devel, program, benchmark]]
    return Figure(statistics.median(figure.value for figure in figures), figures[0].unit)


def printed(text, pattern, unit):
    found = re.search(pattern, text, re.MULTILINE)
    if not found:
        raise Failed(f"nothing that was printed is as {pattern}")
    return figure_of(found[1], unit)


# What figures depend on.

def compiler():
    """Compiler and flags of the build, by a source of the benchmarks."""
    for entry in json.loads((ROOT / "build/compile_commands.json").read_text()):
        if entry["file"].endswith("benchmarks/generation_benchmark.cc"):
            words = shlex.split(entry["command"])
            name = next(word for word in words if word.endswith("++"))
            flags = [word for word in words if re.match("-(O|m|f|g|std=|DNDEBUG)", word)]
            return f"{run([name, '--version']).splitlines()[0]}, {' '.join(flags)}"
    raise Failed("the build has no benchmarks")


def machine():
    about = collections.defaultdict(str, re.findall(
        r"^(\w[\w ]*\w)\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE))
    vectors = [name for name in ("amx_tile", "avx512f", "avx2") if name in about["flags"].split()]
    gib = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 2**30
    return (f"{about['model name']} (family {about['cpu family']}, model {about['model']}), "
            f"{len(os.sched_getaffinity(0))} CPUs, {' '.join(vectors)}, {gib:.0f} GiB; "
            f"{platform.freedesktop_os_release()['PRETTY_NAME']}; {compiler()}")


def commit_of(folder):
    def git(*words):
        return subprocess.run(["git", "-C", folder, *words], text=True, stdout=subprocess.PIPE,
                              check=False).stdout.strip()
    changed = git("status", "--porcelain", "-uno", "--", ":/", ":(exclude,top)docs/benchmarks.md")
    return f"commit {git('log', '-1', '--format=%h')}{' with changes' if changed else ''}"


def work_of_cpus():
    """Seconds that CPUs have worked for other programs, and that they could have worked."""
    seconds = [int(ticks) / os.sysconf("SC_CLK_TCK")
               for ticks in pathlib.Path("/proc/stat").read_text().split()[1:9]]
    return sum(seconds) - seconds[3] - seconds[4] - sum(os.times()[:4]), sum(seconds)


# Tables and the page.

def aim_of(aim, ours, other):
    """The cell of an aim: `at least 1.5` of the ratio, `at most 50 ms` of ours."""
    _, which, limit, *unit = aim.split()
    wanted = figure_of(limit, "ps" if unit == ["/s"] else "".join(unit))
    value = times_as_fast(ours, other) if other and not unit else ours.value
    missed = value < wanted.value if which == "least" else value > wanted.value
    return f"at {which} {wanted if unit else limit}{', **missed**' if missed else ''}"


def table_of(heads, rows):
    """Markdown, without the columns that are empty in all rows."""
    kept = [i for i, _ in enumerate(heads) if any(row[i] for row in rows)]
    lines = ["| " + " | ".join(line[i] for i in kept) + " |" for line in (heads, *rows)]
    return "\n".join([lines[0], "|" + "---|" * len(kept), *lines[1:]])


def compare(table, options):
    """The table, and how its figures came about."""
    rows = table["rows"]
    if "command" in table:
        text = run(["bash", "-c", f". devel/setup.bash && {table['command']}"])
        figures = [[side in row and printed(text, row[side], row.get("unit", table.get("unit")))
                    for side in SIDES] for row in rows]
        how = "as the program says"
    else:
        runs = measured([row[side] for row in rows for side in SIDES if side in row],
                        [DEVEL], options)
        figures = [[side in row and median_of(runs, DEVEL, row[side]) for side in SIDES]
                   for row in rows]
        how = f"medians of {options.turns}"
    cells = [[row["what"], str(ours), str(other or ""),
              digits(times_as_fast(ours, other)) if other else "",
              aim_of(row["aim"], ours, other) if "aim" in row else ""]
             for row, (ours, other) in zip(rows, figures)]
    return table_of(["what", table.get("ours", "LatticeWorld"), table.get("other", ""),
                     "times as fast", "aim"], cells), how


def compare_before(tables, options):
    """What is watched, of both builds in turns."""
    watched = [(row["what"], (*row["ours"][:2], row["watched"]))
               for table in tables.values() for row in table["rows"] if "watched" in row]
    devels = options.before, DEVEL
    runs = measured([side for _, side in watched], devels, options)
    cells = []
    for what, side in watched:
        before, after = (median_of(runs, devel, side) for devel in devels)
        longer = times_as_fast(before, after)
        cells.append([what, str(before), str(after),
                      f"**{longer:.2f}**" if longer > SLOWER else f"{longer:.2f}"])
    return (table_of(["what", "before", "after", "times as long"], cells),
            f"medians of {options.turns}; before: {commit_of(options.before)}")


def replaced(page, name, text):
    """The page with another text between the marks of a table."""
    mark = f"<!-- scripts/benchmarks.py {name} -->\n"
    if page.count(mark) != 1:
        raise Failed(f"the page has {page.count(mark)} tables of that name")
    before, _, rest = page.partition(mark)
    return before + mark + text + rest[rest.index("<!-- end -->"):]


def make(name, tables, options):
    begin, about = work_of_cpus(), f"{machine()}; {commit_of(ROOT)}, {datetime.date.today()}"
    table, how = (compare_before(tables, options) if name == BEFORE else
                  compare(tables[name], options))
    others, could = (now - then for now, then in zip(work_of_cpus(), begin))
    told = f"{about}; {how}; other programs took {max(0, 100 * others / could):.0f} % of the CPUs."
    told = textwrap.fill(told, 100, break_long_words=False, break_on_hyphens=False)
    page = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(replaced(page, name, f"{told}\n\n{table}\n"), encoding="utf-8")


def main():
    tables = read_comparisons(COMPARISONS.read_text(encoding="utf-8"))
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--only", nargs="+", choices=[*tables, BEFORE], metavar="NAME")
    parser.add_argument("--before", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("--turns", type=int, default=5)
    parser.add_argument("--min-time", type=float, default=0.5)
    options = parser.parse_args()
    if BEFORE in (options.only or ()) and not options.before:
        parser.error("the table before needs --before DEVEL")
    failed = False
    for name in options.only or [*tables, *([BEFORE] if options.before else [])]:
        begin_s, needs = time.monotonic(), tables.get(name, {}).get("needs", ())
        missing = [need for need in needs if not (ROOT / need).exists()]
        try:
            if missing:
                said = f"left as it is, for there is no {missing[0]}"
            else:
                make(name, tables, options)
                said = f"{time.monotonic() - begin_s:.0f} s"
        except (Failed, OSError) as error:
            failed, said = True, f"left as it is, for it failed: {error}"
        print(f"{name}: {said}", file=sys.stderr, flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
