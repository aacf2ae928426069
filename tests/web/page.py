#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""page.py PROGRAM SOURCE: pages of --export page show in a browser what --render writes, to the byte.

Chromium loads each page with #check, which prints a hash of the content and of each picture with its
mask. Exit status 77 without Chromium.
"""
import base64
import html
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

from PIL import Image

PROGRAM, SOURCE = (os.path.abspath(argument) for argument in sys.argv[1:3])
CHROMIUM = shutil.which("chromium")


def run(*arguments, status=0):
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)
    assert done.returncode == status, (arguments, done.returncode, done.stderr)
    return done.stdout + done.stderr


def fnv(values):
    result = 2166136261
    for value in values:
        result = (result ^ value) * 16777619 & 0xFFFFFFFF
    return f"{result:08x}"


def shown_by(page):
    done = subprocess.run(
        [CHROMIUM, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
         f"--user-data-dir={os.path.abspath('browser')}", "--virtual-time-budget=120000", "--dump-dom",
         f"file://{os.path.abspath(page)}#check"], capture_output=True, text=True, check=False)
    found = re.findall(r'<pre id="check">(.*?)</pre>', done.stdout, re.S)
    assert found, (page, done.stderr[-2000:])
    return html.unescape(found[-1])


def hash_of(picture):
    rgb = Image.open(picture).convert("RGB").tobytes()
    mask = Image.open(picture[:-4] + ".mask.png").convert("L").tobytes()
    joined = bytearray(4 * len(mask))
    for channel in range(3):
        joined[channel::4] = rgb[channel::3]
    joined[3::4] = mask
    return fnv(joined)


def check_pictures(session, arguments=()):
    """The page's hashes are those of the pictures and of the content that --export hogels writes."""
    run("--export", "page", "--session", session, "--output", "page.html", "--quality", "exact", *arguments)
    run("--export", "hogels", "--session", session, "--output", "hogels_now.png", *arguments)
    shutil.rmtree("pictures", ignore_errors=True)
    run("--render", "--session", session, "--output", "pictures", "--masks", "--quiet", *arguments)
    texels = Image.open("hogels_now.png").convert("RGB").tobytes()
    wanted = {"texels": fnv(texels)} if len(texels) < 2_000_000 else {}
    for name in os.listdir("pictures"):
        if name.endswith(".png") and not name.endswith(".mask.png"):
            wanted[name[:-4]] = hash_of(os.path.join("pictures", name))
    found = dict(line.rsplit(" ", 1) for line in shown_by("page.html").splitlines())
    for name, value in wanted.items():
        assert found.get(name) == value, (session, name, found.get(name), value)
    return len(wanted)


def random_session(chance, sampling):
    """A session of noise with all that a state can have."""
    hogels, directions = [14, 12], [7, 6]
    picture = Image.frombytes("RGB", (hogels[0] * directions[0], hogels[1] * directions[1]),
                              chance.randbytes(3 * hogels[0] * directions[0] * hogels[1] * directions[1]))
    picture.save("noise.png")
    cameras = []
    for k in range(12):
        camera = {"name": f"state {k}", "eye": [chance.uniform(-0.2, 0.2), chance.uniform(-0.2, 0.2), chance.uniform(0.3, 0.8)],
                  "lookat": [chance.uniform(-0.05, 0.05), 0, 0], "fov": chance.uniform(20, 70),
                  "res": [chance.randint(20, 60), chance.randint(20, 60)]}
        if k % 3 == 1:
            camera["distortion"] = {"k1": chance.uniform(-0.3, 0.3), "k2": chance.uniform(-0.1, 0.1), "p1": chance.uniform(-0.02, 0.02)}
        if k == 2:
            camera["distortion"] = {"model": "fisheye", "k1": 0.02, "k2": -0.01}
        if k % 2:
            camera["psf"] = {"sigma": chance.uniform(0.3, 1.5), "windowSize": chance.choice([1, 3, 5]),
                             "border": chance.choice(["renormalise", "clamp", "black"]), "light": chance.choice(["encoded", "linear"])}
        if k == 4:
            camera["stereo"] = {"ipd": 0.063}
        if k in (5, 6):
            camera["pupil"] = {"diameter": 0.01, "focus": chance.uniform(0.2, 0.9)}
        if k == 7:
            del camera["fov"]
            camera["intrinsics"] = {"fx": 50, "fy": 52, "cx": 20, "cy": 18}
        cameras.append(camera)
    cameras[8]["name"] = '<script>alert("x")</script>'.replace("/", "_")
    cameras[9]["name"] = "שלום & 'ciao'"
    return {"hogelscope": 1,
            "display": {"size": [0.3, 0.25], "hogels": hogels, "directions": directions, "fov": [50, 40],
                        "lens": chance.choice(["rectilinear", "equiangular"]),
                        "position": [0.01, -0.02, 0.03], "orientation": [3, -5, 2]},
            "lightField": {"file": "noise.png", **({"viewingDistance": 0.5} if chance.random() < 0.5 else {})},
            "sampling": sampling, "cameras": cameras}


