# SPDX-License-Identifier: BSD-3-Clause
"""Animations of glTF scenes: a frame is the still scene at its time, worked out here by matrices."""

import base64
import csv
import json
import os
import subprocess
import unittest

import numpy as np
from support import PROGRAM, FolderTest, program, read, refusal

import hogelscope as hs

RATE = 7
COMPONENTS = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class Gltf:
    """A document; `json` may be changed before it is written."""

    def __init__(self):
        self.binary = b""
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}],
                     "nodes": [], "meshes": [], "materials": [], "accessors": [],
                     "bufferViews": []}

    def accessor(self, values, kind=5126):
        values = np.asarray(values, {5126: np.float32, 5121: np.uint8, 5123: np.uint16}[kind])
        data = values.tobytes()
        self.json["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)})
        self.binary += data + b"\0" * (-len(data) % 4)
        components = 1 if values.ndim == 1 else values.shape[1]
        self.json["accessors"].append(
            {"bufferView": len(self.json["bufferViews"]) - 1, "componentType": kind,
             "count": len(values), "type": COMPONENTS[components]})
        return len(self.json["accessors"]) - 1

    def mesh(self, points, colour, normals=None, **attributes):
        """Triangles of points in order; returns the number of the mesh."""
        attributes["POSITION"] = self.accessor(points)
        if normals is not None:
            attributes["NORMAL"] = self.accessor(normals)
        self.json["materials"].append({"pbrMetallicRoughness": {"baseColorFactor": [*colour, 1]}})
        self.json["meshes"].append({"primitives": [
            {"attributes": attributes, "material": len(self.json["materials"]) - 1}]})
        return len(self.json["meshes"]) - 1

    def node(self, parent=None, **node):
        self.json["nodes"].append(node)
        number = len(self.json["nodes"]) - 1
        if parent is None:
            self.json["scenes"][0]["nodes"].append(number)
        else:
            self.json["nodes"][parent].setdefault("children", []).append(number)
        return number

    def channel(self, node, path, times, values, interpolation=None, animation=0, name=None):
        animations = self.json.setdefault("animations", [])
        while len(animations) <= animation:
            animations.append({"channels": [], "samplers": []})
        if name:
            animations[animation]["name"] = name
        sampler = {"input": self.accessor(times), "output": self.accessor(values)}
        if interpolation:
            sampler["interpolation"] = interpolation
        animations[animation]["samplers"].append(sampler)
        animations[animation]["channels"].append(
            {"sampler": len(animations[animation]["samplers"]) - 1,
             "target": {"node": node, "path": path}})

    def write(self, file):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.binary).decode()
        self.json["buffers"] = [{"byteLength": len(self.binary), "uri": uri}]
        with open(file, "w", encoding="utf-8") as out:
            json.dump(self.json, out)
        return file


def box(size):
    """The twelve triangles of a box around the origin, and their normals."""
    points, normals = [], []
    for axis in range(3):
        for side in (-1, 1):
            a, b = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]
            middle = side * np.eye(3)[axis]
            square = [middle - a - b, middle + a - b, middle + a + b, middle - a + b]
            points += [square[k] for k in (0, 1, 2, 0, 2, 3)]
            normals += [middle] * 6
    return np.array(points) * np.array(size) / 2, np.array(normals)


def turn(quaternion):
    """The rotation of a quaternion x, y, z, w: the exponential of its axis and angle."""
    *axis, w = np.array(quaternion, float) / np.linalg.norm(quaternion)
    length = np.linalg.norm(axis)
    return about(np.zeros(3) if length == 0 else np.array(axis) / length * 2 * np.arctan2(length, w))


def about(vector):
    """Rodrigues' formula for a rotation vector."""
    angle = np.linalg.norm(vector)
    if angle == 0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def vector_of(rotation):
    """The rotation vector of a matrix, for angles below 180 degrees."""
    axis = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0],
                     rotation[1, 0] - rotation[0, 1]]) / 2
    sine = np.linalg.norm(axis)
    return np.zeros(3) if sine == 0 else axis / sine * np.arctan2(sine, (np.trace(rotation) - 1) / 2)


def frame(translation=(0, 0, 0), rotation=None, scale=(1, 1, 1)):
    """A matrix of 4 x 4 from a rotation of 3 x 3."""
    matrix = np.eye(4)
    matrix[:3, :3] = (np.eye(3) if rotation is None else rotation) * np.array(scale)
    matrix[:3, 3] = translation
    return matrix


def float32(values):
    """As a file of floats has them."""
    return np.float32(values).astype(float)


