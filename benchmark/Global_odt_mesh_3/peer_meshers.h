// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_PEER_MESHERS_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_PEER_MESHERS_H

#include "Tetrahedral_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Other programs that mesh the inside of a surface, as Debian ships them; they work in a directory of their own.
struct Peer_mesher
{
  std::string name;
  // The mesh with cells of about that size, none if the program is not there or fails.
  std::function<Tetrahedral_mesh(double size)> run;
};

// The facets of a mesh that no two cells share, counterclockwise as seen from outside.
inline std::vector<std::array<int, 3> > boundary_facets(const Tetrahedral_mesh& mesh)
{
  std::map<std::array<int, 3>, std::array<int, 3> > facets;
  for(const std::array<int, 4>& c : mesh.cells)
    for(const std::array<int, 3>& f : { std::array<int, 3>{{ c[1], c[2], c[3] }}, { c[0], c[3], c[2] },
                                        { c[0], c[1], c[3] }, { c[0], c[2], c[1] } })
    {
      std::array<int, 3> key = f;
      std::sort(key.begin(), key.end());
      if(facets.erase(key) == 0)
        facets[key] = f;
    }
  std::vector<std::array<int, 3> > result;
  for(const auto& f : facets)
    result.push_back(f.second);
  return result;
}

// As an OFF file and as one in STL.
inline void write_boundary(const Tetrahedral_mesh& mesh, const std::string& prefix)
{
  const std::vector<std::array<int, 3> > facets = boundary_facets(mesh);
  std::ofstream off(prefix + ".off"), stl(prefix + ".stl");
  off.precision(17);
  stl.precision(17);
  std::vector<int> number(mesh.points.size(), -1);
  std::vector<std::size_t> vertices;
  for(const auto& f : facets)
    for(int v : f)
      if(number[v] < 0)
      {
        number[v] = static_cast<int>(vertices.size());
        vertices.push_back(v);
      }
  off << "OFF\n" << vertices.size() << ' ' << facets.size() << " 0\n";
  for(std::size_t v : vertices)
    off << mesh.points[v].transpose() << '\n';
  stl << "solid boundary\n";
  for(const auto& f : facets)
  {
    off << "3 " << number[f[0]] << ' ' << number[f[1]] << ' ' << number[f[2]] << '\n';
    stl << "facet normal 0 0 0\nouter loop\n";
    for(int v : f)
      stl << "vertex " << mesh.points[v].transpose() << '\n';
    stl << "endloop\nendfacet\n";
  }
  stl << "endsolid boundary\n";
}

// The vertices and tetrahedra of a file in netgen's neutral format.
inline Tetrahedral_mesh read_neutral(const std::string& file)
{
  Tetrahedral_mesh mesh;
  std::ifstream in(file);
  std::size_t number = 0;
  in >> number;
  mesh.points.resize(number);
  for(Eigen::Vector3d& p : mesh.points)
    in >> p[0] >> p[1] >> p[2];
  in >> number;
  mesh.cells.resize(in ? number : 0);
  for(std::array<int, 4>& c : mesh.cells)
  {
    int subdomain = 0;
    in >> subdomain >> c[0] >> c[1] >> c[2] >> c[3];
    for(int& v : c)
      --v;
  }
  mesh.orient();
  return mesh;
}

// Whether the command, which says what to the log, comes to a result that was not there before.
inline bool calls_peer(const std::string& command, const std::string& prefix, const std::string& result)
{
  std::remove(result.c_str());
  return std::system((command + " > " + prefix + ".log 2>&1").c_str()) == 0;
}

// Those that keep the boundary of a mesh.
inline std::vector<Peer_mesher> peer_meshers(const Tetrahedral_mesh& mesh, const std::string& directory)
{
  const std::string prefix = directory + "/peer";
  write_boundary(mesh, prefix);
  const auto tetgen = [=](double size)
  {
    const std::string result = prefix + ".1.mesh";
    // The volume of a regular tetrahedron, more or less.
    const std::string options = "-pYq1.4ga" + std::to_string(size * size * size * 0.15);
    return calls_peer("tetgen " + options + " " + prefix + ".off", prefix, result) ? read_medit(result) : Tetrahedral_mesh();
  };
  const auto gmsh = [=](int algorithm, double size)
  {
    const std::string result = prefix + "_gmsh.mesh";
    std::ofstream(prefix + ".geo") << "Merge \"peer.stl\";\nSurface Loop(1)={1};\nVolume(1)={1};\nMesh.Algorithm3D="
                                   << algorithm << ";\nField[1]=MathEval;\nField[1].F=\"" << size
                                   << "\";\nBackground Field=1;\nMesh.CharacteristicLengthExtendFromBoundary=0;\n";
    const bool is_done = calls_peer("gmsh -3 -v 2 -format mesh -o " + result + " " + prefix + ".geo", prefix, result);
    return is_done ? read_medit(result) : Tetrahedral_mesh();
  };
  return { { "TetGen", tetgen },
           { "Gmsh, Delaunay", [=](double size) { return gmsh(1, size); } },
           { "Gmsh, HXT", [=](double size) { return gmsh(10, size); } } };
}

// Netgen, which makes a boundary of its own, for the cube [-1, 1]^3.
inline Peer_mesher netgen_in_cube(const std::string& directory)
{
  const std::string prefix = directory + "/peer";
  const auto netgen = [=](double size)
  {
    const std::string result = prefix + ".neutral";
    std::ofstream(prefix + "_netgen.geo") << "algebraic3d\nsolid cube = orthobrick(-1,-1,-1;1,1,1) -maxh=" << size
                                   << ";\ntlo cube;\n";
    // Debian's program looks for libraries under names that only the package for developers has.
    const std::string libraries = "/usr/lib/$(uname -m)-linux-gnu/netgen";
    const std::string command = "ln -sf $(ls " + libraries + "/libgui.so.*.*.* | head -n 1) " + directory + "/libgui.so; "
      "NETGENDIR=/usr/share/netgen LD_LIBRARY_PATH=" + directory + ":" + libraries + " netgen -batchmode -geofile=" + prefix
      + "_netgen.geo -meshfile=" + result + " -meshfiletype='Neutral Format'";
    return calls_peer("(" + command + ")", prefix, result) ? read_neutral(result) : Tetrahedral_mesh();
  };
  return { "Netgen", netgen };
}

// The mesh of the peer whose number of vertices is closest to the one wanted, among some sizes from a first one on.
inline Tetrahedral_mesh mesh_of_size(const Peer_mesher& peer, std::size_t vertices, double size)
{
  Tetrahedral_mesh best;
  double low = 0, high = 0;
  for(int n = 0; n < 8; ++n)
  {
    Tetrahedral_mesh mesh = peer.run(size);
    const double number = double(mesh.points.size()), wanted = double(vertices);
    if(mesh.cells.empty())
      break;
    const bool is_better = best.cells.empty() || std::abs(number - wanted) < std::abs(double(best.points.size()) - wanted);
    (number > wanted ? low : high) = size;
    size = low == 0 ? size * 0.85 : high == 0 ? size * 1.15 : std::sqrt(low * high);
    if(is_better)
      best = std::move(mesh);
    if(std::abs(number / wanted - 1) < 0.02)
      break;
  }
  return best;
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_PEER_MESHERS_H
