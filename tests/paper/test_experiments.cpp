#include <tbb/global_control.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "figures/chair.h"
#include "rectilin/mesh/edits.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/paper/experiment.h"
#include "rectilin/render/thumbnail.h"
#include "support/catch.h"
#include "support/known_shapes.h"

using namespace rectilin;
using namespace rectilin::paper;

namespace {

/// Runs an experiment given as on the command line. Bounds are wide, for speed; they are bounds all
/// the same.
ExperimentResult run(const char* text, std::vector<std::string> meshes = {}) {
  const Spec spec = Spec::parse(text);
  ExperimentContext context;
  context.meshes = std::move(meshes);
  context.gap = 1e-4;
  return find_experiment(spec.name).make(spec.settings, context);
}

std::vector<double> values(const ExperimentResult& result) {
  std::vector<double> all;
  for (const Json& row : result.data) {
    const double lower = row.at("lower"), r = row.at("rectilinearity"), upper = row.at("upper");
    CHECK(lower <= r);
    CHECK(r <= upper);
    CHECK(upper - lower <= 1.01e-4);
    all.push_back(r);
  }
  return all;
}

/// The value of the row with that label.
double labelled(const ExperimentResult& result, const std::string& label) {
  for (const Json& row : result.data)
    if (row.at("label") == label) return row.at("rectilinearity");
  FAIL("no row is labelled " << label);
  return 0;
}

}  // namespace

TEST_CASE("Experiments have names of their own, and quick settings they accept", "[experiments]") {
  std::set<std::string> names;
  for (const Experiment& experiment : experiments()) {
    CHECK(names.insert(experiment.name).second);
    CHECK(&find_experiment(experiment.name) == &experiment);
    CHECK_FALSE(experiment.help.empty());
    for (const auto& [key, value] : experiment.quick.items())
      CHECK(std::ranges::any_of(experiment.parameters, [key = key](const auto& p) { return p.name == key; }));
    CHECK_THROWS_AS(experiment.make({{"no such setting", 1}}, {}), ParameterError);
  }
  CHECK_THROWS_AS(find_experiment("fig99"), ParameterError);
}

TEST_CASE("Stepped pyramids have R = 1, the smooth one 0.4270 (Fig. 15)", "[experiments]") {
  const ExperimentResult result = run("fig15?steps=4");
  const std::vector<double> r = values(result);
  REQUIRE(r.size() == 4);
  for (std::size_t i = 0; i < 3; ++i) CHECK(r[i] == Approx(1).margin(1e-12));
  CHECK(r[3] == Approx(test::kPyramid).margin(1e-4));  // the gap
  CHECK(result.data[2]["steps"] == 4);
}

TEST_CASE("Inscribed spheres approach R = 0 from above (Fig. 5)", "[experiments]") {
  const std::vector<double> r = values(run("fig5?subdivisions=3"));
  REQUIRE(r.size() == 4);
  CHECK(std::ranges::is_sorted(r, std::greater()));
  CHECK(r.back() > 0);
  CHECK(r.back() < 0.01);
}

TEST_CASE("The more is cut off an edge of a cube, the less rectilinear it is (Fig. 8)", "[experiments]") {
  const std::vector<double> r = values(run("fig8?steps=5"));
  CHECK(r.front() == Approx(1).margin(1e-12));
  CHECK(std::ranges::is_sorted(r, std::greater()));
  // In the pose of the cube with an edge cut off at a from its corners: S = 6 - 2a - a^2 + sqrt(2)
  // a, and the new side projects to a on each of two planes. Depth d is a = 2d here. No pose can be
  // worse than the best.
  const double a = 0.9, surface = 6 - 2 * a - a * a + std::sqrt(2.0) * a, projected = 6 - a * a;
  CHECK(r.back() >= 3 * surface / projected - 2 - 1e-4);
}

TEST_CASE("Rounding a cube takes it to the sphere (Fig. 9)", "[experiments]") {
  const std::vector<double> r = values(run("fig9?steps=5&segments=6"));
  CHECK(r.front() == Approx(1).margin(1e-12));
  CHECK(std::ranges::is_sorted(r, std::greater()));
  CHECK(r.back() < 0.01);
}

TEST_CASE("Ellipsoids rise from the sphere towards the needle's R (Fig. 10)", "[experiments]") {
  const std::vector<double> r = values(run("fig10?steps=4&faces=1000&longest=40"));
  CHECK(std::ranges::is_sorted(r));
  CHECK(r.front() < 0.01);
  const double needle = 3 * std::numbers::pi / 4 - 2;
  CHECK(r.back() < needle);
  CHECK(r.back() > needle - 1.5 / 40);  // what the two ends take shrinks like one over the length
}

TEST_CASE("A ranking is one, and says which meshes it could not read (Fig. 11)", "[experiments]") {
  const ExperimentResult result =
      run("fig11?shown=2", {"shape:pyramid", "shape:box", "missing.off", "shape:torus?slices=8&stacks=6"});
  const std::vector<double> r = values(result);
  REQUIRE(r.size() == 3);
  CHECK(std::ranges::is_sorted(r, std::greater()));
  CHECK(result.data[0]["label"] == "box");
  REQUIRE(result.errors.size() == 1);
  CHECK(result.errors[0].find("missing.off") != std::string::npos);
  CHECK_THROWS_AS(run("fig11", {"missing.off"}), MeshError);
}

