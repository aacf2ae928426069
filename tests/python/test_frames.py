# SPDX-License-Identifier: BSD-3-Clause
"""Light fields in time: frames in files, folders and videos, reports over them, against numpy."""

import csv
import os
import shutil
import signal
import subprocess
import time
import unittest

import numpy as np
from PIL import Image
from support import PROGRAM, FolderTest, program, read, refusal

import hogelscope as hs

HOGELS, DIRECTIONS, FRAMES = (20, 16), (3, 2), 6  # (nx, ny), (du, dv)


def moving(frames=FRAMES, seed=3):
    """A light field (T, dv, du, ny, nx, 3) of smooth content that moves, with parallax."""
    random = np.random.default_rng(seed)
    waves = random.uniform(0.1, 0.5, (3, 2, 4))
    (nx, ny), (du, dv) = HOGELS, DIRECTIONS
    t, v, u, y, x = np.meshgrid(*(np.arange(n) for n in (frames, dv, du, ny, nx)), indexing="ij")
    channels = []
    for across, down in waves:
        places = zip(across, down)
        sums = sum(np.sin(a * (x + u + 2 * t) + d * (y + v - t)) for a, d in places)
        channels.append(127.5 + 30 * sums)
    return np.clip(np.stack(channels, -1).round(), 0, 255).astype(np.uint8)


def picture_of(file):
    return np.asarray(Image.open(file)).astype(float)


def psnr(mse):
    return 10 * np.log10(255**2 / mse)


def rows_of(*path):
    with open(os.path.join(*path), newline="") as file:
        return list(csv.DictReader(file))


class Frames(FolderTest):
    def picture(self, values, *path):
        os.makedirs(os.path.dirname(self.path(*path)), exist_ok=True)
        hs.View("", np.ascontiguousarray(values), np.ones(values.shape[:2], bool)).save(
            self.path(*path))

    def hogel_images(self, light, name="scene.{}.png", first=0):
        """scene.0.png …, the hogel images of the frames; their name with {T}."""
        (nx, ny), (du, dv) = HOGELS, DIRECTIONS
        for number, frame in enumerate(light, first):
            hogels = frame.transpose(2, 0, 3, 1, 4).reshape(ny * dv, nx * du, 3)
            self.picture(hogels, name.format(number))
        return self.path(name.format("{T}"))

    def views(self, light, name, of_view, first=0):
        for number, frame in enumerate(light, first):
            for v, row in enumerate(frame):
                for u, view in enumerate(row):
                    self.picture(view, name, of_view.format(T=number, v=v, u=u))
        return self.path(name)

    def videos(self, light, name="videos", *, rate="25", codec=("-c:v", "ffv1"), ending="mkv"):
        if shutil.which("ffmpeg") is None:
            self.skipTest("ffmpeg is not installed")
        os.makedirs(self.path(name))
        for v in range(light.shape[1]):
            for u in range(light.shape[2]):
                self.video(light[:, v, u], self.path(name, f"{v:02}_{u:02}.{ending}"), rate, codec)
        return self.path(name)

    def video(self, pictures, file, rate="25", codec=("-c:v", "ffv1")):
        size = f"{pictures.shape[2]}x{pictures.shape[1]}"
        subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt",
                        "rgb24", "-s", size, "-r", rate, "-i", "-", *codec, file],
                       input=pictures.tobytes(), check=True)

    def session(self, file, layout="hogels", name="s.json", cameras=None, **light):
        """A session of two states, one of which has leakage."""
        display = {"size": [0.4, 0.32], "fov": [30, 25]}
        if layout == "hogels":
            display |= {"hogels": list(HOGELS), "directions": list(DIRECTIONS)}
        states = [{"name": "a", "eye": [0, 0, 0.6], "fov": 45, "res": [40, 30]},
                  {"name": "b", "eye": [0.05, 0.02, 0.5], "fov": 60, "res": [36, 36],
                   "psf": {"sigma": 0.7, "windowSize": 3}}]
        return self.write(name, {"hogelscope": 1, "display": display,
                                 "lightField": {"file": file, "layout": layout, **light},
                                 "cameras": states if cameras is None else cameras})

    def render(self, session, output, *more):
        program("--render", "--session", session, "--output", self.path(output), "--quiet", *more)
        return {name: read(self.path(output, name)) for name in sorted(os.listdir(
            self.path(output)))}


