# global_odt_mesh_3_add_core(name "include directory"): a static library of all that does not depend on types of the user, so
# that it is compiled once and not along with each program. What links it has to be compiled with the same CGAL and options.
set(GLOBAL_ODT_MESH_3_CORE_SOURCE ${CMAKE_CURRENT_LIST_DIR}/Global_odt_mesh_3_core.cpp)

function(global_odt_mesh_3_add_core name include_directory)
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${GLOBAL_ODT_MESH_3_CORE_SOURCE})
  # As for the headers, our directory is to be searched before CGAL's, wherever that is.
  target_include_directories(${name} BEFORE PRIVATE ${include_directory})
  target_include_directories(${name} SYSTEM PRIVATE $<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_INCLUDE_DIRECTORIES>)
  target_link_libraries(${name} PUBLIC CGAL::CGAL Eigen3::Eigen)
  target_compile_features(${name} PUBLIC cxx_std_17)
  target_compile_definitions(${name} PUBLIC CGAL_GLOBAL_ODT_MESH_3_COMPILED_CORE)
  # It may become a part of shared libraries.
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  # Threads are used where the program asks for them, if the project has found TBB, be it later.
  target_link_libraries(${name} PRIVATE $<TARGET_NAME_IF_EXISTS:CGAL::TBB_support>)
endfunction()
