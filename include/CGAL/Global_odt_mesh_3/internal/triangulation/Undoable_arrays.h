// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_UNDOABLE_ARRAYS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_UNDOABLE_ARRAYS_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Arrays of numbers that remember what has been overwritten.
//
// From begin_trial() to end_trial(), changes are remembered, and undo_trial() brings back what was
// there when the trial had a certain length. Another beginning ends the trial before.
template <int number_of_arrays>
class Undoable_arrays
{
public:
  Undoable_arrays()
  {
    for(auto& a : arrays_)
      a = std::make_shared<std::vector<int> >();
  }

  Undoable_arrays(const Undoable_arrays& other)
    : is_on_trial_(other.is_on_trial_)
    , changes_(other.changes_)
  {
    for(int a = 0; a < number_of_arrays; ++a)
      arrays_[a] = std::make_shared<std::vector<int> >(other[a]);
  }

  Undoable_arrays& operator=(const Undoable_arrays& other) { return *this = Undoable_arrays(other); }

  // Leaves nothing but what may be assigned to.
  Undoable_arrays(Undoable_arrays&&) noexcept = default;
  Undoable_arrays& operator=(Undoable_arrays&&) noexcept = default;

  // The same arrays, except one with other contents, for trials of its own. None may get longer but that one, and no two
  // threads change the same entries.
  Undoable_arrays part(int array, std::vector<int> contents) const
  {
    Undoable_arrays result;
    result.arrays_ = arrays_;
    result.arrays_[array] = std::make_shared<std::vector<int> >(std::move(contents));
    return result;
  }

  const std::vector<int>& operator[](int array) const { return *arrays_[array]; }

  // For changes that are not to be undone.
  std::vector<int>& unguarded(int array)
  {
    CGAL_assertion(changes_[array].empty());
    return *arrays_[array];
  }

  void write(int array, int place, int value)
  {
    int& entry = (*arrays_[array])[place];
    if(is_on_trial_)
      changes_[array].push_back({ place, entry });
    entry = value;
  }

  void push(int array, int value)
  {
    arrays_[array]->push_back(value);
    if(is_on_trial_)
      changes_[array].push_back({ pushed, value });
  }

  int pop(int array)
  {
    const int value = arrays_[array]->back();
    arrays_[array]->pop_back();
    if(is_on_trial_)
      changes_[array].push_back({ popped, value });
    return value;
  }

  // Makes the array longer, which stays when a trial is undone.
  void extend(int array, std::size_t size, int value) { arrays_[array]->resize(size, value); }

  void begin_trial()
  {
    for(std::vector<Change>& c : changes_)
    {
      // The first steps change more than all others.
      if(c.size() < c.capacity() / 8)
        std::vector<Change>(c.capacity() / 2).swap(c);
      c.clear();
    }
    is_on_trial_ = true;
  }

  void end_trial()
  {
    is_on_trial_ = false;
    for(std::vector<Change>& c : changes_)
      c.clear();
  }

  // How many changes there are, for each array.
  typedef std::array<std::size_t, number_of_arrays> Trial_length;

  Trial_length trial_length() const
  {
    Trial_length length;
    for(int a = 0; a < number_of_arrays; ++a)
      length[a] = changes_[a].size();
    return length;
  }

  // Takes back what has changed since the trial had that length.
  void undo_trial(const Trial_length& length)
  {
    for(int a = 0; a < number_of_arrays; ++a)
      undo(*arrays_[a], changes_[a], length[a]);
  }

private:
  // What was there before, or has been pushed at the end, or popped from there.
  struct Change
  {
    int place, value;
  };
  static constexpr int pushed = -1, popped = -2;

  static void undo(std::vector<int>& array, std::vector<Change>& changes, std::size_t length)
  {
    CGAL_assertion(length <= changes.size());
    for( ; changes.size() > length; changes.pop_back())
    {
      const Change& c = changes.back();
      if(c.place == pushed)
        array.pop_back();
      else if(c.place == popped)
        array.push_back(c.value);
      else
        array[c.place] = c.value;
    }
  }

  std::array<std::shared_ptr<std::vector<int> >, number_of_arrays> arrays_;
  bool is_on_trial_ = false;
  std::array<std::vector<Change>, number_of_arrays> changes_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_UNDOABLE_ARRAYS_H
