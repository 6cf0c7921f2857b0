// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_LICENSE_GLOBAL_ODT_MESH_3_H
#define CGAL_LICENSE_GLOBAL_ODT_MESH_3_H

// In a branch of CGAL, this file is generated. Until then, the package comes under the GPL, and the macros that ask for
// more have their meaning.
#include <CGAL/config.h>
#include <CGAL/license.h>

#ifndef CGAL_GLOBAL_ODT_MESH_3_COMMERCIAL_LICENSE
#  ifdef CGAL_LICENSE_WARNING
     CGAL_pragma_warning("The package Global_odt_mesh_3 is used under the terms of the GPLv3+.")
#  endif
#  ifdef CGAL_LICENSE_ERROR
#    error "The package Global_odt_mesh_3 is used under the terms of the GPLv3+, which CGAL_LICENSE_ERROR forbids."
#  endif
#endif

#endif // CGAL_LICENSE_GLOBAL_ODT_MESH_3_H
