#!/usr/bin/env python3
"""Gives worlds to programs of others and writes what came out to docs/reports/peers.md.
scripts/peers.sh runs it; see there."""

import argparse
import datetime
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
REPORT = HERE.parent / "docs" / "reports" / "peers.md"
LAYOUT = ("A lake in the lower left, dense forest in the upper left, a road from west to east, a "
          "village in the center, farmland in the lower right.")
ENVIRONMENT = "A sunny summer noon. A wheeled robot waits in the center, three sheep graze."
LIMIT_S = 600
HEAD = """# Programs of others, fed with worlds

What programs of others make of worlds, episodes, data and models, run by `scripts/peers.sh`
(outside CI: it installs each peer in a folder of its own). "off" is what differs from `--to
heights` at a thousand places, as root of the mean square and at most; "mirrored" is what it would
be with west and east, or north and south, exchanged. A row has the date of its run. What was
guessed beforehand, and what became of it: [guesses](guesses.md). PDAL is missing: PyPI has it as
source alone, and Debian 12 has no package of its library.

| peer | version | date | fed | came out | what a user must do |
| --- | --- | --- | --- | --- | --- |
"""


def peers():
    return {path.stem: path for path in sorted(HERE.iterdir())
            if path.suffix in (".py", ".mjs") and path.stem != "run"}


def listed(path, kind):
    """The packages that a peer's head names: "# pypi: trimesh==5.2.0 numpy==2.4.6"."""
    lines = re.findall(rf"^(?:#|//) {kind}: (.*)$", path.read_text(), re.MULTILINE)
    return [word for line in lines for word in line.split()]


def elevation(path):
    """Hills at 47.4 north, 8.5 east, a ninth of an arc second a cell, as an Arc/Info grid."""
    cells, step = 200, 1 / 32400
    rows = []
    for row in range(cells):
        rows.append(" ".join(f"{430 + 3 * math.sin(row / 17) + 2 * math.cos(col / 23) + row / 90:.3f}"
            for col in range(cells)))
    path.write_text(f"ncols {cells}\nnrows {cells}\nxllcorner 8.5\nyllcorner 47.4\n"
                    f"cellsize {step:.12f}\nNODATA_value -9999\n" + "\n".join(rows) + "\n")


def make_world(program, folder):
    elevation(folder / "elevation.asc")
    with open(folder / "generate.log", "w", encoding="utf-8") as log:
        subprocess.run([program, "generate", "--layout", LAYOUT, "--environment", ENVIRONMENT,
                        "--elevation", folder / "elevation.asc", "--elevation-unit", "degrees",
                        "--seed", "4", "--size", "128", "--resolution", "0.5",
                        "--out", folder / "world"], stdout=log, stderr=log, check=True)


def python_environment(path, folder):
    """The interpreter of a virtual environment in the folder, which sees the system's packages where
    the peer's head says "# site: system"."""
    system = ["--system-site-packages"] if listed(path, "site") else []
    subprocess.run(["/usr/bin/python3", "-m", "venv", *system, folder], check=True)
    return folder / "bin/python"


def install(python, packages):
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check",
                    *packages], check=True)


