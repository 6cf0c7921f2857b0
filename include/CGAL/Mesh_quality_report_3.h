// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_MESH_QUALITY_REPORT_3_H
#define CGAL_MESH_QUALITY_REPORT_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/Global_odt_mesh_3/internal/door/Index_table.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iomanip>
#include <map>
#include <numeric>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Quality

The class `Mesh_quality_report_3` holds measures of the shape of the cells and facets of a mesh complex. It is
filled by `mesh_quality_report_3()` and printed as a table by `operator<<`. The radius ratio of a cell is three times its
inradius over its circumradius, 3r/R.

\sa `mesh_quality_report_3()`
*/
struct Mesh_quality_report_3
{
  /// is the part of a mesh in one subdomain.
  struct Subdomain
  {
    std::size_t number_of_cells = 0;   ///< the number of cells
    double volume = 0;                 ///< the sum of the volumes of the cells
    /// the ODT energy of uniform density, \f$ \sum |\tau|/20 \sum_{i<j} l_{ij}^2 \f$ (equation (2.1) of
    /// \cgalCite{cgal:cwlls-rodt-14})
    double energy = 0;
  };

  static constexpr int number_of_angle_bins = 180;        ///< the number of bins of `angles`, of one degree each
  static constexpr int number_of_radius_ratio_bins = 50;  ///< the number of bins of `radius_ratios`, of 0.02 each
  static constexpr int number_of_facet_angle_bins = 60;   ///< the number of bins of `facet_angles`, of one degree each

  std::size_t number_of_vertices = 0;    ///< the number of vertices of the triangulation
  std::size_t number_of_cells = 0;       ///< the number of cells in the complex
  std::size_t number_of_facets = 0;      ///< the number of facets in the complex
  double smallest_angle = 180;           ///< the smallest dihedral angle, in degrees
  double largest_angle = 0;              ///< the largest dihedral angle, in degrees
  double mean_radius_ratio = 0;          ///< the mean of 3r/R, which is 1 for the regular tetrahedron
  double smallest_radius_ratio = 1;      ///< the smallest 3r/R
  std::array<std::size_t, number_of_angle_bins> angles{};               ///< the histogram of dihedral angles, six a cell
  std::array<std::size_t, number_of_radius_ratio_bins> radius_ratios{}; ///< the histogram of radius ratios
  double smallest_facet_angle = 60;      ///< the smallest of the facets' smallest angles, in degrees
  double largest_facet_angle = 0;        ///< the largest of the facets' smallest angles, 60 for the equilateral triangle
  double mean_facet_angle = 0;           ///< the mean of the facets' smallest angles
  std::array<std::size_t, number_of_facet_angle_bins> facet_angles{};   ///< the histogram of the facets' smallest angles
  /// for each bound in degrees, the number of cells with a smaller angle
  std::vector<std::pair<double, std::size_t> > cells_below;
  /// for each bound, the number of those cells that have such an angle between two facets of the complex: the boundary itself is
  /// sharper than the bound there, and no vertex off the boundary can change that
  std::vector<std::pair<double, std::size_t> > cells_below_at_boundary;
  /// the subdomains, by their indices as they are printed: for example `2`, and `2 (2)` for another index that is printed in the
  /// same way. Indices that cannot be printed are numbered from 1 on
  std::map<std::string, Subdomain> subdomains;
  /// the numbers of cells and facets that the criteria of the mesh generator call bad, if criteria are given
  std::optional<std::pair<std::size_t, std::size_t> > bad_cells_and_facets;
  /// the numbers of cells that violate each of the criteria for cells that are set. `Mesh_cell_criteria_3` has the size
  /// and the radius-edge ratio, in this order. A cell counts for the first criterion that it violates
  std::vector<std::size_t> bad_cells_by_criterion;
  /// the same for facets. `Mesh_facet_criteria_3` has the angle, the size, the distance, and the topology, as far as these are set
  std::vector<std::size_t> bad_facets_by_criterion;

  /// returns the sum over all subdomains.
  Subdomain total() const
  {
    Subdomain sum;
    for(const auto& s : subdomains)
    {
      sum.number_of_cells += s.second.number_of_cells;
      sum.volume += s.second.volume;
      sum.energy += s.second.energy;
    }
    return sum;
  }
};

