// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether topology and all else that is promised of the complex are kept, over seeds: sphere, elephant
// and fandisk at the size of CGAL's examples and at half of it, and the liver. Prints what is broken.
//
//   keep_topology [runs, default 300] [first seed, default 1]
//
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "benchmark_inputs.h"
#include "mesh_contract.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Random.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>

using namespace inputs;

struct Tally
{
  int runs = 0, broken = 0;
  double largest_drift = 0;
};

static std::map<std::string, Tally> tallies;

// The drift of the volume is told, not judged: the meshes of CGAL's examples are coarse. `tolerance`
// is how far from the surface its points may seem, over the size of the mesh.
template <class C3t3, class Domain>
void test(const std::string& name, const C3t3& input, const Domain& domain, unsigned int seed, double tolerance = 4e-3)
{
  const Mesh_contract<C3t3, Domain> contract(input, domain, name + ", seed " + std::to_string(seed));
  C3t3 c3t3(input);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = (seed % 2) * 4, params::random_seed(seed));
  const int before = check::failures();
  contract.check_moved(c3t3, tolerance);
  Tally& tally = tallies[name];
  ++tally.runs;
  tally.broken += check::failures() > before;
  const double drift = CGAL::mesh_quality_report_3(c3t3, { 10 }).total().volume
                       / CGAL::mesh_quality_report_3(input, { 10 }).total().volume - 1;
  tally.largest_drift = (std::max)(tally.largest_drift, std::abs(drift));
}

template <class C3t3, class Domain, class Criteria>
C3t3 mesh(const Domain& domain, const Criteria& criteria)
{
  return CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_exude(), params::no_perturb());
}

int main(int argc, char* argv[])
{
  const unsigned int runs = argc > 1 ? std::atoi(argv[1]) : 300, first_seed = argc > 2 ? std::atoi(argv[2]) : 1;
  typedef CGAL::Mesh_criteria_3<Labeled_triangulation> Labeled_criteria;
  typedef CGAL::Mesh_criteria_3<Polyhedral_triangulation> Polyhedral_criteria;
  const Polyhedron elephant = read_polyhedron(CGAL::data_file_path("meshes/elephant.off"));
  const Polyhedron fandisk = read_polyhedron(CGAL::data_file_path("meshes/fandisk.off"));
  const Polyhedral_domain elephant_domain(elephant);
  Polyhedral_domain fandisk_domain(fandisk);
  fandisk_domain.detect_features();
  CGAL::Image_3 image;
  if(!image.read(CGAL::data_file_path("images/liver.inr.gz").c_str()))
    return EXIT_FAILURE;

  for(unsigned int seed = first_seed; seed < first_seed + runs; ++seed)
  {
    std::mt19937 random(seed);
    CGAL::get_default_random() = CGAL::Random(seed);
    const double f = std::uniform_real_distribution<double>(0.95, 1.05)(random) * (seed % 7 < 3 ? 1 : 0.5);
    switch(seed % 7)
    {
    case 0:
    case 3:
    {
      const Labeled_domain domain = sphere_domain();
      test(seed % 7 == 0 ? "sphere" : "sphere, finer", mesh<Labeled_c3t3>(domain, Labeled_criteria(
        params::facet_angle = 30, params::facet_size = 0.1 * f, params::facet_distance = 0.025 * f,
        params::cell_radius_edge_ratio = 2, params::cell_size = 0.1 * f)), domain, seed);
      break;
    }
    case 1:
    case 4:
      test(seed % 7 == 1 ? "elephant" : "elephant, finer", mesh<Polyhedral_c3t3>(elephant_domain, Polyhedral_criteria(
        params::facet_angle = 25, params::facet_size = 0.15 * f, params::facet_distance = 0.008 * f,
        params::cell_radius_edge_ratio = 3)), elephant_domain, seed);
      break;
    case 2:
    case 5:
      test(seed % 7 == 2 ? "fandisk" : "fandisk, finer", mesh<Polyhedral_c3t3>(fandisk_domain, Polyhedral_criteria(
        params::edge_size = 0.025 * f, params::facet_angle = 25, params::facet_size = 0.05 * f,
        params::facet_distance = 0.005 * f, params::cell_radius_edge_ratio = 3, params::cell_size = 0.05 * f)),
        fandisk_domain, seed);
      break;
    default:
    {
      const Labeled_domain domain = image_domain(image);
      test("liver", mesh<Labeled_c3t3>(domain, Labeled_criteria(
        params::facet_angle = 30, params::facet_size = 12 * f, params::facet_distance = 8 * f,
        params::cell_radius_edge_ratio = 3, params::cell_size = 16 * f)), domain, seed,
        // The size of a voxel: segments that are shorter may miss a step of the surface.
        8e-3);
    }
    }
  }
  for(const auto& t : tallies)
    std::printf("%-16s %3d runs, %d broken, volume changed by at most %.3f %%\n", t.first.c_str(), t.second.runs,
                t.second.broken, 100 * t.second.largest_drift);
  return check::result();
}
