// What the server has done with meshes, each in a process of its own.
#pragma once

#include <array>
#include <atomic>
#include <string>
#include <vector>

#include "child/child.h"
#include "rectilin/search/database.h"

namespace rectilin::serve {

/// Something that a client can be told: one line that names the mesh.
class ShapeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Upload {
  search::Member member;  ///< name, faces, rectilinearity, size
  search::Parts parts;
  std::string left_out;       ///< what the reader left out of the mesh, in one line
  std::string picture, mesh;  ///< a PNG file; as compact_mesh()
};

struct Turn {
  std::array<double, 9> rotation;  ///< by rows
  double distance;                 ///< of the surfaces then, see search::same_pose()
};

/// Thread safe. All functions throw ShapeError.
class MeshWork {
 public:
  /// `command` runs mesh_worker().
  MeshWork(std::vector<std::string> command, ChildLimits limits) : command_(std::move(command)), limits_(limits) {}

  /// A member's picture as a PNG file, or its mesh as compact_mesh(), both in the frame of the largest rectilinearity.
  /// The file must be the one that was indexed.
  std::string picture(const search::Member& member) const { return of_member("picture", member); }
  std::string mesh(const search::Member& member) const { return of_member("mesh", member); }

  /// Reads and describes a file that somebody sent. `name` is only shown and tells the format.
  Upload describe(const std::string& name, const std::string& content, const std::string& descriptor) const;

  /// How to turn the second of two compact meshes to lie like the first.
  Turn turn(const std::string& first, const std::string& second) const;

  /// Ends all work that is being done, and what is asked for later.
  void stop() { stopped_ = true; }

 private:
  std::string of_member(const char* task, const search::Member& member) const;

  std::vector<std::string> command_;
  ChildLimits limits_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace rectilin::serve
