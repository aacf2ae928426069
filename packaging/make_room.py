#!/usr/bin/env python3
"""Makes data/room.glb, the sample scene: a room behind and in front of a panel of 0.5 m x 0.5 m.

Run as: python3 packaging/make_room.py data/room.glb. The same bytes come out each time; metres,
x to the right, y up, z from the panel to the viewer.
"""
import json
import math
import struct
import sys
import zlib

FONT = {  # 5 x 7 dots, a row each, from the top
    "H": "10001 10001 10001 11111 10001 10001 10001", "O": "01110 10001 10001 10001 10001 10001 01110",
    "G": "01110 10001 10000 10111 10001 10001 01111", "E": "11111 10000 10000 11110 10000 10000 11111",
    "L": "10000 10000 10000 10000 10000 10000 11111", "S": "01111 10000 10000 01110 00001 00001 11110",
    "C": "01110 10001 10000 10000 10000 10001 01110", "P": "11110 10001 10001 11110 10000 10000 10000",
    "I": "111 010 010 010 010 010 111", "T": "11111 00100 00100 00100 00100 00100 00100",
    "F": "11111 10000 10000 11110 10000 10000 10000", "D": "11110 10001 10001 10001 10001 10001 11110",
}


def add(a, b, s=1.0):
    return tuple(x + s * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    n = math.sqrt(sum(x * x for x in a))
    return tuple(x / n for x in a)


def mix(a, b, t):
    return tuple(x + t * (y - x) for x, y in zip(a, b))


class Part:
    """Points with one kind of attribute each, and triangles."""

    def __init__(self, smooth=False, textured=False):
        self.smooth, self.textured = smooth, textured
        self.points, self.normals, self.colours, self.uv, self.corners = [], [], [], [], []

    def point(self, p, colour=(1, 1, 1), normal=None, uv=None):
        self.points.append(p)
        self.colours.append(colour)
        self.normals.append(normal)
        self.uv.append(uv)
        return len(self.points) - 1

    def quad(self, a, b, c, d):
        self.corners += [a, b, c, a, c, d]

    def box(self, centre, size, colour, top=None):
        n = [self.point(tuple(centre[k] + size[k] * ((i >> k & 1) - 0.5) for k in range(3)),
                        (top or colour) if i & 2 else colour) for i in range(8)]
        for a, b, c, d in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            self.quad(n[a], n[b], n[c], n[d])

    def panel(self, corner, right, up, colour, upper=None):
        """A flat piece; with uv 0 ... 1 in a textured part."""
        ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
        n = [self.point(add(add(corner, right, s), up, t), mix(colour, upper or colour, t), None, (s, 1 - t))
             for s, t in ring]
        self.quad(*n)

    def grid(self, rows, columns, place, closed=True):
        """place(i / rows, j / columns) gives point, normal, colour; columns close to a ring."""
        width = columns if closed else columns + 1
        first = len(self.points)
        for i in range(rows + 1):
            for j in range(width):
                point, normal, colour = place(i / rows, j / columns)
                self.point(point, colour, unit(normal))
        for i in range(rows):
            for j in range(columns):
                a, b = first + i * width + j, first + i * width + (j + 1) % width
                self.quad(a, b, b + width, a + width)

    def ball(self, centre, radius, low, high, rows=14, columns=24, stretch=(1, 1, 1)):
        def place(s, t):
            n = (math.sin(math.pi * s) * math.cos(2 * math.pi * t), math.cos(math.pi * s),
                 math.sin(math.pi * s) * math.sin(2 * math.pi * t))
            point = tuple(c + radius * k * x for c, k, x in zip(centre, stretch, n))
            return point, tuple(x / k for x, k in zip(n, stretch)), mix(high, low, s)
        self.grid(rows, columns, place)

    def tube(self, path, radius, colour, sides=6, end=None):
        """A round bar along a list of points; the radius may be a list too."""
        radii = radius if isinstance(radius, list) else [radius] * len(path)

        def place(s, t):
            k = round(s * (len(path) - 1))
            way = unit(add(path[min(k + 1, len(path) - 1)], path[max(k - 1, 0)], -1))
            side = unit(cross(way, (0.3, 0.2, 1) if abs(way[2]) < 0.9 else (0, 1, 0)))
            other = cross(way, side)
            n = add(tuple(math.cos(2 * math.pi * t) * x for x in side), other, math.sin(2 * math.pi * t))
            return add(path[k], n, radii[k]), n, mix(colour, end or colour, s)
        self.grid(len(path) - 1, sides, place)


def letters(part, text, left, bottom, z, dot, depth, colours):
    x = left
    for k, letter in enumerate(text):
        rows = FONT[letter].split()
        colour = colours(k / (len(text) - 1))
        for j, row in enumerate(rows):
            start = 0  # runs of dots are one bar
            while start < len(row):
                end = start
                while end < len(row) and row[end] == "1":
                    end += 1
                if end > start:
                    part.box((x + dot * (start + end) / 2, bottom + dot * (6.5 - j), z),
                             (dot * (end - start), dot, depth), colour)
                start = end + 1
        x += dot * (len(rows[0]) + 1)


def png(width, height, rgb):
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in rgb(x, y)) for y in range(height))
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def noise(x, y):
    n = (x * 374761393 + y * 668265263) & 0xFFFFFFFF
    n = ((n ^ (n >> 13)) * 1274126177) & 0xFFFFFFFF
    return (n >> 16 & 0xFF) / 255


