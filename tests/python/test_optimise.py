# SPDX-License-Identifier: BSD-3-Clause
"""optimise(): the least error, proven from its gradient with matrices written here alone."""

import os
import shutil
import subprocess
import time
import unittest
import warnings

import numpy as np
from support import PROGRAM, FolderTest, program, random_views, read, refusal

import hogelscope as hs

NX, NY, DU, DV = 6, 5, 9, 8
SIZE, FOV = (0.12, 0.1), (40.0, 36.0)
ROOM = {"layout": "live", "source": "mesh", "mesh": {"file": os.path.abspath("data/room.glb")}}


def axis_leakage(count, sigma, window, border="renormalise"):
    """Row k: how much of the light seen in direction k is that of each direction."""
    reach = window // 2
    matrix = np.zeros((count, count))
    weights = np.exp(-np.arange(-reach, reach + 1) ** 2 / (2 * sigma**2)) if reach else np.ones(1)
    for k in range(count):
        for at, weight in zip(range(k - reach, k + reach + 1), weights):
            if border == "clamp":
                matrix[k, np.clip(at, 0, count - 1)] += weight
            elif 0 <= at < count:
                matrix[k, at] += weight
        matrix[k] /= matrix[k].sum() if border == "renormalise" else weights.sum()
    return matrix


def leaked(content, psf):
    """Of (dv, du, ny, nx, 3)."""
    across = axis_leakage(DU, psf["sigma"], psf["windowSize"], psf.get("border", "renormalise"))
    down = axis_leakage(DV, psf["sigma"], psf["windowSize"], psf.get("border", "renormalise"))
    return np.einsum("vw,wuyxc,tu->vtyxc", down, content, across)


def leaked_back(light, psf):
    across = axis_leakage(DU, psf["sigma"], psf["windowSize"], psf.get("border", "renormalise"))
    down = axis_leakage(DV, psf["sigma"], psf["windowSize"], psf.get("border", "renormalise"))
    return np.einsum("vw,vtyxc,tu->wuyxc", down, light, across)


def error_and_gap(content, terms):
    """Σ W (L x − t)² of all terms (psf, W, t), and what any content in 0 … 1 can be below it."""
    error, slope = 0, np.zeros_like(content)
    for psf, weights, targets in terms:
        residual = leaked(content, psf) - targets
        error += (weights * residual**2).sum()
        slope += 2 * leaked_back(weights * residual, psf)
    return error, np.maximum(slope * content, slope * (content - 1)).sum()


def decoded(code):
    return np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)


def encoded(light):
    light = np.clip(light, 0, None)
    return np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def state(name, eye, **psf):
    return {"name": name, "eye": list(eye), "lookat": [0, 0, 0], "up": [0, 1, 0], "fov": 14,
            "res": [44, 36], "psf": psf or {"sigma": 0.67, "windowSize": 5}}


def cells_of(camera):
    """The hogel and direction that the middle ray of each pixel meets, and whether it meets one."""
    width, height = camera["res"]
    eye = np.array(camera["eye"], float)
    forward = -eye / np.linalg.norm(eye)
    right = np.cross(forward, [0, 1, 0])
    right /= np.linalg.norm(right)
    down = np.cross(forward, right)
    focal = height / 2 / np.tan(np.radians(camera["fov"]) / 2)
    y, x = np.mgrid[:height, :width]
    ray = (((x - (width - 1) / 2) / focal)[..., None] * right
           + ((y - (height - 1) / 2) / focal)[..., None] * down + forward)
    slopes = ray[..., 0] / ray[..., 2], ray[..., 1] / ray[..., 2]
    fields = [2 * np.tan(np.radians(angle) / 2) for angle in FOV]
    places = np.stack([((eye[0] - eye[2] * slopes[0]) / SIZE[0] + 0.5) * NX,
                       (0.5 - (eye[1] - eye[2] * slopes[1]) / SIZE[1]) * NY,
                       (0.5 + slopes[0] / fields[0]) * DU, (0.5 - slopes[1] / fields[1]) * DV], -1)
    meets = ((places >= 0) & (places < [NX, NY, DU, DV])).all(-1)
    return np.floor(places).astype(int), meets


