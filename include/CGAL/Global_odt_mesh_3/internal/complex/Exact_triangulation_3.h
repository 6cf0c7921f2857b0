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

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Robust_weighted_circumcenter_filtered_traits_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_ds_cell_base_3.h>
#include <CGAL/tags.h>

#include <cstddef>

namespace CGAL::Global_odt_mesh_3::internal {

// As Mesh_3 has them: points of doubles, exact predicates, and the same dual points.
typedef Robust_weighted_circumcenter_filtered_traits_3<Exact_predicates_inexact_constructions_kernel> Exact_traits;

// What else is known of a cell as long as its vertices stay: the cells that a vertex leaves behind are gone when it moves.
enum Cell_flag
{
  IS_LABELLED, IS_BOUNDARY_CELL, MAY_HAVE_BOUNDARY_FACETS,     // while a candidate is labelled
  GIVES_WAY,                                                  // while some cells are replaced
  BORDERS_TRANSFER              // while cells are transferred: of the first facet; those of the other three follow
};

// A vertex that has a number, or -1 as the infinite one. Time stamps keep what CGAL does from depending on addresses.
template <class Base = Regular_triangulation_vertex_base_3<Exact_traits> >
class Numbered_vertex_base_3 : public Base
{
public:
  typedef Tag_true Has_timestamp;

  template <class Tds>
  struct Rebind_TDS
  {
    typedef Numbered_vertex_base_3<typename Base::template Rebind_TDS<Tds>::Other> Other;
  };

  using Base::Base;

  int number() const { return number_; }
  void set_number(int number) { number_ = number; }

  std::size_t time_stamp() const { return time_stamp_; }
  void set_time_stamp(std::size_t stamp) { time_stamp_ = stamp; }

private:
  std::size_t time_stamp_ = std::size_t(-1);
  int number_ = -1;
};

// A cell that has a label, at first 0 for outside, knows which of its facets are in the complex, and has flags. So what is known
// of a cell is gone when it gives way to another.
// That is a quarter of what a cell of a c3t3 takes.
template <class Base = Triangulation_ds_cell_base_3<> >
class Labelled_cell_base_3 : public Base
{
public:
  typedef typename Base::Vertex_handle Vertex_handle;
  typedef typename Base::Cell_handle Cell_handle;
  typedef Exact_traits Geom_traits;
  typedef Exact_traits::Weighted_point_3 Point;
  typedef const Point* Point_iterator;
  typedef const Point* Point_const_iterator;

  template <class Tds>
  struct Rebind_TDS
  {
    typedef Labelled_cell_base_3<typename Base::template Rebind_TDS<Tds>::Other> Other;
  };

  Labelled_cell_base_3() = default;

  Labelled_cell_base_3(Vertex_handle v0, Vertex_handle v1, Vertex_handle v2, Vertex_handle v3)
    : Base(v0, v1, v2, v3)
  {}

  Labelled_cell_base_3(Vertex_handle v0, Vertex_handle v1, Vertex_handle v2, Vertex_handle v3,
                       Cell_handle n0, Cell_handle n1, Cell_handle n2, Cell_handle n3)
    : Base(v0, v1, v2, v3, n0, n1, n2, n3)
  {}

  int label() const { return label_; }
  void set_label(int label) { label_ = label; }

  bool is_facet_in_complex(int i) const { return facets_in_complex_ & (1 << i); }
  void set_facet_in_complex(int i) { facets_in_complex_ |= 1 << i; }
  void clear_facets() { facets_in_complex_ = 0; }

  bool has_flag(int flag) const { return flags_ & (1 << flag); }
  bool has_flags() const { return flags_ != 0; }
  void set_flag(int flag) { flags_ |= 1 << flag; }
  void clear_flags() { flags_ = 0; }

  // How often the removal of slivers has tried in vain to improve the cell.
  int failures() const { return failures_; }
  void add_failure() { ++failures_; }

  // As regular triangulations ask for. Hidden points are not kept.
  Point_iterator hidden_points_begin() const { return nullptr; }
  Point_iterator hidden_points_end() const { return nullptr; }
  void hide_point(const Point&) const {}

  Exact_traits::Point_3 weighted_circumcenter(const Exact_traits& traits) const
  {
    return traits.construct_weighted_circumcenter_3_object()(this->vertex(0)->point(), this->vertex(1)->point(),
                                                             this->vertex(2)->point(), this->vertex(3)->point());
  }

private:
  unsigned char facets_in_complex_ = 0, failures_ = 0;
  unsigned short flags_ = 0;
  int label_ = 0;
};

// CGAL fills small holes with the help of a table that outlives the call, and that would keep what it holds if memory
// ran out on the way, to the harm of all triangulations that come later. Hence the memory for the cells is there before.
class Exact_data_structure_3
  : public Triangulation_data_structure_3<Numbered_vertex_base_3<>, Labelled_cell_base_3<> >
{
  typedef Triangulation_data_structure_3<Numbered_vertex_base_3<>, Labelled_cell_base_3<> > Base;

public:
  template <class Cells, class Facets>
  Vertex_handle _insert_in_small_hole(const Cells& cells, const Facets& facets)
  {
    this->cells().reserve(this->cells().size() + facets.size());
    return Base::_insert_in_small_hole(cells, facets);
  }
};

// The regular triangulation of the vertices of a complex, with what its restriction to the domain says of cells and
// facets.
class Exact_triangulation_3
  : public Regular_triangulation_3<Exact_traits, Exact_data_structure_3>
{
  typedef Regular_triangulation_3<Exact_traits, Exact_data_structure_3> Base;

public:
  using Base::Base;
  using Base::side_of_oriented_power_sphere;
  using Base::side_of_bounded_power_circle;
};

typedef Exact_triangulation_3::Vertex_handle Vertex_handle;
typedef Exact_triangulation_3::Cell_handle Cell_handle;
typedef Exact_triangulation_3::Facet Facet;
typedef Exact_triangulation_3::Weighted_point Weighted_point;

inline Weighted_point weighted_point(const Site& s)
{
  return Weighted_point(Exact_triangulation_3::Bare_point(s.x, s.y, s.z), s.weight);
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EXACT_TRIANGULATION_3_H
