// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_MESH_PICTURE_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_MESH_PICTURE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// Pictures of meshes, drawn by gnuplot: a part of a mesh that is cut open before and after optimization, with bad cells in color and
// the histograms of dihedral angles and radius ratios; and a whole mesh beside the cut.

namespace mesh_picture {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;

// A visible facet, in the plane of the picture.
struct Polygon
{
  double x(int k) const { return corners[static_cast<std::size_t>(2 * k)]; }
  double y(int k) const { return corners[static_cast<std::size_t>(2 * k + 1)]; }
  double center_x() const { return (x(0) + x(1) + x(2)) / 3; }
  double center_y() const { return (y(0) + y(1) + y(2)) / 3; }
  double area() const { return std::abs((x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0))) / 2; }

  std::array<double, 6> corners;
  double depth;
  bool is_cut;   // inside of the mesh, and not on its surface
  double angle;  // the smallest dihedral angle of the cell, in degrees
  double light;  // from 0 to 1
  int color;
};

// A square part of the picture.
struct Window
{
  double x, y, width;
};

inline double smallest_dihedral_angle(const std::array<Point_3, 4>& p)
{
  double smallest = 180;
  for(std::size_t i = 0; i < 4; ++i)
    for(std::size_t j = i + 1; j < 4; ++j)
    {
      const std::size_t k = (i == 0 ? (j == 1 ? 2 : 1) : 0), l = 6 - i - j - k;
      smallest = (std::min)(smallest, std::abs(CGAL::to_double(CGAL::approximate_dihedral_angle(p[i], p[j], p[k], p[l]))));
    }
  return smallest;
}

typedef std::array<double, 3> Rgb;

inline int shaded(const Rgb& rgb, double light)
{
  int color = 0;
  for(double x : rgb)
    color = 256 * color + static_cast<int>(x * light);
  return color;
}

// Cells with an angle below 10 degrees are red, below 20 orange; others yellowish inside, or greenish, purple, or gray, by the
// number of their subdomain, and blue on the surface.
inline int color_of_facet(double smallest_angle, bool is_cut, std::size_t subdomain, double light)
{
  static const std::array<Rgb, 4> inside = {{ {{ 250, 240, 200 }}, {{ 190, 230, 180 }}, {{ 225, 195, 235 }}, {{ 225, 225, 225 }} }};
  const Rgb rgb = smallest_angle < 10 ? Rgb{{ 220, 30, 30 }}
                : smallest_angle < 20 ? Rgb{{ 250, 150, 30 }}
                : is_cut ? inside[subdomain % inside.size()] : Rgb{{ 130, 170, 230 }};
  return shaded(rgb, light);
}

