// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flat arrays hold the cells inside of a labelled triangulation and their neighbors, in an order of their own, for any number of
// threads.

#include "check.h"

#include <CGAL/Global_odt_mesh_3/internal/complex/Index_cells_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>

#include <CGAL/tags.h>

#include <tbb/global_control.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <map>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

// A random triangulation with regions.
static Labelled_triangulation_3 random_triangulation(int number_of_points)
{
  Random_source random(3);
  std::vector<Site> sites;
  for(int n = 0; n < number_of_points; ++n)
  {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    sites.push_back({ x, y, z, 0 });
  }
  Labelled_triangulation_3 tr;
  tr.build(sites);
  for(int c : tr.cells())
  {
    if(tr.is_infinite(c))
      continue;
    Vector_3 p;
    for(const Site& s : tr.cell_sites(c))
      p += position(s) / 4;
    const Vector_3 from_center = p - Vector_3(0.5, 0.5, 0.5);
    tr.set_label(c, from_center.squared_length() > 0.15 ? 0 : p[0] < 0.5 ? 1 : 2);
  }
  return tr;
}

// Of facets, some of which stay.
static bool is_marked(const Labelled_triangulation_3& tr, Half_facet f)
{
  const Triple v = sorted(facet_vertices(tr.vertices(f.cell()), f.index()));
  return v[0] >= 0 && (v[0] + 3 * v[1] + 5 * v[2]) % 11 == 0;
}

static Indexed_triangulation_3 index(const Labelled_triangulation_3& tr, const Thread_policy& threads)
{
  Indexed_triangulation_3 indexed;
  // A mark on one side is enough.
  index_cells(tr, [&tr](Half_facet f) { return tr.is_first_side(f) && is_marked(tr, f); }, threads, indexed);
  return indexed;
}

// Cells and neighbors are those of the triangulation, and facets are constrained if they are to be.
static void same_as_triangulation(const Labelled_triangulation_3& tr, const Indexed_triangulation_3& indexed)
{
  check::that(indexed.is_valid(), "the indexed triangulation is not valid");
  std::map<Quadruple, int> inside;
  for(int c : tr.cells())
    if(tr.label(c) != 0)
      inside[in_canonical_order(tr.vertices(c))] = c;
  check::that(indexed.number_of_cells() == static_cast<int>(inside.size()), "not all cells inside are there, or others");
  int n = 0, constrained = 0, marked_inside = 0;
  for(const auto& cell : inside)
  {
    check::that(indexed.cell(n) == cell.first, "cell ", n, " is not in canonical order");
    for(int i = 0; i < 4; ++i)
    {
      const Half_facet f(cell.second, i), beyond = tr.mirror(f), s = indexed.slot(n, tr.vertex(f)), across = indexed.neighbor(s);
      const bool separates = tr.label(f.cell()) != tr.label(beyond.cell());
      check::that(across.is_side() == (separates || is_marked(tr, f)), "a facet is constrained that should not be, or the reverse");
      if(across.is_side())
      {
        const Half_facet other = indexed.constrained_half_facet(across.other_side());
        check::that(indexed.constrained_half_facet(across) == s, "a side does not know its facet");
        check::that(other.is_none() == (tr.label(beyond.cell()) == 0), "a constrained facet lacks a side, or has one too many");
        ++constrained;
        marked_inside += !separates;
      }
      else
        check::that(indexed.vertex(across) == tr.vertex(beyond)
                    && indexed.cell(across.cell()) == in_canonical_order(tr.vertices(beyond.cell())), "a neighbor is another one");
    }
    ++n;
  }
  check::that(constrained > 500 && marked_inside > 100, "hardly any constrained facets");
}

// The same cells, the last ones first.
static Labelled_triangulation_3 reversed(const Labelled_triangulation_3& tr)
{
  const int last = static_cast<int>(tr.cells().size()) - 1;
  std::vector<Labelled_triangulation_3::Cell> cells(last + 1);
  for(int c = 0; c <= last; ++c)
  {
    cells[last - c].vertices = tr.vertices(c);
    cells[last - c].label = tr.label(c);
    for(int i = 0; i < 4; ++i)
    {
      const Half_facet across = tr.mirror(Half_facet(c, i));
      cells[last - c].neighbors[i] = Half_facet(last - across.cell(), across.index()).id();
    }
  }
  Labelled_triangulation_3 result;
  result.assign(std::move(cells), tr.sites());
  return result;
}

static std::vector<int> contents(const Indexed_triangulation_3& indexed)
{
  std::vector<int> all(indexed.cell_vertices(), indexed.cell_vertices() + indexed.number_of_half_facets());
  all.insert(all.end(), indexed.neighbors(), indexed.neighbors() + indexed.number_of_half_facets());
  for(int v = 0; v < indexed.number_of_vertices(); ++v)
    all.push_back(indexed.incident_cell(v));
  for(int n = 0; n < indexed.number_of_constrained_facets(); ++n)
    for(int side : { 0, 1 })
      all.push_back(indexed.constrained_half_facet(n, side).id());
  return all;
}

int main()
{
  const Labelled_triangulation_3 tr = random_triangulation(6000);
  const Indexed_triangulation_3 indexed = index(tr, Thread_policy());
  std::cout << indexed.number_of_cells() << " cells inside, " << indexed.number_of_constrained_facets() << " facets" << std::endl;
  same_as_triangulation(tr, indexed);
  for(std::size_t number : { 1, 2, 3, 8 })
  {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, number);
    check::that(contents(index(tr, Thread_policy::for_tag<CGAL::Parallel_tag>())) == contents(indexed), number,
                " threads lead elsewhere than none");
  }
  check::that(contents(index(reversed(tr), Thread_policy())) == contents(indexed), "the order of cells matters");
  return check::result();
}