def write(name, document):
    with open(name, "w", encoding="utf-8") as file:
        json.dump(document, file)


def check_damage():
    """A page that is cut, or of which one byte of the content is another one, says so."""
    with open("page.html", encoding="utf-8") as file:
        page = file.read()
    begin = page.index('class="views"')
    begin = page.index(">", begin) + 1
    end = page.index("<", begin)
    picture = bytearray(base64.b64decode(page[begin:end]))
    at = picture.index(b"IDAT") + 4 + 60
    picture[at] ^= 1
    with open("damaged.html", "w", encoding="utf-8") as file:
        file.write(page[:begin] + base64.b64encode(picture).decode() + page[end:])
    assert "damaged" in shown_by("damaged.html")
    # A letter that is none of base64's, in the pictures and in the engine; a session that is no JSON,
    # and one in which a number is another one.
    engine = page.index(">", page.index('id="engine"')) + 2000
    session = page.index('id="session"')
    session = page.index("{", session) + 2
    number = page.index('"eye": [', session) + 8
    for at, letter in ((begin + 500, "!"), (engine, "!"), (engine, "A" if page[engine] != "A" else "B"), (session, "{"), (number, "7")):
        with open("damaged.html", "w", encoding="utf-8") as file:
            file.write(page[:at] + letter + page[at + 1:])
        assert "damaged" in shown_by("damaged.html"), (at, letter)
    for length in (begin + 100, len(page) - 3000, len(page) - 30):
        with open("cut.html", "w", encoding="utf-8") as file:
            file.write(page[:length])
        assert "damaged" in shown_by("cut.html"), length


def check_refusals():
    run("--export", "page", "--session", "session.json", "--output", "a.html", "--quality", "best", status=2)
    run("--export", "hogels", "--session", "session.json", "--output", "a.png", "--quality", "small", status=2)
    sheet = os.path.join(SOURCE, "data/displays/looking_glass_portrait_sheet.json")
    run("--export", "page", "--session", "session.json", "--output", "a.html", "--experiment", "dsis", status=2)
    with open("session.json", encoding="utf-8") as file:
        shutil.copy(json.load(file)["lightField"]["file"], "session.png")
    assert "are called session" in run("--export", "page", "--session", "session.json", "--output", "a.html", "--experiment", "dsis",
                                       "--test", "session.png", status=2)
    assert "a page" in run("--export", "page", "--session", sheet, "--output", "a.html", status=2)
    with open("session.json", encoding="utf-8") as file:
        document = json.load(file)
    document["twin"] = {"lensArray": {"rotation": 1}}
    write("built.json", document)
    assert "twin" in run("--export", "page", "--session", "built.json", "--output", "a.html", status=2)
    assert not os.path.exists("a.html")


def main():
    table = os.path.join(SOURCE, "data/table1.json")
    checked = check_pictures(table)
    with open("page.html", encoding="utf-8") as file:
        page = file.read()
    assert not re.search(r"https?://", re.sub(r">[A-Za-z0-9+/=\s]{200,}<", "><", page)), "an address"
    assert os.path.dirname(SOURCE) not in page and "scene.png" not in page
    chance = random.Random(7)
    for sampling in ({}, {"mapping": "direct", "samplesPerPixel": 2}, {"reconstruction": "bilinear"}, {"reconstruction": "quadrilinear"}):
        write("session.json", random_session(chance, sampling))
        checked += check_pictures("session.json")
    check_damage()
    check_refusals()
    # A live scene's texels are carried; compressed content is said to be so.
    room = os.path.join(SOURCE, "data/room.json")
    small = ["--set", "display.hogels=[40,40]", "--set", "display.directions=[10,10]", "--set", "camera.res=[80,80]"]
    run("--export", "hogels", "--session", room, "--output", "room.png", *small)
    checked += check_pictures(room, small)
    said = run("--export", "page", "--session", room, "--output", "small.html", "--quality", "small", *small)
    assert "compressed" in said and shown_by("small.html").startswith("small")
    said = run("--export", "page", "--session", room, "--output", "real.html", "--set", "lightField.type=real", *small)
    assert "8 bits" in said
    # Two contents: the second one's texels, and the first one's pictures.
    noise = Image.frombytes("RGB", (14 * 7, 12 * 6), chance.randbytes(3 * 14 * 7 * 12 * 6))
    noise.save("other.png")
    run("--export", "page", "--session", "session.json", "--test", "other.png", "--output", "two.html", "--quality", "exact")
    assert f"texels {fnv(noise.tobytes())}" in shown_by("two.html").splitlines()
    noise.crop((0, 0, 7, 6)).save("less.png")
    assert "less.png" in run("--export", "page", "--session", "session.json", "--test", "less.png", "--output", "a.html", status=2)
    print(f"{checked} hashes are alike")


if CHROMIUM is None:
    print("there is no Chromium")
    sys.exit(77)
with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
    os.chdir(folder)
    main()