// The mesh, or what it is without the cells in front of a plane through its middle.
template <class C3t3>
class Cutaway
{
  typedef typename C3t3::Cell_handle Cell_handle;

public:
  explicit Cutaway(const C3t3& c3t3, bool is_cut = true)
    : c3t3_(c3t3)
    , is_cut_(is_cut)
  {
    const auto box = c3t3.bbox();
    middle_ = Vector_3((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2) * view_;
    for(auto c = c3t3_.cells_in_complex_begin(); c != c3t3_.cells_in_complex_end(); ++c)
      subdomains_.insert(c3t3_.subdomain_index(c));
  }

  // From back to front.
  std::vector<Polygon> visible_facets() const
  {
    std::vector<Polygon> facets;
    for(auto c = c3t3_.cells_in_complex_begin(); c != c3t3_.cells_in_complex_end(); ++c)
      if(is_behind(c))
        for(int i = 0; i < 4; ++i)
          if(!goes_on(c, i) && outward_normal(c, i) * view_ > 0)
            facets.push_back(facet(c, i));
    std::sort(facets.begin(), facets.end(), [](const Polygon& p, const Polygon& q) { return p.depth < q.depth; });
    return facets;
  }

private:
  Point_3 point(Cell_handle c, int i) const
  {
    const auto& p = c3t3_.triangulation().point(c, i);
    return Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  bool is_behind(Cell_handle c) const
  {
    if(!c3t3_.is_in_complex(c))
      return false;
    if(!is_cut_)
      return true;
    const Point_3 center = CGAL::centroid(point(c, 0), point(c, 1), point(c, 2), point(c, 3));
    return (center - CGAL::ORIGIN) * view_ < middle_;
  }

  // In a periodic mesh, the neighbor beyond the sides of the period is drawn elsewhere.
  bool goes_on(Cell_handle c, int i) const
  {
    const Cell_handle n = c->neighbor(i);
    return is_behind(n) && point(n, n->index(c->vertex((i + 1) % 4))) == point(c, (i + 1) % 4);
  }

  Vector_3 outward_normal(Cell_handle c, int i) const
  {
    const Point_3 p = point(c, (i + 1) % 4);
    const Vector_3 n = CGAL::cross_product(point(c, (i + 2) % 4) - p, point(c, (i + 3) % 4) - p);
    return n * (point(c, i) - p) < 0 ? n : -n;
  }

  Polygon facet(Cell_handle c, int i) const
  {
    const Point_3 p = point(c, (i + 1) % 4), q = point(c, (i + 2) % 4), r = point(c, (i + 3) % 4);
    const Vector_3 normal = outward_normal(c, i);
    const double light = 0.5 + 0.5 * (normal * view_) / std::sqrt(normal * normal);
    const auto subdomain = c3t3_.subdomain_index(c);
    const bool is_cut = c3t3_.subdomain_index(c->neighbor(i)) == subdomain;
    const std::size_t number = static_cast<std::size_t>(std::distance(subdomains_.begin(), subdomains_.find(subdomain)));
    const double angle = smallest_dihedral_angle({{ point(c, 0), point(c, 1), point(c, 2), point(c, 3) }});
    const Vector_3 a = p - CGAL::ORIGIN, b = q - CGAL::ORIGIN, d = r - CGAL::ORIGIN;
    return { {{ a * right_, a * up_, b * right_, b * up_, d * right_, d * up_ }},
             (a + b + d) * view_, is_cut, angle, light, color_of_facet(angle, is_cut, number, light) };
  }

  static Vector_3 unit_vector(const Vector_3& v) { return v / std::sqrt(v * v); }

  const C3t3& c3t3_;
  bool is_cut_;
  double middle_;
  std::set<typename C3t3::Subdomain_index> subdomains_;
  // The viewer looks against `view_`, with the y-axis upward.
  const Vector_3 view_ = unit_vector({ 0.6, 0.25, 0.76 });
  const Vector_3 right_ = unit_vector(CGAL::cross_product(Vector_3(0, 1, 0), view_));
  const Vector_3 up_ = CGAL::cross_product(view_, right_);
};

// The window, of a width relative to that of the picture, that shows most of the cut and of the surface at once.
inline Window best_window(const std::vector<Polygon>& facets, double relative_width)
{
  const double infinity = std::numeric_limits<double>::infinity();
  double xmin = infinity, xmax = -infinity, ymin = infinity, ymax = -infinity;
  for(const Polygon& f : facets)
  {
    xmin = (std::min)(xmin, f.center_x());
    xmax = (std::max)(xmax, f.center_x());
    ymin = (std::min)(ymin, f.center_y());
    ymax = (std::max)(ymax, f.center_y());
  }
  const double width = (std::max)(xmax - xmin, ymax - ymin);
  if(relative_width >= 1)
    return { (xmin + xmax) / 2, (ymin + ymax) / 2, 1.05 * width };

  Window best = { 0, 0, relative_width * width };
  double most = 0;
  const int steps = 20;
  for(int i = 0; i <= steps; ++i)
    for(int j = 0; j <= steps; ++j)
    {
      const double x = xmin + i * (xmax - xmin) / steps, y = ymin + j * (ymax - ymin) / steps;
      double cut = 0, surface = 0;
      for(const Polygon& f : facets)
        if((std::max)(std::abs(f.center_x() - x), std::abs(f.center_y() - y)) < best.width / 2)
          (f.is_cut ? cut : surface) += f.area();
      if((std::min)(cut, surface) > most)
      {
        most = (std::min)(cut, surface);
        best.x = x;
        best.y = y;
      }
    }
  return best;
}

// Each facet is a dark triangle, and on it a smaller one in its color, so that it covers those farther back, and their
// outlines.
inline void write_facets(const std::vector<Polygon>& facets, const Window& window, const std::string& file)
{
  std::ofstream out(file);
  for(const Polygon& f : facets)
  {
    const double x = f.center_x(), y = f.center_y();
    if((std::max)(std::abs(x - window.x), std::abs(y - window.y)) > 0.6 * window.width)
      continue;
    for(const bool is_outline : { true, false })
    {
      const double scale = is_outline ? 1.02 : 0.92;
      const int color = is_outline ? 0x303030 : f.color;
      for(int k : { 0, 1, 2, 0 })
        out << x + scale * (f.x(k) - x) << ' ' << y + scale * (f.y(k) - y) << ' ' << color << '\n';
      out << '\n';
    }
  }
}

inline void write_histograms(const CGAL::Mesh_quality_report_3& before, const CGAL::Mesh_quality_report_3& after,
                             const std::string& file)
{
  std::ofstream out(file);
  for(std::size_t n = 0; n < before.angles.size(); n += 3)
    out << double(n) + 1.5 << ' ' << before.angles[n] + before.angles[n + 1] + before.angles[n + 2] << ' '
        << after.angles[n] + after.angles[n + 1] + after.angles[n + 2] << '\n';
  out << "\n\n";
  const std::size_t bins = before.radius_ratios.size();
  for(std::size_t n = 0; n < bins; ++n)
    out << (double(n) + 0.5) / double(bins) << ' ' << before.radius_ratios[n] << ' ' << after.radius_ratios[n] << '\n';
}

inline std::string title(const std::string& when, const CGAL::Mesh_quality_report_3& report)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(1) << when << ": angles "
      << report.smallest_angle << "° - " << report.largest_angle << std::setprecision(2) << "°, mean 3r/R "
      << report.mean_radius_ratio;
  return out.str();
}

// Begins the script prefix.gp for prefix.png, of several plots of what is in the window, which is so high relative to its width.
inline std::ofstream begin_script(const std::string& terminal, const std::string& prefix, const Window& w, double height = 1)
{
  std::ofstream out(prefix + ".gp");
  out << "set terminal pngcairo " << terminal << '\n'
      << "set output '" << prefix << ".png'\n"
      << "set multiplot\n"
      << "unset key; unset border; unset tics; set style fill solid 1 noborder\n"
      << "set xrange [" << w.x - w.width / 2 << ':' << w.x + w.width / 2 << "]\n"
      << "set yrange [" << w.y - w.width * height / 2 << ':' << w.y + w.width * height / 2 << "]\n";
  return out;
}

// The command that plots a file of write_facets().
inline std::string plot_facets(const std::string& file)
{
  return "plot '" + file + "' using 1:2:3 with filledcurves closed lc rgb variable\n";
}

inline void write_script(const CGAL::Mesh_quality_report_3& before, const CGAL::Mesh_quality_report_3& after,
                         const Window& w, const std::string& prefix)
{
  std::ofstream out = begin_script("size 1000,838 font 'sans,12'", prefix, w);
  out << "set tmargin at screen 0.965; set bmargin at screen 0.40\n"
      << "set lmargin at screen 0.005; set rmargin at screen 0.485\n"
      << "set title '" << title("before", before) << "' offset 0,-0.5\n"
      << plot_facets(prefix + "_before.dat")
      << "set lmargin at screen 0.515; set rmargin at screen 0.995\n"
      << "set title '" << title("after", after) << "'\n"
      << plot_facets(prefix + "_after.dat")
      << "set border 1; set xtics nomirror out; set key top left; set yrange [0:*]; set style fill solid 0.35 noborder\n"
      << "set tmargin at screen 0.345; set bmargin at screen 0.04\n"
      << "set lmargin at screen 0.02; set rmargin at screen 0.475\n"
      << "set title 'dihedral angles, degrees'; set xrange [0:180]; set xtics 20\n"
      << "plot '" << prefix << ".dat' index 0 using 1:3 with boxes lc rgb '#3060c0' title 'after', "
      << "'' index 0 using 1:2 with histeps lw 2.5 lc rgb '#c03030' title 'before'\n"
      << "set lmargin at screen 0.525; set rmargin at screen 0.98\n"
      << "set title 'radius ratios 3r/R'; set xrange [0:1]; set xtics 0.2\n"
      << "plot '" << prefix << ".dat' index 1 using 1:3 with boxes lc rgb '#3060c0' title 'after', "
      << "'' index 1 using 1:2 with histeps lw 2.5 lc rgb '#c03030' title 'before'\n"
      << "unset multiplot\n";
}

// Calls gnuplot with the script prefix.gp, which makes prefix.png of the files named. These go, and so does the script, unless there is
// no gnuplot.
inline void draw(const std::string& prefix, std::vector<std::string> files)
{
  files.push_back(prefix + ".gp");
  const std::string command = "gnuplot '" + files.back() + "'";
  if(std::system(command.c_str()) != 0)
  {
    std::cout << "picture: run " << command << '\n';
    return;
  }
  for(const std::string& file : files)
    std::remove(file.c_str());
  std::cout << "picture: " << prefix << ".png\n";
}

} // namespace mesh_picture

