# SPDX-License-Identifier: BSD-3-Clause
"""Makes captures of known order, as people bring them, and compares what --info says of each.

Every set is a scene of textured planes at several depths, seen by a grid of cameras, and written as
a folder of views, a quilt, a mosaic or a picture of hogels, with names, gaps and JPEG qualities
drawn at random; ordinary pictures, which are no light field, are among them. A statement that is
"sure" or "likely" and wrong fails.

    captures.py PROGRAM [--sets N] [--first K] [--kind NAME] [--folder DIR] [--verbose]

Set k is the same in every run. A table says how many of each kind are right at once, in size and
in order, to be compared with that of another program.
"""

import argparse
import collections
import io
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

try:
    import numpy as np
    from PIL import Image
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)


class Scene:
    """Planes of noise. A plane of disparity d moves d pixels to the left (up) for each camera to
    the right (down); a larger one hides a smaller one."""

    def __init__(self, rng, width, height, cameras, near, far, cards=5):
        self.width, self.height = width, height
        reach = max(abs(near), abs(far)) * max(cameras) / 2 + 3
        self.margin = int(np.ceil(reach))
        self.planes = [(far, self.texture(rng), None)]
        for disparity in np.sort(rng.uniform(far, near, cards)):
            self.planes.append((disparity, self.texture(rng), self.mask(rng)))
        self.planes[-1] = (near, *self.planes[-1][1:])

    def canvas(self):
        return self.height + 2 * self.margin + 2, self.width + 2 * self.margin + 2

    def texture(self, rng):
        rows, columns = self.canvas()
        base = rng.uniform(40, 200, 3)
        result = np.broadcast_to(base, (rows, columns, 3)).astype(np.float32)
        for size in (3, 6, 12, 24, 48):
            shape = (rows // size + 2, columns // size + 2)
            noise = Image.fromarray(rng.normal(0, 1, shape).astype(np.float32))
            noise = np.asarray(noise.resize((columns, rows), Image.BICUBIC))
            result = result + noise[..., None] * rng.uniform(4, 22) * rng.uniform(0.5, 1, 3)
        return np.clip(result, 0, 255).astype(np.float32)

    def mask(self, rng):
        rows, columns = self.canvas()
        y, x = np.mgrid[0:rows, 0:columns].astype(np.float32)
        x = (x - self.margin - rng.uniform(0, self.width)) / (self.width * rng.uniform(0.06, 0.3))
        y = (y - self.margin - rng.uniform(0, self.height)) / (self.height * rng.uniform(0.06, 0.3))
        inside = x**2 + y**2 - 1 if rng.random() < 0.5 else np.maximum(abs(x), abs(y)) - 1
        return np.clip(0.5 - 12 * inside, 0, 1).astype(np.float32)

    def moved(self, picture, right, down):
        """Returns the part of a canvas that a camera sees, interpolated linearly."""
        x, y = self.margin + right, self.margin + down
        ix, iy = int(np.floor(x)), int(np.floor(y))
        fx, fy = np.float32(x - ix), np.float32(y - iy)
        rows = picture[iy : iy + self.height + 1]
        rows = rows[:-1] * (1 - fy) + rows[1:] * fy
        columns = rows[:, ix : ix + self.width + 1]
        return columns[:, :-1] * (1 - fx) + columns[:, 1:] * fx

    def view(self, u, v):
        """Returns the view of a camera u to the right of the middle and v below it, as floats."""
        seen = None
        for disparity, texture, mask in self.planes:
            colour = self.moved(texture, disparity * u, disparity * v)
            if mask is None:
                seen = colour
                continue
            share = self.moved(mask, disparity * u, disparity * v)[..., None]
            seen = seen * (1 - share) + colour * share
        return seen


def rounded(picture):
    return np.clip(np.round(picture), 0, 255).astype(np.uint8)


def through_jpeg(picture, quality):
    data = io.BytesIO()
    Image.fromarray(picture).save(data, "JPEG", quality=int(quality))
    return np.asarray(Image.open(data))


class Capture:
    """One set: its files, and what is true of it."""

    def __init__(self, seed, kind):
        self.rng = np.random.default_rng([seed, KINDS.index(kind)])
        self.kind = kind
        self.truth = None  # of a picture that is no light field
        self.is_transposed = self.is_from_top = False

    def pick(self, *values):
        return values[int(self.rng.integers(len(values)))]

    def views(self, width, height, columns, rows, near=None):
        """Returns views[v][u] as bytes, from the top left camera on."""
        rng = self.rng
        if near is None:
            near = self.pick(0.5, 1, 2, 3, 5) * rng.uniform(0.8, 1.2)
        near = min(near, 0.5 * min(width, height) / max(columns, rows, 2))
        far = self.pick(-near, 0.0, near / 4, near / 2)
        scene = Scene(rng, width, height, (columns, rows), near, far)
        gain = rng.normal(0, self.pick(0, 0, 0.005), (rows, columns))
        noise = self.pick(0, 0.5, 2)
        result = []
        for v in range(rows):
            result.append([])
            for u in range(columns):
                view = scene.view(u - (columns - 1) / 2, v - (rows - 1) / 2) * (1 + gain[v, u])
                if noise:
                    view = view + rng.normal(0, noise, view.shape)
                result[-1].append(rounded(view))
        return result

    def save(self, picture, path, quality=None):
        quality = quality or int(self.rng.integers(5, 96))
        if path.suffix == ".jpg":
            Image.fromarray(picture).save(path, quality=quality)
        else:
            Image.fromarray(picture).save(path, compress_level=1)

    def folder(self, path, columns, rows, names, skipped=(), extension=None):
        """Writes views as names(row, column of the files) says; the truth has the order."""
        rng = self.rng
        is_up, is_left = bool(rng.integers(2)), bool(rng.integers(2))
        if rng.random() < 0.5:
            is_up = is_left = False
        width, height = int(rng.integers(90, 200)), int(rng.integers(80, 160))
        views = self.views(width, height, columns, rows)
        extension = extension or self.pick(".png", ".jpg")
        quality = int(rng.integers(5, 96))
        path.mkdir()
        for row in range(rows):
            for column in range(columns):
                if (row, column) in skipped:
                    continue
                v = rows - 1 - row if is_up else row
                u = columns - 1 - column if is_left else column
                file = path / (names(row, column) + extension)
                file.parent.mkdir(exist_ok=True)
                self.save(views[v][u], file, quality)
        self.truth = {
            "layout": "views",
            "hogels": [width, height],
            "directions": [columns, rows],
            "rows": "bottom-up" if is_up else "top-down",
            "columns": "right-left" if is_left else "left-right",
        }
        return path

    # The kinds.

    def grid(self, path):
        """Names with row and column, in either order, with holes in some."""
        rng = self.rng
        columns, rows = int(rng.integers(2, 10)), int(rng.integers(2, 10))
        form = self.pick("{0:03d}_{1:03d}", "view_{0}_{1}", "row{0}col{1}", "cam_r{0:02d}_c{1:02d}",
                         "lf[{0}][{1}]", "{1:02d}_{0:02d}", "img-x{1}-y{0}", "u{1}v{0}")
        first, step = self.pick((0, 1), (1, 1), (1, 2))
        names = lambda row, column: form.format(first + step * row, first + step * column)
        skipped = set()
        if rng.random() < 0.2 and columns * rows > 12:
            skipped = {(int(rng.integers(rows)), int(rng.integers(columns)))}
        self.is_transposed = form == "{1:02d}_{0:02d}"
        return self.folder(path, columns, rows, names, skipped)

    def running(self, path):
        """A square that is counted in one of four ways."""
        side = int(self.rng.integers(3, 8))
        scan = self.pick("raster", "serpentine", "columns", "columns-serpentine")
        first, form = self.pick((0, "{:04d}"), (1, "IMG_{:03d}"), (1, "frame{}"))

        def names(row, column):
            line, at = (row, column) if not scan.startswith("columns") else (column, row)
            if scan.endswith("serpentine") and line % 2:
                at = side - 1 - at
            return form.format(first + line * side + at)

        result = self.folder(path, side, side, names)
        self.truth["scan"] = scan
        return result

    def subgrid(self, path):
        """Every n-th view of a numbered grid, such as input_Cam000, 004, 008, 036, …"""
        rng = self.rng
        step = int(rng.integers(2, 5))
        columns, rows = int(rng.integers(2, 8)), int(rng.integers(2, 8))
        width = step * (columns - 1) + 1 + int(rng.integers(0, step))
        offset = int(rng.integers(0, 2)) * int(rng.integers(0, 3))
        form = self.pick("input_Cam{:03d}", "{:04d}", "view{}")
        names = lambda row, column: form.format(offset + step * (row * width + column))
        return self.folder(path, columns, rows, names)

    def row(self, path):
        """One row of cameras, by number, by time, or by a counter that went round."""
        rng = self.rng
        count = int(rng.integers(5, 24))
        while int(np.sqrt(count)) ** 2 == count:
            count += 1
        form = self.pick("number", "time", "time", "counter")
        start = int(rng.integers(1, 40))
        gaps = rng.integers(1, 4, count)
        seconds = 10 * 3600 + int(rng.integers(0, 3600)) + np.cumsum(gaps)
        wrap = 9999 - int(rng.integers(1, count - 1))

        def names(_, column):
            if form == "number":
                return f"frame{start + column:03d}"
            if form == "time":
                at = int(seconds[column])
                return f"IMG_20240102_{at // 3600:02d}{at // 60 % 60:02d}{at % 60:02d}"
            number = wrap + column
            return f"DSC_{number if number <= 9999 else number - 9999:04d}"

        return self.folder(path, count, 1, names)

    def folders(self, path):
        """ROW/COLUMN, letters and dots."""
        columns, rows = int(self.rng.integers(2, 8)), int(self.rng.integers(2, 8))
        form = self.pick("{0:02d}/{1:02d}", "row{0}/col{1}", "letters", "render.{0}.{1}",
                         "a.{0:02d}.{1:02d}")
        if form == "letters":
            names = lambda row, column: "ABCDEFGHIJ"[row] + str(column + 1)
        else:
            names = lambda row, column: form.format(row, column)
        return self.folder(path, columns, rows, names)

    def tiles(self, path, is_quilt, is_small):
        rng = self.rng
        width = int(rng.integers(40, 100)) if is_small else int(rng.integers(100, 220))
        height = int(width * rng.uniform(0.6, 1.2))
        if is_quilt:
            columns, rows = int(rng.integers(2, 9)), int(rng.integers(2, 9))
            views = self.views(width, height, columns * rows, 1, near=self.pick(0.3, 0.6, 1))[0]
            self.is_from_top = rng.random() < 0.3
            is_left = rng.random() < 0.2
            empty = int(rng.integers(1, columns)) if rng.random() < 0.2 else 0
            if is_left:
                views = views[::-1]
            views[len(views) - empty :] = [np.zeros_like(views[0])] * empty

            def tile(row, column):
                return views[(row if self.is_from_top else rows - 1 - row) * columns + column]

            directions = [columns * rows, 1]
        else:
            columns, rows = int(rng.integers(3, 14)), int(rng.integers(3, 14))
            views = self.views(width, height, columns, rows)
            tile = lambda row, column: views[row][column]
            directions = [columns, rows]
        lines = [np.hstack([tile(row, column) for column in range(columns)]) for row in range(rows)]
        path = path.with_suffix(self.pick(".png", ".jpg"))
        self.save(np.vstack(lines), path)
        self.truth = {
            "layout": "quilt" if is_quilt else "mosaic",
            "hogels": [width, height],
            "directions": directions,
            "rows": "top-down",
            "columns": "right-left" if is_quilt and is_left else "left-right",
        }
        return path

    def quilt(self, path):
        return self.tiles(path, True, False)

    def mosaic(self, path):
        return self.tiles(path, False, False)

    def small_mosaic(self, path):
        return self.tiles(path, False, True)

    def hogels(self, path):
        rng = self.rng
        columns, rows = int(rng.integers(5, 18)), int(rng.integers(5, 18))
        if rng.random() < 0.3:
            columns = rows = self.pick(8, 16)
        width, height = int(rng.integers(40, 140)), int(rng.integers(40, 140))
        views = np.array(self.views(width, height, columns, rows, near=self.pick(0.2, 0.5, 1)))
        # [v, u, j, i] → [j·dv + v, i·du + u]
        picture = views.transpose(2, 0, 3, 1, 4).reshape(height * rows, width * columns, 3)
        path = path.with_suffix(self.pick(".png", ".png", ".jpg"))
        self.save(picture, path)
        self.truth = {
            "layout": "hogels",
            "hogels": [width, height],
            "directions": [columns, rows],
            "rows": "top-down",
            "columns": "left-right",
        }
        return path

    def photograph(self, path):
        """An ordinary picture that is or was a JPEG, of sizes that many grids divide."""
        rng = self.rng
        unit = self.pick(1, 8, 16, 16, 48)
        width = unit * max(2, int(rng.integers(200, 800)) // unit)
        height = unit * max(2, int(rng.integers(200, 800)) // unit)
        scene = Scene(rng, width, height, (1, 1), 0, 0, cards=12)
        picture = scene.view(0, 0)
        content = self.pick("scene", "scene", "scene", "repeated", "smooth")
        if content == "repeated":  # a front of windows
            period = int(rng.integers(20, 120))
            y, x = np.mgrid[0:height, 0:width]
            window = (x % period < 0.6 * period) & (y % (period + 8) < 0.7 * period)
            picture = picture * np.where(window, 0.5, 1)[..., None].astype(np.float32)
        if content == "smooth":
            y, x = np.mgrid[0:height, 0:width]
            picture = picture * 0.1 + (60 + 100 * x / width + 40 * y / height)[..., None]
        picture = rounded(picture)
        history = self.pick("jpeg", "jpeg", "was jpeg", "enlarged", "reduced", "never")
        quality = int(rng.integers(5, 96))
        if history != "never":
            picture = through_jpeg(picture, quality)
        if history in ("enlarged", "reduced"):
            factor = self.pick(2, 1.5) if history == "enlarged" else 0.5
            size = int(width * factor), int(height * factor)
            how = self.pick(Image.BILINEAR, Image.BICUBIC, Image.NEAREST)
            picture = np.asarray(Image.fromarray(picture).resize(size, how))
        path = path.with_suffix(".jpg" if history == "jpeg" else ".png")
        self.save(picture, path, quality)
        return path

    def photographs(self, path):
        """A folder of pictures that have nothing in common."""
        rng = self.rng
        path.mkdir()
        count = int(rng.integers(3, 26))
        for k in range(count):
            scene = Scene(rng, 160, 120, (1, 1), 0, 0, cards=8)
            self.save(rounded(scene.view(0, 0)), path / f"DSC_{k + 17:04d}.jpg")
        return path


KINDS = ["grid", "running", "subgrid", "row", "folders", "quilt", "mosaic", "small_mosaic",
         "hogels", "photograph", "photographs"]


def said_by(program, path):
    """Returns what --info says, as a dictionary, and its text; None and the line of a refusal."""
    run = subprocess.run([program, "--info", str(path)], capture_output=True, text=True,
                         timeout=300)
    if run.returncode != 0:
        return None, run.stderr.strip()
    lines = [(line[:12].strip(), line[12:]) for line in run.stdout.splitlines()]
    said = dict(reversed(lines))  # the first of each
    order = re.match(r"rows (\S+), columns (\S+): (\w+)$", said.get("order", ""))
    pair = lambda text: [int(number) for number in text.split("×")]
    return {
        "layout": re.match(r"\w+", said["layout"]).group(),
        "hogels": pair(said.get("hogels", "0×0")),
        "directions": pair(said.get("directions", "0×0")),
        "rows": order.group(1) if order else "",
        "columns": order.group(2) if order else "",
        "confidence": order.group(3) if order else "unknown",
        "assumed": said.get("assumed", "").rpartition(" ")[2] or "unknown",
        "names": said.get("names", ""),
        "scan": said.get("scan", "raster"),
        "is from the top": said["layout"].endswith("from the top left"),
    }, run.stdout


def judge(capture, said):
    """Returns whether layout and order are right, and the confidence of each."""
    truth = capture.truth
    if said is None:
        return truth is None, "refused", False, "refused"
    if truth is None:  # a folder of pictures is one of views that have no order
        is_right = said["layout"] == "views" or said["hogels"] == [0, 0]
        return is_right, said["assumed"], is_right, said["confidence"]
    is_size = all(said[key] == truth[key] for key in ("layout", "hogels", "directions"))
    columns, rows = truth["directions"]
    is_order = is_size and (rows == 1 or said["rows"] == truth["rows"])
    is_order = is_order and (columns == 1 or said["columns"] == truth["columns"])
    is_order = is_order and said["scan"] == truth.get("scan", "raster")
    is_order = is_order and said["is from the top"] == capture.is_from_top
    if capture.is_transposed:
        is_order = is_order and said["names"].startswith("C")
    # The size of a folder's grid is a statement as confident as its order.
    layout = said["confidence"] if truth["layout"] == "views" else said["assumed"]
    return is_size, layout, is_order, said["confidence"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--sets", type=int, default=len(KINDS) * 3)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kind", choices=KINDS)
    parser.add_argument("--folder")
    parser.add_argument("--verbose", action="store_true")
    arguments = parser.parse_args()
    table = collections.defaultdict(collections.Counter)
    wrong = []
    work = pathlib.Path(arguments.folder or tempfile.mkdtemp())
    work.mkdir(exist_ok=True)
    for k in range(arguments.first, arguments.first + arguments.sets):
        kind = arguments.kind or KINDS[k % len(KINDS)]
        capture = Capture(k, kind)
        path = getattr(capture, kind)(work / f"set{k}")
        said, text = said_by(arguments.program, path)
        is_size, layout, is_order, order = judge(capture, said)
        counts = table[kind]
        counts["sets"] += 1
        counts["size"] += is_size
        counts["right"] += is_order
        counts["refused"] += said is None
        for what, is_right, sureness in (("layout", is_size, layout), ("order", is_order, order)):
            if sureness in ("sure", "likely"):
                counts[f"{what} {sureness}"] += 1
                if not is_right:
                    counts["wrong"] += 1
                    wrong.append(f"set {k} ({kind}): {what} {sureness}: {said}; true: {capture.truth}")
        if arguments.verbose:
            print(k, kind, is_size, layout, is_order, order, capture.truth, said or text,
                  re.findall(r"^(?:found by|assumed) .*", text, re.M), flush=True)
        if not arguments.folder:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    if not arguments.folder:
        work.rmdir()
    heads = ["sets", "size", "right", "refused", "layout sure", "layout likely", "order sure",
             "order likely", "wrong"]
    print("kind".ljust(14) + "".join(head.rjust(15) for head in heads))
    for kind in KINDS:
        if kind in table:
            print(kind.ljust(14) + "".join(str(table[kind][head]).rjust(15) for head in heads))
    for line in wrong:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
