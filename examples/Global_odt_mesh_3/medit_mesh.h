// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_MEDIT_MESH_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_MEDIT_MESH_H

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <istream>
#include <iterator>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

// What a file of Medit in ASCII holds. Vertices and elements are numbered from 0, and in the file from 1.
struct Medit_mesh
{
  typedef long long Reference;

  template <std::size_t number_of_vertices>
  struct Element
  {
    std::array<int, number_of_vertices> vertices;
    Reference reference;
  };

  std::vector<std::array<double, 3> > points;
  std::vector<Reference> point_references;
  std::vector<Element<4> > tetrahedra;
  std::vector<Element<3> > triangles;
  std::vector<Element<2> > edges;
  std::vector<int> corners, required_vertices;    // numbers of vertices
  std::vector<int> ridges, required_edges;        // numbers of edges
  std::vector<int> required_triangles;            // numbers of triangles

  // Along with corners, and all that refers to edges.
  void clear_edges()
  {
    edges.clear();
    for(std::vector<int>* numbers : { &corners, &ridges, &required_edges })
      numbers->clear();
  }
};

// Reads a file, and throws std::runtime_error with one line that says what is wrong.
class Medit_reader
{
public:
  explicit Medit_reader(std::istream& in)
    : text_(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>())
  {}

  Medit_mesh operator()()
  {
    if(text_.find('\0') != std::string::npos)
      throw std::runtime_error("is a binary file; \"gmsh in.meshb -save -o out.mesh -format mesh\" makes one of text");
    if(!next() || keyword() != "meshversionformatted")
      throw std::runtime_error("does not begin with MeshVersionFormatted, as files of Medit do");
    section_ = word();
    integer();
    while(next() && keyword() != "end")
      read_section(keyword());
    check_vertices();
    if(mesh_.tetrahedra.empty())
      throw std::runtime_error("has no tetrahedra");
    check_elements(mesh_.tetrahedra, "tetrahedron");
    check_elements(mesh_.triangles, "triangle");
    check_elements(mesh_.edges, "edge");
    check_numbers(mesh_.corners, mesh_.points.size(), "Corners");
    check_numbers(mesh_.required_vertices, mesh_.points.size(), "RequiredVertices");
    check_numbers(mesh_.ridges, mesh_.edges.size(), "Ridges");
    check_numbers(mesh_.required_edges, mesh_.edges.size(), "RequiredEdges");
    check_numbers(mesh_.required_triangles, mesh_.triangles.size(), "RequiredTriangles");
    return std::move(mesh_);
  }

private:
  typedef Medit_mesh::Reference Reference;

  // Whether there is another word; comments are none.
  bool next()
  {
    begin_ = end_;
    while(begin_ < text_.size() && (std::isspace(byte(begin_)) || text_[begin_] == '#'))
      if(text_[begin_] == '#')
        begin_ = (std::min)(text_.find('\n', begin_), text_.size());
      else
        line_ += text_[begin_++] == '\n';
    end_ = begin_;
    while(end_ < text_.size() && !std::isspace(byte(end_)) && text_[end_] != '#')
      ++end_;
    return begin_ < end_;
  }

  unsigned char byte(std::size_t n) const { return static_cast<unsigned char>(text_[n]); }
  std::string word() const { return text_.substr(begin_, end_ - begin_); }

  std::string keyword() const
  {
    std::string s = word();
    std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return s;
  }

  [[noreturn]] void fail(const std::string& what) const
  { throw std::runtime_error("line " + std::to_string(line_) + ": " + what); }

  [[noreturn]] void fail_in_section(const std::string& kind) const
  {
    fail(section_ + ": " + (begin_ < end_ ? '"' + word().substr(0, 30) + "\" is " + kind : "the file ends")
         + (number_ < 0 ? "" : " (in entry " + std::to_string(number_ + 1) + " of " + std::to_string(count_) + ")"));
  }

  Reference integer()
  {
    constexpr Reference most = Reference(1) << 60;
    char* end = nullptr;
    const Reference n = next() ? std::strtoll(text_.c_str() + begin_, &end, 10) : 0;
    if(end != text_.c_str() + end_ || n > most || n < -most)
      fail_in_section("no number of this kind");
    return n;
  }

  double coordinate()
  {
    char* end = nullptr;
    const double x = next() ? std::strtod(text_.c_str() + begin_, &end) : 0;
    if(end != text_.c_str() + end_)
      fail_in_section("no number");
    // Beyond, products of coordinates overflow.
    constexpr double most = 1e50;
    if(!(std::abs(x) <= most))
      fail_in_section("no coordinate");
    return x;
  }

  // A number in the file, whose range is checked at the end.
  int index()
  {
    const Reference n = integer();
    if(n < 1 || n > 2000000000)
      fail_in_section("no number of this kind");
    return static_cast<int>(n - 1);
  }

  // Calls read() for each entry.
  template <class Read>
  void read_entries(const Read& read)
  {
    number_ = -1;
    count_ = integer();
    if(!read_sections_.insert(section_).second)
      fail("a second section " + section_);
    if(count_ < 0 || static_cast<unsigned long long>(count_) > text_.size())
      fail(section_ + " has " + std::to_string(count_) + " entries, which the file is too short for");
    for(number_ = 0; number_ < count_; ++number_)
      read();
    number_ = -1;
  }

  template <std::size_t n>
  void read_elements(std::vector<Medit_mesh::Element<n> >& elements)
  {
    read_entries([&]
    {
      Medit_mesh::Element<n> e;
      for(int& v : e.vertices)
        v = index();
      e.reference = integer();
      elements.push_back(e);
    });
  }

