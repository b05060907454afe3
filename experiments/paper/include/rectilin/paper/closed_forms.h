// R(M) of shapes for which it can be written down; derived in papers/closed-forms.md. Pure
// functions.
#pragma once

#include "rectilin/mesh/mesh.h"

namespace rectilin::paper {

/// A square pyramid (shape:pyramid). Proved to be no more than R; equal to it wherever it has been
/// certified.
double pyramid_rectilinearity(double base, double height);

/// A prism over a regular polygon of `sides` >= 3 corners on a circle of `radius` (shape:prism);
/// with caps or open.
double prism_rectilinearity(int sides, double radius, double height, bool caps = true);

/// A circular cylinder: the limit of prisms.
double cylinder_rectilinearity(double radius, double height, bool caps = true);

/// An ellipsoid with semi-axes a, b, c > 0: the limit of ever finer meshes (shape:ellipsoid).
double ellipsoid_rectilinearity(double a, double b, double c);

/// Its surface area (Legendre).
double ellipsoid_area(double a, double b, double c);

/// A unit cube whose top face, cut loose, is turned by `tilt` in [0, pi/2] about one of its middle
/// lines.
Mesh tilted_top_cube(double tilt);
double tilted_top_rectilinearity(double tilt);

}  // namespace rectilin::paper
