# SPDX-License-Identifier: BSD-3-Clause
"""What README.md shows runs in a copy of what is in the repository, and leaves that as it is."""

import contextlib
import hashlib
import io
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import hogelscope as hs
import numpy as np

TEXT = Path("README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"(?:^    .*\n|^\n(?=    ))+", TEXT, re.MULTILINE)
COMMANDS = [line.strip() for line in re.findall(r"^    hogelscope .*", TEXT, re.MULTILINE)]


def hashes(folder):
    return {str(file): hashlib.sha256(file.read_bytes()).hexdigest()
            for file in sorted(Path(folder).rglob("*")) if file.is_file()}


class Readme(unittest.TestCase):
    def setUp(self):
        self.source = os.getcwd()
        self.folder = tempfile.TemporaryDirectory()
        shutil.copytree("data", self.folder.name + "/data")
        os.chdir(self.folder.name)

    def tearDown(self):
        os.chdir(self.source)
        self.folder.cleanup()

    def test_commands(self):
        program = os.environ["HOGELSCOPE_PROGRAM"]
        environment = {**os.environ, "PATH": os.path.dirname(program) + ":" + os.environ["PATH"]}
        before = hashes("data")
        run = 0
        for command in COMMANDS:
            # The window needs a display server; a comment says which jobs are slow.
            if " --" not in command or "minute" in command.partition(" #")[2]:
                continue
            done = subprocess.run(["bash", "-c", command], env=environment, capture_output=True,
                                  text=True, check=False)
            self.assertEqual(done.returncode, 0, command + "\n" + done.stderr)
            run += 1
        self.assertGreater(run, 12)
        self.assertEqual(hashes("data"), before, "a command writes over a tracked file")
        settings = {"layout": "hogels", "display": {"hogels": [128, 128], "directions": [20, 20]}}
        made = hs.open("scene.png", **settings).array()
        self.assertTrue(np.array_equal(made, hs.open("data/scene.png", **settings).array()))
        states = hs.Session("50.json")["cameras"]
        self.assertGreater(len(states), 50)
        for state in states:
            self.assertFalse(any(state.get("distortion", {}).values()), state["name"])

    def test_python(self):
        code = next(block for block in BLOCKS if "import hogelscope" in block)
        names = {}
        with contextlib.redirect_stdout(io.StringIO()):
            exec("\n".join(line[4:] for line in code.splitlines()), names)  # pylint: disable=exec-used
        self.assertEqual(len(names["rows"]), 20)
        self.assertGreater(min(row["psnr_seen"] for row in names["rows"]), 20)


if __name__ == "__main__":
    unittest.main()