class Rendering(Frames):
    def test_the_same_frames_of_all_kinds_of_files(self):
        """Each frame has the bytes of the same frame as a still; numbers are those of the names."""
        light = moving()
        stills = {}
        for k, frame in enumerate(light):
            still = self.session(self.hogel_images(frame[None], f"still{k}.png"), name=f"{k}.json")
            for name, data in self.render(still, f"still{k}").items():
                stills[name.replace(".png", f".frame{k:04}.png")] = data
        self.assertEqual(len(stills), 2 * FRAMES)
        kinds = {
            "hogels": (self.hogel_images(light), "hogels", {}),
            "folders": (self.views(light, "take", "{T:04}/{v:02}_{u:02}.png"), "views",
                        {"pattern": "{T}/RR_CC.png"}),
            "names": (self.views(light, "flat", "{v}_{u}_t{T}.png"), "views",
                      {"pattern": "R_C_t{T}.png"}),
            "a folder": (self.views(light, "deep", "{T}/x/{v}_{u}.png") + "/{T}/x", "views", {}),
            "videos": (self.videos(light), "views", {}),
        }
        for kind, (file, layout, more) in kinds.items():
            with self.subTest(kind):
                session = self.session(file, layout, **more)
                self.assertEqual(self.render(session, "out of " + kind, "--frames", "all"),
                                 stills)

    def test_videos_of_mosaics_and_hogel_images(self):
        light = moving()
        (nx, ny), (du, dv) = HOGELS, DIRECTIONS
        hogels = light.transpose(0, 3, 1, 4, 2, 5).reshape(FRAMES, ny * dv, nx * du, 3)
        mosaic = light.transpose(0, 1, 3, 2, 4, 5).reshape(FRAMES, dv * ny, du * nx, 3)
        wanted = self.render(self.session(self.hogel_images(light)), "files", "--frames", "1:5:2")
        self.assertEqual(len(wanted), 6)
        if shutil.which("ffmpeg") is None:
            self.skipTest("ffmpeg is not installed")
        self.video(hogels, self.path("hogels.mkv"))
        self.assertEqual(wanted, self.render(self.session(self.path("hogels.mkv")), "hogels",
                                             "--frames", "1:5:2"))
        self.video(mosaic, self.path("mosaic.mkv"))
        document = hs.Session(self.session(self.path("mosaic.mkv"), "mosaic"))
        document["display"]["directions"] = list(DIRECTIONS)
        document.save(self.path("mosaic.json"))
        self.assertEqual(wanted, self.render(self.path("mosaic.json"), "mosaic", "--frames",
                                             "1:5:2"))

    def test_raw_yuv(self):
        """4:4:4 in 8 bits by the names of its files, as MPEG's."""
        grey = np.repeat(moving()[..., :1], 3, -1)
        grey = np.clip(grey, 16, 235)
        os.mkdir(self.path("raw"))
        for v in range(DIRECTIONS[1]):
            for u in range(DIRECTIONS[0]):
                planes = [grey[:, v, u, ..., 0], *2 * [np.full(grey.shape[:1] + grey.shape[3:5],
                                                                128)]]
                name = f"{v}_{u}_{HOGELS[0]}x{HOGELS[1]}_yuv444p.yuv"
                np.stack(planes, 1).astype(np.uint8).tofile(self.path("raw", name))
        full = np.floor((grey - 16) / 219 * 255 + 0.5).astype(np.uint8)
        session = self.session(self.path("raw"), "views",
                               pattern=f"R_C_{HOGELS[0]}x{HOGELS[1]}_yuv444p.yuv")
        wanted = self.session(self.hogel_images(full), name="w.json")
        self.assertEqual(self.render(session, "raw-out", "--frames", "all"),
                         self.render(wanted, "files", "--frames", "all"))

    def test_a_still_is_its_first_frame(self):
        light = np.repeat(moving(1), FRAMES, 0)
        session = self.session(self.hogel_images(light))
        still = self.session(self.path("scene.0.png"), name="still.json")
        stills = self.render(still, "still")
        self.assertEqual(stills, self.render(session, "first"))
        for name, data in self.render(session, "all", "--frames", "all").items():
            self.assertEqual(data, stills[name[0] + ".png"])

    def test_time_chooses_a_frame(self):
        """frame = first + step·⌊⌊time·fps + 1e-6⌋ / step⌋, the last one after the end."""
        light = moving(12)
        self.hogel_images(light, "n{}.png", first=30)
        for listed, rate in (([30, 41, 1], 25), ([32, 40, 4], 29.97)):
            times = [0, 1 / rate, 1 / rate - 1e-9, 1 / rate - 1e-3, 3 / rate, 4 / rate, 0.2, 5]
            states = [{"name": f"s{k}", "eye": [0, 0, 0.6], "fov": 45, "res": [24, 20], "time": t}
                      for k, t in enumerate(times)]
            session = self.session(self.path("n{T}.png"), cameras=states, frames=listed, fps=rate)
            shown = self.render(session, f"timed{rate}")
            first, last, step = listed
            for k, t in enumerate(times):
                frame = min(first + step * (int(np.floor(t * rate + 1e-6)) // step), last)
                still = self.session(self.path(f"n{frame}.png"), name="n.json",
                                     cameras=[{**states[k]}])
                with self.subTest(time=t, rate=rate):
                    self.assertEqual(shown[f"s{k}.png"],
                                     self.render(still, f"n{rate}-{k}")[f"s{k}.png"])

    def test_a_trace_keeps_its_times(self):
        """Each sample is a state at the frame of its time; of a still they are places."""
        with open(self.path("walk.csv"), "w") as file:
            file.write("time,x,y,z\n3.0,-0.1,0,0.6\n3.1,0,0.01,0.6\n3.4,0.1,0,0.5\n")
        session = self.session(self.hogel_images(moving()), fps=12)
        still = self.session(self.path("scene.0.png"), name="still.json")
        said = program("--make-cameras", self.path("walk.csv"), "--session", session, "--count",
                       "7", "--output", self.path("walked.json"), "--states", "a",
                       "--set", "cameraSet.keepTemplate=false")
        self.assertIn("each sample is a state with a time", said)
        states = hs.Session(self.path("walked.json"))["cameras"]
        times = [0.4 * (k + 0.5) / 7 for k in range(7)]
        np.testing.assert_allclose([state["time"] for state in states], times, rtol=1e-12)
        np.testing.assert_allclose([state["eye"][0] for state in states],
                                   np.interp(times, [0, 0.1, 0.4], [-0.1, 0, 0.1]), atol=1e-8)
        shown = self.render(self.path("walked.json"), "walked")
        for k, t in enumerate(times):
            alone = hs.Session(self.path("walked.json"))
            alone["lightField"] = {"file": self.path(f"scene.{int(np.floor(t * 12 + 1e-6))}.png"),
                                   "layout": "hogels"}
            alone["cameras"] = [states[k]]
            alone.save(self.path("alone.json"))
            name = states[k]["name"] + ".png"
            self.assertEqual(shown[name], self.render(self.path("alone.json"), f"al{k}")[name])
        program("--make-cameras", self.path("walk.csv"), "--session", still, "--count", "7",
                "--output", self.path("places.json"), "--quiet")
        self.assertNotIn("time", hs.Session(self.path("places.json"))["cameras"][-1])

    def test_names_of_eyes_masks_and_focus(self):
        session = hs.Session(self.session(self.hogel_images(moving(2))))
        session["cameras"][0].update(stereo={"ipd": 0.02}, pupil={"diameter": 0.004})
        session.save(self.path("eyes.json"))
        names = self.render(self.path("eyes.json"), "eyes", "--states", "a", "--frames", "1",
                            "--masks")
        self.assertEqual(sorted(names), ["a.left.frame0001.mask.png", "a.left.frame0001.png",
                                         "a.right.frame0001.mask.png", "a.right.frame0001.png"])
        names = self.render(self.path("eyes.json"), "joint", "--states", "a", "--frames", "1",
                            "--stereo", "side-by-side", "--focus-stack", "2")
        self.assertEqual(sorted(names), ["a.focus01.frame0001.png", "a.focus02.frame0001.png",
                                         "a.frame0001.focus.csv"])

    def test_shards_take_frames_that_follow_each_other(self):
        session = self.session(self.hogel_images(moving()))
        everything = self.render(session, "all", "--frames", "all")
        parts = [self.render(session, f"part{k}", "--frames", "all", "--shard", f"{k}/4")
                 for k in (1, 2, 3, 4)]
        self.assertEqual({**parts[0], **parts[1], **parts[2], **parts[3]}, everything)
        self.assertEqual([len(part) for part in parts], [4, 2, 4, 2])
        self.assertEqual({name[7:] for name in parts[0]}, {"0000.png", "0001.png"})

    def test_a_path_shows_the_frames_of_its_time(self):
        session = self.session(self.hogel_images(moving()), fps=30)
        document = hs.Session(session)
        document["cameras"][1] = {**document["cameras"][0], "name": "c", "eye": [0.1, 0, 0.6]}
        document.save(session)
        path = self.render(session, "path", "--between", "3")
        self.assertEqual(len(path), 5)
        for k in range(5):
            still = hs.Session(session)
            still["lightField"] = {"file": self.path(f"scene.{k}.png"), "layout": "hogels"}
            still["cameras"] = [{**document["cameras"][0], "eye": [0.025 * k, 0, 0.6],
                                 "name": f"frame_{k + 1:04}"}]
            still.save(self.path("still.json"))
            self.assertEqual(path[f"frame_{k + 1:04}.png"],
                             self.render(self.path("still.json"), f"s{k}")[f"frame_{k + 1:04}.png"])

    def test_lines(self):
        files = self.hogel_images(moving())
        session = self.session(files)
        render = ("--render", "--session", session, "--output", self.path("out"))
        self.assertIn("of 6 frames the first one, 0, is used; --frames all uses all",
                      program(*render, "--states", "a"))
        for frames, line in (("3:9", "--frames 3:9: has frame 6, but the light field's are 0:5"),
                             ("5:3", "--frames 5:3: must be all, a frame, or FIRST:LAST:STEP, such "
                                     "as 0:99:10"),
                             ("1:x", "--frames 1:x: must be all"), ("-1", "--frames -1"),
                             ("0:5:0", "--frames 0:5:0: must be all")):
            self.assertIn(line, refusal(*render, f"--frames={frames}"))
        still = self.session(self.path("scene.0.png"), name="still.json")
        self.assertIn("--frames all: the light field is one frame",
                      refusal("--render", "--session", still, "--output", self.path("out"),
                              "--frames", "all"))
        self.session(files, cameras=[{"name": "t", "eye": [0, 0, 1], "time": 1}])
        self.assertIn("t: time: needs lightField.fps", refusal(*render))
        self.assertIn("all states have a time", refusal(*render, "--frames", "all"))
        os.remove(self.path("scene.3.png"))
        self.assertIn("frame 3 is missing: there are 5 frames, 0 … 5", refusal(*render))
        self.session(files, frames=[0, 2])
        self.render(session, "three", "--frames", "all")
        self.session(files, frames=[0, 5, 2])
        self.assertEqual(len(self.render(session, "two", "--frames", "0:4:4")), 4)
        shutil.copy(self.path("scene.2.png"), self.path("scene.02.png"))
        self.assertIn("has two frames 2: 02 and 2", refusal(*render))
        os.remove(self.path("scene.02.png"))
        self.picture(np.zeros((32, 57, 3), np.uint8), "scene.4.png")
        self.assertIn("scene.4.png", refusal(*render, "--frames", "all"))
        self.assertIn("no file has a number in place of {T}",
                      refusal(*render, "--set", "lightField.file=" + self.path("none.{T}.png")))

    def test_videos_that_do_not_fit(self):
        """One line that names the view: fewer frames, another rate or size, damaged in its middle."""
        light = moving()
        session = self.session(self.videos(light), "views")
        render = ("--render", "--session", session, "--output", self.path("out"), "--frames",
                  "all")
        view = self.path("videos", "01_02.mkv")
        kept = read(view)
        self.video(light[:4, 1, 2], view)
        self.assertIn("01_02.mkv: frames: are 4, but the first view has 6", refusal(*render))
        self.video(light[:, 1, 2], view, rate="24")
        self.assertIn("01_02.mkv: frames: are 24 a second, but those of the first view 25",
                      refusal(*render))
        self.video(light[:, 1, 2, :8], view)
        self.assertIn("01_02.mkv: size: is 20×8 px, but the first view is 20×16",
                      refusal(*render))
        with open(view, "wb") as file:
            file.write(kept[:len(kept) // 2] + bytes(400) + kept[len(kept) // 2 + 400:])
        self.assertIn("01_02.mkv", refusal(*render))

    def test_info(self):
        shown = subprocess.run([PROGRAM, "--info", self.session(self.videos(moving()), "views")],
                               capture_output=True, text=True, check=True).stdout
        self.assertIn("frames      6: 0 … 5; 25 a second, 0.24 s", shown)
        name = self.hogel_images(moving())
        shown = subprocess.run([PROGRAM, "--info", name, "--set", "display.hogels=[20,16]",
                                "--set", "display.directions=[3,2]"],
                               capture_output=True, text=True, check=True).stdout
        self.assertIn("frames      6: 0 … 5; lightField.fps says how many a second", shown)


class Opening(Frames):
    """Frames are assumed only by opening and --info, where names and pictures say so."""

    def info(self, folder):
        return subprocess.run([PROGRAM, "--info", folder], capture_output=True, text=True,
                              check=False).stdout

    def test_folders_of_frames(self):
        light = moving(4)
        folder = self.views(light, "take", "frame_{T:03}/{v:02}_{u:02}.png", first=5)
        said = self.info(folder)
        self.assertIn("frames      4: 5 … 8", said)
        self.assertIn("assumed     frames, one in each folder frame_{T}: sure", said)
        session = hs.Session(folder)
        self.assertEqual(session["lightField"]["file"], os.path.join(folder, "frame_{T}"))
        self.assertSame(session.light_field().array(), light)

    def test_several_scenes_are_no_frames(self):
        random = np.random.default_rng(2)
        scenes = random.integers(0, 256, (3, 2, 3, *HOGELS[::-1], 3), np.uint8)
        folder = self.views(scenes, "scenes", "{T}/{v:02}_{u:02}.png")
        self.assertNotIn("frames", self.info(folder))

    def quilts(self, light, folder, name):
        (nx, ny), (du, dv) = HOGELS, DIRECTIONS
        for number, frame in enumerate(light, 1):
            quilt = frame[::-1].transpose(0, 2, 1, 3, 4).reshape(dv * ny, du * nx, 3)
            self.picture(quilt, folder, name.format(number))

    @staticmethod
    def one_row(light):
        """The views of quilts are one row of directions."""
        return light.reshape(len(light), 1, -1, *light.shape[3:])

    def test_a_folder_of_quilts(self):
        """Names cannot tell frames from codings of one frame, so that it is never sure."""
        light = moving(3)
        self.quilts(light, "take", "room 2.{:03}_qs3x2a1.25.png")
        said = self.info(self.path("take"))
        self.assertIn("frames      3: 1 … 3", said)
        self.assertIn("assumed     frames, one in each file room 2.{T}_qs3x2a1.25.png: likely", said)
        session = hs.Session(self.path("take"))
        self.assertEqual(session["lightField"]["file"],
                         self.path("take", "room 2.{T}_qs3x2a1.25.png"))
        self.assertSame(session.light_field().array(), self.one_row(light))

    def test_pictures_beside_one(self):
        """A file that is opened stays itself; those that may be its frames are told."""
        light = moving(3)
        self.quilts(light, "take", "room_{}_qs3x2a1.25.png")
        one = self.path("take", "room_2_qs3x2a1.25.png")
        self.assertIn("2 pictures have this name but for its number, and the next one is like it: "
                      f"if they are frames, open {self.path('take', 'room_{T}_qs3x2a1.25.png')}",
                      self.info(one))
        self.assertSame(hs.Session(one).light_field().array(), self.one_row(light)[1])
        self.quilts(255 - light[:1], "scenes", "room_{}_qs3x2a1.25.png")
        os.rename(self.path("scenes", "room_1_qs3x2a1.25.png"),
                  self.path("take", "room_3_qs3x2a1.25.png"))
        self.assertNotIn("if they are frames", self.info(one))

    def test_folders_of_rows_are_no_frames(self):
        light = moving(1)[0]
        for v, row in enumerate(light):
            for u, view in enumerate(row):
                self.picture(view, "rows", f"{v:02}", f"{u:02}.png")
        said = self.info(self.path("rows"))
        self.assertNotIn("frames", said)
        self.assertIn("2 rows of 3", said)


class Exports(Frames):
    def test_a_file_for_each_frame(self):
        """Each layout, and a store, gives the same pictures again."""
        session = self.session(self.hogel_images(moving()))
        wanted = self.render(session, "wanted", "--frames", "all")
        for layout, output in (("hogels", "e{T}.png"), ("views", "views/{T}/v"),
                               ("mosaic", "m{T}.png"), ("pack", "p{T}.tif")):
            program("--export", layout, "--session", session, "--output", self.path(output),
                    "--quiet")
            document = hs.Session(session)
            document["lightField"] = {"file": self.path(output), "layout": layout}
            document.save(self.path("again.json"))
            with self.subTest(layout):
                self.assertEqual(self.render(self.path("again.json"), layout + " again",
                                             "--frames", "all"), wanted)
        program("--pack", self.path("views", "{T}", "v"), "--output", self.path("q{T}.tif"),
                "--frames", "1:5:2", "--quiet")
        self.assertEqual(sorted(name for name in os.listdir(self.folder) if name[0] == "q"),
                         ["q0001.tif", "q0003.tif", "q0005.tif"])

    def test_a_video_of_quilts(self):
        """Its frames are those of the quilts in files, but for what the codec loses."""
        if shutil.which("ffmpeg") is None:
            self.skipTest("ffmpeg is not installed")
        light = moving()[:, :1]
        (nx, ny), (du, _) = HOGELS, DIRECTIONS
        quilts = light.transpose(0, 3, 2, 4, 1, 5).reshape(FRAMES, ny, du * nx, 3)
        self.video(quilts, self.path("own_qs3x1a1.25.mkv"), rate="12")
        session = self.session(self.path("own_qs3x1a1.25.mkv"), "quilt")
        program("--export", "quilt", "--session", session, "--output", self.path("q_{T}.png"),
                "--quiet")
        self.assertSame(picture_of(self.path("q_0003.png")), quilts[3])
        program("--export", "quilt", "--session", session, "--frames", "all", "--output",
                self.path("quilts.mp4"), "--quiet")
        shown = subprocess.run(["ffmpeg", "-loglevel", "error", "-i", self.path("quilts.mp4"), "-f",
                                "rawvideo", "-pix_fmt", "rgb24", "-"], capture_output=True,
                               check=True).stdout
        found = np.frombuffer(shown, np.uint8).reshape(FRAMES, ny, du * nx, 3)
        self.assertLess(np.abs(found.astype(float) - quilts).mean(), 6)

    def test_lines(self):
        session = self.session(self.hogel_images(moving()))
        export = ("--export", "hogels", "--session", session, "--output")
        self.assertIn("is one name for 6 frames: put {T} into it",
                      refusal(*export, self.path("e.png"), "--frames", "all"))
        self.assertIn("of 6 frames the first one", program(*export, self.path("e.png")))
        self.assertSame(picture_of(self.path("e.png")), picture_of(self.path("scene.0.png")))
        program(*export, self.path("e.png"), "--frames", "4", "--quiet")
        self.assertSame(picture_of(self.path("e.png")), picture_of(self.path("scene.4.png")))
        self.assertIn("needs lightField.fps",
                      refusal(*export, self.path("e.mp4"), "--frames", "all"))
        still = self.session(self.path("scene.0.png"), name="still.json")
        self.assertIn("has {T}, but the light field is one frame",
                      refusal("--export", "hogels", "--session", still, "--output",
                              self.path("x{T}.png")))
        self.hogel_images(moving(), "in{}.png", first=1000)
        same = self.session(self.path("in{T}.png"), name="same.json")
        self.assertIn("in1000.png", refusal("--export", "hogels", "--session", same, "--output",
                                            self.path("in{T}.png")))


class Package(Frames):
    def test_arrays_with_frames(self):
        """LightField of an array, of files and of videos; each frame is that of --render."""
        light = moving()
        session = hs.Session(self.session(self.hogel_images(light), fps=25))
        wanted = {name: picture_of(self.path("wanted", name)) for name in self.render(
            self.path("s.json"), "wanted", "--frames", "all")}
        own = session.light_field()
        self.assertEqual((own.frames, own.fps, own.shape), (range(6), 25, light.shape))
        self.assertSame(own.array(), light)
        self.assertSame(own.array(frame=4), light[4])
        array = hs.LightField(light[::-1][::-1])
        self.assertEqual((array.frames, array.fps, array.shape), (range(6), None, light.shape))
        for frames in ((frame for frame in light), map(np.copy, light), list(light)):
            np.testing.assert_array_equal(hs.LightField(frames).array(), light)
        for wrong in ("text", b"bytes", {1: 2}, {1, 2}, 5, None):
            self.assertRaises(TypeError, hs.LightField, wrong)
        self.assertRaises(ZeroDivisionError, hs.LightField, (light[0] / 0 // 0 if k else 1 // k
                                                             for k in range(1)))
        self.assertSame(array.array(), light)
        for content in (None, own, array, light, self.path("scene.{T}.png")):
            for frame in (3, 0, 5):
                for view in session.render(None, content, frame=frame):
                    self.assertSame(view.image, wanted[f"{view.state}.frame{frame:04}.png"])
                    self.assertSame(np.clip(np.floor(view.values.astype(float) + 0.5), 0, 255),
                                    view.image)
            self.assertSame(session.render("a", content).image, wanted["a.frame0000.png"])
        self.assertSame(session.render("a", time=0.121).image, wanted["a.frame0003.png"])
        self.assertRefuses("frame: 6 is not there", session.render, "a", frame=6)
        self.assertRefuses("give one of them", session.render, "a", frame=1, time=1)
        self.assertRefuses("frame: 9 is not there", own.array, frame=9)
        self.assertRefuses("needs lightField.fps", session.render, "a", array, time=1)
        self.assertRefuses("shape", hs.LightField, light[:0])

    def test_late_values_are_those_of_the_frame(self):
        session = hs.Session(self.session(self.hogel_images(moving())))
        views = [session.render("b", frame=frame) for frame in (2, 5, 2)]
        for view in views:
            self.assertSame(np.clip(np.floor(view.values.astype(float) + 0.5), 0, 255), view.image)
        self.assertSame(views[0].image, views[2].image)
        self.assertGreater(np.abs(views[0].values - views[1].values).max(), 1)

    def test_states_with_a_time(self):
        """Each has its own frame, in one call."""
        session = hs.Session(self.session(self.hogel_images(moving()), fps=10))
        session["cameras"] = [{**session["cameras"][0], "name": str(k), "time": time}
                              for k, time in enumerate((0.5, 0, 0.25, 9))]
        frames = (5, 0, 2, 5)
        for view, frame in zip(session.render(), frames):
            still = {key: value for key, value in session["cameras"][0].items() if key != "time"}
            self.assertSame(view.image, session.render(still, frame=frame).image)
        self.assertEqual([view.state for view in session.render_all()], list("0123"))

    def test_a_report_on_arrays(self):
        light = moving()
        coded = np.clip(light.astype(int) + 9, 0, 255).astype(np.uint8)
        session = hs.Session(self.session(self.hogel_images(light)))
        of_array = hs.report(session, {"coded": coded}, light_field=light,
                             output=self.path("array"))
        name = self.hogel_images(coded, "t{}.png")
        of_files = hs.report(session, {"coded": name}, output=self.path("files"))
        self.assertEqual(len(of_array), 12)
        self.assertEqual(str(list(of_array)), str(list(of_files)))


class Reports(Frames):
    def setUp(self):
        super().setUp()
        self.light = moving()
        noise = np.random.default_rng(1).integers(-12, 13, self.light.shape)
        self.coded = np.clip(self.light + noise, 0, 255).astype(np.uint8)
        self.reference = self.session(self.hogel_images(self.light, "r{}.png"), fps=25)
        self.test = self.hogel_images(self.coded, "t{}.png")

    def report(self, output, *more, session=None):
        program("--report", "--session", session or self.reference, "--test", self.test,
                "--output", self.path(output), "--quiet", *more)
        return rows_of(self.path(output), "report.csv")

    def images(self, light, name):
        """Pictures by frame and state, as the program renders them, and what they see."""
        self.render(self.session(self.hogel_images(light, name + "{}.png"), name=name + ".json"),
                    name, "--frames", "all", "--masks")
        return {(k, state): (picture_of(self.path(name, f"{state}.frame{k:04}.png")),
            picture_of(self.path(name, f"{state}.frame{k:04}.mask.png")) > 0)
            for k in range(len(light)) for state in "ab"}

    def test_rows_are_those_of_the_stills(self):
        rows = self.report("all")
        self.assertEqual([(row["frame"], row["state"]) for row in rows],
                         [(str(k), state) for k in range(FRAMES) for state in "ab"])
        metrics = rows_of(self.path("all"), "metrics.csv")
        for k in (0, 3):
            still = self.session(self.path(f"r{k}.png"), name="still.json")
            program("--report", "--session", still, "--test", self.path(f"t{k}.png"), "--output",
                    self.path(f"still{k}"), "--quiet")
            for name, found in (("report.csv", rows), ("metrics.csv", metrics)):
                for own, row in zip(rows_of(self.path(f"still{k}"), name), found[2 * k:]):
                    own["test"] = self.test
                    self.assertEqual(own, {key: row[key] for key in own})

    def test_pooled_figures_are_numpys(self):
        rows = self.report("pooled")
        summary = {(row["figure"], row["state"]): float(row["value"])
                   for row in rows_of(self.path("pooled"), "summary.csv")
                   if row["test"] == self.test}
        for state in ("a", "b", ""):
            own = [row for row in rows if state in ("", row["state"])]
            for figure in ("psnr", "psnr_seen", "ssim"):
                values = np.array([float(row[figure]) for row in own])
                with self.subTest(state=state, figure=figure):
                    np.testing.assert_allclose(summary["mean_" + figure, state], values.mean(),
                                               rtol=1e-12)
                    np.testing.assert_allclose(summary["p5_" + figure, state],
                                               np.percentile(values, 5), rtol=1e-12)
                    if state or figure == "ssim":
                        self.assertEqual(summary["worst_" + figure, state], values.min())
        worst = min(rows, key=lambda row: float(row["psnr_seen"]))
        self.assertEqual(summary["worst_psnr_seen", f"{worst['state']}, frame {worst['frame']}"],
                         float(worst["psnr_seen"]))

    def test_flicker_is_numpys(self):
        self.report("flicker")
        references, tests = self.images(self.light, "R"), self.images(self.coded, "T")
        squares = {"a": [], "b": []}
        seen = {"a": [], "b": []}
        for state in "ab":
            for k in range(1, FRAMES):
                change = (tests[k, state][0] - tests[k - 1, state][0] - references[k, state][0]
                          + references[k - 1, state][0])
                mask = tests[k, state][1] & references[k - 1, state][1]
                squares[state].append((change**2).mean())
                seen[state].append((change[mask]**2).mean())
        metrics = rows_of(self.path("flicker"), "metrics.csv")
        for state in "ab":
            own = [row for row in metrics if row["state"] == state]
            self.assertEqual(own[0]["flicker_mse"], "nan")
            np.testing.assert_allclose([float(row["flicker_mse"]) for row in own[1:]],
                                       squares[state], rtol=1e-6)
            np.testing.assert_allclose([float(row["flicker_mse_seen"]) for row in own[1:]],
                                       seen[state], rtol=1e-6)
        summary = {(row["figure"], row["state"]): float(row["value"])
                   for row in rows_of(self.path("flicker"), "summary.csv")
                   if row["test"] == self.test}
        for state in "ab":
            np.testing.assert_allclose(summary["flicker_psnr", state],
                                       psnr(np.mean(squares[state])), rtol=1e-6)
        np.testing.assert_allclose(summary["flicker_psnr", ""],
                                   psnr(np.mean(squares["a"] + squares["b"])), rtol=1e-6)

    def test_a_frozen_error_does_not_flicker(self):
        steady = np.clip(self.light.astype(int), 0, 245)
        light = self.hogel_images(steady.astype(np.uint8), "r{}.png")
        self.hogel_images((steady + 10).astype(np.uint8), "t{}.png")
        self.report("frozen", "--states", "a", session=self.session(light))
        metrics = rows_of(self.path("frozen"), "metrics.csv")
        self.assertLess(max(float(row["flicker_mse"]) for row in metrics[1:]), 1e-3)
        self.assertGreater(min(float(row["psnr_y"]) for row in metrics), 20)

    def files(self, output):
        """The tables of a report, and its pictures; the page has the time."""
        found = {}
        for folder, _, names in os.walk(self.path(output)):
            for name in names:
                if not name.endswith(".html"):
                    file = os.path.join(folder, name)
                    found[os.path.relpath(file, self.path(output))] = read(file)
        return found

    def test_shards_make_the_same_report(self):
        self.report("whole", "--images")
        for k in (2, 3, 1):
            program("--report", "--session", self.reference, "--test", self.test, "--output",
                    self.path("parts"), "--images", "--quiet", "--shard", f"{k}/3")
        self.report("parts", "--images")
        self.assertEqual(self.files("parts"), self.files("whole"))

    def test_goes_on_after_a_kill(self):
        self.report("whole")
        command = [PROGRAM, "--report", "--session", self.reference, "--test", self.test,
                   "--output", self.path("killed"), "--quiet"]
        for wait in np.linspace(0.03, 0.3, 10):
            run = subprocess.Popen(command, stderr=subprocess.DEVNULL)
            time.sleep(wait)
            run.send_signal(signal.SIGKILL)
            run.wait()
        self.report("killed")
        self.assertEqual(self.files("killed"), self.files("whole"))

    def test_several_tests_and_a_part_of_the_frames(self):
        other = self.hogel_images(np.roll(self.coded, 1, axis=3), "o{}.png")
        program("--report", "--session", self.reference, "--test", self.test, "--test", other,
                "--output", self.path("two"), "--quiet", "--frames", "1:5:2")
        rows = rows_of(self.path("two"), "report.csv")
        self.assertEqual([(row["frame"], row["state"], row["test"]) for row in rows],
                         [(k, state, test) for k in "135" for state in "ab"
                          for test in (self.test, other)])
        one = {(row["frame"], row["state"]): row for row in self.report("one")}
        for row in rows[::2]:
            self.assertEqual(row, one[row["frame"], row["state"]])

    def test_states_with_a_time(self):
        document = hs.Session(self.reference)
        document["cameras"][0]["time"] = 0.09
        document.save(self.path("timed.json"))
        rows = self.report("timed", session=self.path("timed.json"))
        self.assertEqual([(row["frame"], row["state"]) for row in rows],
                         [("0", "b"), ("1", "b"), ("2", "a"), ("2", "b"), ("3", "b"), ("4", "b"),
                          ("5", "b")])

    def test_tests_with_other_frames(self):
        os.remove(self.path("t5.png"))
        self.assertIn("frames: are 5, 0 … 4, but those of the session's light field are 6, 0 … 5",
                      refusal("--report", "--session", self.reference, "--test", self.test,
                              "--output", self.path("out")))
        self.report("less", "--frames", "0:4")

    def test_videos_against_files(self):
        """The same figures, whatever holds the frames; rates are of one frame."""
        videos = self.videos(self.coded)
        wanted = self.report("files")
        program("--report", "--session", self.reference, "--test", videos, "--output",
                self.path("videos-report"), "--quiet")
        found = rows_of(self.path("videos-report"), "report.csv")
        for row in wanted + found:
            row["test"] = ""
        self.assertEqual(found, wanted)

    def test_from_python(self):
        report = hs.report(hs.Session(self.reference), {"coded": self.test},
                           output=self.path("python"), frames=range(0, 5, 2),
                           metrics={"number": lambda r, t, seen, info: float(info["frame"])})
        self.assertEqual([(row["frame"], row["number"]) for row in report],
                         [(k, float(k)) for k in (0, 0, 2, 2, 4, 4)])
        self.assertEqual([row["psnr"] for row in report],
                         [float(row["psnr"]) for row in self.report("cli", "--frames", "0:4:2")])
        self.assertRefuses("frames 7: has frame 7, but the light field's are 0:5", hs.report,
                           hs.Session(self.reference), {"coded": self.test},
                           output=self.path("python"), frames=7)


if __name__ == "__main__":
    unittest.main()
