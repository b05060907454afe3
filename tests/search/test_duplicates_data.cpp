// Real models, each with a copy that was turned, scaled, renumbered, written in another format and, half of them,
// simplified or subdivided. Needs the Princeton Shape Benchmark in $RECTILIN_DATA/psb.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>

#include "rectilin/base/random.h"
#include "rectilin/base/rotation.h"
#include "rectilin/mesh/edits.h"
#include "rectilin/mesh/mesh_io.h"
#include "rectilin/retrieval/collection.h"
#include "rectilin/search/duplicates.h"
#include "rectilin/search/index.h"
#include "support/catch.h"
#include "support/scratch_folder.h"
#include "support/subdivided.h"

using namespace rectilin;
using namespace rectilin::search;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kModels = 300;

Mesh disguised(Mesh mesh, std::size_t number, Random& random) {
  if (number % 4 == 1) mesh = test::subdivided(mesh);
  if (number % 4 == 3) mesh = simplified(mesh, mesh.triangles.size() / 2);
  const Eigen::Matrix3d turn = random_rotation(random).matrix() * std::exp(random.uniform(-3, 3));
  std::vector<std::uint32_t> number_of(mesh.vertices.size());
  for (std::uint32_t i = 0; i < number_of.size(); ++i) number_of[i] = i;
  for (std::size_t i = number_of.size(); i > 1; --i) std::swap(number_of[i - 1], number_of[random.below(i)]);
  Mesh copy{mesh.vertices, mesh.triangles};
  for (std::size_t i = 0; i < number_of.size(); ++i) copy.vertices[number_of[i]] = turn * mesh.vertices[i];
  for (Triangle& t : copy.triangles) {
    for (std::uint32_t& v : t) v = number_of[v];
    std::rotate(t.begin(), t.begin() + static_cast<long>(random.below(3)), t.end());
  }
  for (std::size_t i = copy.triangles.size(); i > 1; --i)
    std::swap(copy.triangles[i - 1], copy.triangles[random.below(i)]);
  return copy;
}

std::string original_of(const std::string& name) {
  const std::string stem = fs::path(name).stem();
  return stem.substr(0, stem.find('-'));
}

}  // namespace

TEST_CASE("copies of real models are found", "[data]") {
  const char* data = std::getenv("RECTILIN_DATA");
  const fs::path psb = fs::path(data ? data : "") / "psb";
  if (!data || !fs::exists(psb / "classification/v1/base/train.cla")) {
    std::cout << "skipped: RECTILIN_DATA has no psb/ with its classification\n";
    return;
  }
  const retrieval::Collection collection =
      retrieval::find_collection(psb, retrieval::read_classification(psb / "classification/v1/base/train.cla"));
  const test::ScratchFolder scratch;
  Random random(11);
  std::vector<std::string> models;
  const std::vector<std::string> formats{".off", ".obj", ".ply", ".stl"};
  for (std::size_t i = 0; models.size() < kModels && 3 * i < collection.files.size(); ++i) {
    const Mesh mesh = load_mesh(collection.files[3 * i]).mesh;
    const std::string name = collection.classes.models[3 * i];
    write_mesh(scratch.path() / (name + "-a.off"), mesh);
    write_mesh(scratch.path() / (name + "-b" + formats[random.below(4)]), disguised(mesh, models.size(), random),
               {.recentre = true});
    models.push_back(name);
  }
  REQUIRE(models.size() == kModels);
  Database database(scratch.path() / "shapes.db", "best");
  CHECK(update_index(database, {scratch.path().string()}).errors.empty());
  const Duplicates found = find_duplicates(database);
  std::set<std::string> paired;
  std::size_t strangers = 0;
  for (const DuplicateGroup& group : found.groups) {
    std::set<std::string> originals;
    for (const std::size_t member : group.members) {
      const std::string original = original_of(found.members[member].name);
      if (!originals.insert(original).second) paired.insert(original);
    }
    if (originals.size() < 2) continue;
    ++strangers;
    std::string text;
    for (const std::string& original : originals) text += " " + original;
    std::cout << "one shape in more than one model:" << text << '\n';
  }
  std::size_t same_surface = 0, simplified_ones = 0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    ++(i % 4 == 3 ? simplified_ones : same_surface);
    if (paired.contains(models[i])) continue;
    --(i % 4 == 3 ? simplified_ones : same_surface);
    std::cout << "not found: " << models[i] << (i % 4 == 3 ? ", simplified" : "") << '\n';
  }
  std::cout << same_surface << " of " << kModels * 3 / 4 << " copies of the same surface found, " << simplified_ones
            << " of " << kModels / 4 << " simplified ones; " << found.pairs_looked_at << " pairs looked at\n";
  CHECK(same_surface == kModels * 3 / 4);
  CHECK((same_surface + simplified_ones) * 100 >= kModels * 99);
  CHECK(strangers <= 1);  // m372 and m375 are one torso
}
