// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_PARTIAL_GRADIENT_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_PARTIAL_GRADIENT_H

#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_energy_3.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What a chunk of cells adds to a gradient that others add to at the same time.
//
// The gradient is divided into pages, each of which has an owner among the chunks, that adds to it directly. Others
// add to copies of the page, which add_borrowed_pages() adds to it later. As cells that are close to each other have
// vertices with numbers that are close, few pages are borrowed.
class Partial_gradient
{
public:
  static constexpr int page_bits = 4, page_length = 1 << page_bits;

  static int number_of_pages(std::size_t number_of_vertices)
  {
    return static_cast<int>((number_of_vertices + page_length - 1) / page_length);
  }

  // Begins with zero. The chunk has a number, which is that of the owner for its own pages.
  void start(int chunk, const std::vector<int>& owners, std::vector<Site_gradient>& gradient)
  {
    chunk_ = chunk;
    owners_ = owners.data();
    gradient_ = gradient.data();
    if(pages_.size() != owners.size())
      pages_.assign(owners.size(), nullptr);
    else
      for(int p : open_pages_)
        pages_[p] = nullptr;
    open_pages_.clear();
    borrowed_.clear();
  }

  // Where to add what a vertex gets.
  Site_gradient& at(int v)
  {
    Site_gradient* page = pages_[v >> page_bits];
    if(page == nullptr)
      page = open(v >> page_bits);
    return page[v & (page_length - 1)];
  }

  // Those from `first` to `end`.
  void add_borrowed_pages(int first, int end, std::vector<Site_gradient>& gradient) const
  {
    for(std::size_t n = 0; n < borrowed_.size(); ++n)
    {
      const int p = borrowed_[n];
      if(p < first || p >= end)
        continue;
      const std::size_t begin = std::size_t(p) * page_length;
      const std::size_t length = (std::min)(gradient.size() - begin, std::size_t(page_length));
      for(std::size_t i = 0; i < length; ++i)
        gradient[begin + i] += copies_[n][i];
    }
  }

private:
  // Apart from at(), which is to be part of the loop.
  BOOST_NOINLINE Site_gradient* open(int p)
  {
    open_pages_.push_back(p);
    if(owners_[p] == chunk_)
      return pages_[p] = gradient_ + std::size_t(p) * page_length;
    if(borrowed_.size() == copies_.size())
      copies_.emplace_back();
    Page& copy = copies_[borrowed_.size()];
    borrowed_.push_back(p);
    copy.fill(Site_gradient{ 0, 0, 0, 0 });
    return pages_[p] = copy.data();
  }

  typedef std::array<Site_gradient, page_length> Page;

  int chunk_ = 0;
  const int* owners_ = nullptr;             // for each page
  Site_gradient* gradient_ = nullptr;
  std::vector<Site_gradient*> pages_;       // where to add, null at first
  std::vector<int> open_pages_, borrowed_;
  std::deque<Page> copies_;                 // of borrowed pages, and room for more; these do not move
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_PARTIAL_GRADIENT_H
