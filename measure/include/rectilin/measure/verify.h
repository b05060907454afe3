// Checks a certificate of R(M) from scratch.
#pragma once

#include <string>
#include <string_view>

#include "rectilin/mesh/mesh_view.h"

namespace rectilin {

struct Verdict {
  bool accepted = false;
  std::string reason;      ///< why the certificate is refused, in one line
  double lower = 0;        ///< proved: R(M) >= lower, since the certificate's rotation attains it
  double upper = 0;        ///< proved: R(M) <= upper
  std::size_t leaves = 0;  ///< parts of the zone that were checked
  std::size_t cuts = 0;    ///< cuts, sums over all faces, that were computed again
};

/// Does the text (JSON, see papers/certificate.md) prove an interval for R of this mesh? The check shares nothing
/// with the search but the mesh type: it has plain loops over the unmerged faces, and a bound of its own by
/// Bernstein coefficients. Whatever the text contains, it never throws because of it. It takes about 1.5 ns for each
/// face and cut.
Verdict verify_certificate(std::string_view text, const MeshView& mesh);

/// A digest that identifies a mesh: FNV-1a (64 bits) over the coordinates of the triangles' corners in order. It
/// protects against mix-ups, not against forgery; the proof itself is checked on the mesh.
std::string mesh_digest(const MeshView& mesh);

}  // namespace rectilin