class Optimise(FolderTest):
    def setUp(self):
        super().setUp()
        warnings.simplefilter("ignore")  # that a wrong sigma is worse than none
        self.addCleanup(warnings.resetwarnings)

    def session(self, cameras, light_field=None, **optimise):
        if light_field is None:
            if not os.path.exists(self.path("views")):
                self.write_floats(random_views(np.float32, (DV, DU, NY, NX, 3)))
            light_field = {"layout": "views", "file": self.path("views")}
        return hs.Session({
            "hogelscope": 1,
            "display": {"size": SIZE, "hogels": [NX, NY], "directions": [DU, DV], "fov": FOV},
            "lightField": light_field, "cameras": cameras,
            "optimise": {"iterations": 2000, "tolerance": 0, **optimise}})

    def write_floats(self, views):
        """As files of floats, which are not rounded."""
        os.mkdir(self.path("views"))
        for v, row in enumerate(views):
            for u, picture in enumerate(row):
                view = hs.View("", np.zeros(picture.shape, np.uint8),
                               np.ones(picture.shape[:2], bool), np.float32(255) * picture)
                view.save(self.path("views", f"{v:02}_{u:02}.exr"))

    def optimised(self, session, **more):
        """The content that is written, 0 … 1."""
        output = self.path("optimised")
        self.rows = hs.optimise(session, output, layout="views", **more)
        return hs.open(output).array().astype(float)

    def assert_is_least(self, content, terms):
        error, gap = error_and_gap(content, terms)
        self.assertLess(gap, 1e-3 * error)
        worse, _ = error_and_gap(np.clip(content + 0.01, 0, 1), terms)
        self.assertGreater(worse, error)

    def test_own_light(self):
        for border in ("renormalise", "clamp", "black"):
            psf = {"sigma": 0.67, "windowSize": 5, "border": border}
            session = self.session([state("a", [0, 0, 0.6], **psf)])
            own = hs.open(self.path("views")).array().astype(float)
            self.assert_is_least(self.optimised(session), [(psf, 1, own)])
            self.assertGreater(self.rows[0]["after_psnr"], self.rows[0]["before_psnr"])

    def test_states_of_several_leakages_and_a_lift(self):
        first, second = {"sigma": 0.5, "windowSize": 3}, {"sigma": 1, "windowSize": 7}
        session = self.session([state("a", [0, 0, 0.6], **first), state("b", [0, 0, 0.5], **second),
                                state("c", [0, 0.01, 0.5], **first)], lift=[0.1, 0.2])
        own = 0.1 + 0.7 * hs.open(self.path("views")).array().astype(float)
        self.assert_is_least(self.optimised(session), [(first, 2, own), (second, 1, own)])

    def test_linear_light_is_weighed_by_the_slope_of_its_encoding(self):
        psf = {"sigma": 0.67, "windowSize": 5, "light": "linear"}
        session = self.session([state("a", [0, 0, 0.6], **psf)])
        own = decoded(hs.open(self.path("views")).array().astype(float))
        low, high = np.maximum(own, 1e-4), np.maximum(leaked(own, psf), 1e-4)
        flat = np.abs(low - high) < 1e-4
        with np.errstate(divide="ignore", invalid="ignore"):
            slope = np.where(flat, 1.055 / 2.4 * low ** (1 / 2.4 - 1),
                             (encoded(low) - encoded(high)) / (low - high))
        content = decoded(self.optimised(session))
        self.assert_is_least(content, [(psf, np.minimum(slope, 12.92) ** 2, own)])

    def wishes(self, cameras, pictures):
        """The number of rays of each texel, and the sum of what they should see."""
        count, light = np.zeros((DV, DU, NY, NX, 1)), np.zeros((DV, DU, NY, NX, 3))
        for camera, picture in zip(cameras, pictures):
            cells, meets = cells_of(camera)
            i, j, u, v = cells[meets].T
            np.add.at(count, (v, u, j, i), 1)
            np.add.at(light, (v, u, j, i), picture[meets])
        return count, light

    def check_states(self, session, pictures, keep):
        cameras = session["cameras"]
        psf = cameras[0]["psf"]
        content = self.optimised(session)
        count, light = self.wishes(cameras, pictures)
        kept = keep * count.sum() / np.count_nonzero(count)
        own = self.own
        weights = count + kept
        self.assert_is_least(content, [(psf, weights, (light + kept * own) / weights)])

    def test_pictures_of_states(self):
        cameras = [state("a", [0.01, 0, 0.6]), state("b", [-0.05, 0.02, 0.5]),
                   state("c", [0.03, -0.05, 0.55])]
        os.mkdir(self.path("pictures"))
        pictures = []
        for number, camera in enumerate(cameras):
            noise = np.random.default_rng(number).integers(0, 256, (36, 44, 3), np.uint8)
            view = hs.View("", noise, np.ones((36, 44), bool))
            view.save(self.path("pictures", camera["name"] + ".png"))
            pictures.append(noise / 255)
        session = self.session(cameras, target="views", views=self.path("pictures"), keep=0.4)
        self.own = hs.open(self.path("views")).array().astype(float)
        self.check_states(session, pictures, 0.4)
        self.assertEqual({row["reference"] for row in self.rows}, {"display", "views"})
        with self.assertRaisesRegex(hs.InputError, r'has 44×36 pixels; the state "c" has 30×36'):
            cameras[2]["res"] = [30, 36]
            hs.optimise(self.session(cameras, target="views", views=self.path("pictures")),
                        self.path("other"), layout="views")
        os.rename(self.path("pictures", "c.png"), self.path("pictures", "c.jpg"))
        shutil.copy(self.path("pictures", "c.jpg"), self.path("pictures", "c.tif"))
        with self.assertRaisesRegex(hs.InputError, "has several files c.…"):
            hs.optimise(session, self.path("other"), layout="views")
        for name in ("c.jpg", "c.tif"):
            os.remove(self.path("pictures", name))
        with self.assertRaisesRegex(hs.InputError, 'has no picture c.png of the state "c"'):
            hs.optimise(session, self.path("other"), layout="views")

    def test_ideal_views_of_states(self):
        cameras = [state("a", [0.01, 0, 0.6]), state("b", [-0.05, 0.02, 0.5])]
        session = self.session(cameras, dict(ROOM, type="real"), target="ideal", keep=0.2, samples=4)
        exported = self.path("own")
        session.save(self.path("s.json"))
        program("--export", "views", "--prefilter", "--session", self.path("s.json"), "--set",
                "optimise.samples=4", "--output", exported)
        self.own = hs.open(exported).array()
        pictures = [np.round(257 * session.render(camera, ideal=True).values.astype(float)) / 65535
                    for camera in cameras]
        output = self.path("optimised")
        self.rows = hs.optimise(session, output, layout="views")
        count, light = self.wishes(cameras, pictures)
        kept = 0.2 * count.sum() / np.count_nonzero(count)
        weights = count + kept
        self.assert_is_least(hs.open(output).array().astype(float),
                             [(cameras[0]["psf"], weights, (light + kept * self.own) / weights)])
        self.assertEqual({row["reference"] for row in self.rows}, {"display", "ideal"})

    def test_ideal_views_through_a_unit(self):
        """The scene is asked for them, not the light field that is corrected for the unit."""
        linear = {"sigma": 0.67, "windowSize": 5, "light": "linear"}
        session = self.session([state("a", [0.01, 0, 0.6], **linear)], ROOM, target="ideal",
                               iterations=50)
        session["twin"] = {"random": {"gain": {"sigma": 0.1}, "shift": {"sigma": 0.0002}}}
        self.optimised(session)
        ideal = [row for row in self.rows if row["view"] == "a" and row["reference"] == "ideal"]
        self.assertGreater(ideal[0]["after_psnr"], ideal[0]["before_psnr"])

    def test_views_are_compared_as_bright_as_a_unit_can_be(self):
        """Gains alone are made up for wholly, but for brightness: the dimmest hogel is white."""
        session = self.session([state("a", [0, 0, 0.6], windowSize=1, light="linear")])
        session["twin"] = {"random": {"gain": {"sigma": 0.1}}}
        self.optimised(session)
        for row in self.rows:
            self.assertGreater(row["after_psnr"], 48)  # both are rounded to 8 bits
            self.assertLess(row["before_psnr"], 40)

    def test_light_of_states_without_leakage_does_not_matter(self):
        linear = {"sigma": 0.67, "windowSize": 5, "light": "linear"}
        rows = []
        for light in ("encoded", "linear"):
            session = self.session([state("a", [0, 0, 0.6], **linear),
                                    state("b", [0, 0, 0.5], windowSize=1, light=light)],
                                   lift=[0.2, 0.1], iterations=50)
            self.optimised(session)
            shutil.rmtree(self.path("optimised"))
            rows.append([row["after_psnr"] for row in self.rows if row["view"] in "ab"])
        self.assertEqual(*rows)

    def test_without_leakage_is_the_prefiltered_export(self):
        session = self.session([state("a", [0, 0, 0.6], windowSize=1)], ROOM)
        session.save(self.path("s.json"))
        program("--export", "hogels", "--prefilter", "--session", self.path("s.json"),
                "--output", self.path("prefiltered.png"))
        program("--optimise", "hogels", "--session", self.path("s.json"),
                "--output", self.path("optimised.png"))
        self.assertEqual(read(self.path("optimised.png")), read(self.path("prefiltered.png")))
        program("--export", "hogels", "--session", self.path("s.json"),
                "--output", self.path("plain.png"))
        self.assertNotEqual(read(self.path("plain.png")), read(self.path("prefiltered.png")))

    def test_bytes_depend_on_nothing(self):
        """Threads, the memory for wishes and the layout of the result."""
        cameras = [state("a", [0.01, 0, 0.6]), state("b", [-0.05, 0.02, 0.5])]
        session = self.session(cameras, ROOM, target="ideal", tolerance=0.01, iterations=100)
        session.save(self.path("s.json"))
        expected = None
        for threads in ("1", "2", "7"):
            program("--optimise", "hogels", "--session", self.path("s.json"), "--threads", threads,
                    "--output", self.path("o.png"))
            texts = [read(self.path(name)) for name in ("o.png", "o.csv", "o.html")]
            expected = expected or texts
            self.assertEqual(texts, expected)
        program("--optimise", "pack", "--session", self.path("s.json"),
                "--output", self.path("o.tif"))
        np.testing.assert_array_equal(hs.open(self.path("o.tif")).array(), self.optimised_bytes())
        for shard in ("2/3", "1/3"):  # the third is left to the command without --shard
            program("--optimise", "pack", "--session", self.path("s.json"), "--shard", shard,
                    "--output", self.path("shards.tif"))
        self.assertEqual(len(os.listdir(self.path("shards.tif.rows"))), 4)
        self.assertFalse(os.path.exists(self.path("shards.tif")))
        program("--optimise", "pack", "--session", self.path("s.json"),
                "--output", self.path("shards.tif"))
        self.assertEqual(read(self.path("shards.tif")), read(self.path("o.tif")))
        self.assertEqual(read(self.path("shards.csv")), read(self.path("o.csv")))
        self.assertFalse(os.path.exists(self.path("shards.tif.rows")))

    def optimised_bytes(self):
        program("--optimise", "views", "--session", self.path("s.json"),
                "--output", self.path("bytes"))
        return hs.open(self.path("bytes")).array()

    def test_rows_of_another_problem_are_not_taken(self):
        session = self.session([state("a", [0, 0, 0.6])], ROOM)
        session.save(self.path("s.json"))
        command = ["--optimise", "pack", "--session", self.path("s.json"), "--output",
                   self.path("o.tif")]
        program(*command, "--shard", "1/1", "--set", "psf.sigma=1")
        program(*command)
        program(*command[:-1], self.path("alone.tif"))
        self.assertEqual(read(self.path("o.tif")), read(self.path("alone.tif")))

    def test_a_killed_run_goes_on(self):
        session = self.session([state("a", [0, 0, 0.6])], ROOM)
        session["display"].update(hogels=[40, 30], directions=[16, 16])
        session.save(self.path("s.json"))
        command = [PROGRAM, "--optimise", "pack", "--session", self.path("s.json"), "--set",
                   "optimise.iterations=300", "--quiet", "--output"]
        rows = self.path("killed.tif.rows")
        with subprocess.Popen([*command, self.path("killed.tif")]) as run:
            while run.poll() is None and len(os.listdir(rows) if os.path.exists(rows) else []) < 5:
                time.sleep(0.01)
            run.kill()
        with open(os.path.join(rows, ".hogelscope-x.part"), "w", encoding="utf-8"):
            pass  # what a process leaves that dies while it writes
        kept = {name: os.stat(os.path.join(rows, name)).st_mtime_ns for name in os.listdir(rows)
                if name.endswith(".row")}
        self.assertTrue(5 <= len(kept) < 30 and not os.path.exists(self.path("killed.tif")), kept)
        subprocess.run([*command, self.path("killed.tif")], check=True)
        subprocess.run([*command, self.path("whole.tif")], check=True)
        self.assertEqual(read(self.path("killed.tif")), read(self.path("whole.tif")))
        self.assertEqual(read(self.path("killed.csv")), read(self.path("whole.csv")))
        self.assertFalse(os.path.exists(rows))

    def test_units(self):
        """Gains, dead pixels and shifts: dead ones are black, and seen through the unit the content
        comes closer to what the display as designed shows."""
        psf = {"sigma": 0.67, "windowSize": 5, "light": "linear"}
        session = self.session([state("a", [0, 0, 0.6], **psf)])
        session["twin"] = {"dead": {"hogels": [[2, 3]], "columns": [4]},
                           "random": {"gain": {"sigma": 0.05}, "seed": 3}}
        session["optimise"]["iterations"] = 200
        content = self.optimised(session)
        self.assertEqual(content[:, :, 3, 2].max(), 0)
        self.assertEqual(content[:, 4, :, 0].max(), 0)
        self.assertGreater(content[:, 3, :, 0].max(), 0.5)
        self.assertGreater(self.rows[0]["after_psnr"], self.rows[0]["before_psnr"])
        session["twin"] = {"random": {"shift": {"sigma": 0.0002}, "seed": 3}}
        shutil.rmtree(self.path("optimised"))
        self.assertGreater(self.optimised(session)[:, :, 3, 2].max(), 0.5)
        self.assertGreater(self.rows[0]["after_psnr"], self.rows[0]["before_psnr"])
        session["twin"] = {"leakage": {"sigmaGrowth": 0.2}}
        with self.assertRaisesRegex(hs.InputError, "twin.leakage: differs over the field"):
            hs.optimise(session, self.path("other"), layout="views")

    def test_contrast_follows_its_law(self):
        """A wave over directions that leakage took the factor OTF from gets it back."""
        u = np.arange(DU)
        wave = 0.5 + 0.2 * np.cos(2 * np.pi * (u[None, :] / 4 + np.arange(NX)[:, None] / 7))
        views = np.zeros((DV, DU, NY, NX, 3), np.float32)
        views[:] = wave.T[None, :, None, :, None]
        self.write_floats(views)
        psf = {"sigma": 0.67, "windowSize": 5}
        content = self.optimised(self.session([state("a", [0, 0, 0.6], **psf)]))
        weights = np.exp(-np.arange(-2, 3) ** 2 / (2 * 0.67**2))
        transfer = (weights * np.cos(np.pi / 2 * np.arange(-2, 3))).sum() / weights.sum()

        def contrast(values):
            inner = values[:, 2:6].mean(axis=(0, 2, 4))  # one period, away from the field's edges
            waves = np.exp(-2j * np.pi * np.arange(2, 6) / 4)
            return 2 * np.abs(waves @ inner) / 4 / 0.5

        np.testing.assert_allclose(contrast(leaked(views, psf)), 0.4 * transfer, atol=1e-4)
        np.testing.assert_allclose(contrast(leaked(content, psf)), 0.4, atol=1e-3)

    def test_refusals(self):
        psf = {"sigma": 0.67, "windowSize": 5}
        cases = [
            ({"sampling": {"reconstruction": "bilinear"}}, {}, 'sampling.reconstruction: must be "near'),
            ({}, {"lift": [0.5, 0.5]}, "optimise.lift: leaves no contrast"),
            ({}, {"target": "ideal"}, 'lightField.layout: is not "live"'),
            ({}, {"target": "views"}, "optimise.views: is missing"),
        ]
        for more, optimise, said in cases:
            session = self.session([state("a", [0, 0, 0.6], **psf)], **optimise)
            session.update(more)
            with self.subTest(said), self.assertRaisesRegex(hs.InputError, said):
                hs.optimise(session, self.path("o"), layout="views")
        session = self.session([state("a", [0, 0, 0.6], windowSize=1)])
        with self.assertRaisesRegex(hs.InputError, "there is nothing to optimise"):
            hs.optimise(session, self.path("o"), layout="views")
        session = self.session([state("a", [0, 0, 0.6]), state("b", [0, 0, 0.5], **psf,
                                                               light="linear")])
        with self.assertRaisesRegex(hs.InputError, r"cameras\[1\].psf.light: differs from that of"):
            hs.optimise(session, self.path("o"), layout="views")
        session = self.session([state("a", [0.5, 0, -0.6])], ROOM, target="ideal")
        with self.assertRaisesRegex(hs.InputError, "no state sees the display"):
            hs.optimise(session, self.path("o"), layout="views")
        session = self.session([dict(state("a", [0, 0, 0.6]), pupil={"diameter": 0.004})], ROOM,
                               target="ideal")
        with self.assertRaisesRegex(hs.InputError, r"cameras\[0\].pupil: has a pixel see several"):
            hs.optimise(session, self.path("o"), layout="views")
        with self.assertRaisesRegex(hs.InputError, 'is not one of hogels, views, quilt, pack'):
            hs.optimise(session, self.path("o"), layout="mosaic")
        with self.assertRaisesRegex(hs.InputError, "o.png: is the name of a store"):
            hs.optimise(session, self.path("o.png"), layout="pack")
        session = self.session([state("a", [0, 0, 0.6], **psf)])
        os.mkdir(self.path("taken.csv"))
        for output, said in (("taken", "taken.csv: is a folder"), ("o{T}", "the number of a frame")):
            with self.assertRaisesRegex(hs.InputError, said):
                hs.optimise(session, self.path(output), layout="views")
        self.assertFalse(os.path.exists(self.path("o")))
        self.assertIn("--shard: is for --optimise pack", refusal(
            "--optimise", "hogels", "--session", "data/room.json", "--output", self.path("o.png"),
            "--shard", "1/2"))
        self.assertIn("--prefilter: is for a live scene", refusal(
            "--export", "hogels", "--session", self.path("views"), "--output", self.path("o.png"),
            "--prefilter"))


if __name__ == "__main__":
    unittest.main()
