# SPDX-License-Identifier: BSD-3-Clause
# The code of docs/notebook.ipynb; packaging/notebooks.py makes that of this.
# %% [markdown]
# # Two codecs, seen on a light field display
#
# A codec for light fields is usually judged by the PSNR of its views. A viewer never sees those views: the display mixes
# them, pixel by pixel, by where the eye is. Here JPEG and WebP code the same views, 20 cameras look at the display, and the
# bits that one codec saves are counted in both ways.

# %%
import io

import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

import hogelscope as hs

# %% [markdown]
# ## A light field
#
# The display: 160 × 120 hogels on 0.40 × 0.30 m, each with 9 × 9 directions over 50°. Its content is the program's own scene,
# a card, a ball and a wall at known depths, traced into 9 rows of 9 views. With views of your own:
# `views = np.stack([np.stack([np.asarray(Image.open(…)) for u in range(9)]) for v in range(9)])`.

# %%
session = hs.Session({
    "display": {"size": [0.40, 0.30], "hogels": [160, 120], "directions": [9, 9], "fov": [50, 50]},
    "lightField": {"layout": "live", "source": "scene"},
    "cameras": [{"name": "camera", "eye": [0, 0, 0.8], "fov": 26, "res": [240, 180],
                 "psf": {"sigma": 0.5, "windowSize": 3}}],
})
views = session.light_field().array()
print("views (dv, du, ny, nx, 3):", views.shape, views.dtype)

# %% [markdown]
# ## Two codecs
#
# Every view is coded by itself. The rate is in bits per directional pixel, that is, per pixel of a view.

# %%
def coded(codec, quality):
    """The views after the codec, and their bits per directional pixel."""
    decoded = np.empty_like(views)
    size = 0
    for v, u in np.ndindex(views.shape[:2]):
        file = io.BytesIO()
        Image.fromarray(views[v, u]).save(file, codec, quality=quality)
        size += file.tell()
        decoded[v, u] = np.asarray(Image.open(file).convert("RGB"))
    return decoded, 8 * size / views[..., 0].size


tests, rates = {}, {"JPEG": {}, "WebP": {}}
for codec in rates:
    for quality in (10, 30, 55, 80):
        name = f"{codec} {quality}"
        tests[name], rates[codec][name] = coded(codec, quality)
for codec, points in rates.items():
    print(codec, {name: round(rate, 3) for name, rate in points.items()})

# %% [markdown]
# ## Twenty cameras
#
# They stand at random in a box before the panel, and look at its middle.

# %%
cameras = hs.cameras(session, "random", count=20, seed=1, region={
    "region": "box", "centre": [0, 0, 0.8], "extent": [0.2, 0.15, 0.2]})
reference = session.render(cameras, views)
seen = {name: session.render(cameras, test) for name, test in tests.items()}


def perceived(name):
    """Mean PSNR over what the cameras see of the display, in dB."""
    return np.mean([hs.compare(a, b)["psnr_seen"] for a, b in zip(reference, seen[name])])


def of_views(name):
    """Mean PSNR of the views themselves, in dB."""
    errors = np.mean((views.astype(float) - tests[name]) ** 2, axis=(2, 3, 4))
    return np.mean(10 * np.log10(255**2 / errors))


curves = {
    (codec, how): [(rate, measure(name)) for name, rate in points.items()]
    for codec, points in rates.items()
    for how, measure in (("views", of_views), ("perceived", perceived))
}
for how in ("views", "perceived"):
    delta = hs.bd_rate(curves["JPEG", how], curves["WebP", how])
    print(f"{how}: WebP needs {delta['rate']:+.1f} % bits at equal PSNR (BD-rate)")

# %% [markdown]
# ## What it looks like

# %%
figure, axes = plt.subplots(1, 3, figsize=(9.5, 3), dpi=80, layout="constrained")
axes[0].imshow(reference[0].image)
axes[0].set_title("a camera's picture", fontsize=9)
difference = np.abs(reference[0].image.astype(int) - seen["JPEG 10"][0].image).max(axis=2)
shown = axes[1].imshow(difference, cmap="magma", vmax=60)
axes[1].set_title("its error, JPEG 10", fontsize=9)
figure.colorbar(shown, ax=axes[1], label="code values", shrink=0.7)
for axis in axes[:2]:
    axis.set_axis_off()
for (codec, how), points in curves.items():
    axes[2].plot(*zip(*points), "o-" if how == "perceived" else "s--", markersize=3, linewidth=1,
                 color="tab:blue" if codec == "JPEG" else "tab:orange", label=f"{codec}, {how}")
axes[2].set_xlabel("bits per directional pixel")
axes[2].set_ylabel("mean PSNR / dB")
axes[2].legend(fontsize=7)
axes[2].grid(alpha=0.3)
plt.show()

# %% [markdown]
# The same as a report, with its page, tables and pictures of where on the panel the error comes from:
#
# ```python
# rows = hs.report(session, tests, light_field=views, cameras=cameras, groups=rates, output="codecs")
# pandas.DataFrame(rows).groupby("test")["psnr_seen"].mean()
# ```
