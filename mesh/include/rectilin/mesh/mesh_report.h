// Shows a MeshReport to people (one line) and to programs (JSON).
#pragma once

#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "rectilin/base/json_fwd.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// One line that says what part of a file is not in the mesh, and what the file holds that it should not: "left out: 2
/// faces of fewer than three corners, 230 bytes of data behind the last face (line 12)". Empty if the mesh is the whole
/// mesh of the file. Every command that reads meshes prints it.
std::string summary(const MeshReport& report);

/// Collects what readers left out of many meshes: one line "NAME: SUMMARY" for each mesh, however often it is read.
/// Thread safe.
class LossLog {
 public:
  void add(const std::string& name, const MeshReport& report);
  void add_line(const std::string& line);
  /// The lines, sorted by name.
  std::vector<std::string> lines() const;

 private:
  mutable std::mutex mutex_;
  std::set<std::string> lines_;
};

/// A JSON object with all fields of the report; `first_unknown` and `left_over_place` are null where there is nothing
/// to tell.
Json to_json(const MeshReport& report);

}  // namespace rectilin
