// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EXACT_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EXACT_TRIANGULATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Spatial_order.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Robust_weighted_circumcenter_filtered_traits_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_ds_cell_base_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The same as in Mesh_3: points of doubles, exact predicates, and the same dual points.
typedef Robust_weighted_circumcenter_filtered_traits_3<Exact_predicates_inexact_constructions_kernel> Exact_traits;
typedef Exact_traits::Weighted_point_3 Weighted_point;

inline Weighted_point weighted_point(const Site& s) { return Weighted_point(Exact_traits::Point_3(s.x, s.y, s.z), s.weight); }

// For a flat cell, the result depends on the order of the vertices.
inline Vector_3 exact_dual_point(const std::array<Site, 4>& s)
{
  return coordinates(Exact_traits().construct_weighted_circumcenter_3_object()(weighted_point(s[0]), weighted_point(s[1]),
                                                                               weighted_point(s[2]), weighted_point(s[3])));
}

// A vertex or cell with a number; the infinite vertex has number -1.
template <class Base>
class Numbered_base_3 : public Base
{
public:
  template <class Tds>
  struct Rebind_TDS
  {
    typedef Numbered_base_3<typename Base::template Rebind_TDS<Tds>::Other> Other;
  };

  using Base::Base;

  int number() const { return number_; }
  void set_number(int number) { number_ = number; }

private:
  int number_ = -1;
};

// A cell without a list of hidden points.
template <class Base = Triangulation_ds_cell_base_3<> >
class Bare_cell_base_3 : public Base
{
public:
  typedef Exact_traits Geom_traits;
  typedef Weighted_point Point;
  typedef const Point* Point_iterator;
  typedef const Point* Point_const_iterator;

  template <class Tds>
  struct Rebind_TDS
  {
    typedef Bare_cell_base_3<typename Base::template Rebind_TDS<Tds>::Other> Other;
  };

  using Base::Base;

  Point_iterator hidden_points_begin() const { return nullptr; }
  Point_iterator hidden_points_end() const { return nullptr; }
  void hide_point(const Point&) const {}
};

// CGAL fills small holes with the help of a table that outlives the call. If memory ran out meanwhile, the table would keep its
// contents and spoil all later triangulations. Hence the memory for the cells is reserved first.
class Exact_data_structure_3
  : public Triangulation_data_structure_3<Numbered_base_3<Regular_triangulation_vertex_base_3<Exact_traits> >,
                                          Numbered_base_3<Bare_cell_base_3<> > >
{
  typedef Triangulation_data_structure_3<Numbered_base_3<Regular_triangulation_vertex_base_3<Exact_traits> >,
                                         Numbered_base_3<Bare_cell_base_3<> > > Base;

public:
  template <class Cells, class Facets>
  Vertex_handle _insert_in_small_hole(const Cells& cells, const Facets& facets)
  {
    this->cells().reserve(this->cells().size() + facets.size());
    return Base::_insert_in_small_hole(cells, facets);
  }
};

// CGAL's regular triangulation of numbered vertices. Even an empty one tells signs with CGAL's perturbation.
class Exact_triangulation_3
  : public Regular_triangulation_3<Exact_traits, Exact_data_structure_3>
{
  typedef Regular_triangulation_3<Exact_traits, Exact_data_structure_3> Base;

public:
  using Base::Base;
  using Base::side_of_bounded_power_circle;
  using Base::side_of_oriented_power_sphere;

  // Inserts the sites; hidden ones get no vertex. Weighted points come first, so that few vertices become hidden later.
  void insert_sites(const std::vector<int>& numbers, const std::vector<Site>& sites)
  {
    std::vector<Site> inserted;
    inserted.reserve(numbers.size());
    for(int v : numbers)
      inserted.push_back(sites[v]);
    std::vector<std::size_t> order = insertion_order(inserted);
    std::stable_partition(order.begin(), order.end(), [&](std::size_t n) { return inserted[n].weight != 0; });
    Cell_handle hint;
    for(std::size_t n : order)
    {
      const Weighted_point p = weighted_point(inserted[n]);
      const Vertex_handle v = hint == Cell_handle() ? this->insert(p) : this->insert(p, hint);
      if(v == Vertex_handle())
        continue;
      // If another site at the same place has the vertex already, that number stays.
      if(v->number() < 0)
        v->set_number(numbers[n]);
      hint = v->cell();
    }
  }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EXACT_TRIANGULATION_3_H
