#!/usr/bin/env python3
# Copyright (c) 2026 The Global ODT Mesh authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares optimizers on files of Medit: Gmsh's own, Netgen's, and the command optimize_mesh of the examples.

  compare_on_files.py OPTIMIZE_MESH DIRECTORY [FILE.mesh ...]

Prints a table in Markdown. If no files are named, it makes some in the directory: a ball and a CAD part by Gmsh, three of
Netgen's examples, and the inside of CGAL's elephant by TetGen, as far as these programs are there. The environment variable
CGAL_DATA_DIR says where CGAL's data is. On Debian, the modules are in python3-gmsh and python3-netgen, and Netgen's examples in
netgen-doc; what is not there is left out. Times are those of the optimization alone, without reading and writing.
"""
import math
import os
import shutil
import subprocess
import sys
import time

try:
    import gmsh
except ImportError:
    gmsh = None
try:
    import netgen.meshing as netgen
    from netgen.csg import CSGeometry
except ImportError:
    netgen = None

NETGEN_EXAMPLES = "/usr/share/doc/netgen/examples/"

BALL = """SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 1};
Mesh.CharacteristicLengthMax = 0.15;
"""

PART = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 2, 1, 0.3};
Cylinder(2) = {0.5, 0.5, -0.1, 0, 0, 0.6, 0.2};
Cylinder(3) = {1.5, 0.5, -0.1, 0, 0, 0.6, 0.1};
Sphere(4) = {1, 0.5, 0.3, 0.25};
BooleanUnion(5) = { Volume{1}; Delete; }{ Volume{4}; Delete; };
BooleanDifference(6) = { Volume{5}; Delete; }{ Volume{2, 3}; Delete; };
Mesh.CharacteristicLengthMax = 0.07;
Mesh.CharacteristicLengthFromCurvature = 1;
Mesh.MinimumElementsPerTwoPi = 16;
"""


class Mesh:
    """The points and tetrahedra of a file. A tetrahedron is a tuple of four numbers, from 0 on, and a reference."""

    def __init__(self, points, cells):
        self.points = points
        self.cells = [c if self.determinant(c) > 0 else ((c[1], c[0]) + c[2:]) for c in cells]

    @staticmethod
    def read(name):
        with open(name, encoding="ascii") as text:
            words = [w for line in text for w in line.split("#")[0].split()]
        points, cells, place = [], [], 0
        while place < len(words):
            width = {"Vertices": 4, "Tetrahedra": 5}.get(words[place])
            place += 1
            if width is None:
                continue
            number = int(words[place])
            rows = [words[place + 1 + width * n:place + 1 + width * (n + 1)] for n in range(number)]
            place += 1 + width * number
            if width == 4:
                points = [tuple(map(float, r[:3])) for r in rows]
            else:
                cells = [tuple(int(x) - 1 for x in r[:4]) + (int(r[4]),) for r in rows]
        return Mesh(points, cells)

    def write(self, name):
        with open(name, "w", encoding="ascii") as out:
            out.write("MeshVersionFormatted 2\nDimension 3\nVertices\n%d\n" % len(self.points))
            out.writelines("%.17g %.17g %.17g 0\n" % p for p in self.points)
            out.write("Tetrahedra\n%d\n" % len(self.cells))
            out.writelines("%d %d %d %d %d\n" % (c[0] + 1, c[1] + 1, c[2] + 1, c[3] + 1, c[4]) for c in self.cells)
            out.write("End\n")

    def determinant(self, cell):
        p, q, r, s = (self.points[v] for v in cell[:4])
        return dot(cross(minus(q, p), minus(r, p)), minus(s, p))

    def facets(self, cell):
        """Counterclockwise as seen from outside."""
        a, b, c, d = cell[:4]
        return (a, c, b), (a, b, d), (b, c, d), (a, d, c)

    def measures(self):
        """The number of cells, the smallest angle, the number of cells below 20 degrees, the mean of 3r/R, and the volume."""
        smallest, below, ratios, volume = 180.0, 0, 0.0, 0.0
        for cell in self.cells:
            points = [self.points[v] for v in cell[:4]]
            numbers = dict(zip(cell[:4], range(4)))
            normals = [cross(minus(points[numbers[f[1]]], points[numbers[f[0]]]),
                             minus(points[numbers[f[2]]], points[numbers[f[0]]])) for f in self.facets(cell)]
            lengths = [math.sqrt(dot(n, n)) for n in normals]
            angle = min(math.degrees(math.acos(max(-1.0, min(1.0, -dot(normals[i], normals[j]) / (lengths[i] * lengths[j])))))
                        for i in range(4) for j in range(i))
            smallest = min(smallest, angle)
            below += angle < 20
            # The inradius is three times the volume over the area, and the circumradius that of a triangle of products of edges.
            six_volumes = self.determinant(cell)
            volume += six_volumes / 6
            edge = lambda i, j: math.dist(points[i], points[j])
            a, b, c = edge(0, 1) * edge(2, 3), edge(0, 2) * edge(1, 3), edge(0, 3) * edge(1, 2)
            product = max(0.0, (a + b + c) * (a + b - c) * (a - b + c) * (-a + b + c))
            inradius, circumradius = six_volumes / sum(lengths), math.sqrt(product) / (4 * six_volumes)
            ratios += 3 * inradius / circumradius
        return len(self.cells), smallest, below, ratios / len(self.cells), volume


