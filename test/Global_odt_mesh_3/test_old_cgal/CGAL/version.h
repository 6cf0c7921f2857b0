// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Stands for the header of CGAL 5.4.

#define CGAL_VERSION 5.4
#define CGAL_VERSION_NR 1050401000
