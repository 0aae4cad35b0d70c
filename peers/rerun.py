"""rerun imports an episode by way of MCAP, as ROS 1 and as ROS 2 messages, and files of a world."""
# debian: python3-rosbag
# pypi: rerun-sdk==0.41.0 rosbags==0.11.9 mcap==1.6.0

import re
import sys
import warnings
from pathlib import Path

import rerun

from episode import bag_as_mcap, episode
from peer import FOLDER, Peer, export, run

BIN = Path(sys.executable).parent


def imported(path):
    """{column: rows} of what rerun makes of an MCAP file, and rows a topic of what it left raw."""
    recording = path.with_suffix(".rrd")
    done = run(BIN / "rerun", "mcap", "convert", path, "-o", recording)
    if not recording.exists():
        raise SystemExit(done.stdout)
    return columns(recording)


def columns(recording):
    rows = {}
    said = run(BIN / "rerun", "rrd", "print", recording).stdout
    for count, entity, names in re.findall(
            r"with ([\d ]+) rows.*? - (/\S*) - data columns: \[(.*?)\]", said):
        for name in names.split():
            key = entity, name
            rows[key] = rows.get(key, 0) + int(re.sub(r"\D", "", count))
    return rows


def check_files(peer):
    """What log_file_from_path takes of a world's exports."""
    glb = export("glb", "instanced.glb")
    ply = export("ply", "points.ply")
    stream = rerun.RecordingStream("worlds")
    recording = FOLDER / "files.rrd"
    stream.save(recording)
    for path in (glb, ply):
        stream.log_file_from_path(path)
    stream.flush()
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        stream.log_file_from_path(episode())
    del stream
    kinds = sorted({name.split(":")[0] for _, name in columns(recording)
                    if not name.startswith(("RecordingInfo", "rerun"))})
    peer.check("world.glb and points.ply", {"Asset3D", "Points3D"} <= set(kinds),
               f"{', '.join(kinds)}; the points' `label` and `asset` are left out")
    peer.check("a bag", any("No importer" in str(one.message) for one in said),
               "refused: no importer")


def main():
    peer = Peer("rerun", rerun.__version__, "an episode's bag by way of MCAP, `--to glb`, `--to ply`",
                "`rosbags-convert --src A.bag --dst folder --dst-storage mcap` first: it reads no "
                "bags, and of MCAP with ROS 1 messages it keeps bytes only")
    first, count = bag_as_mcap(episode(), FOLDER / "ros1.mcap")
    rows = imported(first)
    raw = sum(n for (_, name), n in rows.items() if name == "McapMessage:data")
    peer.check("MCAP with ROS 1 messages", raw == count, f"{raw} of {count} kept as bytes, none read")
    run(BIN / "rosbags-convert", "--src", episode(), "--dst", FOLDER / "ros2", "--dst-storage",
        "mcap")
    rows = imported(next((FOLDER / "ros2").glob("*.mcap")))
    raw = sum(n for (_, name), n in rows.items() if name == "McapMessage:data")
    shown = {}
    for (entity, name), n in rows.items():
        kind = name.split(":")[0]
        if kind in ("Transform3D", "GridMap", "Scalars", "Points3D", "Image"):
            shown.setdefault(kind, {})[entity] = n
    peer.check("with ROS 2 messages", raw == 0 and "Transform3D" in shown and "GridMap" in shown,
               "; ".join(f"{kind} of {', '.join(sorted(of))}" for kind, of in sorted(shown.items())) +
               "; the others are read, and shown as tables")
    check_files(peer)
    peer.finish()


main()