def key_before(times, t):
    """The number of the key before a time, and the part of the way to the next one."""
    times = float32(times)
    k = min(max(int(np.searchsorted(times, t, side="right")) - 1, 0), len(times) - 1)
    if t <= times[0] or k == len(times) - 1:
        return k, 0.0
    return k, (t - times[k]) / (times[k + 1] - times[k])


def linear(times, values, t):
    k, part = key_before(times, t)
    values = float32(values)
    return values[k] if part == 0 else (1 - part) * values[k] + part * values[k + 1]


def shortest(times, quaternions, t):
    """The rotation that turns evenly from one key to the next."""
    k, part = key_before(times, t)
    first = turn(float32(quaternions)[k])
    if part == 0:
        return first
    return first @ about(part * vector_of(first.T @ turn(float32(quaternions)[k + 1])))


def spline(times, rows, t):
    """De Casteljau's construction of the curve; rows are tangent, value, tangent of each key."""
    k, part = key_before(times, t)
    rows = float32(rows).reshape(len(times), 3, -1)
    if part == 0:
        return rows[k, 1]
    third = (float32(times)[k + 1] - float32(times)[k]) / 3
    points = [rows[k, 1], rows[k, 1] + third * rows[k, 2],
              rows[k + 1, 1] - third * rows[k + 1, 0], rows[k + 1, 1]]
    while len(points) > 1:
        points = [(1 - part) * a + part * b for a, b in zip(points, points[1:])]
    return points[0]


def info(file):
    return subprocess.run([PROGRAM, "--info", file], capture_output=True, text=True,
                          check=True).stdout


class Animations(FolderTest):
    def session(self, file, name="s.json", *, mesh=None, **light):
        """A session of two states, one of which sees through a lens."""
        mesh = {"file": file, "shading": "lambert", "background": [20, 30, 60], **(mesh or {})}
        states = [{"name": "a", "eye": [0, 0, 0.6], "fov": 45, "res": [60, 48]},
                  {"name": "b", "eye": [0.06, 0.02, 0.5], "fov": 60, "res": [50, 50],
                   "distortion": {"k1": 0.1}}]
        return self.write(name, {
            "hogelscope": 1,
            "display": {"size": [0.4, 0.32], "hogels": [40, 32], "directions": [8, 6],
                        "fov": [40, 30]},
            "lightField": {"layout": "live", "source": "mesh", "mesh": mesh, **light},
            "cameras": states})

    def moving(self, file, animation="0", **light):
        return self.session(file, mesh={"animation": animation}, fps=RATE, **light)

    def pictures(self, session, name, *more):
        program("--render", "--session", session, "--output", self.path(name), "--quiet", *more)
        return {file: read(self.path(name, file)) for file in sorted(os.listdir(self.path(name)))}

    def stills(self, session):
        """The pictures of a session's states, made in this process."""
        opened = hs.Session(session)
        pictures = {}
        for state in ("a", "b"):
            opened.render(state).save(self.path("still.png"))
            pictures[state + ".png"] = read(self.path("still.png"))
        return pictures

    def assert_stills(self, moving, still_at, last):
        """Each frame of a document has the bytes of the still document at its time."""
        session = self.moving(moving)
        frames = self.pictures(session, "frames", "--frames", "all")
        self.assertEqual(len(frames), 2 * (last + 1))
        seen = set()
        for k in range(last + 1):
            still = self.session(still_at(k / RATE).write(self.path("still.gltf")), "still.json")
            stills = self.stills(still)
            for state in ("a", "b"):
                picture = frames[f"{state}.frame{k:04}.png"]
                self.assertEqual(picture, stills[f"{state}.png"], f"{state}, frame {k}")
                seen.add(picture)
        self.assertGreater(len(seen), last)  # it moves
        return session, frames


