# SPDX-License-Identifier: BSD-3-Clause
# The code of docs/notebook_pyvista.ipynb; packaging/notebooks.py makes that of this.
# %% [markdown]
# # Views in a 3-D scene, by PyVista
#
# `View.to_vtk()` is a `vtkImageData`, which PyVista wraps without another copy. Debian 12 has VTK (`python3-vtk9`) but no
# PyVista: `pip install --no-deps pyvista` into an environment with Debian's packages
# (`python3 -m venv --system-site-packages`) uses Debian's VTK.

# %%
import numpy as np
import pyvista as pv

import hogelscope as hs

# %%
session = hs.Session({
    "display": {"size": [0.40, 0.30], "hogels": [160, 120], "directions": [9, 9], "fov": [50, 50]},
    "lightField": {"layout": "live", "source": "scene"},
    "cameras": [{"name": f"camera {k + 1}", "eye": [x, 0, 0.8], "fov": 26, "res": [240, 180]}
                for k, x in enumerate((-0.15, 0.0, 0.15))],
})
views = session.render()
image = pv.wrap(views[1].to_vtk())
print(image.dimensions, image.active_scalars_name, image.point_data["image"].dtype)

# %% [markdown]
# The picture as it is: VTK's rows begin at the bottom, so it stands upright.

# %%
plotter = pv.Plotter(off_screen=True, window_size=(480, 360))
plotter.add_mesh(image, scalars="image", rgb=True)
plotter.view_xy()
plotter.show()

# %% [markdown]
# Each picture hangs a tenth of a metre before its camera, as large as what the camera sees there; the panel is the grey
# rectangle. Lengths are metres in the display's frame: +x right, +y up, +z to the viewer. All cameras look at its middle.

# %%
plotter = pv.Plotter(off_screen=True, window_size=(640, 480))
width, height = session["display"]["size"]
plotter.add_mesh(pv.Plane(i_size=width, j_size=height), color="grey")
for view, camera in zip(views, session["cameras"]):
    eye = np.array(camera["eye"])
    forward = -eye / np.linalg.norm(eye)
    down = 2 * 0.1 * np.tan(np.radians(camera["fov"]) / 2)  # fov is from top to bottom
    across = view.image.shape[1] / view.image.shape[0] * down
    right = np.cross(forward, [0, 1, 0])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    corner = eye + 0.1 * forward - right * across / 2 - up * down / 2
    plane = pv.Plane()
    plane.points = np.array([corner + a * right * across + b * up * down
                             for b in np.linspace(0, 1, 11) for a in np.linspace(0, 1, 11)])
    plotter.add_mesh(plane, texture=pv.Texture(view.image))
    plotter.add_mesh(pv.Sphere(0.008, eye), color="black")
plotter.camera_position = [(0.9, 0.5, 1.3), (0, 0, 0.35), (0, 1, 0)]
plotter.show()
