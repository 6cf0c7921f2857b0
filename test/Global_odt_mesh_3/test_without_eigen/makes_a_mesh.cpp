// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A program that has not known of Eigen, which Mesh_3 does without: the first that it hears of it says what to do.

#include <CGAL/make_mesh_3.h>
