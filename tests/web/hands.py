#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""hands.py PROGRAM SOURCE [PICTURE]: a page of --export page by mouse, wheel, fingers, keys and sliders.

Exit status 77 without Chromium, its driver or selenium. PICTURE gets what is shown at the end.
"""
import csv
import glob
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

from PIL import Image

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
    from selenium.webdriver.common.by import By
except ImportError:
    print("there is no selenium")
    sys.exit(77)

PROGRAM, SOURCE = (os.path.abspath(argument) for argument in sys.argv[1:3])
CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
if CHROMIUM is None or DRIVER is None:
    print("there is no Chromium with its driver")
    sys.exit(77)


# A headset: two eyes 64 mm apart, a head that the test moves, frames every 20 ms. It keeps the middle
# pixel of the left eye's picture.
HEADSET = """
window.head = { x: 0.3, y: 1.6, z: 0.2 };
window.lit = [];
const near = 0.1, far = 10;
const projection = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0]);
const poseNow = () => ({ transform: { position: { ...head } }, views: [-1, 1].map(side => {
  const position = { x: head.x + side * 0.032, y: head.y, z: head.z };
  const matrix = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -position.x, -position.y, -position.z, 1]);
  return { side, projectionMatrix: projection, transform: { position, inverse: { matrix } } };
}) });
const session = {
  renderState: {}, updateRenderState: async state => { session.renderState = state; }, requestReferenceSpace: async () => ({}),
  requestAnimationFrame: draw => setTimeout(() => {
    draw(performance.now(), { getViewerPose: poseNow });
    const { gl } = session.renderState.baseLayer, pixel = new Uint8Array(4);
    gl.readPixels(75, 75, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    window.lit = [...pixel];
  }, 20),
};
window.XRWebGLLayer = class {
  constructor(of, gl) { this.gl = gl; this.framebuffer = null; }
  getViewport({ side }) { return { x: side < 0 ? 0 : 150, y: 0, width: 150, height: 150 }; }
};
WebGLRenderingContext.prototype.makeXRCompatible = async () => {};
Object.defineProperty(navigator, 'xr', { value: { isSessionSupported: async mode => mode === 'immersive-vr', requestSession: async () => session } });
"""


class Page:
    """A page in a window of this size, once it has its small pictures."""

    def __init__(self, file, size, before="", more=""):
        options = Options()
        for argument in ("--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                         "--disable-dev-shm-usage", f"--window-size={size}"):
            options.add_argument(argument)
        options.binary_location = CHROMIUM
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": before})
        self.open(file, more)

    def open(self, file, more=""):
        self.driver.get(f"file://{os.path.abspath(file)}{more}")
        self.wait(lambda: self.script("document.body.dataset.ready") == "yes")

    def script(self, text):
        return self.driver.execute_script(f"return {text}")

    def text(self, name):
        return self.script(f"document.getElementById('{name}').textContent")

    def wait(self, condition):
        end = time.time() + 120
        while not condition():
            assert time.time() < end, (self.text("error"), self.text("place"), self.text("pixel"))
            time.sleep(0.02)

    def pixels(self):
        """A sum over what the canvas shows."""
        return self.script("[...document.getElementById('view').getContext('2d').getImageData(0, 0, "
                           "document.getElementById('view').width, document.getElementById('view').height)"
                           ".data].reduce((sum, value, k) => (sum * 31 + value) % 1000003, 7)")

    def after(self, action):
        """Does something to the picture, and returns when it has changed."""
        before = self.pixels()
        action()
        self.wait(lambda: self.pixels() != before)


def eye(page):
    return [float(value) for value in page.text("place").split(" m:")[0].removeprefix("Eye at ").split(", ")]


def check(page):
    view = page.driver.find_element(By.ID, "view")
    begin = page.pixels()
    assert eye(page) == [0, 0, 0.559], eye(page)
    page.after(lambda: ActionChains(page.driver).drag_and_drop_by_offset(view, 60, 0).perform())
    assert eye(page)[0] < -0.05, "a drag to the right turns the display to the right"
    page.after(lambda: ActionChains(page.driver).scroll_from_origin(ScrollOrigin.from_element(view), 0, 300).perform())
    assert sum(value * value for value in eye(page)) > 0.65 ** 2, "the wheel moves away"
    view.send_keys("0")
    page.wait(lambda: page.pixels() == begin)
    page.after(lambda: view.send_keys("\ue014"))  # the right arrow
    assert eye(page)[0] > 0.01
    page.after(lambda: view.send_keys("2"))
    assert page.script("document.querySelectorAll('#states button')[1].getAttribute('aria-pressed')") == "true"
    view.send_keys("1")
    page.wait(lambda: page.pixels() == begin)
    # A slider says its value with its unit, also to those who hear it.
    slider = page.driver.find_element(By.ID, "distortion.k1")
    page.after(lambda: slider.send_keys("\ue012"))
    slider = page.driver.find_element(By.ID, "psf.sigma")
    page.after(lambda: slider.send_keys("\ue014"))
    assert slider.get_attribute("aria-valuetext").endswith(" px"), slider.get_attribute("aria-valuetext")
    # Both eyes, and the sampling.
    for name in ("show", "sampling.reconstruction"):
        page.after(lambda: page.script(
            f"(s => {{ s.selectedIndex = 2; s.dispatchEvent(new Event('input')); }})(document.getElementById('{name}'))"))
    page.script("(s => { s.selectedIndex = 0; s.dispatchEvent(new Event('input')); })(document.getElementById('show'))")
    # Why is this pixel black?
    view.send_keys("2")
    page.wait(lambda: page.script("document.querySelectorAll('#states button')[1].getAttribute('aria-pressed')") == "true")
    time.sleep(0.3)
    corner = (4 - view.size["width"] / 2, 4 - view.size["height"] / 2)
    ActionChains(page.driver).move_to_element_with_offset(view, *map(int, corner)).click().perform()
    page.wait(lambda: "black: " in page.text("pixel"))
    ActionChains(page.driver).move_to_element(view).click().perform()
    page.wait(lambda: "seen; hogel " in page.text("pixel"))
    assert page.text("error") == ""
    # Nothing was asked of a network.
    assert page.script("performance.getEntriesByType('resource').filter(e => !/^(data|blob):/.test(e.name)).length") == 0


def check_fingers(page):
    """Two fingers that part come nearer, as a phone has it."""
    box = page.script("(r => [r.left + r.width / 2, r.top + r.height / 2])(document.getElementById('view').getBoundingClientRect())")

    def touch(kind, apart):
        points = [] if kind == "touchEnd" else [
            {"x": box[0] + side * apart, "y": box[1], "id": number} for number, side in enumerate((-1, 1))]
        page.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    before = eye(page)[2]
    touch("touchStart", 30)
    for apart in (40, 50, 60):
        touch("touchMove", apart)
    touch("touchEnd", 0)
    page.wait(lambda: abs(eye(page)[2] - before / 2) < 0.02)


def answer(page, count, key):
    """Looks at both and moves, and answers so many questions."""
    view = page.driver.find_element(By.ID, "view")
    for _ in range(count):
        question = page.text("count")
        view.send_keys(key)  # not before both were seen
        assert page.text("count") == question
        first = page.pixels()
        view.send_keys("2")
        page.wait(lambda: page.pixels() != first)
        page.after(lambda: view.send_keys("\ue014"))
        view.send_keys("1")
        view.send_keys(key)
        page.wait(lambda: page.script("document.getElementById('trial').hidden") or page.text("count") != question)


def check_experiment(page, file):
    """A viewer who stops and goes on; returns the file of votes."""
    begin = "(w => { w.value = 52; document.querySelector('#welcome button').click(); })(document.getElementById('screenWidth'))"
    assert page.script("document.getElementById('viewer').value") == "P 7"
    assert not page.driver.find_element(By.ID, "controls").is_displayed()
    page.script(begin)
    assert page.text("count").startswith("Practice"), page.text("count")
    answer(page, 3, "c")
    assert page.text("count") == "Question 1 of 4", page.text("count")
    answer(page, 2, "b")
    page.open(file, "?id=P%207")
    page.script(begin)
    assert page.text("count") == "Question 3 of 4", page.text("count")
    answer(page, 2, "e")
    page.driver.find_element(By.ID, "votesFile").click()
    saved = lambda: glob.glob(os.path.join(os.environ["HOME"], "**/votes_P_7.json"), recursive=True)
    page.wait(saved)
    return saved()[0]


def check_headset(page):
    page.driver.execute_script("window.eyes = []; const own = ask; ask = (what, request, told) => {"
                               " if (what === 'panel') eyes.push(request.state.eye); return own(what, request, told); };")
    assert page.driver.find_element(By.ID, "vr").is_displayed()
    page.driver.find_element(By.ID, "vr").click()
    page.wait(lambda: page.script("eyes.length") >= 2)
    left, right = page.script("eyes.slice(0, 2)")
    assert all(abs(a - b) < 1e-9 for a, b in zip(left, [-0.032, 0, 0.559])), left
    assert all(abs(a - b) < 1e-9 for a, b in zip(right, [0.032, 0, 0.559])), right
    page.wait(lambda: sum(page.script("lit")[:3]) > 60)  # the panel, not the room around it
    seen = page.script("eyes.length")
    page.driver.execute_script("window.head = { x: 0.35, y: 1.7, z: 0.1 };")
    page.wait(lambda: page.script("eyes.length") >= seen + 4)
    last = page.script("eyes[eyes.length - 1]")
    assert all(abs(a - b) < 1e-9 for a, b in zip(last[1:], [0.1, 0.459])), last


with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
    os.environ["HOME"] = folder
    file = os.path.join(folder, "page.html")
    subprocess.run([PROGRAM, "--export", "page", "--session", os.path.join(SOURCE, "data/table1.json"),
                    "--output", file, "--quiet"], check=True)
    page = Page(file, "1200,900")
    try:
        check(page)
        if len(sys.argv) > 3:
            page.driver.save_screenshot(sys.argv[3])
    finally:
        page.driver.quit()
    page = Page(file, "1200,900", HEADSET)
    try:
        check_headset(page)
    finally:
        page.driver.quit()
    page = Page(file, "500,900")  # the least that Chromium has
    try:
        page.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": 390, "height": 800, "deviceScaleFactor": 2, "mobile": True})
        assert page.script("document.documentElement.scrollWidth") <= 390, "wider than a phone"
        assert page.script("document.getElementById('view').getBoundingClientRect().width") > 300
        check_fingers(page)
    finally:
        page.driver.quit()
    # Compared with a coded one: the PSNR of a report, another picture for each content, the map.
    try:
        Image.open(os.path.join(SOURCE, "data/scene.png")).save(os.path.join(folder, "coded.jpg"), quality=30)
        session = os.path.join(SOURCE, "data/table1.json")
        test = ["--session", session, "--test", os.path.join(folder, "coded.jpg"), "--quiet"]
        subprocess.run([PROGRAM, "--export", "page", *test, "--output", file, "--quality", "exact"], check=True)
        subprocess.run([PROGRAM, "--report", *test, "--output", os.path.join(folder, "report")], check=True)
        with open(os.path.join(folder, "report", "report.csv"), encoding="utf-8") as table:
            wanted = float(next(csv.DictReader(table))["psnr_seen"])
        page = Page(file, "1200,900")
        assert page.text("psnr") == f"coded against table1: PSNR {wanted:.2f} dB", (page.text("psnr"), wanted)
        view = page.driver.find_element(By.ID, "view")
        shown = {page.pixels()}
        page.after(lambda: view.send_keys("2"))
        shown.add(page.pixels())
        for mode in ("wipe", "error"):
            page.after(lambda: page.script(f"(s => {{ s.value = '{mode}'; s.dispatchEvent(new Event('input')); }})(document.getElementById('mode'))"))
            shown.add(page.pixels())
        assert len(shown) == 4, shown
    finally:
        page.driver.quit()
    # An experiment: two tests in two states.
    small = os.path.join(folder, "small.json")
    with open(os.path.join(SOURCE, "tests/data/table1.json"), encoding="utf-8") as document:
        session_of = json.load(document)
    session_of["cameras"] = session_of["cameras"][:2]
    session_of["lightField"]["file"] = os.path.join(SOURCE, "tests/data", session_of["lightField"]["file"])
    with open(small, "w", encoding="utf-8") as document:
        json.dump(session_of, document)
    tests = []
    for quality in (40, 2):
        tests += ["--test", os.path.join(folder, f"coded{quality}.jpg")]
        Image.open(session_of["lightField"]["file"]).convert("RGB").save(tests[-1], quality=quality)
    subprocess.run([PROGRAM, "--export", "page", "--session", small, *tests, "--output", file, "--experiment", "dsis", "--quiet"], check=True)
    page = Page(file, "1200,900", more="?id=P%207")
    try:
        votes = check_experiment(page, file)
    finally:
        page.driver.quit()
    with open(votes, encoding="utf-8") as document:
        trials = json.load(document)["trials"]
    assert [trial["vote"] for trial in trials] == [4, 4, 1, 1], trials
    assert len({(trial["state"], *trial["shown"]) for trial in trials}) == 4
    assert all(trial["shown"][0] == "small" and trial["seconds"] > 0 for trial in trials), trials
    assert all({point[1] for point in trial["path"]} == {0, 1} and trial["path"][-1][2] > 0.005 for trial in trials), trials
    subprocess.run([PROGRAM, "--votes", votes, "--output", os.path.join(folder, "votes"), "--quiet"], check=True)
    with open(os.path.join(folder, "votes/votes.csv"), encoding="utf-8") as table:
        assert sum(float(row["mos"]) for row in csv.DictReader(table) if row["state"] != "all states") == 10
print("all of it is as it should be")
