// The methods, each in a file of its own: from a surface to a pose, but for what finish() adds.
#pragma once

#include "rectilin/base/parameters.h"
#include "rectilin/pose/pose.h"
#include "surface.h"

namespace rectilin::pose {

struct NoOptions {
  void bind(Parameters&) {}
};

/// A gap of a billionth takes no longer than one of a millionth, and of several frames that are nearly as good finds
/// the best: the same one however the mesh was turned.
struct CertifiedOptions {
  double gap = 1e-9;
  int cells = 2'000'000;
  bool optima = true;
  void bind(Parameters& table);
};

struct BoxOptions {
  int directions = 400;
  void bind(Parameters& table);
};

struct SymmetryOptions {
  int planes = 8;
  void bind(Parameters& table);
};

struct SilhouetteOptions {
  double tolerance = 1e-5;
  int evaluations = 400;
  std::string optimizer = "nelder-mead";
  void bind(Parameters& table);
};

struct CpnOptions {
  bool pixels = true;
  int size = 256;
  double gap = 1e-9;
  void bind(Parameters& table);
};

struct CompositeOptions {
  double symmetry = 0.2;
  double flat = 0.05;
  int planes = 8;
  double gap = 1e-9;
  void bind(Parameters& table);
};

Pose pca_pose(const Surface& surface);
Pose vertex_pca_pose(const Surface& surface);
Pose normal_pca_pose(const Surface& surface);
Pose rectilinear_pose(const Surface& surface, const CertifiedOptions& options);
Pose hull_pose(const Surface& surface, const CertifiedOptions& options);
Pose box_pose(const Surface& surface, const BoxOptions& options);
Pose symmetry_pose(const Surface& surface, const SymmetryOptions& options);
Pose silhouette_pose(const Surface& surface, const SilhouetteOptions& options);
Pose cpn_pose(const Surface& surface, const CpnOptions& options);
Pose composite_pose(const Surface& surface, const CompositeOptions& options);

/// A pose of one frame, which is unique.
Pose single(std::string name, const Rotation& rotation);

/// The axes of a symmetric matrix, by decreasing eigenvalue, and what equal eigenvalues leave open.
Pose principal_axes(const Eigen::Matrix3d& moments, const std::string& name);

/// Moves the candidate of that index to the front and makes it the pose's rotation.
void choose(Pose& pose, std::size_t index);

}  // namespace rectilin::pose
