// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_SYNTHETIC_IMAGES_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_SYNTHETIC_IMAGES_H

#include <CGAL/Image_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// Labeled images of n^3 voxels of size 1, as they come from microscopes and scanners. 0 is the outside.
namespace synthetic_images {

// Filled by label(i, j, k).
template <class Label>
CGAL::Image_3 labeled_image(int n, const Label& label)
{
  using namespace CGAL;                 // of the latest versions, where it is
  _image* im = _createImage(n, n, n, 1, 1, 1, 1, sizeof(unsigned char), WK_FIXED, SGN_UNSIGNED);
  unsigned char* voxel = static_cast<unsigned char*>(im->data);
  for(int k = 0; k < n; ++k)
    for(int j = 0; j < n; ++j)
      for(int i = 0; i < n; ++i)
        *voxel++ = static_cast<unsigned char>(label(i, j, k));
  return CGAL::Image_3(im);
}

// Seven labels, in layers that are thinner than a cell.
inline CGAL::Image_3 head(int n)
{
  const double center = (n - 1) / 2., scale = n / 96.;
  const auto waves = [](double x, double y, double z, double frequency, double phase)
  { return std::sin(frequency * x + phase) * std::sin(frequency * y + 1.3 * phase) * std::sin(frequency * z + .7 * phase); };
  return labeled_image(n, [=](int i, int j, int k)
  {
    const double x = (i - center) / scale, y = (j - center) / scale, z = (k - center) / scale;
    // Whether the place is in one of two ellipsoids, left and right.
    const auto is_in_pair = [=](const std::array<double, 3>& axes, const std::array<double, 3>& at)
    {
      const auto distance = [&](double side)
      { return std::hypot((x - side * at[0]) / axes[0], (y - side * at[1]) / axes[1], (z - side * at[2]) / axes[2]); };
      return (std::min)(distance(1), distance(-1)) < 1;
    };
    const double r = 41 * std::hypot(x / 38, y / 44, z / 41);
    const double inner_bone = 33.5 + 1.3 * waves(x, y, z, .1, 2);
    const double gray = 31.2 + 2.9 * std::sin(.23 * x + .5) * std::sin(.21 * y) * std::sin(.25 * z + .3)
                        + 1.2 * std::sin(.35 * x) * std::sin(.4 * z + .2) - .45 * std::exp(-x * x / 5) * (std::max)(0., z);
    const double white = gray - 3.6 - 2.2 * std::sin(.31 * x + .2) * std::sin(.29 * y + .5) * std::sin(.33 * z);
    int label = r < 41 + 1.2 * waves(x, y, z, .11, .4) ? 1 : 0;
    if(r < 37.5 + 1.5 * waves(x, y, z, .09, 1)) label = 2;
    if(r < inner_bone) label = 3;
    if(r < (std::min)(gray, inner_bone)) label = 4;
    if(r < (std::min)(white, inner_bone)) label = 5;
    if(label >= 3 && is_in_pair({{ 7, 9, 6 }}, {{ 11, 2, -5 }})) label = 7;
    if(label >= 3 && is_in_pair({{ 5, 14, 4.5 }}, {{ 7, -2, 3 }})) label = 6;
    if(label >= 3 && label <= 5 && std::hypot(x, y + 4) < 7 && z < -14) label = 5;
    return label;
  });
}

// The Voronoi cells of random points in a ball.
inline CGAL::Image_3 polycrystal(int n, std::size_t number_of_cells)
{
  typedef std::array<double, 3> Place;
  const auto squared_distance = [](const Place& p, const Place& q)
  { return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]); };
  std::mt19937 engine(7);
  std::uniform_real_distribution<> uniform(-1, 1);
  std::vector<Place> points;
  while(points.size() < number_of_cells)
  {
    const double x = uniform(engine), y = uniform(engine), z = uniform(engine);
    const Place p = {{ x, y, z }};
    if(squared_distance(p, {{ 0, 0, 0 }}) <= 1
       && std::all_of(points.begin(), points.end(), [&](const Place& q) { return squared_distance(p, q) >= .15; }))
      points.push_back(p);
  }
  return labeled_image(n, [=](int i, int j, int k)
  {
    const double center = (n - 1) / 2., radius = .45 * n;
    const Place p = {{ (i - center) / radius, (j - center) / radius, (k - center) / radius }};
    const auto nearest = std::min_element(points.begin(), points.end(), [&](const Place& a, const Place& b)
                                          { return squared_distance(p, a) < squared_distance(p, b); });
    return squared_distance(p, {{ 0, 0, 0 }}) <= 1 ? nearest - points.begin() + 1 : 0;
  });
}

// Five balls, each with a label of its own.
inline CGAL::Image_3 separate_balls()
{
  typedef std::array<double, 3> Place;
  const std::array<Place, 5> centers = {{ {{ 15, 15, 15 }}, {{ 45, 15, 15 }}, {{ 15, 45, 20 }}, {{ 45, 45, 40 }}, {{ 30, 30, 48 }} }};
  return labeled_image(60, [=](int i, int j, int k)
  {
    for(int n = 0; n < 5; ++n)
      if(std::hypot(i - centers[n][0], j - centers[n][1], k - centers[n][2]) < 4 + 2 * n)
        return n + 1;
    return 0;
  });
}

} // namespace synthetic_images

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_SYNTHETIC_IMAGES_H
