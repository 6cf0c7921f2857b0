// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_TRIANGULATION_3_H

#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_ds_cell_base_3.h>
#include <CGAL/tags.h>

#include <cstddef>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A vertex that has a number, or -1 as the infinite one. Time stamps keep what CGAL does from depending on addresses.
template <class Traits, class Base = CGAL::Regular_triangulation_vertex_base_3<Traits> >
class Numbered_vertex_base_3 : public Base
{
public:
  typedef Tag_true Has_timestamp;

  template <class Tds>
  struct Rebind_TDS
  {
    typedef Numbered_vertex_base_3<Traits, typename Base::template Rebind_TDS<Tds>::Other> Other;
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

// A cell that has a label, at first 0 for outside, knows which of its facets are in the complex, and has four bits for
// what else is known of it. That is a quarter of what a cell of a c3t3 takes.
template <class Traits, class Base = CGAL::Triangulation_ds_cell_base_3<> >
class Labelled_cell_base_3 : public Base
{
public:
  typedef typename Base::Vertex_handle Vertex_handle;
  typedef typename Base::Cell_handle Cell_handle;
  typedef Traits Geom_traits;
  typedef typename Traits::Weighted_point_3 Point;
  typedef const Point* Point_iterator;
  typedef const Point* Point_const_iterator;

  template <class Tds>
  struct Rebind_TDS
  {
    typedef Labelled_cell_base_3<Traits, typename Base::template Rebind_TDS<Tds>::Other> Other;
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
  void forget_facets() { facets_in_complex_ = 0; }

  bool is_marked(int bit) const { return marks_ & (1 << bit); }
  void mark(int bit) { marks_ |= 1 << bit; }
  void unmark(int bit) { marks_ &= ~(1 << bit); }
  void unmark_all() { marks_ = 0; }

  // As regular triangulations ask for. Hidden points are not kept.
  Point_iterator hidden_points_begin() const { return nullptr; }
  Point_iterator hidden_points_end() const { return nullptr; }
  void hide_point(const Point&) const {}

  template <class Any_traits>
  auto weighted_circumcenter(const Any_traits& traits) const
  {
    return traits.construct_weighted_circumcenter_3_object()(this->vertex(0)->point(), this->vertex(1)->point(),
                                                             this->vertex(2)->point(), this->vertex(3)->point());
  }

private:
  unsigned char facets_in_complex_ = 0, marks_ = 0;
  int label_ = 0;
};

// CGAL fills small holes with the help of a table that outlives the call, and that would keep what it holds if memory
// ran out on the way, to the harm of all triangulations that come later. Hence the memory for the cells is there before.
template <class Vertex_base, class Cell_base>
class Restricted_data_structure_3 : public CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>
{
  typedef CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base> Base;

public:
  template <class Cells, class Facets>
  typename Base::Vertex_handle _insert_in_small_hole(const Cells& cells, const Facets& facets)
  {
    this->cells().reserve(this->cells().size() + facets.size());
    return Base::_insert_in_small_hole(cells, facets);
  }
};

// The regular triangulation of the vertices of a complex, with what its restriction to the domain says of cells and
// facets. Input is that of the c3t3.
template <class Input>
class Restricted_triangulation_3
  : public CGAL::Regular_triangulation_3<
      typename Input::Geom_traits,
      Restricted_data_structure_3<
        Numbered_vertex_base_3<typename Input::Geom_traits>,
        Labelled_cell_base_3<typename Input::Geom_traits> > >
{
public:
  typedef Input Input_triangulation;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_TRIANGULATION_3_H
