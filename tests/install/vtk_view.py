# vtk_view.py SESSION STATE PNG: the wrapped VTK module's picture is that of the program, and what is
# wrong is told without an exception.
import sys

import vtkmodules.vtkCommonCore as vtkCommonCore
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from hogelscope_vtk import vtkHogelSessionView


def pixels(image):
    return vtk_to_numpy(image.GetPointData().GetScalars())


session, state, png = sys.argv[1:]
view = vtkHogelSessionView()
assert view.SetSession(session, state), view.GetErrorMessage()
view.Update()
reader = vtkPNGReader()
reader.SetFileName(png)
reader.Update()
shown, expected = view.GetOutput(), reader.GetOutput()
assert shown.GetDimensions() == expected.GetDimensions()
assert pixels(shown).max() > 100
assert (pixels(shown) == pixels(expected)).all()
seen = vtk_to_numpy(shown.GetPointData().GetArray("Seen"))
assert 0 < (seen == 255).mean() <= 1

before = pixels(shown).copy()
view.SetEye(0.1, 0, 0.6)
view.Update()
assert (before != pixels(view.GetOutput())).any()

vtkCommonCore.vtkObject.GlobalWarningDisplayOff()
assert not view.SetSession(session, "nobody")
assert view.GetErrorMessage() == f'{session}: has no camera state "nobody"', view.GetErrorMessage()
print(f"{state}: {len(before)} pixels are equal")
