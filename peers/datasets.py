"""datasets loads what `latticeworld dataset` writes, with its card and with its pictures."""
# pypi: datasets==5.2.0 pillow==13.0.0 numpy==2.4.6

import json
import subprocess

import datasets
import numpy
import PIL.Image

from peer import FOLDER, PROGRAM, Peer


def main():
    peer = Peer("datasets", datasets.__version__, "`latticeworld dataset --generate 40`",
                "put an `<image>` placeholder into the messages where a trainer wants one")
    data = FOLDER / "data"
    subprocess.run([PROGRAM, "dataset", "--generate", "40", "--seed", "1", "--split", "0.6,0.2",
                    "--out", data], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    for part in ("layout", "environment", "relief"):
        lines = {split: sum(1 for _ in open(data / part / f"{split}.jsonl"))
                 for split in ("train", "validation", "test")}
        loaded = datasets.load_dataset(str(data), part, cache_dir=str(FOLDER / "cache"))
        rows = {split: loaded[split].num_rows for split in loaded}
        same = rows == {split: count for split, count in lines.items() if count}
        first = json.loads((data / part / "train.jsonl").open().readline())
        kept = loaded["train"][0]["messages"]
        same = same and kept == first["messages"]
        peer.check(part, same, f"{rows}, messages the same; {', '.join(loaded['train'].features)}")
    record = next(json.loads(line) for line in open(data / "relief" / "train.jsonl"))
    picture = PIL.Image.open(data / record["images"][0])
    values = numpy.asarray(picture)
    peer.check("a height map by Pillow", values.max() > 255, f"mode {picture.mode}, {values.dtype}, "
               f"{values.min()} to {values.max()}")
    column = datasets.Dataset.from_dict({"image": [str(data / record["images"][0])]}).cast_column(
        "image", datasets.Image())
    decoded = numpy.asarray(column[0]["image"])
    peer.check("the same as datasets.Image", numpy.array_equal(decoded, values),
               f"mode {column[0]['image'].mode}, {decoded.min()} to {decoded.max()}")
    rgb = numpy.asarray(column.cast_column("image", datasets.Image(mode="RGB"))[0]["image"])
    peer.check("with mode RGB", True, f"{rgb.min()} to {rgb.max()}, {len(numpy.unique(rgb))} values "
               f"of {len(numpy.unique(values))}")
    peer.finish()


main()