class Nodes(Animations):
    """A tree of boxes and a lamp, moved by all kinds of interpolation."""

    TIMES = [0.1, 0.35, 1.0, 1.6]
    PLACES = [[0, 0, -0.1], [0.08, 0.03, -0.05], [-0.09, 0, 0], [0, 0.02, 0.03]]
    TURNS = [[0, 0, 0, 1], [0, -0.6, 0, -0.8], [0.5, 0.5, 0.5, 0.5], [0.1, 0.7, 0, 0.7]]
    SIZES = [[1, 1, 1], [0.5, 1, 1.5], [1, 2, 1], [0.7, 0.7, 0.7]]
    CURVE = [[0, 0, 0], [0, 0.1, 0.05], [0.2, 0, 0], [-0.1, 0.1, 0], [0.1, -0.05, 0.1], [0, 0, 0.1],
             [0, 0.3, 0], [-0.08, 0, 0.02], [0.2, 0, 0], [0, 0, 0.1], [0, 0.1, 0], [0, 0, 0]]
    TWIST = [[0, 0, 0, 0], [0, 0, 0, 1], [0, 0, 1, 0], [0, 0, 0.4, 0], [0, 0, 0.6, 0.8],
             [0, 0, 1, -0.3], [0, 0, 0, 1], [0.6, 0, 0, 0.8], [1, 0, 0, 0], [0, 0, 0, 0],
             [0, 0.1, 0, 1], [0, 0, 0, 0]]

    def document(self):
        gltf = Gltf()
        gltf.json["extensions"] = {"KHR_lights_punctual": {"lights": [
            {"type": "point", "color": [1, 0.9, 0.8], "intensity": 0.6}]}}
        parent = gltf.node(mesh=gltf.mesh(*self.part([0.1, 0.06, 0.04], [0.9, 0.3, 0.2])))
        gltf.node(parent, mesh=gltf.mesh(*self.part([0.04, 0.08, 0.05], [0.3, 0.9, 0.3])),
                  translation=[0.05, 0.06, 0.02])
        gltf.node(mesh=gltf.mesh(*self.part([0.05, 0.05, 0.05], [0.3, 0.4, 1])))
        gltf.node(translation=[0.1, 0.1, 0.4],
                  extensions={"KHR_lights_punctual": {"light": 0}})
        return gltf

    @staticmethod
    def part(size, colour):
        points, normals = box(size)
        return points, colour, normals

    def animated(self):
        gltf = self.document()
        gltf.channel(0, "translation", self.TIMES, self.PLACES, "LINEAR", name="walk")
        gltf.channel(0, "rotation", self.TIMES, self.TURNS)
        gltf.channel(1, "scale", self.TIMES, self.SIZES, "STEP")
        gltf.channel(2, "translation", self.TIMES, self.CURVE, "CUBICSPLINE")
        gltf.channel(2, "rotation", self.TIMES, self.TWIST, "CUBICSPLINE")
        gltf.channel(3, "translation", [0, 1.6], [[0.1, 0.1, 0.4], [-0.2, 0, 0.3]])
        return gltf

    def still_at(self, t):
        gltf = self.document()
        step = key_before(self.TIMES, t)[0]
        places = [
            frame(linear(self.TIMES, self.PLACES, t), shortest(self.TIMES, self.TURNS, t)),
            frame([0.05, 0.06, 0.02], scale=float32(self.SIZES)[step]),
            frame(spline(self.TIMES, self.CURVE, t), turn(spline(self.TIMES, self.TWIST, t))),
            frame(linear([0, 1.6], [[0.1, 0.1, 0.4], [-0.2, 0, 0.3]], t))]
        for node, place in zip(gltf.json["nodes"], places):
            node.pop("translation", None)
            node["matrix"] = place.T.ravel().tolist()
        return gltf

    def test_frames_are_the_stills_of_their_times(self):
        file = self.animated().write(self.path("moving.gltf"))
        session, frames = self.assert_stills(file, self.still_at, 11)  # 1.6 s at 7 a second

        # A frame does not depend on those before it, nor on how it is asked for.
        for number in (9, 2):
            alone = self.pictures(session, f"alone{number}", "--frames", str(number))
            for name, picture in alone.items():
                self.assertEqual(picture, frames[name])
        at = hs.Session(session)
        view = at.render("a", time=9 / RATE)
        view.save(self.path("python.png"))
        self.assertEqual(read(self.path("python.png")), frames["a.frame0009.png"])

    def test_by_name_and_by_number(self):
        gltf = self.animated()
        gltf.channel(0, "translation", [0, 1], [[0, 0, 0], [0.1, 0, 0]], animation=1, name="2")
        file = gltf.write(self.path("two.gltf"))
        wanted = self.pictures(self.moving(file, "walk"), "name", "--frames", "3")
        for k, animation in enumerate(("0", 0)):
            self.assertEqual(
                self.pictures(self.moving(file, animation), f"number{k}", "--frames", "3"), wanted)
        second = self.pictures(self.moving(file, "2"), "second", "--frames", "all")
        self.assertEqual(len(second), 16)  # a name, though there is no number 2
        rest = self.stills(self.session(file, "rest.json"))
        self.assertEqual(rest, self.stills(
            self.session(self.document().write(self.path("d.gltf")), "d.json")))

    def test_exports_reports_and_stills(self):
        """An export of the frames has the bytes of the live views, frame by frame."""
        file = self.animated().write(self.path("moving.gltf"))
        session = self.moving(file, frames=[1, 9, 4])
        program("--export", "hogels", "--session", session, "--frames", "all", "--output",
                self.path("out", "h.{T}.png"), "--quiet")
        self.assertEqual(sorted(os.listdir(self.path("out"))),
                         ["h.0001.png", "h.0005.png", "h.0009.png"])
        self.assertEqual(len({read(self.path("out", f)) for f in os.listdir(self.path("out"))}), 3)
        program("--report", "--session", session, "--test", self.path("out", "h.{T}.png"),
                "--output", self.path("report"), "--quiet")
        with open(self.path("report", "report.csv"), newline="", encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual([row["frame"] for row in rows], ["1", "1", "5", "5", "9", "9"])
        for row in rows:
            self.assertEqual((row["mse"], row["psnr"]), ("0", "inf"), row)

    def test_it_opens_with_its_first_animation(self):
        file = self.animated().write(self.path("moving.gltf"))
        out = info(file)
        self.assertIn("\n  animation   0\n", out)
        self.assertIn("\nframes      49: 0 … 48; 30 a second, 1.63 s\n", out)
        rest = info(self.document().write(self.path("rest.gltf")))
        self.assertNotIn("frames ", rest)


class Skins(Animations):
    """A strip that follows three joints, one of which has no part of the movement."""

    TIMES = [0, 0.5, 1]
    TURNS = [[0, 0, 0, 1], [0, 0, 0.5, 0.8660254], [0.3, 0, 0.2, 0.9]]

    def document(self, points=None):
        random = np.random.default_rng(7)
        low = np.linspace(-0.12, 0.12, 9)
        strip = []
        for a, b in zip(low, low[1:]):
            for x, y in ((a, -0.02), (b, -0.02), (b, 0.02), (a, -0.02), (b, 0.02), (a, 0.02)):
                strip.append([x, y, 0.01])
        self.rest = np.array(strip)
        self.joints = random.integers(0, 3, (len(strip), 4)).astype(np.uint8)
        weights = random.uniform(0, 1, (len(strip), 4)) * (random.random((len(strip), 4)) > 0.3)
        weights[:, 0] += 0.2
        self.weights = weights / weights.sum(1, keepdims=True)
        gltf = Gltf()
        attributes = {}
        if points is None:
            attributes = {"JOINTS_0": gltf.accessor(self.joints, 5121),
                          "WEIGHTS_0": gltf.accessor(self.weights)}
        shown = self.rest if points is None else points
        normals = np.tile([0.0, 0, 1], (len(strip), 1)) if points is None else None
        mesh = gltf.mesh(shown, [0.9, 0.7, 0.2], normals, **attributes)
        return gltf, mesh

    def skinned(self):
        gltf, mesh = self.document()
        self.binds = [frame([-0.05, 0, 0]), frame([0.03, 0, 0], about(np.array([0, 0, 0.2]))),
                      frame([0.1, 0.01, 0])]
        root = gltf.node(translation=[0.05, 0, 0])
        middle = gltf.node(root, translation=[-0.04, 0, 0])
        tip = gltf.node(middle, translation=[-0.06, 0.01, 0])
        matrices = gltf.accessor([bind.T.ravel() for bind in self.binds])
        gltf.json["skins"] = [{"joints": [root, middle, tip], "inverseBindMatrices": matrices}]
        # The node's own place does not count.
        gltf.node(mesh=mesh, skin=0, translation=[5, 5, 5])
        gltf.channel(middle, "rotation", self.TIMES, self.TURNS)
        return gltf

    def points_at(self, t):
        root = frame([0.05, 0, 0])
        middle = root @ frame([-0.04, 0, 0], shortest(self.TIMES, self.TURNS, t))
        tip = middle @ frame([-0.06, 0.01, 0])
        joints = np.array([node @ float32(bind) for node, bind in zip((root, middle, tip),
                                                                     self.binds)])
        blended = np.einsum("pk,pkij->pij", float32(self.weights), joints[self.joints])
        whole = np.concatenate([float32(self.rest), np.ones((len(self.rest), 1))], 1)
        return np.einsum("pij,pj->pi", blended, whole)[:, :3]

    def still_at(self, t):
        gltf, mesh = self.document(self.points_at(t))
        gltf.node(mesh=mesh)
        return gltf

    def test_points_follow_their_joints(self):
        """Unlit, since the still's normals are those of its faces."""
        gltf = self.skinned()
        file = gltf.write(self.path("skin.gltf"))
        unlit = {"shading": "unlit"}
        moving = self.session(file, mesh={"animation": "0", **unlit}, fps=RATE)
        frames = self.pictures(moving, "frames", "--frames", "all")
        self.assertEqual(len(frames), 16)
        for k in range(8):
            still = self.session(self.still_at(k / RATE).write(self.path("still.gltf")),
                                 "still.json", mesh=unlit)
            for name, picture in self.stills(still).items():
                self.assertEqual(picture, frames[name.replace(".", f".frame{k:04}.", 1)], (k, name))
        self.assertEqual(len(set(frames.values())), 16)
        # At rest it follows its joints, too.
        rest = self.stills(self.session(file, "rest.json", mesh=unlit))
        self.assertEqual(rest["a.png"], frames["a.frame0000.png"])

    def test_refusals(self):
        def line(change):
            gltf = self.skinned()
            change(gltf)
            text = refusal("--render", "--session", self.moving(gltf.write(self.path("x.gltf"))),
                           "--output", self.path("out"))
            self.assertEqual(text.count("\n"), 0)
            return text.split("plugin mesh: " + self.path("x.gltf") + ": ")[-1]

        def skin(**change):
            return lambda gltf: gltf.json["skins"][0].update(change)

        def attribute(name, values, kind=5126):
            def change(gltf):
                attributes = gltf.json["meshes"][0]["primitives"][0]["attributes"]
                attributes[name] = gltf.accessor(values, kind)
            return change

        def animate(**change):
            return lambda gltf: gltf.json["animations"][0]["channels"][0].update(change)

        def sample(**change):
            return lambda gltf: gltf.json["animations"][0]["samplers"][0].update(change)

        def times(values):
            return lambda gltf: sample(input=gltf.accessor(values))(gltf)

        count = 48
        self.assertEqual(line(skin(joints=[])), "skins[0]: has no list of joints")
        self.assertEqual(line(skin(joints=[0, 1, 77])),
                         "skins[0]: has a joint that is no node of the scene")
        self.assertIn("is not a matrix for each joint of skins[0]",
                      line(skin(inverseBindMatrices=0)))
        self.assertIn("names joint 3 of 3",
                      line(attribute("JOINTS_0", np.full((count, 4), 3), 5121)))
        self.assertIn("is below 0 or NaN",
                      line(attribute("WEIGHTS_0", np.full((count, 4), np.nan))))
        self.assertIn("does not fit the points", line(attribute("WEIGHTS_0", np.ones((3, 4)))))
        self.assertIn("without the other", line(attribute("WEIGHTS_1", np.ones((count, 4)))))
        self.assertIn("names a sampler that is not there", line(animate(sampler=9)))
        self.assertIn("moves node 99, which is not there",
                      line(animate(target={"node": 99, "path": "scale"})))
        self.assertIn("does not fit the times as scale",
                      line(animate(target={"node": 1, "path": "scale"})))
        self.assertIn("must be LINEAR, STEP or CUBICSPLINE", line(sample(interpolation="BEZIER")))
        self.assertIn("does not fit the times", line(sample(interpolation="CUBICSPLINE")))
        for wrong in ([0, 0, 1], [0, 2, 1], [-1, 0, 1], [0, np.nan, 1], [0, 1, np.inf]):
            self.assertIn("its times must grow, from 0 or later", line(times(wrong)))

        def matrix(gltf):
            gltf.json["nodes"][1] = {"matrix": np.eye(4).ravel().tolist(),
                                     **{k: v for k, v in gltf.json["nodes"][1].items()
                                        if k != "translation"}}
        self.assertIn("moves nodes[1], which has a matrix", line(matrix))

    def test_lines_for_wrong_names(self):
        file = self.skinned().write(self.path("x.gltf"))

        def line(animation, mesh=file, **light):
            return refusal("--render", "--session", self.moving(mesh, animation, **light),
                           "--output", self.path("out")).split("plugin mesh: " + mesh)[-1]
        self.assertEqual(line("run"), ": has no animation run: it has 0")
        self.assertEqual(line("1"), ": has no animation 1: it has 0")
        with open(self.path("a.obj"), "w", encoding="utf-8") as out:
            out.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assertEqual(line("0", self.path("a.obj")),
                         ": has no animation 0: leave mesh.animation empty")
        self.assertIn("lists frame 8, but there are frames 0 … 7", line("0", frames=[0, 8]))
        self.assertIn("there is one frame", line("", frames=[0, 8]))


if __name__ == "__main__":
    unittest.main()
