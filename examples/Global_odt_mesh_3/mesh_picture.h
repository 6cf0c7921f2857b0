// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_MESH_PICTURE_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_MESH_PICTURE_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_shape_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

// A picture of a mesh before and after optimization, drawn by gnuplot: the mesh
// cut open, bad cells in colour, and the histograms of angles and radius ratios.

// Writes the visible facets of the cells behind a plane, back to front, as
// polygons in the plane of the picture with a colour each.
template <class C3t3>
void write_cutaway(const C3t3& c3t3, const std::string& file)
{
  typedef typename C3t3::Triangulation Triangulation;
  typedef std::array<double, 3> Vector;
  const Triangulation& tr = c3t3.triangulation();
  const auto position = [&tr](typename Triangulation::Cell_handle c, int i)
  {
    const auto& p = tr.point(c, i);
    return Vector{{ CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()) }};
  };
  const auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  // An orthonormal frame; the viewer looks against `view`.
  const Vector right = {{ -0.6, 0.8, 0 }}, up = {{ -0.64, -0.48, 0.6 }}, view = {{ 0.48, 0.36, 0.8 }};
  const auto bbox = c3t3.bbox();
  const Vector middle = {{ (bbox.xmin() + bbox.xmax()) / 2, (bbox.ymin() + bbox.ymax()) / 2, (bbox.zmin() + bbox.zmax()) / 2 }};
  const auto is_behind = [&](typename Triangulation::Cell_handle c)
  {
    double depth = 0;
    for(int i = 0; i < 4; ++i)
      depth += dot(position(c, i), view) / 4;
    return c3t3.is_in_complex(c) && depth < dot(middle, view);
  };

  struct Polygon { double depth; std::array<double, 6> xy; int color; };
  std::vector<Polygon> polygons;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    if(!is_behind(c))
      continue;
    std::array<CGAL::Global_odt_mesh_3::internal::Site, 4> s;
    for(int i = 0; i < 4; ++i)
    {
      const Vector p = position(c, i);
      s[i] = { p[0], p[1], p[2], 0 };
    }
    const CGAL::Global_odt_mesh_3::internal::Cell_shape_3 shape(s[0], s[1], s[2], s[3]);
    const double angle = *std::min_element(shape.angles.begin(), shape.angles.end());
    for(int i = 0; i < 4; ++i)
    {
      const auto neighbor = c->neighbor(i);
      if(is_behind(neighbor))
        continue;
      const Vector a = position(c, (i + 1) % 4), b = position(c, (i + 2) % 4), d = position(c, (i + 3) % 4);
      const Vector ab = {{ b[0] - a[0], b[1] - a[1], b[2] - a[2] }}, ad = {{ d[0] - a[0], d[1] - a[1], d[2] - a[2] }};
      const Vector n = {{ ab[1] * ad[2] - ab[2] * ad[1], ab[2] * ad[0] - ab[0] * ad[2], ab[0] * ad[1] - ab[1] * ad[0] }};
      const double light = 0.55 + 0.45 * std::abs(dot(n, view)) / std::sqrt(dot(n, n));
      const bool cut = c3t3.subdomain_index(neighbor) == c3t3.subdomain_index(c);
      // Below 10 degrees red, below 20 orange; else yellowish inside, blue outside.
      const Vector rgb = angle < 10 ? Vector{{ 220, 30, 30 }} : angle < 20 ? Vector{{ 250, 150, 30 }}
                       : cut ? Vector{{ 250, 240, 200 }} : Vector{{ 120, 160, 220 }};
      int color = 0;
      for(double x : rgb)
        color = 256 * color + static_cast<int>(x * light);
      polygons.push_back({ (dot(a, view) + dot(b, view) + dot(d, view)) / 3,
                           {{ dot(a, right), dot(a, up), dot(b, right), dot(b, up), dot(d, right), dot(d, up) }}, color });
    }
  }
  std::sort(polygons.begin(), polygons.end(), [](const Polygon& p, const Polygon& q) { return p.depth < q.depth; });
  std::ofstream out(file);
  for(const Polygon& p : polygons)
  {
    // A dark triangle, and on it one a little smaller: outlined, in order.
    const double x = (p.xy[0] + p.xy[2] + p.xy[4]) / 3, y = (p.xy[1] + p.xy[3] + p.xy[5]) / 3;
    for(const bool outline : { true, false })
    {
      const double scale = outline ? 1.02 : 0.91;
      for(int k : { 0, 2, 4, 0 })
        out << x + scale * (p.xy[k] - x) << ' ' << y + scale * (p.xy[k + 1] - y) << ' '
            << (outline ? 0x303030 : p.color) << '\n';
      out << '\n';
    }
  }
}

