// Checks a certificate of R(M) from scratch.
#pragma once

#include <string>
#include <string_view>

#include "rectilin/mesh/mesh_view.h"

namespace rectilin {

struct Verdict {
  bool accepted = false;
  std::string reason;          ///< one line, if refused
  double lower = 0;            ///< proved: R(M) >= lower, that of the certificate's rotation
  double upper = 0;            ///< proved: R(M) <= upper
  std::size_t leaves = 0;      ///< parts of the zone that were checked
  std::size_t directions = 0;  ///< sums over all faces that were recomputed
};

/// Does the text (JSON, see papers/certificate.md) prove an interval for R of this mesh? Shares nothing with the search
/// but the mesh type: plain loops over the unmerged faces, and a bound by Bernstein coefficients. Never throws for
/// what the text says, whatever it says. About 1.5 ns for a face and a direction.
Verdict verify_certificate(std::string_view text, const MeshView& mesh);

/// Identifies a mesh: FNV-1a (64 bits) over the coordinates of the triangles' corners in order. It guards against
/// mistakes, not malice; the proof itself is checked on the mesh.
std::string mesh_digest(const MeshView& mesh);

}  // namespace rectilin
