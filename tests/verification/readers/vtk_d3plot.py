# What VTK's reader of LS-DYNA's databases finds in a folder, in its last state: a line
# "states nodes shells time", a line of the box, a line of sums over the shells: stress xx and the
# one extra value, then a line "name: cells" for each part. Status 77: there is no VTK here.
import sys

try:
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
    from vtkmodules.vtkIOLSDyna import vtkLSDynaReader
except ImportError:
    sys.exit(77)

reader = vtkLSDynaReader()
reader.SetDatabaseDirectory(sys.argv[1])
reader.UpdateInformation()
states = reader.GetNumberOfTimeSteps()
reader.SetTimeStep(states - 1)
reader.Update()
low, high, stress, extra = [1e30] * 3, [-1e30] * 3, 0.0, 0.0
parts = []
each = reader.GetOutputDataObject(0).NewIterator()
while not each.IsDoneWithTraversal():
    part = each.GetCurrentDataObject()
    box = part.GetBounds()
    low = [min(a, b) for a, b in zip(low, box[0::2])]
    high = [max(a, b) for a, b in zip(high, box[1::2])]
    of_cells = part.GetCellData()
    parts.append(f"{each.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME())}: {part.GetNumberOfCells()}")
    for cell in range(part.GetNumberOfCells()):
        stress += of_cells.GetArray("Stress").GetComponent(cell, 0)
        extra += of_cells.GetArray("IntPtData").GetComponent(cell, 0)
    each.GoToNextItem()
print(states, reader.GetNumberOfNodes(), reader.GetNumberOfShellCells(), reader.GetTimeValue(states - 1))
print(*low, *high)
print(stress, extra)
print(*parts, sep="\n")
