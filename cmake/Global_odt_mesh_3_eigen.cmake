# The target Eigen3::Eigen, from what the project has found already, or else from Eigen's own package configuration, or
# else from the module that some versions of CGAL bring, which only finds the directory.
if(NOT TARGET Eigen3::Eigen AND NOT EIGEN3_INCLUDE_DIR)
  find_package(Eigen3 3.1.0 QUIET CONFIG)
endif()
if(NOT TARGET Eigen3::Eigen)
  if(NOT EIGEN3_INCLUDE_DIR)
    find_package(Eigen3 3.1.0 REQUIRED)
  endif()
  add_library(Eigen3::Eigen INTERFACE IMPORTED)
  set_target_properties(Eigen3::Eigen PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${EIGEN3_INCLUDE_DIR}")
endif()
