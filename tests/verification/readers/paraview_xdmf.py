# What ParaView's readers of XDMF find in a file, for each reader (the default one, which is Xdmf2's, and
# Xdmf3's): a line "reader states first-time last-time", then for the first and the last state a line of the
# blocks' names, for the last state a line "block points cells", its box, and the sums of its arrays.
# Status 77: there is no ParaView for Python here.
import sys

try:
    from paraview import servermanager, simple
except ImportError:
    sys.exit(77)


def blocks(reader, time):
    """Leaves with their names; Xdmf3's temporal reader has no names for them."""
    reader.UpdatePipeline(time)
    data = servermanager.Fetch(reader)
    found = []
    for k in range(data.GetNumberOfBlocks()):
        about = data.GetMetaData(k)
        found.append(((about.Get(data.NAME()) if about else None) or "-", data.GetBlock(k)))
    return found


for name, reader in (("Xdmf2", simple.XDMFReader(FileNames=[sys.argv[1]])), ("Xdmf3", simple.Xdmf3ReaderT(FileName=[sys.argv[1]]))):
    if name == "Xdmf2":
        reader.PointArrayStatus = reader.PointArrayStatus.Available
        reader.CellArrayStatus = reader.CellArrayStatus.Available
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues)
    print(name, len(times), times[0], times[-1])
    print(*(block for block, _ in blocks(reader, times[0])))
    last = blocks(reader, times[-1])
    print(*(block for block, _ in last))
    for block, grid in last:
        print(block, grid.GetNumberOfPoints(), grid.GetNumberOfCells())
        print(*grid.GetBounds())
        for data, wanted in ((grid.GetCellData(), ("pressure", "stress")), (grid.GetPointData(), ("velocity", "mass"))):
            for array in wanted:
                values = data.GetArray(array)
                if values:
                    print(array, sum(values.GetComponent(i, 0) for i in range(values.GetNumberOfTuples())))
