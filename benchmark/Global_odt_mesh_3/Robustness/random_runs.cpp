// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Random domains, criteria and parameters: no run may crash, hang, or break what is promised of the mesh. Each run is
// a process of its own, and is determined by its seed.
//
//   random_runs FILE [ours|cgal|both] [runs, default 1000] [first seed, default 1] [jobs, default 1]
//   random_runs --repeat SEED [ours|cgal]
//
// appends a line for each run to the file, and passes over seeds that are there already; then it prints what became of
// all runs in the file, as a table in Markdown. "both" does ours and then CGAL's, with a file for each, FILE.ours and FILE.cgal. The exit
// status says whether all of ours are well, or of CGAL's if these alone are wanted.
//
// Compiled with CGAL_CONCURRENT_MESH_3 and TBB, on triangulations for several threads. Meshes are made by one of them even
// so, since that repeats.
//
// Compiled with RANDOM_PERIODIC_RUNS, on periodic domains, for which CGAL's headers have to be configured otherwise.
//
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#ifdef RANDOM_PERIODIC_RUNS
#include "random_periodic_domains.h"
#else
#include "random_domains.h"
#endif

#include "Markdown_table.h"
#include "mesh_contract.h"
#include "odt_of_mesh_3.h"

#include <CGAL/Timer.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>
#include <CGAL/property_map.h>
#include <CGAL/refine_mesh_3.h>
#include <CGAL/version.h>

#ifdef CGAL_CONCURRENT_MESH_3
#include <tbb/task_arena.h>
#endif

#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace random_domains;

static const unsigned int most_seconds = 600;           // of CPU time; a run that takes longer hangs
static const unsigned int most_seconds_of_waiting = 3600;
static const unsigned int most_seconds_of_mesher = 60;  // to make the input
static const int exit_unmeshed = 3;
static const double most_of_layer_for_number = 1;
static const double most_of_layer = 0.3;                // by which volumes may change: meshes can be far from their domains

static constexpr bool is_parallel = std::is_same<Concurrency_tag, CGAL::Parallel_tag>::value;

// Of legal values: half of the runs are calls of the default kind.
struct Random_parameters
{
  double time_limit = 0, convergence = 0.02, freeze_bound = 0.01, sliver_bound = 0, surface_weight = 1.2;
  int max_iteration_number = 0, number_of_rounds = 4;
  bool do_freeze = true, optimize_boundary = true, do_remove_slivers = true, domain_is_thread_safe = false;
  bool do_insert_vertices = false, do_remove_vertices = false;
  double number_of_vertices = 0;      // over that of the input, if any is wanted
  bool keeps_vertices = false, keeps_cells = false;     // some of them
  long callback_stops_after = -1, callback_throws_after = -1;
  unsigned int random_seed = 0;

  explicit Random_parameters(Draw& draw)
  {
    random_seed = static_cast<unsigned int>(draw.integer(0, 1000000));
    do_insert_vertices = random_seed % 2 == 0;
    do_remove_vertices = random_seed / 2 % 2 == 0;
    if(random_seed % 8 == 0)
      number_of_vertices = 0.25 * (1 + random_seed / 8 % 12);
    keeps_vertices = random_seed % 16 == 3 || random_seed % 16 == 6;
    keeps_cells = random_seed % 16 == 11;
    if(is_parallel)
      domain_is_thread_safe = draw.chance(0.5);
    if(draw.chance(0.5))
      return;
    time_limit = draw.chance(0.3) ? draw.power(1e-3, 1) : 0;
    convergence = draw.chance(0.3) ? draw.uniform(0, 1) : 0.02;
    freeze_bound = draw.chance(0.3) ? draw.uniform(0, 1) : 0.01;
    sliver_bound = draw.chance(0.3) ? draw.uniform(0, 70) : 0;
    surface_weight = draw.chance(0.3) ? draw.power(1e-3, 100) : 1.2;
    max_iteration_number = draw.chance(0.3) ? draw.integer(1, 300) : 0;
    number_of_rounds = draw.integer(0, 4);
    do_freeze = draw.chance(0.7);
    optimize_boundary = draw.chance(0.8);
    do_remove_slivers = draw.chance(0.8);
    if(draw.chance(0.2))
      (draw.chance(0.5) ? callback_stops_after : callback_throws_after) = draw.integer(0, 100);
  }

