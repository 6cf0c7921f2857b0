// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flat arrays hold the cells of CGAL's triangulation and their neighbors, in an order of their own, for any number of
// threads.

#include "check.h"

#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Index_triangulation_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/tags.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <map>
#include <set>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Regular_triangulation_3<Kernel> Triangulation;
typedef Triangulation::Cell_handle Cell_handle;
typedef Triangulation::Vertex_handle Vertex_handle;
typedef Triangulation::Facet Facet;

// A random triangulation with regions, and with marked facets inside, between and outside of them.
struct Labelled_triangulation
{
  Triangulation tr;
  std::map<Vertex_handle, int> numbers;

  explicit Labelled_triangulation(int number_of_points)
  {
    Random_source random(3);
    for(int n = 0; n < number_of_points; ++n)
    {
      const double x = random.uniform(), y = random.uniform(), z = random.uniform();
      const Vertex_handle v = tr.insert(Triangulation::Weighted_point(Triangulation::Bare_point(x, y, z), 0));
      // Not in the order of the vertices.
      numbers[v] = (n * 7919) % number_of_points;
    }
  }

  int number(Vertex_handle v) const { return numbers.at(v); }

  Quadruple vertices(Cell_handle c) const
  {
    return {{ number(c->vertex(0)), number(c->vertex(1)), number(c->vertex(2)), number(c->vertex(3)) }};
  }

  Triple vertices(const Facet& f) const
  {
    const Triple& i = facet_indices(f.second);
    return {{ number(f.first->vertex(i[0])), number(f.first->vertex(i[1])), number(f.first->vertex(i[2])) }};
  }

  int label(Cell_handle c) const
  {
    if(tr.is_infinite(c))
      return 0;
    const auto point = [c](int i) { return c->vertex(i)->point().point(); };
    const auto p = CGAL::centroid(point(0), point(1), point(2), point(3));
    return CGAL::squared_distance(p, Kernel::Point_3(0.5, 0.5, 0.5)) > 0.15 ? 0 : p.x() < 0.5 ? 1 : 2;
  }

  bool is_marked(Cell_handle c, int i) const
  {
    if(tr.is_infinite(Facet(c, i)))
      return false;
    const Triple v = sorted(vertices(Facet(c, i)));
    return (v[0] + 3 * v[1] + 5 * v[2]) % 11 == 0;
  }

  bool is_constrained(Cell_handle c, int i) const { return label(c) != label(c->neighbor(i)) || is_marked(c, i); }

  Constrained_facets index_cells(const std::vector<Cell_handle>& cells, const Thread_policy& threads, Indexed_triangulation_3& indexed) const
  {
    return index_triangulation_3(tr, cells, [this](Vertex_handle v) { return number(v); },
                                 [this](Cell_handle c) { return label(c); },
                                 [this](Cell_handle c, int i) { return is_marked(c, i); }, threads, indexed);
  }
};

// Cells and neighbors are CGAL's, and facets are constrained if they are to be.
static void same_as_cgal(const Labelled_triangulation& t, const std::vector<Cell_handle>& cells, const Indexed_triangulation_3& indexed, const Constrained_facets& facets)
{
  check::that(indexed.is_valid(), "the indexed triangulation is not valid");
  std::map<Quadruple, Cell_handle> inside;
  for(Cell_handle c : t.tr.finite_cell_handles())
    if(t.label(c) != 0)
      inside[in_canonical_order(t.vertices(c))] = c;
  check::that(indexed.number_of_cells() == static_cast<int>(inside.size()), "not all cells inside are there, or others");
  int n = 0, constrained = 0, marked_inside = 0;
  for(const auto& cell : inside)
  {
    check::that(indexed.cell(n) == cell.first, "cell ", n, " is not in canonical order");
    const Cell_handle c = cell.second;
    for(int i = 0; i < 4; ++i)
    {
      const Half_facet s = indexed.slot(n, t.number(c->vertex(i))), across = indexed.neighbor(s);
      check::that(across.is_side() == t.is_constrained(c, i), "a facet is constrained that should not be, or the reverse");
      if(across.is_side())
      {
        const Constrained_facet& f = facets[across.constrained_facet()];
        const Facet here = across.side() == 0 ? Facet(c, i) : t.tr.mirror_facet(Facet(c, i));
        check::that(Facet(cells[f.cell], f.index) == here && f.vertices == t.vertices(here), "a constrained facet is on the wrong side");
        ++constrained;
        marked_inside += t.label(c) == t.label(c->neighbor(i));
        continue;
      }
      check::that(indexed.vertex(across) == t.number(t.tr.mirror_vertex(c, i))
                  && indexed.cell(across.cell()) == in_canonical_order(t.vertices(c->neighbor(i))), "a neighbor is not CGAL's");
    }
    ++n;
  }
  check::that(constrained > 500 && marked_inside > 100, "hardly any constrained facets");
}