def minus(p, q):
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def cross(p, q):
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def optimize_by_gmsh(name, out):
    gmsh.open(name)
    begin = time.process_time()
    gmsh.model.mesh.optimize("", force=True)
    seconds = time.process_time() - begin
    gmsh.option.setNumber("Mesh.SaveAll", 1)
    gmsh.write(out)
    gmsh.clear()
    return seconds


def netgen_mesh(mesh):
    """Netgen's, with the boundary and the interfaces, which it keeps, as surface elements."""
    result = netgen.Mesh()
    result.dim = 3
    numbers = [result.Add(netgen.MeshPoint(netgen.Pnt(*p))) for p in mesh.points]
    # References become numbers from 1 on, as 0 is outside.
    domains = {reference: n + 1 for n, reference in enumerate(sorted({c[4] for c in mesh.cells}))}
    sides = {}
    for cell in mesh.cells:
        for facet in mesh.facets(cell):
            sides.setdefault(tuple(sorted(facet)), []).append((facet, domains[cell[4]]))
    descriptors = {}
    for side in sides.values():
        inside, outside = side[0][1], side[1][1] if len(side) == 2 else 0
        if inside == outside:
            continue
        if (inside, outside) not in descriptors:
            number = len(descriptors) + 1
            descriptors[inside, outside] = result.Add(
                netgen.FaceDescriptor(surfnr=number, domin=inside, domout=outside, bc=number))
        result.Add(netgen.Element2D(descriptors[inside, outside], [numbers[v] for v in side[0][0]]))
    for a, b, c, d, reference in mesh.cells:
        result.Add(netgen.Element3D(domains[reference], [numbers[v] for v in (a, b, d, c)]))
    return result


def write_netgen(mesh, name):
    Mesh([tuple(p.p) for p in mesh.Points()],
         [tuple(v.nr - 1 for v in e.vertices) + (max(1, e.index),) for e in mesh.Elements3D()]).write(name)


def optimize_by_netgen(name, out):
    mesh = netgen_mesh(Mesh.read(name))
    begin = time.process_time()
    mesh.OptimizeVolumeMesh()
    seconds = time.process_time() - begin
    write_netgen(mesh, out)
    return seconds


def optimize_by_command(command, name, out, *options):
    done = subprocess.run([command, name, out, "--ignore-edges", *options], capture_output=True, text=True, check=False)
    if done.returncode > 1:
        raise RuntimeError(done.stderr)
    return float(done.stdout.split()[-2])       # "...; 1.23 seconds"