namespace Global_odt_mesh_3::internal {

inline std::size_t bin(double value, int number_of_bins)
{
  return static_cast<std::size_t>((std::min)(static_cast<int>(value), number_of_bins - 1));
}

// The smallest angle between two facets of the cell that are in the complex, or 180 degrees.
template <class C3T3>
double angle_between_facets(const C3T3& c3t3, typename C3T3::Cell_handle c, const Cell_shape_3& shape)
{
  double smallest = 180;
  for(int i = 0, n = 0; i < 3; ++i)
    for(int j = i + 1; j < 4; ++j, ++n)
      if(c3t3.is_in_complex(c, i) && c3t3.is_in_complex(c, j))
        smallest = (std::min)(smallest, shape.angles[static_cast<std::size_t>(n)]);
  return smallest;
}

inline void add_shape(Mesh_quality_report_3& report, const Cell_shape_3& shape, double sharpest_edge)
{
  const auto extremes = std::minmax_element(shape.angles.begin(), shape.angles.end());
  report.smallest_angle = (std::min)(report.smallest_angle, *extremes.first);
  report.largest_angle = (std::max)(report.largest_angle, *extremes.second);
  for(std::size_t n = 0; n < report.cells_below.size(); ++n)
  {
    report.cells_below[n].second += *extremes.first < report.cells_below[n].first;
    report.cells_below_at_boundary[n].second += sharpest_edge < report.cells_below_at_boundary[n].first;
  }
  for(double a : shape.angles)
    ++report.angles[bin(a, Mesh_quality_report_3::number_of_angle_bins)];
  report.smallest_radius_ratio = (std::min)(report.smallest_radius_ratio, shape.radius_ratio);
  const int bins = Mesh_quality_report_3::number_of_radius_ratio_bins;
  ++report.radius_ratios[bin(shape.radius_ratio * bins, bins)];
}

template <class C3T3>
void add_facets(Mesh_quality_report_3& report, const C3T3& c3t3)
{
  double sum = 0;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
  {
    std::array<Site, 3> s;
    for(int k = 0; k < 3; ++k)
      s[static_cast<std::size_t>(k)] = weighted_site(c3t3.triangulation().point(f->first, (f->second + 1 + k) % 4));
    const double angle = smallest_angle_of_facet(s);
    report.smallest_facet_angle = (std::min)(report.smallest_facet_angle, angle);
    report.largest_facet_angle = (std::max)(report.largest_facet_angle, angle);
    ++report.facet_angles[bin(angle, Mesh_quality_report_3::number_of_facet_angle_bins)];
    sum += angle;
    ++report.number_of_facets;
  }
  if(report.number_of_facets > 0)
    report.mean_facet_angle = sum / double(report.number_of_facets);
}

// Returns the number of the criterion that calls a cell or a facet bad, or 0 if the criteria do not tell it.
template <class Is_bad>
std::size_t violated_criterion(const Is_bad& is_bad) { return static_cast<std::size_t>(is_bad->first); }
inline std::size_t violated_criterion(bool) { return 0; }

template <class Is_bad>
void count_violation(const Is_bad& is_bad, std::vector<std::size_t>& by_criterion)
{
  if(!is_bad)
    return;
  const std::size_t n = violated_criterion(is_bad);
  by_criterion.resize((std::max)(by_criterion.size(), n + 1));
  ++by_criterion[n];
}

inline std::string printed_violations(const char* of, const std::vector<std::size_t>& by_criterion)
{
  std::ostringstream s;
  s << std::accumulate(by_criterion.begin(), by_criterion.end(), std::size_t(0)) << ' ' << of;
  for(std::size_t n = 0; by_criterion.size() > 1 && n < by_criterion.size(); ++n)
    s << (n == 0 ? " (" : " + ") << by_criterion[n] << (n + 1 == by_criterion.size() ? ")" : "");
  return s.str();
}

template <class T, class = void>
struct Is_printable : std::false_type {};

template <class T>
struct Is_printable<T, std::void_t<decltype(std::declval<std::ostream&>() << std::declval<const T&>())> > : std::true_type {};

// Prints the n-th index. Concepts do not require that this is possible; otherwise it is the number.
template <class Index>
std::string printed(const Index& index, std::size_t n)
{
  std::ostringstream s;
  if constexpr (Is_printable<Index>::value)
    s << index;
  else
    s << n + 1;
  return s.str();
}

// Different indices may be printed in the same way.
inline void add_subdomain(Mesh_quality_report_3& report, const std::string& name, const Mesh_quality_report_3::Subdomain& subdomain)
{
  std::string other = name;
  for(int n = 2; !report.subdomains.emplace(other, subdomain).second; ++n)
    other = name + " (" + std::to_string(n) + ")";
}

} // namespace Global_odt_mesh_3::internal