TEST_CASE("Deletion of nothing changes nothing, and runs differ (Fig. 13)", "[experiments]") {
  const ExperimentResult result = run("fig13?runs=3", {"shape:ellipsoid?faces=800"});
  const std::vector<double> r = values(result);
  REQUIRE(r.size() == 36);  // 12 parts, 3 runs
  CHECK(r[0] == r[1]);
  CHECK(r[0] == r[2]);
  CHECK(std::set(r.begin() + 27, r.begin() + 30).size() == 3);  // 90 % deleted
}

TEST_CASE("Simplified to all its faces a mesh is itself (Fig. 14)", "[experiments]") {
  const ExperimentResult result = run("fig14", {"shape:ellipsoid?faces=2000"});
  const std::vector<double> r = values(result);
  REQUIRE(r.size() == 7);
  CHECK(r[0] == Approx(run("fig11", {"shape:ellipsoid?faces=2000"}).data[0]["rectilinearity"].get<double>()));
  CHECK(std::abs(r[1] - r[0]) < 0.005);  // half the faces of a smooth body
  CHECK(result.data[6]["faces"].get<int>() <= 20);
}

TEST_CASE("A chair withstands holes and slats; noise costs the more the finer it is (Fig. 12)", "[experiments]") {
  const ExperimentResult result = run("fig12?finest=4000");
  std::vector<std::string> titles;
  for (const Json& row : result.data)
    if (const std::string label = row.at("label"); label.find(',') == std::string::npos) titles.push_back(label);
  REQUIRE(titles.size() == 3);
  std::vector<double> loss;
  for (const std::string& title : titles) {
    const double whole = labelled(result, title);
    CHECK(std::abs(labelled(result, title + ", slats") - whole) < 0.1);
    CHECK(labelled(result, title + ", noise 1 %") < whole);
    loss.push_back(whole - labelled(result, title + ", noise 0.1 %"));
  }
  CHECK(loss.front() < loss.back());
}

TEST_CASE("The genetic algorithm never passes the certified bound, and only rises (Fig. 6)", "[experiments]") {
  const ExperimentResult result = run("fig6?runs=3&generations=8", {"shape:pyramid?rotate=random"});
  REQUIRE(result.data[0]["final"].size() == 3);
  for (const double r : result.data[0]["final"]) CHECK(r <= result.data[0]["upper"].get<double>());
  CHECK_THROWS_AS(run("fig6?domain=nowhere"), ParameterError);
}

TEST_CASE("Experiments are the same for any number of threads, and the seed matters", "[experiments]") {
  const Experiment& deletion = find_experiment("fig13");
  const auto go = [&](std::uint64_t seed) {
    ExperimentContext context;
    context.meshes = {"shape:blob?faces=600"};
    context.seed = seed;
    context.gap = 1e-4;
    return deletion.make({{"runs", 2}}, context);
  };
  const ExperimentResult many = go(1);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const ExperimentResult alone = go(1);
  CHECK(many.data == alone.data);
  CHECK(many.sheets[0].svg == alone.sheets[0].svg);
  CHECK(many.data != go(2).data);
}

TEST_CASE("A stopped experiment throws, and writes nothing", "[experiments]") {
  std::stop_source source;
  source.request_stop();
  ExperimentContext context;
  context.stop = source.get_token();
  CHECK_THROWS_AS(find_experiment("fig15").make(Json::object(), context), Stopped);
}

TEST_CASE("Thumbnails are PNG files, whatever the mesh", "[experiments]") {
  const auto is_png = [](const std::string& file) { return file.starts_with("\x89PNG\r\n") && file.size() > 100; };
  const std::string sphere = render::thumbnail(make_shape(Spec::parse("sphere?subdivisions=2")), render::Up::kZ);
  CHECK(is_png(sphere));
  CHECK(sphere != render::thumbnail(make_shape(Spec::parse("box")), render::Up::kZ));
  // Neither scale nor place matters; a power of two keeps every bit.
  CHECK(sphere == render::thumbnail(make_shape(Spec::parse("sphere?subdivisions=2&scale=1024")), render::Up::kZ));
  CHECK(is_png(render::thumbnail(Mesh{}, render::Up::kY)));
  Mesh flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}}, {{0, 1, 2}, {0, 3, 0}}};  // no area
  CHECK(is_png(render::thumbnail(flat, render::Up::kY)));
  for (Vector3& p : flat.vertices) p *= 0.8e308;  // as large as can be
  CHECK(is_png(render::thumbnail(flat, render::Up::kY)));
}

TEST_CASE("The chair has about the faces asked for, and stands", "[experiments]") {
  for (const int faces : {500, 5000}) {
    const Mesh mesh = figures::chair({.faces = faces});
    CHECK(static_cast<double>(mesh.triangles.size()) == Approx(faces).epsilon(0.2));
    CHECK(largest_extent(mesh) == Approx(1).epsilon(0.1));
    const auto lowest = std::ranges::min_element(mesh.vertices, {}, [](const Vector3& p) { return p.z(); });
    CHECK(lowest->z() == 0);
  }
}
