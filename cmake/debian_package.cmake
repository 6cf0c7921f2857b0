# A package of Debian, by cpack -G DEB. As for Debian's tools, DEBFULLNAME and DEBEMAIL in the environment are who makes it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME libcgal-global-odt-mesh-3-dev)
set(CPACK_PACKAGE_VENDOR "The Global ODT Mesh authors")
set(packager "$ENV{DEBFULLNAME}")
if(NOT packager)
  set(packager ${CPACK_PACKAGE_VENDOR})
endif()
set(address "$ENV{DEBEMAIL}")
if(NOT address)
  cmake_host_system_information(RESULT host QUERY FQDN)
  set(address "packager@${host}")
endif()
set(CPACK_PACKAGE_CONTACT "${packager} <${address}>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "global optimization of 3D meshes made by CGAL (headers)")
set(CPACK_PACKAGE_DESCRIPTION "This header-only package takes the place of odt_optimize_mesh_3() of CGAL's
package 3D Mesh Generation. It moves the vertices of a tetrahedral mesh and
removes slivers, so that cells come close to regular tetrahedra.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libeigen3-dev")
# Nothing that is installed has to be built, be there examples in the same build or not.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

# What the policy of Debian wants of each package.
set(debian ${CMAKE_CURRENT_BINARY_DIR}/debian)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
string(TIMESTAMP year "%Y" UTC)
file(WRITE ${debian}/copyright
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: ${PROJECT_NAME}

Files: *
Copyright: ${year} ${CPACK_PACKAGE_VENDOR}
License: GPL-3.0-or-later
 On Debian systems, the text of version 3 of the GNU General Public License is
 in /usr/share/common-licenses/GPL-3.
")
file(WRITE ${debian}/changelog
"${CPACK_PACKAGE_NAME} (${PROJECT_VERSION}) unstable; urgency=medium

  * Release ${PROJECT_VERSION}; CHANGES.md tells what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
execute_process(COMMAND gzip -9nf ${debian}/changelog)
set(CPACK_INSTALLED_DIRECTORIES ${debian} usr/share/doc/${CPACK_PACKAGE_NAME})

include(CPack)
