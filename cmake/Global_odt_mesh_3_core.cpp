// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Global_odt_mesh_3/internal/Mesh_optimizer_3_impl.h>