  // The number of vertices, or that of the input if any is wanted.
  double wanted_number(std::size_t before) const
  { return number_of_vertices > 0 ? std::ceil(number_of_vertices * double(before)) : double(before); }

  friend std::ostream& operator<<(std::ostream& out, const Random_parameters& p)
  {
    return out << "time_limit " << p.time_limit << ", convergence " << p.convergence << ", freeze_bound " << p.freeze_bound
               << ", sliver_bound " << p.sliver_bound << ", surface_weight " << p.surface_weight << ", max_iteration_number "
               << p.max_iteration_number << ", number_of_rounds " << p.number_of_rounds << ", do_freeze " << p.do_freeze
               << ", optimize_boundary " << p.optimize_boundary << ", do_remove_slivers " << p.do_remove_slivers
               << ", do_insert_vertices " << p.do_insert_vertices << ", do_remove_vertices " << p.do_remove_vertices
               << ", number_of_vertices times " << p.number_of_vertices
               << ", keeps_vertices " << p.keeps_vertices << ", keeps_cells " << p.keeps_cells
               << ", domain_is_thread_safe " << p.domain_is_thread_safe
               << ", callback stops, throws after " << p.callback_stops_after << ", " << p.callback_throws_after
               << ", random_seed " << p.random_seed;
  }
};

// Vertices or cells of a mesh, in every other of ten layers, that are to stay.
template <class C3t3>
class What_stays
{
  typedef typename C3t3::Vertex_handle Vertex_handle;
  typedef typename C3t3::Cell_handle Cell_handle;

public:
  std::set<Vertex_handle> vertices;
  std::set<Cell_handle> selected_cells;         // all the others

  What_stays(const C3t3& c3t3, const Random_parameters& p)
  {
    const CGAL::Bbox_3 b = c3t3.bbox();
    const auto stays = [&](Vertex_handle v) { return static_cast<long>(std::floor(10 * (v->point().z() - b.zmin()) / b.z_span())) % 2 == 0; };
    for(auto v = c3t3.triangulation().finite_vertices_begin(); p.keeps_vertices && v != c3t3.triangulation().finite_vertices_end(); ++v)
      if(stays(v))
        keep(v);
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
      if(!p.keeps_cells || !stays(c->vertex(0)))
        selected_cells.insert(c);
      else
      {
        cells_.push_back({ {{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }}, c->subdomain_index() });
        for(Vertex_handle v : cells_.back().vertices)
          keep(v);
      }
  }

  void check(const C3t3& c3t3) const
  {
    std::size_t lost = 0;
    for(const auto& v : places_)
      lost += v.first->point() != v.second;
    for(const Cell& cell : cells_)
    {
      Cell_handle c;
      const auto& v = cell.vertices;
      lost += !c3t3.triangulation().is_cell(v[0], v[1], v[2], v[3], c) || c->subdomain_index() != cell.subdomain;
    }
    check::that(lost == 0, lost, " vertices and cells that were to stay have not");
  }

private:
  struct Cell
  {
    std::array<Vertex_handle, 4> vertices;
    typename C3t3::Subdomain_index subdomain;
  };

  void keep(Vertex_handle v)
  {
    vertices.insert(v);
    places_.emplace_back(v, v->point());
  }

  std::vector<std::pair<Vertex_handle, typename C3t3::Triangulation::Weighted_point> > places_;
  std::vector<Cell> cells_;
};

