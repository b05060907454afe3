// R(M) of shapes for which there is a formula; papers/closed-forms.md derives them. Pure functions.
#pragma once

#include "rectilin/mesh/mesh.h"

namespace rectilin::paper {

/// A square pyramid (shape:pyramid). It is proved that R is no less, and certified bounds agree with it wherever they
/// were computed.
double pyramid_rectilinearity(double base, double height);

/// A prism over a regular polygon with `sides` >= 3 corners on a circle of `radius` (shape:prism), with or without its
/// two ends.
double prism_rectilinearity(int sides, double radius, double height, bool caps = true);

/// A circular cylinder: the limit of prisms.
double cylinder_rectilinearity(double radius, double height, bool caps = true);

/// An ellipsoid with semi-axes a, b, c > 0: the limit of ever finer meshes (shape:ellipsoid).
double ellipsoid_rectilinearity(double a, double b, double c);

/// Its surface area (Legendre).
double ellipsoid_area(double a, double b, double c);

/// A unit cube whose top face is cut loose and turned by `tilt`, in [0, pi/2], about one of its middle lines.
Mesh tilted_top_cube(double tilt);
double tilted_top_rectilinearity(double tilt);

}  // namespace rectilin::paper
