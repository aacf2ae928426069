# SPDX-License-Identifier: BSD-3-Clause
"""A campaign that is killed and goes on, and one of several shards."""

import os
import shutil
import signal
import subprocess
import unittest

from support import PROGRAM
from test_campaign import CampaignTest, files_in


class Stops(CampaignTest):
    def test_stops_and_shards_make_the_same_files(self):
        self.campaign("whole")
        wanted = files_in(self.path("whole"))
        for number in (2, 1):
            self.campaign("out", "--shard", f"{number}/2")
        self.assertFalse(os.path.exists(self.path("out", "campaign.csv")))
        self.campaign("out")
        self.same(wanted, files_in(self.path("out")))
        shutil.rmtree(self.path("out"))

        stops = 0
        for delay in (0.1, 0.4, 0.9):
            process = subprocess.Popen(
                [PROGRAM, "--report", "--campaign", "campaign.json", "--output", "out", "--quiet"],
                cwd=self.folder, stderr=subprocess.DEVNULL)
            try:
                process.wait(delay)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
                process.wait()
                stops += 1
        self.assertGreater(stops, 1)
        self.campaign("out")
        self.same(wanted, files_in(self.path("out")))

    def same(self, wanted, found):
        """The folders' names stand in the commands of the pages."""
        self.assertEqual(sorted(wanted), sorted(found))
        for name, data in wanted.items():
            self.assertEqual(data.replace(b"whole/", b"out/"), found[name], name)


if __name__ == "__main__":
    unittest.main()