// Draws prefix.png. The part of the mesh that is shown is as wide as said, relative to all of it.
template <class C3t3>
void draw_before_and_after(const C3t3& before, const C3t3& after, const std::string& prefix, double relative_width = 0.5)
{
  using namespace mesh_picture;
  const std::vector<Polygon> facets_before = Cutaway<C3t3>(before).visible_facets();
  const Window window = best_window(facets_before, relative_width);
  write_facets(facets_before, window, prefix + "_before.dat");
  write_facets(Cutaway<C3t3>(after).visible_facets(), window, prefix + "_after.dat");
  const auto report_before = CGAL::mesh_quality_report_3(before), report_after = CGAL::mesh_quality_report_3(after);
  write_histograms(report_before, report_after, prefix + ".dat");
  write_script(report_before, report_after, window, prefix);
  draw(prefix, { prefix + ".dat", prefix + "_before.dat", prefix + "_after.dat" });
}

// Draws prefix.png: the whole mesh on the left, and the mesh cut open on the right.
template <class C3t3>
void draw_whole_and_cut(const C3t3& c3t3, const std::string& prefix)
{
  using namespace mesh_picture;
  const std::vector<Polygon> whole = Cutaway<C3t3>(c3t3, false).visible_facets();
  const Window w = best_window(whole, 1);
  write_facets(whole, w, prefix + "_left.dat");
  write_facets(Cutaway<C3t3>(c3t3).visible_facets(), w, prefix + "_right.dat");
  std::ofstream out = begin_script("size 1600,800", prefix, w);
  out << "set tmargin at screen 1; set bmargin at screen 0\n"
      << "set lmargin at screen 0; set rmargin at screen 0.5\n"
      << plot_facets(prefix + "_left.dat")
      << "set lmargin at screen 0.5; set rmargin at screen 1\n"
      << plot_facets(prefix + "_right.dat")
      << "unset multiplot\n";
  out.close();
  draw(prefix, { prefix + "_left.dat", prefix + "_right.dat" });
}

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_MESH_PICTURE_H
