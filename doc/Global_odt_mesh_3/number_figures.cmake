# Numbers the figures of the user manual where it is built without the documentation system of CGAL: the alias \cgalFigureBegin
# writes the name of a figure in front of its caption, and \cgalFigureRef into the links to it.
#
#   cmake -DPAGE=index.html -P number_figures.cmake
file(READ ${PAGE} page)
string(REGEX MATCHALL "<b>Figure godt_[a-z_]+" captions "${page}")
set(number 0)
foreach(caption ${captions})
  math(EXPR number "${number} + 1")
  string(REPLACE "<b>" "" name "${caption}")
  string(REGEX REPLACE "${name}([^a-z_])" "Figure ${number}\\1" page "${page}")
endforeach()
file(WRITE ${PAGE} "${page}")