// Writes prefix.dat, prefix_before.dat, prefix_after.dat and the script
// prefix.gp, which makes prefix.png; calls gnuplot, if there is one.
template <class C3t3>
void draw_before_and_after(const C3t3& before, const C3t3& after, const std::string& prefix)
{
  const auto b = CGAL::mesh_quality_report_3(before), a = CGAL::mesh_quality_report_3(after);
  write_cutaway(before, prefix + "_before.dat");
  write_cutaway(after, prefix + "_after.dat");
  std::ofstream data(prefix + ".dat");
  for(std::size_t n = 0; n < b.angles.size(); n += 3)
    data << double(n) + 1.5 << ' ' << b.angles[n] + b.angles[n + 1] + b.angles[n + 2] << ' '
         << a.angles[n] + a.angles[n + 1] + a.angles[n + 2] << '\n';
  data << "\n\n";
  for(std::size_t n = 0; n < b.radius_ratios.size(); ++n)
    data << (double(n) + 0.5) / double(b.radius_ratios.size()) << ' ' << b.radius_ratios[n] << ' ' << a.radius_ratios[n] << '\n';
  data.close();
  std::ofstream script(prefix + ".gp");
  script << "set terminal pngcairo size 1400,1150 font 'sans,13'\n"
         << "set output '" << prefix << ".png'\n"
         << "set multiplot layout 2,2\n"
         << "unset key; unset border; unset tics; set size ratio -1; set style fill solid 1.0 noborder\n"
         << "set title 'before: mean 3r/R " << b.mean_radius_ratio << ", " << b.cells_below[1].second
         << " cells below 10 degrees'\n"
         << "plot '" << prefix << "_before.dat' using 1:2:3 with filledcurves closed lc rgb variable\n"
         << "set title 'after: mean 3r/R " << a.mean_radius_ratio << ", " << a.cells_below[1].second
         << " cells below 10 degrees'\n"
         << "plot '" << prefix << "_after.dat' using 1:2:3 with filledcurves closed lc rgb variable\n"
         << "set size noratio; set border; set xtics; set ytics; set key top left\n"
         << "set title 'dihedral angles'\nset xrange [0:180]\nset style fill solid 0.35 noborder\n"
         << "plot '" << prefix << ".dat' index 0 using 1:3 with boxes lc rgb '#3060c0' title 'after', "
         << "'' index 0 using 1:2 with histeps lw 2 lc rgb '#c03030' title 'before'\n"
         << "set title 'radius ratios 3r/R'\nset xrange [0:1]\n"
         << "plot '" << prefix << ".dat' index 1 using 1:3 with boxes lc rgb '#3060c0' title 'after', "
         << "'' index 1 using 1:2 with histeps lw 2 lc rgb '#c03030' title 'before'\n"
         << "unset multiplot\n";
  script.close();
  const std::string command = "gnuplot '" + prefix + ".gp'";
  if(std::system(command.c_str()) == 0)
    std::cout << "picture: " << prefix << ".png\n";
  else
    std::cout << "picture: run " << command << '\n';
}

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_MESH_PICTURE_H
