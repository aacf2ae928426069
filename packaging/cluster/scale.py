#!/usr/bin/env python3
"""How long a report takes on N nodes: a table from measured costs, for planning a campaign.

Prints Markdown. A task is one view (a camera state of one test); each node runs one shard of one
core, then one node takes up what all have done. Costs are seconds of one core, measured by the
commands in docs/measurements.md; give your own: scale.py --view 0.5 --read 4
"""
import argparse
import random

options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
options.add_argument("--start", type=float, default=0.4, help="starting the program")
options.add_argument("--read", type=float, default=0.4, help="reading the light fields")
options.add_argument("--view", type=float, default=0.1, help="rendering and comparing one view")
options.add_argument("--row", type=float, default=85e-6, help="taking up one row, and its part of the page")
options.add_argument("--panel", type=float, default=0.01, help="taking up one shard's sums")
options.add_argument("--killed", type=float, default=0.01, help="share of shards that are killed half way")
cost = options.parse_args()


def shard(tasks, rng):
    """The seconds of a shard, and the tasks that it leaves undone."""
    done = tasks if rng.random() >= cost.killed else tasks // 2
    # Views differ: from nothing seen to all of the panel.
    views = sum(rng.lognormvariate(-0.08, 0.4) for _ in range(done)) * cost.view
    return cost.start + cost.read + views, tasks - done


def report(tasks, nodes, rng):
    """The seconds until the report is written, and those of all cores."""
    shards = [shard(tasks // nodes + (k < tasks % nodes), rng) for k in range(min(nodes, tasks))]
    left = sum(undone for _, undone in shards)
    merge = (cost.start + cost.read + left * cost.view + tasks * cost.row + len(shards) * cost.panel)
    return max(seconds for seconds, _ in shards) + merge, sum(s for s, _ in shards) + merge


def text(seconds):
    return f"{seconds:.0f} s" if seconds < 120 else f"{seconds / 60:.0f} min" if seconds < 7200 else f"{seconds / 3600:.1f} h"


print("| views | " + " | ".join(f"{n} node{'s' * (n > 1)}" for n in (1, 10, 100, 1000)) + " |")
print("|---" * 5 + "|")
for exponent in range(2, 6):
    cells = []
    for nodes in (1, 10, 100, 1000):
        rng = random.Random(exponent * nodes)
        runs = sorted(report(10**exponent, nodes, rng) for _ in range(5))
        wall, cores = runs[2]
        useful = 10**exponent * cost.view / cores
        cells.append(f"{text(wall)} ({100 * useful:.0f} %)")
    print(f"| {10**exponent} | " + " | ".join(cells) + " |")
