#!/usr/bin/env bash
# Prints how many lines of code headers have: neither comments nor blank lines nor lone braces.
#
#   count_lines_of_code.sh [directory]
set -euo pipefail
find "${1:-$(dirname "$0")/../include}" -name '*.h' -print0 | xargs -0 awk '
  FNR == 1 { in_comment = 0 }
  {
    line = $0
    code = ""
    while(line != "")
    {
      if(in_comment)
      {
        end = index(line, "*/")
        if(end == 0)
          break
        line = substr(line, end + 2)
        in_comment = 0
        continue
      }
      begin = index(line, "/*")
      slashes = index(line, "//")
      if(slashes > 0 && (begin == 0 || slashes < begin))
      {
        code = code substr(line, 1, slashes - 1)
        break
      }
      if(begin == 0)
      {
        code = code line
        break
      }
      code = code substr(line, 1, begin - 1)
      line = substr(line, begin + 2)
      in_comment = 1
    }
    gsub(/[ \t]/, "", code)
    if(code != "" && code !~ /^[{}]+$/)
      ++number
  }
  END { print number }'