template <class C3t3, class Domain, class... Others>
void optimize(C3t3& c3t3, const Domain& domain, const Random_parameters& p, const Others&... others)
{
  long calls = 0;
  const auto callback = [&](double)
  {
    if(p.callback_throws_after >= 0 && calls >= p.callback_throws_after)
      throw Planned_failure();
    return p.callback_stops_after < 0 || calls++ < p.callback_stops_after;
  };
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::time_limit = p.time_limit, params::convergence = p.convergence,
                            params::freeze_bound = p.freeze_bound, params::max_iteration_number = p.max_iteration_number,
                            params::do_freeze = p.do_freeze, params::sliver_bound = p.sliver_bound,
                            params::surface_weight = p.surface_weight, params::number_of_rounds = p.number_of_rounds,
                            params::optimize_boundary = p.optimize_boundary, params::do_remove_slivers = p.do_remove_slivers,
                            params::callback(callback), params::random_seed(p.random_seed), others...);
}

// With what there is not for periodic meshes.
template <class C3t3, class Domain>
void optimize(C3t3& c3t3, const Domain& domain, const Random_parameters& p, const What_stays<C3t3>& stays)
{
  const auto optimize = [&](const auto&... others)
  {
    ::optimize(c3t3, domain, p, params::do_insert_vertices = p.do_insert_vertices, params::do_remove_vertices = p.do_remove_vertices,
               params::domain_is_thread_safe(p.domain_is_thread_safe), others...);
  };
  if(p.number_of_vertices > 0)
    optimize(params::number_of_vertices = p.wanted_number(c3t3.triangulation().number_of_vertices()));
  else if(p.keeps_vertices)
    optimize(params::vertex_is_constrained_map(CGAL::Boolean_property_map<const std::set<typename C3t3::Vertex_handle> >(stays.vertices)));
  else if(p.keeps_cells)
    optimize(params::cell_is_selected_map(CGAL::Boolean_property_map<const std::set<typename C3t3::Cell_handle> >(stays.selected_cells)));
  else
    optimize();
}

// With CGAL's functions, threads make another mesh each time.
template <class F>
void on_one_thread(const F& f)
{
#ifdef CGAL_CONCURRENT_MESH_3
  tbb::task_arena(1).execute(f);
#else
  f();
#endif
}

// What users call next has to find a mesh that it can go on with.
template <class C3t3, class Domain, class Criteria>
void go_on(C3t3& c3t3, const Domain& domain, const Criteria& criteria, Draw& draw)
{
  switch(draw.integer(0, 5))
  {
  case 0: CGAL::refine_mesh_3(c3t3, domain, criteria, params::no_exude(), params::no_perturb()); break;
  case 1: CGAL::perturb_mesh_3(c3t3, domain, params::time_limit = 2); break;
  case 2: CGAL::exude_mesh_3(c3t3, params::time_limit = 2); break;
  default: return;
  }
  check::that(c3t3.triangulation().is_valid(), "not a valid triangulation after what followed");
}

// Of one run.
struct Outcome
{
  std::string what;
  std::size_t vertices = 0;
  double seconds = 0;      // of CPU time
};

// The signal SIGPROF comes when the process has used so much CPU time from now.
static void limit_cpu_time(unsigned int seconds)
{
  itimerval timer = {};
  timer.it_value.tv_sec = seconds;
  setitimer(ITIMER_PROF, &timer, nullptr);
}

// What is no domain that CGAL meshes is no run: the process ends.
template <class Input>
typename Input::C3t3 mesh_in_time(Input& input)
{
  std::signal(SIGPROF, [](int) { _exit(exit_unmeshed); });
  limit_cpu_time(most_seconds_of_mesher);
  typename Input::C3t3 c3t3;
  on_one_thread([&] { c3t3 = input.mesh(); });
  std::signal(SIGPROF, SIG_DFL);
  limit_cpu_time(most_seconds);
  alarm(most_seconds_of_waiting);
  return c3t3;
}

// Whether the call throws, as it may if the domain or the callback does.
template <class Input, class F>
bool throws(Input& input, Draw& draw, Outcome& outcome, const F& call)
{
  input.fail_sometimes(draw);
  bool has_thrown = false;
  CGAL::Timer timer;
  timer.start();
  try
  {
    call();
  }
  catch(const Planned_failure&)
  {
    has_thrown = true;
  }
  timer.stop();
  outcome.seconds = timer.time();
  input.stop_failing();
  return has_thrown;
}

