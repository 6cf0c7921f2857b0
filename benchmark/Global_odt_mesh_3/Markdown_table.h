// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_MARKDOWN_TABLE_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_MARKDOWN_TABLE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

enum class Better { HIGH, LOW, NEITHER };

// Of numbers, with so many digits behind the point.
struct Column
{
  std::string title;
  int digits;
  Better better;
};

// A table of numbers in Markdown, each in a cell of its own, and the best of those that are compared in bold. Rows begin with
// texts. A row is told on the standard error as soon as it is there, so that one sees how far a long program is.
class Markdown_table
{
public:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();     // an empty cell

  // Numbers are compared down a column, among rows that agree in all texts but the last.
  Markdown_table(std::vector<std::string> texts, std::vector<Column> columns)
    : texts_(std::move(texts)), columns_(std::move(columns))
  {}

  // What others begin with, such as an input, is not to be compared with them.
  void add(std::vector<std::string> texts, std::vector<double> values, bool is_compared = true)
  {
    for(const std::string& t : texts)
      std::cerr << t << "  ";
    for(std::size_t k = 0; k < values.size(); ++k)
      std::cerr << ' ' << printed(values[k], k);
    std::cerr << std::endl;
    rows_.push_back({ std::move(texts), std::move(values), is_compared });
  }

  friend std::ostream& operator<<(std::ostream& out, const Markdown_table& table)
  {
    out << '|';
    for(const std::string& t : table.texts_)
      out << ' ' << t << " |";
    for(const Column& c : table.columns_)
      out << ' ' << c.title << " |";
    out << "\n|";
    for(std::size_t k = 0; k < table.texts_.size(); ++k)
      out << "---|";
    for(std::size_t k = 0; k < table.columns_.size(); ++k)
      out << "---:|";
    const std::map<std::string, Range> ranges = table.ranges();
    for(std::size_t n = 0; n < table.rows_.size(); ++n)
    {
      const Row& row = table.rows_[n];
      out << "\n|";
      for(std::size_t k = 0; k < row.texts.size(); ++k)
        out << ' ' << (k + 1 < row.texts.size() && n > 0 && table.rows_[n - 1].texts[k] == row.texts[k] ? "" : row.texts[k]) << " |";
      for(std::size_t k = 0; k < row.values.size(); ++k)
      {
        const std::string number = table.printed(row.values[k], k);
        const char* const mark = table.is_best(row, k, ranges) ? "**" : "";
        out << ' ' << mark << number << mark << " |";
      }
    }
    return out << std::endl;
  }

private:
  typedef std::pair<double, double> Range;

  struct Row
  {
    std::vector<std::string> texts;
    std::vector<double> values;
    bool is_compared;
  };

  std::string printed(double x, std::size_t column) const
  {
    std::ostringstream out;
    out.setf(std::ios::fixed);
    out.precision(columns_[column].digits);
    if(!std::isnan(x))
      out << x;
    return out.str();
  }

  // As it is printed, so that what looks the same counts as equal.
  double value(const Row& row, std::size_t column) const { return std::stod(printed(row.values[column], column)); }

  bool can_be_best(const Row& row, std::size_t column) const
  { return row.is_compared && columns_[column].better != Better::NEITHER && !std::isnan(row.values[column]); }

  // The same for numbers that are compared.
  static std::string group(const Row& row, std::size_t column)
  {
    std::string key = std::to_string(column);
    for(std::size_t k = 0; k + 1 < row.texts.size(); ++k)
      key += '|' + row.texts[k];
    return key;
  }

  std::map<std::string, Range> ranges() const
  {
    std::map<std::string, Range> ranges;
    for(const Row& row : rows_)
      for(std::size_t k = 0; k < columns_.size(); ++k)
        if(can_be_best(row, k))
        {
          const double x = value(row, k);
          Range& range = ranges.emplace(group(row, k), Range(x, x)).first->second;
          range = Range((std::min)(range.first, x), (std::max)(range.second, x));
        }
    return ranges;
  }

  // Where all are equal, none is.
  bool is_best(const Row& row, std::size_t column, const std::map<std::string, Range>& ranges) const
  {
    if(!can_be_best(row, column))
      return false;
    const Range& range = ranges.at(group(row, column));
    return range.first < range.second
           && value(row, column) == (columns_[column].better == Better::HIGH ? range.second : range.first);
  }

  std::vector<std::string> texts_;
  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_MARKDOWN_TABLE_H
