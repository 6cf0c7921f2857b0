// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_OPTIMIZE_MESH_OPTIONS_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_OPTIMIZE_MESH_OPTIONS_H

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

// What optimize_mesh is told on its command line.
struct Optimize_mesh_options
{
  static constexpr char help[] = R"(usage: optimize_mesh IN.mesh OUT [options]

Improves the tetrahedra of a mesh in the format of Medit (ASCII): vertices move, inside and on the boundary, and slivers are
removed. OUT is in the same format or, if its name ends in .vtu, in that of ParaView. Gmsh converts others, and makes
references of physical groups:
  gmsh in.msh -save -o in.mesh -format mesh -setnumber Mesh.SaveElementTagType 2

  --insert              insert vertices where that improves cells, or where a valid mesh needs them
  --remove              remove vertices where that improves cells
  --size S              the circumradii of cells, in the unit of the coordinates; only with --insert, which then also splits
                        features, or --remove
  --vertices N          the number of vertices; implies --insert and --remove
  --fix-boundary        vertices and triangles on surfaces stay as they are
  --facet-distance D    how far the middle of a triangle may be from the surface that the file has, in the unit of the
                        coordinates (default 0: as far as the surface that the triangles stand for may be, by the angles
                        between them)
  --sliver-bound A      the dihedral angle, in degrees, that cells should exceed (0 to 70.5; default 0: as far as possible)
  --only-slivers        remove slivers, and leave the rest as it is
  --feature-angle A     where normals of triangles differ by more, in degrees, the edge is a feature (0 to 180; default 60)
  --ignore-edges        edges and corners in the file are no features, and are not written unless they are sharp, say; TetGen
                        writes all edges of its surfaces
  --time-limit T        in seconds (default 0: none)
  --seed N              of all random choices (default 0)
  --quiet               print nothing but errors, and why the mesh is unchanged if it is
  --help                print this

The domain is the one that the mesh fills. Features do not move: edges and corners in the file, edges where the references of
triangles or tetrahedra change, and edges that are sharp. RequiredVertices, RequiredEdges, and RequiredTriangles stay as
well, with their vertices.

References of vertices, edges, triangles, and tetrahedra are kept. All triangles are written that lie between tetrahedra of
different references, or between inside and outside, and all features. Those that the file does not have get references
greater than those it has: one for each pair of tetrahedra references, and one for each set of triangle references that meet
at an edge. Vertices keep their order; inserted ones come last, with reference 0. Vertices that no tetrahedron has are
written as they are. Triangles are counterclockwise as seen from outside or, between two references of tetrahedra, from the
greater one; inside of one reference, they may be so from either side. Triangles and edges that no tetrahedron has are left
out, and so are triangles of reference 0 inside of one reference of tetrahedra, unless they are required. Inverted tetrahedra
are turned. In .vtu files, references that are not all positive become numbers from 1 on.

Second-order elements, and cells other than tetrahedra, are not supported.

The exit status is 0 if the mesh is improved; 1 if it is written unchanged, with the reason on standard error; 2 if the
command line or a file is not good, with the reason in one line.
)";

  std::string in, out;
  bool do_insert = false, do_remove = false, fixes_boundary = false, only_slivers = false, ignores_edges = false;
  bool is_quiet = false, wants_help = false;
  double sliver_bound = 0, size = 0, facet_distance = 0, time_limit = 0, feature_angle = 60;
  std::size_t number_of_vertices = 0;
  unsigned int seed = 0;

  // Throws std::runtime_error with one line.
  explicit Optimize_mesh_options(const std::vector<std::string>& arguments)
  {
    std::vector<std::string> files;
    for(std::size_t n = 0; n < arguments.size(); ++n)
    {
      const std::string& a = arguments[n];
      const std::size_t equal = a.find('=');
      const std::string name = a.substr(0, equal);
      if(a.compare(0, 1, "-") != 0)
        files.push_back(a);
      else if(is_switch(name))
      {
        if(equal != std::string::npos)
          throw std::runtime_error(name + " takes no value");
      }
      else if(equal != std::string::npos)
        set_number(name, a.substr(equal + 1));
      else
        set_number(name, n + 1 < arguments.size() ? arguments[++n] : "");
    }
    if(!wants_help)
      check(files);
  }

private:
  bool is_switch(const std::string& name)
  {
    const std::map<std::string, bool*> switches = {
      { "--insert", &do_insert }, { "--remove", &do_remove }, { "--fix-boundary", &fixes_boundary },
      { "--only-slivers", &only_slivers }, { "--ignore-edges", &ignores_edges }, { "--quiet", &is_quiet },
      { "--help", &wants_help }, { "-h", &wants_help } };
    const auto it = switches.find(name);
    if(it != switches.end())
      *it->second = true;
    return it != switches.end();
  }

  void set_number(const std::string& name, const std::string& text)
  {
    const auto number = [&](double smallest, double largest, bool is_whole = false)
    {
      char* end = nullptr;
      const double x = std::strtod(text.c_str(), &end);
      if(text.empty() || *end != '\0' || !(x >= smallest && x <= largest) || (is_whole && x != std::floor(x)))
        throw std::runtime_error(name + " needs a " + (is_whole ? "whole " : "") + "number from " + printed(smallest)
                                 + " to " + printed(largest));
      return x;
    };
    constexpr double most_vertices = 33554432;    // 2^25
    if(name == "--sliver-bound")
      sliver_bound = number(0, 70.5);
    else if(name == "--size")
      size = number(1e-50, 1e50);
    else if(name == "--facet-distance")
      facet_distance = number(0, 1e50);
    else if(name == "--time-limit")
      time_limit = number(0, 1e9);
    else if(name == "--feature-angle")
      feature_angle = number(0, 180);
    else if(name == "--vertices")
      number_of_vertices = static_cast<std::size_t>(number(1, most_vertices, true));
    else if(name == "--seed")
      seed = static_cast<unsigned int>(number(0, 4294967295., true));
    else
      throw std::runtime_error("there is no option " + name + "; --help shows those there are");
  }

  static std::string printed(double x)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.10g", x);
    return text;
  }

  void check(const std::vector<std::string>& files)
  {
    if(files.size() != 2)
      throw std::runtime_error("two files are needed, to read and to write; --help shows the options");
    in = files[0];
    out = files[1];
    if(number_of_vertices > 0)
      do_insert = do_remove = true;
    if(size > 0 && !do_insert && !do_remove)
      throw std::runtime_error("--size needs --insert, or --remove, or both");
    if(only_slivers && (do_insert || do_remove))
      throw std::runtime_error("--only-slivers excludes --insert, --remove, and --vertices");
  }
};

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_OPTIMIZE_MESH_OPTIONS_H
