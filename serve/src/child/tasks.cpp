#include "child/tasks.h"

#include <filesystem>
#include <optional>
#include <string>

#include "rectilin/base/printable.h"
#include "rectilin/mesh/mesh_report.h"
#include "rectilin/mesh/source.h"
#include "rectilin/render/thumbnail.h"
#include "rectilin/search/describe.h"
#include "rectilin/search/digest.h"
#include "rectilin/search/same_pose.h"
#include "shapes/compact_mesh.h"

namespace rectilin::serve {
namespace {

std::string text_of_bytes(const Json& value) {
  const auto& bytes = value.get_binary();
  return {bytes.begin(), bytes.end()};
}

std::string picture_of(const retrieval::Model& model) {
  return render::thumbnail(model.posed("rectilinear"), render::Up::kZ);
}

Json member_bytes(const Json& task, bool picture) {
  const std::string source = text_of_bytes(task["source"]);
  const std::string file = search::file_of(source);
  const std::optional<std::string> digest = file.empty() ? std::string() : search::file_digest(file);
  if (!digest || search::source_digest(source, *digest) != task["digest"])
    throw MeshError(printable(source) + ": changed since it was indexed; run 'rectilin index' again");
  const retrieval::Model model(load_mesh(source).mesh);
  return {{"bytes", as_bytes(picture ? picture_of(model) : compact_mesh(model.posed("rectilinear")))}};
}

Json description(const Json& task) {
  std::filesystem::current_path(task["folder"].get<std::string>());  // messages name the file without the folder
  LoadedMesh loaded = load_mesh(text_of_bytes(task["source"]));
  const retrieval::Model model(std::move(loaded.mesh));
  const search::DescribedMesh described =
      search::describe_model(model, search::make_terms(task["descriptor"].get<std::string>()));
  Json parts = Json::array();
  for (const auto& part : described.parts) parts.push_back(Json::binary({part.begin(), part.end()}));
  return {{"faces", described.member.faces},
          {"rectilinearity", described.member.rectilinearity},
          {"size", described.member.size},
          {"left_out", printable(summary(loaded.report))},
          {"parts", std::move(parts)},
          {"picture", as_bytes(picture_of(model))},
          {"mesh", as_bytes(compact_mesh(model.posed("rectilinear")))}};
}

Json turn(const Json& task) {
  const search::SamePose pose =
      search::same_pose(mesh_of_compact(text_of_bytes(task["first"])), mesh_of_compact(text_of_bytes(task["second"])));
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) rotation.push_back(pose.rotation(row, column));
  return {{"rotation", std::move(rotation)}, {"distance", pose.distance}};
}

}  // namespace

Json do_task(const Json& task) {
  const std::string name = task["task"];
  if (name == "describe") return description(task);
  if (name == "turn") return turn(task);
  return member_bytes(task, name == "picture");
}

}  // namespace rectilin::serve