  void read_numbers(std::vector<int>& numbers) { read_entries([&] { numbers.push_back(index()); }); }

  void read_vertices()
  {
    read_entries([&]
    {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      mesh_.points.push_back({{ x, y, z }});
      mesh_.point_references.push_back(integer());
    });
  }

  void read_section(const std::string& name)
  {
    section_ = word();
    if(name == "dimension")
    {
      if(integer() != 3)
        fail("the dimension is not 3");
    }
    else if(name == "vertices")
      read_vertices();
    else if(name == "tetrahedra")
      read_elements(mesh_.tetrahedra);
    else if(name == "triangles")
      read_elements(mesh_.triangles);
    else if(name == "edges")
      read_elements(mesh_.edges);
    else if(name == "corners")
      read_numbers(mesh_.corners);
    else if(name == "ridges")
      read_numbers(mesh_.ridges);
    else if(name == "requiredvertices")
      read_numbers(mesh_.required_vertices);
    else if(name == "requirededges")
      read_numbers(mesh_.required_edges);
    else if(name == "requiredtriangles")
      read_numbers(mesh_.required_triangles);
    else
      skip_section(name);
  }

  // Up to the next keyword. What would be lost is refused.
  void skip_section(const std::string& name)
  {
    if(!std::isalpha(byte(begin_)))
      fail("\"" + word().substr(0, 30) + "\" where a section should begin");
    static const std::set<std::string> unsupported = { "hexahedra", "prisms", "pentahedra", "wedges", "pyramids",
                                                       "tetrahedrap2", "trianglesp2", "edgesp2" };
    const bool is_unsupported = unsupported.count(name) > 0;
    const auto first_line = line_;
    if(is_unsupported && integer() > 0)
      throw std::runtime_error("line " + std::to_string(first_line) + ": " + section_ + " are not supported");
    std::size_t end = end_;
    auto line = line_;
    while(next() && !(std::isalpha(byte(begin_)) && keyword() != "nan" && keyword() != "inf"))
    {
      end = end_;
      line = line_;
    }
    end_ = end;
    line_ = line;
  }

  void check_vertices() const
  {
    if(mesh_.points.empty())
      throw std::runtime_error("has no vertices");
  }

  template <std::size_t n>
  void check_elements(const std::vector<Medit_mesh::Element<n> >& elements, const std::string& name) const
  {
    for(std::size_t k = 0; k < elements.size(); ++k)
    {
      std::array<int, n> v = elements[k].vertices;
      std::sort(v.begin(), v.end());
      if(static_cast<std::size_t>(v.back()) >= mesh_.points.size())
        throw std::runtime_error(name + ' ' + std::to_string(k + 1) + " has vertex " + std::to_string(v.back() + 1) + " of "
                                 + std::to_string(mesh_.points.size()));
      const auto twice = std::adjacent_find(v.begin(), v.end());
      if(twice != v.end())
        throw std::runtime_error(name + ' ' + std::to_string(k + 1) + " has vertex " + std::to_string(*twice + 1)
                                 + " twice");
    }
  }

  void check_numbers(const std::vector<int>& numbers, std::size_t most, const std::string& name) const
  {
    for(int n : numbers)
      if(static_cast<std::size_t>(n) >= most)
        throw std::runtime_error(name + " has number " + std::to_string(n + 1) + " of " + std::to_string(most));
  }

  const std::string text_;
  std::size_t begin_ = 0, end_ = 0;       // of the word
  int line_ = 1;
  std::string section_;
  Reference number_ = -1, count_ = 0;     // of the entry
  std::set<std::string> read_sections_;
  Medit_mesh mesh_;
};

// The least digits that give the same number, from 15 on.
inline std::string printed_coordinate(double x)
{
  char text[32];
  for(int digits = 15; digits <= 17; ++digits)
  {
    std::snprintf(text, sizeof(text), "%.*g", digits, x);
    if(std::strtod(text, nullptr) == x)
      break;
  }
  return text;
}

class Medit_writer
{
public:
  explicit Medit_writer(std::ostream& out) : out_(out) {}

  void operator()(const Medit_mesh& mesh)
  {
    out_ << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.points.size() << '\n';
    for(std::size_t n = 0; n < mesh.points.size(); ++n)
    {
      for(double x : mesh.points[n])
        out_ << printed_coordinate(x) << ' ';
      out_ << mesh.point_references[n] << '\n';
    }
    write("Edges", mesh.edges);
    write("Triangles", mesh.triangles);
    write("Tetrahedra", mesh.tetrahedra);
    write("Corners", mesh.corners);
    write("Ridges", mesh.ridges);
    write("RequiredVertices", mesh.required_vertices);
    write("RequiredEdges", mesh.required_edges);
    write("RequiredTriangles", mesh.required_triangles);
    out_ << "End\n";
  }

private:
  // Empty sections are left out.
  template <class T>
  void write(const char* section, const std::vector<T>& entries)
  {
    if(!entries.empty())
      out_ << section << '\n' << entries.size() << '\n';
    for(const T& e : entries)
      write(e);
  }

  void write(int number) { out_ << number + 1 << '\n'; }

  template <std::size_t n>
  void write(const Medit_mesh::Element<n>& e)
  {
    for(int v : e.vertices)
      out_ << v + 1 << ' ';
    out_ << e.reference << '\n';
  }

  std::ostream& out_;
};

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_MEDIT_MESH_H