/*!
\ingroup PkgGlobalOdtMesh3Quality

measures the cells and facets of a mesh complex.

\tparam C3T3 a model of `MeshComplex_3InTriangulation_3`

\param c3t3 the mesh
\param bounds angles in degrees: cells with a smaller dihedral angle are counted for each

\sa `odt_energy_3()`
*/
template <class C3T3>
Mesh_quality_report_3 mesh_quality_report_3(const C3T3& c3t3,
                                            const std::vector<double>& bounds = { 5, 10, 15, 20, 30 })
{
  namespace odt = Global_odt_mesh_3::internal;
  typedef Mesh_quality_report_3 Report;
  Report report;
  report.number_of_vertices = c3t3.triangulation().number_of_vertices();
  odt::add_facets(report, c3t3);
  for(double b : bounds)
    report.cells_below.emplace_back(b, 0);
  report.cells_below_at_boundary = report.cells_below;
  double sum = 0;
  odt::Index_table<typename C3T3::Subdomain_index> indices;
  std::vector<Report::Subdomain> subdomains;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    std::array<odt::Site, 4> s;
    for(int i = 0; i < 4; ++i)
      s[static_cast<std::size_t>(i)] = odt::weighted_site(c3t3.triangulation().point(c, i));
    const odt::Cell_shape_3 shape(s[0], s[1], s[2], s[3]);
    odt::add_shape(report, shape, odt::angle_between_facets(c3t3, c, shape));
    sum += shape.radius_ratio;
    const odt::Cell_products t(s[0], s[1], s[2], s[3]);
    const auto n = static_cast<std::size_t>(indices.number(c3t3.subdomain_index(c)));
    subdomains.resize((std::max)(subdomains.size(), n + 1));
    Report::Subdomain& subdomain = subdomains[n];
    ++subdomain.number_of_cells;
    subdomain.volume += t.determinant / 6;
    subdomain.energy += odt::uniform_odt_energy(t, s[0], s[1], s[2], s[3]).energy;
    ++report.number_of_cells;
  }
  if(report.number_of_cells > 0)
    report.mean_radius_ratio = sum / double(report.number_of_cells);
  for(std::size_t n = 0; n < subdomains.size(); ++n)
    odt::add_subdomain(report, odt::printed(indices.value(static_cast<int>(n)), n), subdomains[n]);
  return report;
}

/*!
\ingroup PkgGlobalOdtMesh3Quality

measures the cells and facets of a mesh complex, and counts those that the mesh generator would refine.

\tparam C3T3 a model of `MeshComplex_3InTriangulation_3`
\tparam MeshCriteria a model of `MeshCriteria_3` for the triangulation of `C3T3`

\param c3t3 the mesh
\param criteria the criteria with which it was made
\param bounds angles in degrees: cells with a smaller dihedral angle are counted for each
*/
template <class C3T3, class MeshCriteria>
Mesh_quality_report_3 mesh_quality_report_3(const C3T3& c3t3, const MeshCriteria& criteria,
                                            const std::vector<double>& bounds = { 5, 10, 15, 20, 30 })
{
  Mesh_quality_report_3 report = mesh_quality_report_3(c3t3, bounds);
  namespace odt = Global_odt_mesh_3::internal;
  std::vector<std::size_t> &cells = report.bad_cells_by_criterion, &facets = report.bad_facets_by_criterion;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    odt::count_violation(criteria.cell_criteria_object()(c3t3.triangulation(), c), cells);
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    odt::count_violation(criteria.facet_criteria_object()(c3t3.triangulation(), *f), facets);
  report.bad_cells_and_facets = std::make_pair(std::accumulate(cells.begin(), cells.end(), std::size_t(0)),
                                               std::accumulate(facets.begin(), facets.end(), std::size_t(0)));
  return report;
}

