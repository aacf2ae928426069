# ten_lines.py SESSION: the lines on Python in README.md, with the installed package.
import sys
import tempfile

import numpy as np

import hogelscope as hs

s = hs.Session(sys.argv[1])
whole = s.render("Fig 4")
s["display"]["fov"] = [50, 50]
views = np.random.default_rng(1).integers(0, 256, (20, 20, 128, 128, 3), np.uint8)
lf = hs.LightField(views)
v = s.render("Fig 4", light_field=lf)
assert v.image.shape == whole.image.shape and (v.image != whole.image).any()
figures = hs.compare(v, s.render("Fig 4"))
assert 0 < figures["psnr_seen"] < 30, figures
cams = hs.cameras(s, "random", count=2, seed=3)
rows = hs.report(s, {"lf": lf}, cameras=cams, output=tempfile.mkdtemp())
print(len(rows), "rows of a report; PSNR", round(figures["psnr_seen"], 2))
