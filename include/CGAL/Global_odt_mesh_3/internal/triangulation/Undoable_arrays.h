// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_UNDOABLE_ARRAYS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_UNDOABLE_ARRAYS_H

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
// there when the trial had a certain length. Another beginning ends the trial before.
template <int number_of_arrays>
class Undoable_arrays
{
public:
  const std::vector<int>& operator[](int array) const { return arrays_[array]; }

  // For changes that are not to be undone.
  std::vector<int>& unguarded(int array)
  {
    CGAL_assertion(changes_.empty());
    return arrays_[array];
  }

  void write(int array, int place, int value)
  {
    int& entry = arrays_[array][place];
    if(is_on_trial_)
      changes_.push_back({ array, place, entry });
    entry = value;
  }

  void push(int array, int value)
  {
    arrays_[array].push_back(value);
    if(is_on_trial_)
      changes_.push_back({ array, pushed, value });
  }

  int pop(int array)
  {
    const int value = arrays_[array].back();
    arrays_[array].pop_back();
    if(is_on_trial_)
      changes_.push_back({ array, popped, value });
    return value;
  }

  // Makes the array longer, which stays when a trial is undone.
  void extend(int array, std::size_t size, int value) { arrays_[array].resize(size, value); }

  void begin_trial()
  {
    changes_.clear();
    is_on_trial_ = true;
  }

  void end_trial()
  {
    is_on_trial_ = false;
    changes_.clear();
  }

  std::size_t trial_length() const { return changes_.size(); }

  void undo_trial(std::size_t length)
  {
    CGAL_assertion(length <= changes_.size());
    for( ; changes_.size() > length; changes_.pop_back())
    {
      const Change& c = changes_.back();
      if(c.place == pushed)
        arrays_[c.array].pop_back();
      else if(c.place == popped)
        arrays_[c.array].push_back(c.value);
      else
        arrays_[c.array][c.place] = c.value;
    }
  }

private:
  // What was there before, or has been pushed at the end, or popped from there.
  struct Change
  {
    int array, place, value;
  };
  static constexpr int pushed = -1, popped = -2;

  std::array<std::vector<int>, number_of_arrays> arrays_;
  bool is_on_trial_ = false;
  std::vector<Change> changes_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_UNDOABLE_ARRAYS_H