def make_files(directory):
    files = []
    if gmsh:
        for name, geometry in ("ball", BALL), ("part", PART):
            script, mesh = (os.path.join(directory, "gmsh_" + name + suffix) for suffix in (".geo", ".mesh"))
            with open(script, "w", encoding="ascii") as out:
                out.write(geometry)
            gmsh.open(script)
            gmsh.model.mesh.generate(3)
            gmsh.write(mesh)
            gmsh.clear()
            files.append(mesh)
    if netgen and os.path.isdir(NETGEN_EXAMPLES):
        for name, size in ("cone", .2), ("cubemcyl", 8), ("cylsphere", .12):
            mesh = os.path.join(directory, "netgen_" + name + ".mesh")
            write_netgen(CSGeometry(NETGEN_EXAMPLES + name + ".geo").GenerateMesh(maxh=size), mesh)
            files.append(mesh)
    if shutil.which("tetgen") and "CGAL_DATA_DIR" in os.environ:
        surface = os.path.join(directory, "elephant.off")
        shutil.copy(os.path.join(os.environ["CGAL_DATA_DIR"], "meshes", "elephant.off"), surface)
        subprocess.run(["tetgen", "-pq1.3/10Yg", surface], stdout=subprocess.DEVNULL, check=True)
        mesh = os.path.join(directory, "tetgen_elephant.mesh")
        # Without the triangles inside, all of which TetGen writes.
        Mesh.read(os.path.join(directory, "elephant.1.mesh")).write(mesh)
        files.append(mesh)
    return files


def marked(rows, n, column, digits, best):
    """A number in bold if it is the best of those that are compared, as they are printed, and not all are equal."""
    printed = ["%.*f" % (digits, r[1][column]) for r in rows]
    compared = [float(x) for x in printed[1:]]
    is_best = n > 0 and float(printed[n]) == best(compared) and min(compared) < max(compared)
    return "**" + printed[n] + "**" if is_best else printed[n]


def print_rows(title, rows):
    for n, (tool, measures, seconds) in enumerate(rows):
        change = round(100 * (measures[4] / rows[0][1][4] - 1), 2) + 0.0        # no negative zero
        print("|", title if n == 0 else "", "|", tool, "|", measures[0], "|", marked(rows, n, 1, 1, max), "|",
              marked(rows, n, 2, 0, min), "|", marked(rows, n, 3, 3, max), "|", "" if n == 0 else "%.2f" % change, "|",
              "" if seconds is None else "%.1f" % seconds, "|", flush=True)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    command, directory = sys.argv[1:3]
    os.makedirs(directory, exist_ok=True)
    if gmsh:
        gmsh.initialize()
        gmsh.option.setNumber("General.Verbosity", 1)
    if netgen:
        netgen.SetMessageImportance(0)
    tools = []
    if gmsh:
        tools.append(("Gmsh", optimize_by_gmsh))
    if netgen:
        tools.append(("Netgen", optimize_by_netgen))
    for options in [], ["--fix-boundary"]:
        title = "`optimize_mesh" + "".join(" " + o for o in options) + "`"
        tools.append((title, lambda name, out, options=options: optimize_by_command(command, name, out, *options)))
    print("| mesh | optimizer | cells | smallest angle (degrees) | below 20 degrees | mean 3r/R | change of volume (%) | time (s) |")
    print("|---|---|---:|---:|---:|---:|---:|---:|")
    for name in sys.argv[3:] or make_files(directory):
        title = os.path.splitext(os.path.basename(name))[0]
        rows = [("none", Mesh.read(name).measures(), None)]
        for tool, optimize in tools:
            out = os.path.join(directory, "optimized.mesh")
            seconds = optimize(name, out)
            rows.append((tool, Mesh.read(out).measures(), seconds))
        print_rows(title, rows)


if __name__ == "__main__":
    main()
