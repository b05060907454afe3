#include "rectilin/mesh/mesh_report.h"

#include "rectilin/base/parameters.h"

namespace rectilin {
namespace {

/// "1 face of three", "2 faces of three".
std::string counted(std::size_t count, const std::string& thing, const std::string& what,
                    const std::string& plural = "s") {
  return std::to_string(count) + " " + thing + (count == 1 ? " " : plural + " ") + what;
}

std::string in_brackets(const std::string& text) { return text.empty() ? "" : " (" + text + ")"; }

void append(std::string& list, const std::string& item) { list += (list.empty() ? "" : ", ") + item; }

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

}  // namespace

std::string summary(const MeshReport& r) {
  std::string out, found;
  if (r.dropped_short > 0) append(out, counted(r.dropped_short, "face", "of fewer than three corners"));
  if (r.dropped_nonfinite > 0)
    append(out, counted(r.dropped_nonfinite, "face", "with a coordinate that is not a finite number"));
  if (r.unknown_statements > 0)
    append(out, counted(r.unknown_statements, "statement", "that may be surface") + in_brackets(r.first_unknown));
  if (r.left_over_bytes > 0)
    append(out, counted(r.left_over_bytes, "byte", "of data behind the last face") + in_brackets(r.left_over_place));
  if (r.scene.unplaced > 0) append(out, counted(r.scene.unplaced, "mesh", "not in the scene", "es"));
  if (r.odd_facets > 0) append(found, counted(r.odd_facets, "facet", "of other than three corners"));
  if (r.scene.deformed > 0)
    append(found, counted(r.scene.deformed, "mesh", "whose skin or morph targets are not applied", "es"));
  if (r.padding_bytes > 0) append(found, counted(r.padding_bytes, "byte", "of padding at the end"));
  if (!out.empty()) out = "left out: " + out;
  const bool one = found.starts_with("1 ");
  if (!found.empty()) out += (out.empty() ? "there " : "; there ") + std::string(one ? "is " : "are ") + found;
  return out;
}

void LossLog::add(const std::string& name, const MeshReport& report) {
  if (const std::string loss = summary(report); !loss.empty()) add_line(name + ": " + loss);
}

void LossLog::add_line(const std::string& line) {
  const std::lock_guard lock(mutex_);
  lines_.insert(line);
}

std::vector<std::string> LossLog::lines() const {
  const std::lock_guard lock(mutex_);
  return {lines_.begin(), lines_.end()};
}

Json to_json(const MeshReport& r) {
  Json json = {{"vertices", r.vertices},
               {"polygons", r.polygons},
               {"triangulated", r.triangulated},
               {"nonfinite_vertices", r.nonfinite_vertices},
               {"dropped_nonfinite", r.dropped_nonfinite},
               {"dropped_short", r.dropped_short},
               {"degenerate", r.degenerate},
               {"duplicate_vertices", r.duplicate_vertices},
               {"unreferenced_vertices", r.unreferenced_vertices},
               {"odd_facets", r.odd_facets},
               {"unknown_statements", r.unknown_statements},
               {"first_unknown", text_or_null(r.first_unknown)},
               {"left_over_bytes", r.left_over_bytes},
               {"left_over_place", text_or_null(r.left_over_place)},
               {"padding_bytes", r.padding_bytes}};
  if (r.scene.metres_per_unit > 0)
    json["scene"] = {{"metres_per_unit", r.scene.metres_per_unit},
                     {"instances", r.scene.instances},
                     {"skipped", r.scene.skipped},
                     {"unplaced", r.scene.unplaced},
                     {"deformed", r.scene.deformed}};
  return json;
}

}  // namespace rectilin
