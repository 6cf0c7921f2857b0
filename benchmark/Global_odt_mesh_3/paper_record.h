// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_PAPER_RECORD_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_PAPER_RECORD_H

#include <CGAL/Mesh_quality_report_3.h>

#include <array>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

// The text that printf() would print.
inline std::string text(const char* format, ...)
{
  char buffer[400];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

inline std::string percent(double x) { return text("%+.2f %%", x); }

// What a program shows of the paper: rows beside those printed there, whether what the paper claims holds, and pictures.
// With a directory, rows go to rows.md there, and data and scripts of pictures, which gnuplot draws if there is one, to
// files of their own; without one, rows are only printed.
class Paper_record
{
public:
  explicit Paper_record(std::string directory) : directory_(std::move(directory)) {}

  bool has_directory() const { return !directory_.empty(); }

  // "-": the paper does not say.
  void row(const std::string& figure, const std::string& what, const std::string& paper, const std::string& here)
  {
    std::cerr << figure << ", " << what << ": paper " << paper << ", here " << here << std::endl;
    if(has_directory())
      std::ofstream(directory_ + "/rows.md", std::ios::app)
        << "| " << figure << " | " << what << " | " << paper << " | " << here << " |\n";
  }

  // What is said of one thing, the paper's number, and that measured here.
  typedef std::array<std::string, 3> Number;

  // A row for each.
  void rows(const std::string& figure, const std::string& name, const std::vector<Number>& numbers)
  {
    for(const Number& n : numbers)
      row(figure, name + ": " + n[0], n[1], n[2]);
  }

  // One that the exit status of the program depends on.
  void claim(const std::string& figure, bool holds, const std::string& what)
  {
    number_of_failures_ += !holds;
    row(figure, what, "yes", holds ? "yes" : "**no**");
  }

  int result() const { return number_of_failures_ == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

  // A data file for gnuplot, empty lines ending a block.
  std::ofstream data(const std::string& name) const { return std::ofstream(directory_ + "/" + name + ".dat"); }

  // The command that plots these columns of the first blocks of a data file.
  static std::string plot(const std::string& columns, const std::vector<std::string>& titles, const std::string& style = "lines lw 2")
  {
    std::string command;
    for(std::size_t n = 0; n < titles.size(); ++n)
      command += (n == 0 ? "plot " : ", ") + text("data index %zu using ", n) + columns + " with " + style + " title \"" + titles[n]
                 + "\"";
    return command + "\n";
  }

  // Draws `name`.png by these commands, after which `name`.dat is called `data`.
  void draw(const std::string& name, const std::string& commands, int width = 1200, int height = 480) const
  {
    if(!has_directory())
      return;
    const std::string script = directory_ + "/" + name + ".gp";
    std::ofstream(script) << "set terminal pngcairo noenhanced size " << width << "," << height << " font 'sans,12'\n"
                          << "set output '" << directory_ << "/" << name << ".png'\n"
                          << "data = '" << directory_ << "/" << name << ".dat'\n" << commands;
    if(std::system(("gnuplot '" + script + "'").c_str()) != 0)
      std::cerr << "there is no picture " << name << ".png" << std::endl;
  }

  // Calls draw(file), where `file` is that of the picture without its ending.
  template <class Draw>
  void draw_cutaways(const std::string& name, const Draw& draw) const
  {
    if(has_directory())
      draw(directory_ + "/" + name);
  }

  // Histograms of dihedral angles and radius ratios. The curves leave room for the key on the left of the latter.
  void draw_histograms(const std::string& name,
                       const std::vector<std::pair<std::string, CGAL::Mesh_quality_report_3> >& meshes) const
  {
    if(!has_directory())
      return;
    std::vector<std::string> titles;
    std::ofstream angles = data(name + "_angles"), ratios = data(name);
    for(const auto& m : meshes)
    {
      const CGAL::Mesh_quality_report_3& r = m.second;
      titles.push_back(m.first);
      for(std::size_t n = 0; n + 2 < r.angles.size(); n += 3)
        angles << double(n) + 1.5 << ' '
               << double(r.angles[n] + r.angles[n + 1] + r.angles[n + 2]) / 6 / double(r.number_of_cells) << '\n';
      for(std::size_t n = 0; n < r.radius_ratios.size(); ++n)
        ratios << (double(n) + 0.5) / double(r.radius_ratios.size()) << ' '
               << double(r.radius_ratios[n]) / double(r.number_of_cells) << '\n';
      angles << "\n\n";
      ratios << "\n\n";
    }
    angles.close();
    ratios.close();
    const std::string plots = plot("1:2", titles, "histeps lw 2");
    draw(name, "set multiplot layout 1,2\nset key top left\nset yrange [0:*]\nset title 'radius ratios 3r/R'\nset xrange [0:1]\n" + plots
               + "data = '" + directory_ + "/" + name + "_angles.dat'\nunset key\nset title 'dihedral angles'\nset xrange [0:180]\n" + plots
               + "unset multiplot\n");
  }

private:
  std::string directory_;
  int number_of_failures_ = 0;
};

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_PAPER_RECORD_H
