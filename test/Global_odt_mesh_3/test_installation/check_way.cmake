# Configures, builds, and installs a project that gets the package of the directory PACKAGE, which is installed below PREFIX,
# in the given WAY, and checks that nothing but the project's own file is installed.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${result}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${BUILD})
file(MAKE_DIRECTORY ${BUILD})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${BUILD} -G ${GENERATOR} -DWAY=${WAY} -DPACKAGE=${PACKAGE}
    -DCMAKE_PREFIX_PATH=${PREFIX} -DCGAL_DIR=${CGAL_DIR} -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_INSTALL_PREFIX=${BUILD}/prefix)
run(${CMAKE_COMMAND} --build ${BUILD})
run(${CMAKE_COMMAND} --build ${BUILD} --target install)
file(GLOB_RECURSE files RELATIVE ${BUILD}/prefix ${BUILD}/prefix/*)
if(NOT files STREQUAL "share/program/includes_our_header.cpp")
  message(FATAL_ERROR "installed with the project of the user: ${files}")
endif()