template <class Input>
void run(Input& input, const std::string& method, Draw& draw, Outcome& outcome)
{
  auto c3t3 = mesh_in_time(input);
  Mesh_contract<typename Input::C3t3, typename Input::Domain> contract(c3t3, input.domain, input.name);
  outcome.vertices = c3t3.triangulation().number_of_vertices();
  const Random_parameters parameters(draw);
  if(method != "cgal")
    contract.permit(parameters.do_insert_vertices, parameters.do_remove_vertices,
                    double(outcome.vertices) / parameters.wanted_number(outcome.vertices));
  std::cerr << input.name << ", " << outcome.vertices << " vertices: " << parameters << std::endl;
  const What_stays<typename Input::C3t3> stays(c3t3, parameters);
  const bool has_thrown = throws(input, draw, outcome, [&]
  {
    if(method == "cgal")
      odt_of_mesh_3(c3t3, input.domain);
    else
      optimize(c3t3, input.domain, parameters, stays);
  });
  if(method != "cgal")
    stays.check(c3t3);
  if(has_thrown)
    contract.check_untouched(c3t3);
  else if(method != "cgal" && !parameters.optimize_boundary)
    contract.check(c3t3);
  else
    contract.check_moved(c3t3, input.tolerance, 0, parameters.number_of_vertices > 0 ? most_of_layer_for_number : most_of_layer);
  if(!has_thrown)
    on_one_thread([&] { go_on(c3t3, input.domain, input.criteria(), draw); });
}

#ifdef RANDOM_PERIODIC_RUNS
static void run(Periodic_input& input, const std::string& method, Draw& draw, Outcome& outcome)
{
  periodic::C3t3 c3t3 = mesh_in_time(input);
  const periodic::State<periodic::C3t3> before(c3t3);
  const bool is_of_domain = periodic::number_of_wrong_cells(c3t3, input.domain) == 0;
  outcome.vertices = before.vertices.size();
  const Random_parameters parameters(draw);
  std::cerr << input.name << ", " << outcome.vertices << " vertices: " << parameters << std::endl;
  const bool has_thrown = throws(input, draw, outcome, [&]
  {
    if(method == "cgal")
      odt_of_mesh_3(c3t3, input.domain);
    else
      optimize(c3t3, input.domain, parameters);
  });
  if(has_thrown)
    check::that(c3t3.triangulation().is_valid() && periodic::State<periodic::C3t3>(c3t3) == before, input.name, ": the mesh was touched");
  else
    periodic::check_contract(before, c3t3, input.domain, input.name, parameters.do_remove_slivers ? 30 : 0, is_of_domain);
}
#endif

static Outcome run(unsigned int seed, const std::string& method)
{
  Draw draw(seed);
  Outcome outcome;
  with_random_input(draw, [&](auto& input)
  {
    outcome.what = input.name;
    run(input, method, draw, outcome);
  });
  return outcome;
}

// Of a child process, whose complaints go to a file beside the other.
static int run_and_tell(const std::string& file, unsigned int seed, const std::string& method)
{
  const std::string complaints = file + "." + std::to_string(seed);
  if(std::freopen(complaints.c_str(), "w", stderr) == nullptr)
    return EXIT_FAILURE;
  std::setvbuf(stderr, nullptr, _IONBF, 0);             // what terminates the process is to be read there, too
  const Outcome outcome = run(seed, method);
  if(check::failures() > 0)
    return EXIT_FAILURE;
  std::remove(complaints.c_str());
  std::ostringstream line;
  line << seed << " well " << outcome.vertices << " " << outcome.seconds << " " << outcome.what << "\n";
  std::ofstream(file, std::ios::app) << line.str() << std::flush;
  return EXIT_SUCCESS;
}