// Marked facets without a cell inside follow, each once.
static void facets_outside(const Labelled_triangulation& t, const std::vector<Cell_handle>& cells, const Indexed_triangulation_3& indexed, const Constrained_facets& facets)
{
  std::set<Triple> expected, found;
  for(const Facet& f : t.tr.finite_facets())
    if(t.label(f.first) == 0 && t.label(f.first->neighbor(f.second)) == 0 && t.is_marked(f.first, f.second))
      expected.insert(sorted(t.vertices(f)));
  for(std::size_t n = indexed.number_of_constrained_facets(); n < facets.size(); ++n)
  {
    const Facet f(cells[facets[n].cell], facets[n].index);
    check::that(!t.tr.is_infinite(f.first) && facets[n].vertices == t.vertices(f),
                "a facet outside is not as its cell sees it");
    check::that(found.insert(sorted(facets[n].vertices)).second, "a facet outside occurs twice");
  }
  check::that(found == expected && expected.size() > 100, "other facets outside than those that are marked");
}

// The arrays, and the constrained facets.
static std::vector<int> contents(const Indexed_triangulation_3& indexed, const Constrained_facets& facets)
{
  std::vector<int> all(indexed.cell_vertices(), indexed.cell_vertices() + indexed.number_of_half_facets());
  all.insert(all.end(), indexed.neighbors(), indexed.neighbors() + indexed.number_of_half_facets());
  for(int v = 0; v < indexed.number_of_vertices(); ++v)
    all.push_back(indexed.incident_cell(v));
  for(int n = 0; n < indexed.number_of_constrained_facets(); ++n)
    all.insert(all.end(), { indexed.constrained_half_facet(n, 0).id(), indexed.constrained_half_facet(n, 1).id() });
  for(const Constrained_facet& f : facets)
    all.insert(all.end(), f.vertices.begin(), f.vertices.end());
  return all;
}

int main()
{
  const Labelled_triangulation t(6000);
  std::vector<Cell_handle> cells = all_cells(t.tr);
  check::that(cells.size() == t.tr.number_of_cells(), "not all cells are listed");
  Indexed_triangulation_3 indexed;
  const Constrained_facets facets = t.index_cells(cells, Thread_policy(), indexed);
  std::cout << indexed.number_of_cells() << " cells inside, " << facets.size() << " facets" << std::endl;
  same_as_cgal(t, cells, indexed, facets);
  facets_outside(t, cells, indexed, facets);
  const std::vector<int> expected = contents(indexed, facets);
  for(std::size_t number : { 1, 2, 3, 8 })
  {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, number);
    Indexed_triangulation_3 again;
    const Constrained_facets facets_again = t.index_cells(cells, Thread_policy::for_tag<CGAL::Parallel_tag>(), again);
    check::that(contents(again, facets_again) == expected, number, " threads lead elsewhere than none");
  }
  // Where cells are in the triangulation decides about the facets' order and sides alone.
  std::reverse(cells.begin(), cells.end());
  Indexed_triangulation_3 reversed;
  const Constrained_facets reversed_facets = t.index_cells(cells, Thread_policy(), reversed);
  same_as_cgal(t, cells, reversed, reversed_facets);
  facets_outside(t, cells, reversed, reversed_facets);
  check::that(std::equal(expected.begin(), expected.begin() + indexed.number_of_half_facets(), reversed.cell_vertices()),
              "the order of cells depends on that in the triangulation");
  // Arrays that are there already are replaced.
  const Constrained_facets replacing = t.index_cells(all_cells(t.tr), Thread_policy(), reversed);
  check::that(contents(reversed, replacing) == expected, "something is left of what the arrays were");
  return check::result();
}
