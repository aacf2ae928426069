# SPDX-License-Identifier: BSD-3-Clause
"""Long work: other threads run, Ctrl-C stops it, nothing is half-written, a report goes on."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np
from support import TABLE1, FolderTest, small_session

import hogelscope as hs


def slow_session():
    """A view of it takes many seconds."""
    s = hs.Session(TABLE1)
    s["sampling"]["samplesPerPixel"] = 8
    s["cameras"][3]["res"] = [4000, 4000]
    return s


class Enough(Exception):
    pass


def interrupt_soon(started):
    """As Ctrl-C, once the work has begun."""
    def wait():
        started.wait()
        os.kill(os.getpid(), signal.SIGINT)
    threading.Thread(target=wait).start()


class Stopping(FolderTest):
    def test_threads_run(self):
        """A thread ticks while a view is rendered, until it has ticked enough; progress goes on meanwhile."""
        ticks = 0
        told = []
        enough = threading.Event()

        def tick():
            nonlocal ticks
            while ticks < 200:
                ticks += 1
                time.sleep(0.001)
            enough.set()

        def stop(done):
            told.append(done)
            if enough.is_set():
                raise Enough

        thread = threading.Thread(target=tick)
        thread.start()
        with self.assertRaises(Enough):
            slow_session().render("Fig 4", progress=stop)
        thread.join()
        self.assertEqual(ticks, 200)
        self.assertLess(told[-1], 1)

    def test_interrupt(self):
        """Also without a listener that Python code could stop in."""
        s = slow_session()
        started = threading.Event()
        interrupt_soon(started)
        s["sampling"]["samplesPerPixel"] = 16
        begin = time.process_time()
        with self.assertRaises(KeyboardInterrupt):
            started.set()
            s.render("Fig 4")
        self.assertLess(time.process_time() - begin, 10)  # the whole view takes some fifty
        s["sampling"]["samplesPerPixel"] = 1
        s.render("Fig 5")  # and it is usable as before

    def test_another_thread_may_render(self):
        """Signals are the main thread's, work is anybody's."""
        found = []
        s = hs.Session(TABLE1)

        def work():
            found.append(s.render("Fig 4").image)

        threads = [threading.Thread(target=work) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(found), 3)
        self.assertSame(found[0], found[1])
        self.assertSame(found[0], found[2])

    def test_waiting_for_a_session_stops(self):
        """One session renders one view at a time; who waits for it hears Ctrl-C."""
        s = slow_session()
        release = threading.Event()
        begun = threading.Event()

        def tell(_):
            begun.set()
            if release.is_set():
                raise Enough

        def work():
            with self.assertRaises(Enough):
                s.render("Fig 4", progress=tell)

        thread = threading.Thread(target=work)
        thread.start()
        begun.wait()
        try:
            with self.assertRaises(KeyboardInterrupt):
                interrupt_soon(begun)
                s.render("Fig 5")
        finally:
            release.set()
        thread.join()

    def test_progress_errors_are_raised(self):
        with self.assertRaises(ZeroDivisionError):
            hs.Session(TABLE1).render(0, progress=lambda done: 1 / 0)
        with self.assertRaises(TypeError):
            hs.Session(TABLE1).render(0, progress=5)

    def test_report_goes_on(self):
        s = hs.Session(small_session())
        cams = hs.cameras(s, "random", count=40)
        for state in cams:
            state["res"] = [200, 200]
        views = np.random.default_rng(1).integers(0, 256, (4, 4, 40, 40, 3), np.uint8)
        asked = {"tests": {"a": views // 8 * 8}, "light_field": views, "cameras": cams}
        whole = hs.report(s, output=self.path("whole"), **asked)
        out = self.path("out")

        def stop_half(done):
            if done > 0.5:
                os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            hs.report(s, output=out, progress=stop_half, **asked)
        left = set(os.listdir(out))
        self.assertIn("report.journal", left)
        self.assertFalse({"report.csv", "report.html"} & left)
        with open(os.path.join(out, "report.journal"), encoding="utf-8") as file:
            done = len(file.read().splitlines())
        self.assertGreater(done, 2)
        self.assertEqual(hs.report(s, output=out, **asked), whole)
        for name in ("report.csv", "metrics.csv", "summary.csv"):
            with open(self.path("whole", name), "rb") as a, open(self.path("out", name), "rb") as b:
                self.assertEqual(a.read(), b.read())
        self.assertFalse([name for name in os.listdir(out) if "journal" in name or "panel1" in name])

    def test_script_ends_at_interrupt(self):
        """As a user sees it: a traceback that ends in KeyboardInterrupt."""
        script = ("import hogelscope as hs; s = hs.Session('tests/data/table1.json');"
                  "s['sampling']['samplesPerPixel'] = 8; s['cameras'][3]['res'] = [4000, 4000];"
                  "print('begun', flush=True); s.render('Fig 4')")
        with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True) as child:
            self.assertEqual(child.stdout.readline(), "begun\n")
            time.sleep(0.3)
            child.send_signal(signal.SIGINT)
            _, said = child.communicate(timeout=60)
        self.assertEqual(child.returncode, -signal.SIGINT)
        self.assertTrue(said.endswith("KeyboardInterrupt\n"), said)

    def test_daemon_threads_end_with_python(self):
        script = ("import threading, time; import hogelscope as hs; s = hs.Session('tests/data/table1.json');"
                  "s['sampling']['samplesPerPixel'] = 8; s['cameras'][3]['res'] = [4000, 4000];"
                  "begun = threading.Event();"
                  "work = lambda: s.render('Fig 4', progress=lambda done: begun.set());"
                  "threading.Thread(target=work, daemon=True).start(); begun.wait()")
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True,
                              check=False, timeout=100)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def small_report(self, metric):
        """A report of two states whose only metric is this one, and its light field."""
        s = hs.Session(small_session())
        views = np.random.default_rng(1).integers(0, 256, (4, 4, 9, 9, 3), np.uint8)
        lf = hs.LightField(views)
        return hs.report(s, {"a": lf}, light_field=lf, output=self.path("out"),
                         metrics={"m": lambda *asked: metric(s, lf, *asked)})

    def test_metrics_may_render(self):
        """Also the light field that the report reads, and in another report."""
        def same(s, lf, reference, test, seen, info):
            self.assertIs(threading.current_thread(), threading.main_thread())
            image = s.render(info["state"], lf).image
            inner = hs.report(s, {"b": lf}, light_field=lf, output=self.path("inner"),
                              metrics={"n": lambda *_: lf.array().max()})
            return {"error": np.abs(image / 255 - reference).max(), "inner": inner[0]["n"]}

        for row in self.small_report(same):
            self.assertLess(row["m_error"], 1e-6)
            self.assertGreater(row["m_inner"], 200)

    def test_interrupt_in_a_metric(self):
        """Ctrl-C ends a metric that waits, and is itself raised; so is an exit."""
        def sleeps(*_):
            interrupted = threading.Event()
            interrupt_soon(interrupted)
            interrupted.set()
            while True:  # a signal just before one long sleep would be heard after it
                time.sleep(0.01)

        def leaves(*_):
            sys.exit(3)

        with self.assertRaises(KeyboardInterrupt):
            self.small_report(sleeps)
        with self.assertRaises(SystemExit):
            self.small_report(leaves)

    def test_interrupts_that_a_metric_keeps(self):
        """The second Ctrl-C leaves, in a view that the metric asked for."""
        kept = []

        def keeps_one(*_):
            started = threading.Event()
            interrupt_soon(started)
            started.set()
            try:
                slow_session().render("Fig 4")
            except KeyboardInterrupt:
                if kept:
                    raise
                kept.append(1)
            return 1

        with self.assertRaises(KeyboardInterrupt):
            self.small_report(keeps_one)
        self.assertEqual(len(kept), 1)

    def test_another_interrupt_leaves_deaf_work(self):
        """A plugin that hears nothing for long does not keep its process."""
        script = ("import sys, numpy as np, hogelscope as hs; hs.add_plugin_folder(sys.argv[1]);"
                  "black = np.zeros((20, 20, 3), np.uint8); print('begun', flush=True);"
                  "hs.compare(black, black, metrics='deaf')")
        with subprocess.Popen([sys.executable, "-c", script, self.write_plugins("deaf")],
                              stdout=subprocess.PIPE, text=True) as child:
            self.assertEqual(child.stdout.readline(), "begun\n")
            while child.poll() is None:
                time.sleep(0.5)
                child.send_signal(signal.SIGINT)
        self.assertEqual(child.returncode, -signal.SIGINT)

    def test_daemon_threads_in_python_end_with_it(self):
        """In a metric, and in progress; also in a view that these asked for."""
        script = """
