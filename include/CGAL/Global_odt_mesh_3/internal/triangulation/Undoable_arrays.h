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
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Arrays of numbers that remember what has been overwritten.
//
// From begin_trial() to end_trial(), changes are remembered, and undo_trial() brings back what was
// there when it began. Another beginning ends the trial before.
template <int number_of_arrays>
class Undoable_arrays
{
public:
  const std::vector<int>& operator[](int array) const { return arrays_[array]; }

  // For changes that are not to be undone.
  std::vector<int>& unguarded(int array)
  {
    CGAL_assertion(changes_[array].empty());
    return arrays_[array];
  }

  void write(int array, int place, int value)
  {
    int& entry = arrays_[array][place];
    if(is_on_trial_)
      changes_[array].push_back({ place, entry });
    entry = value;
  }

  void push(int array, int value)
  {
    arrays_[array].push_back(value);
    if(is_on_trial_)
      changes_[array].push_back({ pushed, value });
  }

  int pop(int array)
  {
    const int value = arrays_[array].back();
    arrays_[array].pop_back();
    if(is_on_trial_)
      changes_[array].push_back({ popped, value });
    return value;
  }

  // Makes the array longer by as many values, which stay when a trial is undone.
  void extend(int array, std::size_t number, int value) { arrays_[array].resize(arrays_[array].size() + number, value); }

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

  // Takes back what has changed since the trial began.
  void undo_trial()
  {
    for(int a = 0; a < number_of_arrays; ++a)
      undo(arrays_[a], changes_[a]);
  }

private:
  // What was there before, or has been pushed at the end, or popped from there.
  struct Change
  {
    int place, value;
  };
  static constexpr int pushed = -1, popped = -2;

  static void undo(std::vector<int>& array, std::vector<Change>& changes)
  {
    for( ; !changes.empty(); changes.pop_back())
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

  std::array<std::vector<int>, number_of_arrays> arrays_;
  bool is_on_trial_ = false;
  std::array<std::vector<Change>, number_of_arrays> changes_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_UNDOABLE_ARRAYS_H
