"""Loss curves: a CSV with a line a measurement, and a picture of it."""

import csv
import math
import os

from .whole_files import whole_file

COLORS = [(31, 119, 180), (214, 39, 40), (44, 160, 44), (148, 103, 189)]


def ticks(most):
    """Round numbers from 0 to `most`, four to ten of them."""
    step = 10.0 ** math.floor(math.log10(most))
    step *= next(part for part in (1, 0.5, 0.2, 0.1) if most / (step * part) >= 4)
    return [i * step for i in range(int(most / step * (1 + 1e-9)) + 1)]


class LossCurve:
    """Measurements of the names in `columns` at steps. Kept in a CSV file that grows as they come."""

    def __init__(self, path, columns):
        self.path = path
        self.columns = ["step"] + list(columns)
        self.rows = []

    def keep_until(self, step):
        """Reads what an interrupted run measured up to a step, and forgets what came after."""
        self.rows = []
        if os.path.exists(self.path):
            with open(self.path, newline="", encoding="utf-8", errors="replace") as file:
                whole = [line for line in file if line.endswith("\n")]  # the last one may be half
            for row in csv.DictReader(whole):
                if int(row["step"]) <= step:
                    self.rows.append({name: float(value) for name, value in row.items() if value})
        self._write()

    def add(self, step, **values):
        self.rows.append({"step": step, **values})
        with open(self.path, "a", newline="", encoding="utf-8") as file:
            self._writer(file).writerow(self._texts(self.rows[-1]))
            file.flush()
            os.fsync(file.fileno())

    def _texts(self, row):
        texts = {name: f"{row[name]:.6g}" for name in self.columns if name in row}
        texts["step"] = str(int(row["step"]))
        return texts

    def _writer(self, file):
        return csv.DictWriter(file, self.columns)

    def _write(self):
        with whole_file(self.path) as file:
            self._writer(file).writeheader()
            for row in self.rows:
                self._writer(file).writerow(self._texts(row))

    def draw(self, path, title):
        """A PNG of all columns over the steps. Nothing is drawn before two measurements."""
        from PIL import Image, ImageDraw

        points = {name: [(r["step"], r[name]) for r in self.rows if name in r] for name in self.columns[1:]}
        points = {name: some for name, some in points.items() if len(some) > 1}
        if not points:
            return
        width, height, left, top = 900, 560, 70, 60
        right, bottom = width - 20, height - 50
        last = max(x for some in points.values() for x, _ in some)
        high = max(y for some in points.values() for _, y in some)
        image = Image.new("RGB", (width, height), "white")
        draw = ImageDraw.Draw(image)
        draw.text((left, 12), title, fill="black")
        for value in ticks(high) if high > 0 else []:
            y = bottom - (bottom - top) * value / high
            draw.line([(left, y), (right, y)], fill=(225, 225, 225))
            draw.text((12, y - 6), f"{value:g}", fill="black")
        for value in ticks(last):
            draw.text((left + (right - left) * value / last - 14, bottom + 8), f"{value:g}", fill="black")
        draw.text(((left + right) / 2, bottom + 26), "step", fill="black")
        for i, (name, some) in enumerate(points.items()):
            color = COLORS[i % len(COLORS)]
            line = [(left + (right - left) * x / last, bottom - (bottom - top) * y / high) for x, y in some]
            draw.line(line, fill=color, width=2)
            label = right - 130 * (len(points) - i)
            draw.line([(label, 38), (label + 25, 38)], fill=color, width=3)
            draw.text((label + 32, 32), name, fill="black")
        image.save(path)
