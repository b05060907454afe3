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

/// What readers left out of many meshes: a line "NAME: SUMMARY" for each, once however often it is read. Thread safe.
class LossLog {
 public:
  void add(const std::string& name, const MeshReport& report);
  void add_line(const std::string& line);
  /// By name.
  std::vector<std::string> lines() const;

 private:
  mutable std::mutex mutex_;
  std::set<std::string> lines_;
};

/// An object with all fields of the report; `first_unknown` and `left_over_place` are null where there is none.
Json to_json(const MeshReport& report);

}  // namespace rectilin