import sys, tempfile, threading, time
import numpy as np, hogelscope as hs
s = hs.Session("tests/data/table1.json")
slow = s.copy()
slow["sampling"]["samplesPerPixel"] = 8
slow["cameras"][3]["res"] = [4000, 4000]
lf = hs.LightField(np.zeros((3, 3, 9, 9, 3), np.uint8))
begun = threading.Event()
def wait(*_):
    begun.set()
    time.sleep(1000)
def wait_soon(*_):
    begun.set()
    for _ in range(100000):
        time.sleep(0.01)
def render(*_):
    slow.render("Fig 4", progress=lambda done: begun.set())
metric = {"wait": wait, "wait_soon": wait_soon, "render": render}.get(sys.argv[1])
with tempfile.TemporaryDirectory() as out:
    bare = hs.Session({"cameras": [{"name": "a", "eye": [0, 0, 1], "res": [20, 20]}]})
    def work():
        try:
            if metric:
                hs.report(bare, {"a": lf}, light_field=lf, output=out, metrics={"m": metric})
            else:
                slow.render("Fig 4", progress=wait)
        finally:
            begun.set()
    threading.Thread(target=work, daemon=True).start()
    begun.wait()
"""
        for how in ("wait", "wait_soon", "render", "progress"):
            done = subprocess.run([sys.executable, "-c", script, how], capture_output=True,
                                  text=True, check=False, timeout=100)
            self.assertEqual((done.returncode, done.stderr), (0, ""), how)

    def test_fork(self):
        """Children of a process that has rendered render, too (multiprocessing)."""
        import multiprocessing

        views = np.full((3, 3, 9, 9, 3), 5, np.uint8)
        hs.Session(small_session()).render("left", views)
        with multiprocessing.get_context("fork").Pool(2) as pool:
            self.assertEqual(pool.map_async(brightest, [7, 8, 9]).get(100), [7, 8, 9])


def brightest(value):
    views = np.full((3, 3, 9, 9, 3), value, np.uint8)
    return hs.Session(small_session()).render("left", views).image.max()


if __name__ == "__main__":
    unittest.main()