// The seeds that have been, and how those runs ended.
static std::map<unsigned int, std::string> read(const std::string& file)
{
  std::map<unsigned int, std::string> ends;
  std::ifstream in(file);
  unsigned int seed;
  std::string end, rest;
  while(in >> seed >> end && std::getline(in, rest))
    ends[seed] = end;
  return ends;
}

static void wait_for_one(const std::string& file, std::map<pid_t, unsigned int>& running)
{
  int status = 0;
  const pid_t child = wait(&status);
  const auto it = running.find(child);
  if(it == running.end())
    return;
  const bool hangs = WIFSIGNALED(status) && (WTERMSIG(status) == SIGPROF || WTERMSIG(status) == SIGALRM);
  const bool is_unmeshed = WIFEXITED(status) && WEXITSTATUS(status) == exit_unmeshed;
  const std::string end = hangs ? "hangs" : WIFSIGNALED(status) ? "crashes" : is_unmeshed ? "unmeshed"
                        : WEXITSTATUS(status) != 0 ? "breaks" : "";
  if(!end.empty())
    std::ofstream(file, std::ios::app) << it->second << " " << end << " random_runs --repeat " << it->second << std::endl;
  running.erase(it);
}

static void run_all(const std::string& file, const std::string& method, unsigned int runs, unsigned int first_seed,
                    std::size_t jobs)
{
  const std::map<unsigned int, std::string> before = read(file);
  std::map<pid_t, unsigned int> running;
  for(unsigned int seed = first_seed; seed < first_seed + runs; ++seed)
  {
    if(before.count(seed) > 0)
      continue;
    while(running.size() >= jobs)
      wait_for_one(file, running);
    std::cout.flush();
    const pid_t child = fork();
    if(child == 0)
      _exit(run_and_tell(file, seed, method));
    if(child > 0)
      running[child] = seed;
  }
  while(!running.empty())
    wait_for_one(file, running);
}

int main(int argc, char* argv[])
{
  if(argc < 2)
  {
    std::cerr << "usage: " << argv[0] << " FILE [ours|cgal|both] [runs] [first seed] [jobs], or --repeat SEED [ours|cgal]"
              << std::endl;
    return EXIT_FAILURE;
  }
  const std::string file = argv[1];
  if(file == "--repeat" && argc > 2)
  {
    const Outcome outcome = run(static_cast<unsigned int>(std::atol(argv[2])), argc > 3 ? argv[3] : "ours");
    std::cout << outcome.what << ", " << outcome.vertices << " vertices, " << outcome.seconds << " s" << std::endl;
    return check::result();
  }
  const std::string method = argc > 2 ? argv[2] : "ours";
  const bool both = method == "both";
  Markdown_table table({ "CGAL", "method" }, { { "runs", 0, Better::NEITHER }, { "well", 0, Better::NEITHER },
                                               { "crash", 0, Better::NEITHER }, { "longer than ten minutes", 0, Better::NEITHER },
                                               { "break a guarantee", 0, Better::NEITHER },
                                               { "not meshed by CGAL within a minute", 0, Better::NEITHER } });
  int failures = 0;
  for(const std::string& m : both ? std::vector<std::string>{ "ours", "cgal" } : std::vector<std::string>{ method })
  {
    const std::string file_of_method = both ? file + "." + m : file;
    run_all(file_of_method, m, argc > 3 ? std::atoi(argv[3]) : 1000, argc > 4 ? std::atoi(argv[4]) : 1,
            argc > 5 ? std::atoi(argv[5]) : 1);
    std::map<std::string, int> tally;
    for(const auto& e : read(file_of_method))
      ++tally[e.second];
    std::vector<double> values = { 0 };
    for(const char* end : { "well", "crashes", "hangs", "breaks", "unmeshed" })
    {
      values.push_back(tally[end]);
      values[0] += values.back();
    }
    table.add({ CGAL_VERSION_STR, m == "cgal" ? "CGAL's odt" : "this package" }, values);
    if(m == "ours" || !both)
      failures += tally["crashes"] + tally["hangs"] + tally["breaks"];
  }
  std::cout << table;
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