def wood(x, y):
    """Planks of 16 texels along y, with a grain."""
    plank = x // 16
    shade = 0.8 + 0.3 * noise(plank, (y + 37 * plank) // 64 % 2) + 0.12 * (noise(x, y // 16 % 8) - 0.5)
    if x % 16 == 0 or (y + 37 * plank) % 64 == 0:
        shade *= 0.55
    return tuple(min(255, 4 * int(c * shade / 4)) for c in (168, 112, 66))


def poster(x, y):
    """A sun over hills, and two words."""
    for text, left, top in (("LIGHT", 34, 66), ("FIELD", 38, 82)):
        at = left
        for letter in text:
            rows = FONT[letter].split()
            i, j = (x - at) // 2, (y - top) // 2
            if 0 <= j < 7 and 0 <= i < len(rows[0]) and x >= at and rows[j][i] == "1":
                return (250, 244, 226)
            at += 2 * (len(rows[0]) + 1)
    if y > 52 + 5 * math.sin(x / 11) + 3 * math.sin(x / 5 + 1):
        return (33, 52, 86)
    if y > 42 + 8 * math.sin(x / 17 + 2):
        return (60, 92, 130)
    if (x - 88) ** 2 + (y - 30) ** 2 < 200:
        return (255, 214, 102)
    band = 6 * (y // 6)
    return (min(255, 232 + band // 3), 120 + 2 * band, 96 + 2 * band)


def make_room():
    flat = Part()
    flat.panel((-0.36, -0.27, -0.3), (0.72, 0, 0), (0, 0.57, 0), (0.36, 0.46, 0.55), (0.58, 0.68, 0.74))
    flat.panel((-0.36, -0.27, 0), (0, 0, -0.3), (0, 0.57, 0), (0.50, 0.24, 0.17), (0.72, 0.44, 0.32))
    flat.panel((0.36, -0.27, -0.3), (0, 0, 0.3), (0, 0.57, 0), (0.28, 0.38, 0.26), (0.48, 0.60, 0.42))
    flat.panel((-0.36, 0.3, -0.3), (0.72, 0, 0), (0, 0, 0.3), (0.8, 0.8, 0.76))
    for centre, size in (((0, -0.255, -0.296), (0.72, 0.03, 0.008)), ((-0.356, -0.255, -0.15), (0.008, 0.03, 0.292)),
                         ((0.356, -0.255, -0.15), (0.008, 0.03, 0.292))):
        flat.box(centre, size, (0.85, 0.83, 0.78))
    for dx, dy, sx, sy in ((0, 0.087, 0.236, 0.012), (0, -0.087, 0.236, 0.012), (0.112, 0, 0.012, 0.162),
                           (-0.112, 0, 0.012, 0.162)):  # the poster's frame
        flat.box((-0.09 + dx, 0.12 + dy, -0.293), (sx, sy, 0.014), (0.10, 0.07, 0.05))
    letters(flat, "HOGELSCOPE", -0.2055, -0.205, 0.045, 0.007, 0.007,
            lambda t: (0.90, 0.16 + 0.55 * t, 0.06 + 0.05 * t) if t < 0.5 else mix((0.9, 0.43, 0.08), (0.98, 0.75, 0.15), 2 * t - 1))
    flat.box((0.0, -0.214, 0.04), (0.44, 0.016, 0.04), (0.10, 0.07, 0.06), (0.17, 0.12, 0.10))
    flat.box((0.19, -0.105, -0.19), (0.21, 0.012, 0.13), (0.50, 0.31, 0.17), (0.66, 0.43, 0.25))  # the table
    for title, (x, height, colour) in enumerate(((0.118, 0.05, (0.60, 0.12, 0.12)), (0.131, 0.056, (0.13, 0.30, 0.52)),
                                                  (0.145, 0.047, (0.80, 0.62, 0.16)), (0.157, 0.053, (0.18, 0.42, 0.26)))):
        flat.box((x, -0.099 + height / 2, -0.2 + 0.002 * title), (0.011, height, 0.036), colour)

    smooth = Part(smooth=True)
    for x in (0.095, 0.285):
        for z in (-0.245, -0.135):
            smooth.tube([(x, -0.27, z), (x, -0.11, z)], 0.005, (0.42, 0.26, 0.15))
    # A vase with a plant.
    profile = [(0, 0.012), (0.12, 0.021), (0.35, 0.027), (0.6, 0.022), (0.8, 0.012), (1, 0.016)]

    def vase(s, t):
        k = round(s * (len(profile) - 1))
        height, radius = profile[k]
        n = (math.cos(2 * math.pi * t), 0, math.sin(2 * math.pi * t))
        return add((0.225, -0.099 + 0.062 * height, -0.185), n, radius), n, mix((0.10, 0.30, 0.42), (0.55, 0.80, 0.82), s)
    smooth.grid(len(profile) - 1, 20, vase)
    for k in range(13):
        angle, lean = 2.4 * k, 0.45 + 0.25 * (k % 4)
        out = (math.cos(angle), 0, math.sin(angle))
        length = 0.085 + 0.02 * (k % 3)
        stem = [add((0.225, -0.04 + length * t, -0.185), out, 0.5 * length * lean * t * t) for t in (0, 0.35, 0.7, 1)]
        smooth.tube(stem, 0.0012, (0.14, 0.28, 0.08), 4)
        side = unit(cross(out, (0, 1, 0)))

        def leaf(s, t, base=stem[-1], out=out, side=side):
            width = 0.011 * math.sin(math.pi * min(1, s * 0.96 + 0.02))
            p = add(add(base, out, 0.042 * s), (0, 1, 0), 0.014 * math.sin(2.6 * s) - 0.012 * s * s)
            return add(p, side, width * (2 * t - 1)), (0.4 * out[0], 1, 0.4 * out[2]), mix((0.10, 0.36, 0.10), (0.52, 0.74, 0.20), s * 0.8 + 0.2 * t)
        smooth.grid(5, 2, leaf, closed=False)
    smooth.ball((0.262, -0.077, -0.14), 0.022, (0.55, 0.05, 0.07), (0.95, 0.35, 0.22))  # an apple-red ball
    # A birdcage in front of the panel, hanging from above.
    centre, radius = (0.118, 0.075, 0.055), 0.052
    wire = (0.86, 0.70, 0.32)
    for k in range(12):
        angle = math.pi * k / 6
        out = (math.cos(angle), 0, math.sin(angle))
        smooth.tube([add(add(centre, (0, y, 0)), out, r) for y, r in
                     ((-0.055, radius), (0.02, radius), (0.042, 0.044), (0.058, 0.028), (0.066, 0.002))], 0.0013, wire, 4)
    for y in (-0.055, -0.018, 0.02):
        ring = [add(add(centre, (0, y, 0)), (math.cos(math.pi * k / 12), 0, math.sin(math.pi * k / 12)), radius) for k in range(25)]
        smooth.tube(ring, 0.0018, wire, 4)
    smooth.tube([add(centre, (0, 0.064, 0)), add(centre, (0, 0.25, 0))], 0.001, wire, 4)
    smooth.ball(add(centre, (0, -0.055, 0)), radius, (0.30, 0.20, 0.10), (0.50, 0.36, 0.2), 6, 20, (1, 0.06, 1))
    smooth.tube([add(centre, (-radius, -0.02, 0)), add(centre, (radius, -0.02, 0))], 0.0022, (0.45, 0.3, 0.15), 5)
    smooth.ball(add(centre, (0, 0.001, 0)), 0.017, (0.95, 0.55, 0.05), (1.0, 0.86, 0.15), 10, 16, (0.85, 1.15, 1.1))
    smooth.ball(add(centre, (-0.006, 0.024, 0.006)), 0.0105, (1.0, 0.80, 0.10), (1.0, 0.88, 0.25), 8, 12)
    smooth.tube([add(centre, (-0.014, 0.024, 0.011)), add(centre, (-0.023, 0.022, 0.016))], [0.004, 0.0003], (0.85, 0.3, 0.05), 6)
    smooth.ball(add(centre, (-0.0105, 0.027, 0.0145)), 0.0018, (0.02, 0.02, 0.02), (0.02, 0.02, 0.02), 5, 8)
    smooth.tube([add(centre, (0.008, -0.012, -0.004)), add(centre, (0.030, -0.036, -0.012))], [0.008, 0.003], (0.80, 0.45, 0.05), 6)

    rug = Part(smooth=True)
    rings = [(0.62, 0.12, 0.12), (0.62, 0.12, 0.12), (0.88, 0.80, 0.62), (0.88, 0.80, 0.62), (0.14, 0.20, 0.36), (0.14, 0.20, 0.36)]
    edges = [0.0, 0.4, 0.4001, 0.7, 0.7001, 1.0]

    def carpet(s, t):
        k = round(s * 5)
        return ((0.02 + 0.17 * edges[k] * math.cos(2 * math.pi * t), -0.268, -0.13 + 0.095 * edges[k] * math.sin(2 * math.pi * t)),
                (0, 1, 0), rings[k])
    rug.grid(5, 40, carpet)

    chair = Part(smooth=True)
    brown, pale = (0.36, 0.20, 0.10), (0.62, 0.40, 0.22)
    for x in (-0.042, 0.042):
        chair.tube([(x, 0, 0.042), (0.9 * x, 0.085, 0.038)], [0.0032, 0.0045], brown)
        chair.tube([(x, 0, -0.046), (0.9 * x, 0.085, -0.038), (0.9 * x, 0.13, -0.041), (0.95 * x, 0.19, -0.052)], 0.0042, brown, 6, pale)
    for y, z in ((0.035, 0.04), (0.045, -0.042)):
        chair.tube([(-0.04, y, z), (0.04, y, z)], 0.0024, pale)
    for k in range(5):
        x = -0.026 + 0.013 * k
        chair.tube([(x, 0.093, -0.039), (x, 0.178, -0.05)], 0.0018, pale, 5)
    chair.tube([(-0.04, 0.182, -0.051), (0, 0.19, -0.055), (0.04, 0.182, -0.051)], 0.0052, brown)
    chair.ball((0, 0.09, 0), 0.048, brown, pale, 6, 20, (1, 0.1, 1))

    floor = Part(textured=True)
    floor.panel((-0.36, -0.27, 0.0), (0.72, 0, 0), (0, 0, -0.3), (1, 1, 1))
    picture = Part(textured=True)
    picture.panel((-0.196, 0.039, -0.295), (0.212, 0, 0), (0, 0.162, 0), (1, 1, 1))
    return {"walls, letters, books": (flat, 0), "plant, cage, table": (smooth, 0), "rug": (rug, 0), "chair": (chair, 0),
            "floor": (floor, 1), "poster": (picture, 2)}


def write_glb(path, parts):
    binary, views, accessors, meshes, nodes = b"", [], [], [], []

    def view(data):
        nonlocal binary
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
        binary += data + b"\0" * (-len(data) % 4)
        return len(views) - 1

    def accessor(data, component, kind, count, **more):
        accessors.append({"bufferView": view(data), "componentType": component, "type": kind, "count": count, **more})
        return len(accessors) - 1

    def floats(rows):
        return struct.pack("<%df" % sum(map(len, rows)), *(x for row in rows for x in row))

    for name, (part, material) in parts.items():
        count = len(part.points)
        rounded = [tuple(round(x, 5) for x in p) for p in part.points]
        attributes = {"POSITION": accessor(floats(rounded), 5126, "VEC3", count,
                                           min=[min(p[k] for p in rounded) for k in range(3)],
                                           max=[max(p[k] for p in rounded) for k in range(3)])}
        if part.smooth:
            attributes["NORMAL"] = accessor(floats([tuple(round(x, 4) for x in n) for n in part.normals]), 5126, "VEC3", count)
        if part.textured:
            attributes["TEXCOORD_0"] = accessor(floats(part.uv), 5126, "VEC2", count)
        else:
            codes = bytes(round(255 * min(1, max(0, c))) for rgb in part.colours for c in (*rgb, 1))
            attributes["COLOR_0"] = accessor(codes, 5121, "VEC4", count, normalized=True)
        corners = accessor(struct.pack("<%dH" % len(part.corners), *part.corners), 5123, "SCALAR", len(part.corners))
        meshes.append({"name": name, "primitives": [{"attributes": attributes, "indices": corners, "material": material}]})
        nodes.append({"name": name, "mesh": len(meshes) - 1})
    turn = math.radians(38) / 2
    for node in nodes:
        if node["name"] == "chair":
            node.update(translation=[-0.16, -0.27, -0.15], rotation=[0, round(math.sin(turn), 6), 0, round(math.cos(turn), 6)],
                        scale=[1.15, 1.15, 1.15])
    nodes.append({"name": "light", "translation": [-0.10, 0.24, 0.22], "extensions": {"KHR_lights_punctual": {"light": 0}}})
    images = [{"name": name, "mimeType": "image/png", "bufferView": view(png(*size, picture))}
              for name, size, picture in (("wood", (128, 128), wood), ("poster", (128, 104), poster))]

    def material(name, **more):
        return {"name": name, "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 1, **more}, "doubleSided": True}
    document = {
        "asset": {"version": "2.0", "generator": "hogelscope packaging/make_room.py"},
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"name": "light", "type": "point", "color": [1, 0.95, 0.86], "intensity": 0.85}]}},
        "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes,
        "materials": [material("painted"), material("wood", baseColorTexture={"index": 0}), material("poster", baseColorTexture={"index": 1})],
        "textures": [{"source": 0, "sampler": 0}, {"source": 1, "sampler": 0}],
        "samplers": [{"wrapS": 33071, "wrapT": 33071}], "images": images,
        "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(binary)}],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)


if __name__ == "__main__":
    write_glb(sys.argv[1], make_room())
