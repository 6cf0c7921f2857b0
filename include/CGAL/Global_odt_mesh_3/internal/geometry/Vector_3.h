// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VECTOR_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VECTOR_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Global_odt_mesh_3::internal {

// Three coordinates. What the expression templates of Eigen make of vectors this short takes twice the time to compile.
class Vector_3
{
public:
  Vector_3() : c_{ 0, 0, 0 } {}
  Vector_3(double x, double y, double z) : c_{ x, y, z } {}

  double x() const { return c_[0]; }
  double y() const { return c_[1]; }
  double z() const { return c_[2]; }
  double operator[](int i) const { return c_[i]; }
  double& operator[](int i) { return c_[i]; }

  Vector_3& operator+=(const Vector_3& v) { return *this = *this + v; }
  Vector_3& operator-=(const Vector_3& v) { return *this = *this - v; }
  Vector_3& operator*=(double s) { return *this = s * *this; }
  Vector_3& operator/=(double s) { return *this = *this / s; }

  friend Vector_3 operator+(const Vector_3& a, const Vector_3& b) { return { a[0] + b[0], a[1] + b[1], a[2] + b[2] }; }
  friend Vector_3 operator-(const Vector_3& a, const Vector_3& b) { return { a[0] - b[0], a[1] - b[1], a[2] - b[2] }; }
  friend Vector_3 operator-(const Vector_3& a) { return { -a[0], -a[1], -a[2] }; }
  friend Vector_3 operator*(double s, const Vector_3& a) { return { s * a[0], s * a[1], s * a[2] }; }
  friend Vector_3 operator*(const Vector_3& a, double s) { return s * a; }
  friend Vector_3 operator/(const Vector_3& a, double s) { return { a[0] / s, a[1] / s, a[2] / s }; }
  friend bool operator==(const Vector_3& a, const Vector_3& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }
  friend bool operator!=(const Vector_3& a, const Vector_3& b) { return !(a == b); }

  double dot(const Vector_3& b) const { return c_[0] * b[0] + (c_[1] * b[1] + c_[2] * b[2]); }
  Vector_3 cross(const Vector_3& b) const
  {
    return { c_[1] * b[2] - c_[2] * b[1], c_[2] * b[0] - c_[0] * b[2], c_[0] * b[1] - c_[1] * b[0] };
  }
  double squared_length() const { return dot(*this); }
  double length() const { return std::sqrt(squared_length()); }
  Vector_3 normalized() const { return squared_length() > 0 ? *this / length() : *this; }

private:
  double c_[3];
};

// Long vectors, which are those of Eigen, have three entries for each vertex.
template <class Long_vector>
Vector_3 vector_at(const Long_vector& x, std::ptrdiff_t v) { return { x[3 * v], x[3 * v + 1], x[3 * v + 2] }; }

template <class Long_vector>
void set_vector(Long_vector& x, std::ptrdiff_t v, const Vector_3& y)
{
  for(int i = 0; i < 3; ++i)
    x[3 * v + i] = y[i];
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VECTOR_3_H