/*!
\ingroup PkgGlobalOdtMesh3Quality

prints a report as a table with histograms, without facets if there are none.
*/
inline std::ostream& operator<<(std::ostream& out, const Mesh_quality_report_3& r)
{
  std::ostringstream s;   // leaves the format of `out` alone
  s << "vertices " << r.number_of_vertices << ", cells " << r.number_of_cells
    << ", facets of the complex " << r.number_of_facets << '\n'
    << std::fixed << std::setprecision(2)
    << "dihedral angles " << r.smallest_angle << " - " << r.largest_angle << " degrees\n"
    << std::setprecision(4)
    << "radius ratio 3r/R   mean " << r.mean_radius_ratio << ", smallest " << r.smallest_radius_ratio << '\n'
    << std::setprecision(2);
  if(r.number_of_facets > 0)
    s << "smallest angle of a facet " << r.smallest_facet_angle << " - " << r.largest_facet_angle << " degrees, mean "
      << r.mean_facet_angle << '\n';
  if(r.bad_cells_and_facets)
    s << "beyond the criteria " << Global_odt_mesh_3::internal::printed_violations("cells", r.bad_cells_by_criterion) << ", "
      << Global_odt_mesh_3::internal::printed_violations("facets", r.bad_facets_by_criterion) << '\n';
  s << "cells with an angle below" << std::defaultfloat << std::setprecision(6);
  const auto list = [&s](const std::vector<std::pair<double, std::size_t> >& numbers)
  {
    for(const auto& b : numbers)
      s << "  " << b.first << ": " << b.second;
    s << '\n';
  };
  list(r.cells_below);
  if(std::any_of(r.cells_below_at_boundary.begin(), r.cells_below_at_boundary.end(), [](const auto& b) { return b.second > 0; }))
  {
    s << "of these, between two facets of the complex";
    list(r.cells_below_at_boundary);
  }
  s << "subdomain        cells          volume      ODT energy\n";
  const auto row = [&s](const std::string& name, const Mesh_quality_report_3::Subdomain& d)
  {
    s << std::left << std::setw(10) << name << std::right << std::setw(12) << d.number_of_cells
      << std::setw(16) << d.volume << std::setw(16) << d.energy << '\n';
  };
  for(const auto& d : r.subdomains)
    row(d.first, d.second);
  if(r.subdomains.size() > 1)
    row("all", r.total());

  // Some bins are one row.
  const auto histogram = [&s](const char* title, const auto& bins, std::size_t bins_in_row, double width, int precision)
  {
    std::vector<std::size_t> rows(bins.size() / bins_in_row, 0);
    for(std::size_t n = 0; n < bins.size(); ++n)
      rows[n / bins_in_row] += bins[n];
    const std::size_t highest = *std::max_element(rows.begin(), rows.end());
    s << title << '\n';
    for(std::size_t n = 0; n < rows.size(); ++n)
    {
      const std::size_t bar = highest == 0 ? 0 : (rows[n] * 50 + highest - 1) / highest;
      s << std::fixed << std::setprecision(precision) << std::setw(7) << double(n) * width << " - "
        << std::setw(4) << double(n + 1) * width << std::setw(9) << rows[n] << ' ' << std::string(bar, '#') << '\n';
    }
  };
  histogram("dihedral angles, degrees", r.angles, 10, 10, 0);
  histogram("radius ratios", r.radius_ratios, 5, 0.1, 1);
  if(r.number_of_facets > 0)
    histogram("smallest angle of each facet, degrees", r.facet_angles, 5, 5, 0);
  return out << s.str();
}

} // namespace CGAL

#endif // CGAL_MESH_QUALITY_REPORT_3_H
