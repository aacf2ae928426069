# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the package share: a folder, small light fields, the program beside it."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest

import numpy as np

import hogelscope as hs

PROGRAM = os.environ["HOGELSCOPE_PROGRAM"]
TABLE1 = "tests/data/table1.json"


def program(*arguments):
    """Runs the program; what it says on stderr. An error is an AssertionError."""
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return done.stderr


def refusal(*arguments):
    """The one line that the program refuses arguments with, without its own name."""
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)
    assert done.returncode == 2, done
    return done.stderr.strip().removeprefix("hogelscope: ")


def read(*names, mode="rb"):
    """What a file has."""
    with open(os.path.join(*names), mode) as file:
        return file.read()


def random_views(dtype=np.uint8, shape=(3, 4, 12, 10, 3)):
    """A light field of noise, in the whole range of its type."""
    random = np.random.default_rng(5)
    if dtype == np.float32:
        return random.random(shape, np.float32)
    return random.integers(0, np.iinfo(dtype).max, shape, dtype, endpoint=True)


def small_session(**changes):
    """A dict of a session of two small states that need no file."""
    states = [
        {"name": "middle", "eye": [0, 0, 0.6], "fov": 50, "res": [60, 40]},
        {"name": "left", "eye": [-0.1, 0.05, 0.5], "fov": 55, "res": [50, 50],
         "distortion": {"k1": 0.1}, "psf": {"sigma": 0.7, "windowSize": 5}},
    ]
    return {"hogelscope": 1, "display": {"size": [0.4, 0.4]}, "cameras": states, **changes}


class FolderTest(unittest.TestCase):
    """Has a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, name, document):
        with open(self.path(name), "w", encoding="utf-8") as file:
            json.dump(document, file)
        return self.path(name)

    def write_views(self, views, name="views", ending="png"):
        """As files row_column of 8-bit or 16-bit pictures, by the package itself."""
        os.mkdir(self.path(name))
        for v, row in enumerate(views):
            for u, picture in enumerate(row):
                seen = np.ones(picture.shape[:2], bool)
                hs.View("", picture, seen).save(self.path(name, f"{v:02}_{u:02}.{ending}"))
        return self.path(name)

    def write_plugins(self, *names):
        """The tests' metrics of these names, in a folder for hs.add_plugin_folder()."""
        build = os.path.dirname(os.path.dirname(PROGRAM))
        with open(os.path.join(build, "plugins-3", "ms-ssim", "plugin.json")) as file:
            document = json.load(file)
        for name in names:
            os.makedirs(self.path("plugins", name))
            library = shutil.copy(os.path.join(build, "tests", "wrong_plugins", name + ".so"),
                                  self.path("plugins", name))
            document.update(name=name, file=name + ".so", bytes=os.path.getsize(library))
            self.write(os.path.join("plugins", name, "plugin.json"), document)
        return self.path("plugins")

    def assertSame(self, first, second):  # noqa: N802: as unittest's own
        np.testing.assert_array_equal(first, second)

    def assertRefuses(self, pattern, call, *arguments, **named):  # noqa: N802
        """An InputError of one line."""
        with self.assertRaisesRegex(hs.InputError, pattern) as caught:
            call(*arguments, **named)
        self.assertNotIn("\n", str(caught.exception))
        return str(caught.exception)
