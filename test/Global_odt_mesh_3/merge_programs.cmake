# merge_programs(target name...): one program of the sources name.cpp, each with a main() of its own, so that the headers and instances
# that they share are compiled once. Its first argument names the main() to be called, with the arguments that follow. A source that
# stands alone, as those do that define macros before headers or operators of all, is compiled as it is.
function(merge_programs target)
  set(includes "")
  set(bodies "")
  set(calls "")
  foreach(name ${ARGN})
    set(source ${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    file(STRINGS ${source} lines REGEX "^#include ")
    list(APPEND includes ${lines})
    get_filename_component(name ${name} NAME)
    string(APPEND bodies "namespace ${name} {\n#include \"${source}\"\n}\n")
    string(APPEND calls "  if(name == \"${name}\")\n    return call(${name}::main, argc - 1, argv + 1);\n")
  endforeach()
  list(LENGTH ARGN number)
  if(number GREATER 1)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
  endif()
  list(REMOVE_DUPLICATES includes)
  # First, so that headers are not included in namespaces; those that are included for some versions of CGAL only, always.
  string(REPLACE ";" "\n" includes "${includes}")
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp CONTENT "${includes}
#include <boost/optional.hpp>
#include <iostream>
#include <optional>
#include <string>

${bodies}
static int call(int (*f)(), int, char**) { return f(); }
static int call(int (*f)(int, char**), int argc, char** argv) { return f(argc, argv); }

int main(int argc, char** argv)
{
  const std::string name = argc > 1 ? argv[1] : \"\";
${calls}  std::cerr << \"no program has the name \" << name << std::endl;
  return 2;
}
")
  add_executable(${target} ${source})
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_compile_features(${target} PRIVATE cxx_std_17)
  target_link_libraries(${target} PRIVATE CGAL::CGAL CGAL::Data)
endfunction()