def packages_of(python):
    return subprocess.run([python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"],
                          check=True, stdout=subprocess.PIPE, text=True).stdout.strip()


def shared(path, worlds):
    """Where the large packages are that several peers share ("# shared: torch==2.15.0"): they are
    installed once, beside the worlds. None: the peer has none."""
    packages = listed(path, "shared")
    if not packages:
        return None
    folder = worlds / ("shared-" + "-".join(packages))
    if not folder.exists():
        making = folder.with_name(folder.name + ".part")
        shutil.rmtree(making, ignore_errors=True)
        install(python_environment(path, making), packages)
        making.rename(folder)
    return packages_of(folder / "bin/python")


def installed(path, folder, worlds, wheel):
    """The command that runs a peer, with its packages in the folder."""
    for package in listed(path, "debian"):
        subprocess.run(["dpkg-query", "-W", package], check=True, stdout=subprocess.DEVNULL)
    if path.suffix == ".mjs":
        shutil.copy(path, folder)
        shutil.copy(HERE / "common" / "peer.mjs", folder)
        subprocess.run(["npm", "install", "--silent", "--no-audit", "--no-fund", "--prefix",
                        folder, *listed(path, "npm")], check=True, stdout=subprocess.DEVNULL)
        return ["node", folder / path.name]
    python = python_environment(path, folder / "python")
    found = [shared(path, worlds)] if listed(path, "shared") else []
    if listed(path, "module") and wheel.is_dir():
        found.append(str(wheel))
    if found:
        (pathlib.Path(packages_of(python)) / "peers.pth").write_text("\n".join(found) + "\n")
    packages = listed(path, "pypi")
    if listed(path, "module") and not wheel.is_dir():
        packages.append(str(wheel))
    if packages:
        install(python, packages)
    # -P: or else peers/trimesh.py would be what it imports as trimesh.
    return [python, "-P", path]


def run_peer(path, program, worlds, wheel):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        result = folder / "result.json"
        try:
            command = installed(path, folder, worlds, wheel)
        except subprocess.CalledProcessError as error:
            print(f"{path.stem}: cannot be installed: {error}")
            return None
        surroundings = {**os.environ, "PEER_PROGRAM": str(program), "PEER_WORLDS": str(worlds),
                        "PEER_RESULT": str(result), "PEER_FOLDER": str(folder),
                        "PYTHONPATH": str(HERE / "common"), "PYTHONDONTWRITEBYTECODE": "1"}
        try:
            done = subprocess.run(command, env=surroundings, cwd=folder, timeout=LIMIT_S,
                                  check=False)
        except subprocess.TimeoutExpired:
            print(f"{path.stem}: not ready after {LIMIT_S} s")
            return None
        if not result.exists():
            print(f"{path.stem}: ended with {done.returncode} before it had a result")
            return None
        return json.loads(result.read_text())


def row_of(result):
    came = "; ".join(("" if ok else "**OFF** ") + f"{name}: {figures}"
                     for name, ok, figures in result["checks"])
    cells = [result["name"], result["version"], datetime.date.today().isoformat(), result["fed"],
             came, result["must"] or "nothing"]
    return "| " + " | ".join(str(cell).replace("|", "/").replace("\n", " ")
                             for cell in cells) + " |"


def write_report(rows):
    """Rows replace those of the same peer; the others stay."""
    kept = {}
    if REPORT.exists():
        for line in REPORT.read_text().splitlines():
            found = re.match(r"\| (?!peer \||---)(.+?) \|", line)
            if found:
                kept[found.group(1)] = line
    kept.update(rows)
    REPORT.parent.mkdir(exist_ok=True)
    REPORT.write_text(HEAD + "".join(kept[name] + "\n" for name in sorted(kept, key=str.lower)))


def main():
    parser = argparse.ArgumentParser(description="Feeds worlds to programs of others.")
    parser.add_argument("names", nargs="*", metavar="NAME", help="of " + ", ".join(peers()))
    parser.add_argument("--program", type=pathlib.Path,
                        default=HERE.parent / "devel/lib/latticeworld/latticeworld")
    parser.add_argument("--wheel", type=pathlib.Path, default=HERE.parent / "build/python_module",
                        help="the module latticeworld for Python: a wheel of "
                        "scripts/build_wheel.sh, or a folder that holds the module "
                        "[build/python_module]")
    parser.add_argument("--worlds", type=pathlib.Path,
                        help="a folder that keeps the world and its exports for the next run")
    arguments = parser.parse_args()
    unknown = [name for name in arguments.names if name not in peers()]
    if unknown:
        parser.error(f"no peer is called {', '.join(unknown)}; there are {', '.join(peers())}")
    program = arguments.program.resolve()
    failed = []
    with tempfile.TemporaryDirectory() as name:
        worlds = (arguments.worlds or pathlib.Path(name)).resolve()
        worlds.mkdir(exist_ok=True)
        if not (worlds / "world").exists():
            make_world(program, worlds)
        for peer in arguments.names or peers():
            print(f"== {peer}", flush=True)
            result = run_peer(peers()[peer], program, worlds, arguments.wheel.resolve())
            if result:
                write_report({result["name"]: row_of(result)})
            if not result or not all(ok for _, ok, _ in result["checks"]):
                failed.append(peer)
    print("as expected" if not failed else "not as expected: " + ", ".join(failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
