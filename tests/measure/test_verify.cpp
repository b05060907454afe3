// Proofs are accepted as written, and refused if anything in them is changed.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "rectilin/measure/projected_area.h"
#include "rectilin/measure/verify.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/certify.h"
#include "support/catch.h"

using namespace rectilin;

namespace {

Json prove(const Mesh& mesh, const CertifyOptions& options = {}, Budget budget = {}) {
  const ProjectedArea objective(area_vectors(mesh));
  Evaluator evaluator(objective, budget);
  Certificate certificate;
  certify(evaluator, options, &certificate);
  return to_json(certificate, mesh_digest(mesh));
}

Mesh mesh_of(const std::string& shape) { return load_mesh("shape:" + shape).mesh; }

void require_refused(const Json& proof, const Mesh& mesh, const std::string& reason) {
  const Verdict verdict = verify_certificate(proof.dump(), mesh);
  REQUIRE_FALSE(verdict.accepted);
  REQUIRE_THAT(verdict.reason, Catch::Contains(reason));
}

}  // namespace

TEST_CASE("verify accepts what certify proves", "[verify]") {
  for (const char* spec : {"pyramid", "box?rotate=random", "cylinder?sides=64&rotate=random", "soup?faces=300",
                           "blob?faces=2000", "prism?sides=7&scale=1e-40"}) {
    INFO(spec);
    const Mesh mesh = mesh_of(spec);
    const Verdict verdict = verify_certificate(prove(mesh).dump(), mesh);
    INFO(verdict.reason);
    REQUIRE(verdict.accepted);
    REQUIRE(verdict.upper - verdict.lower <= 1.001e-6);
    REQUIRE(verdict.upper >= verdict.lower);
  }
}

TEST_CASE("verify accepts the finest proof there is", "[verify]") {
  for (const char* spec : {"pyramid", "prism?sides=7", "soup?faces=50"}) {
    INFO(spec);
    const Mesh mesh = mesh_of(spec);
    const Verdict verdict = verify_certificate(prove(mesh, {.gap = 0}).dump(), mesh);
    INFO(verdict.reason);
    REQUIRE(verdict.accepted);
  }
}

TEST_CASE("a run that is stopped proves what it got to", "[verify]") {
  const Mesh mesh = mesh_of("soup?faces=100");
  const double best = verify_certificate(prove(mesh).dump(), mesh).upper;
  double before = 1 + 1e-12;  // R of any mesh, with rounding
  for (const int cells : {1, 10, 100, 400}) {
    const Verdict verdict = verify_certificate(prove(mesh, {.cells = cells}).dump(), mesh);
    INFO(cells << " cells: " << verdict.reason);
    REQUIRE(verdict.accepted);
    REQUIRE(verdict.upper >= best - 1e-6);
    REQUIRE(verdict.upper <= before);
    before = verdict.upper;
  }
  REQUIRE(before < best + 0.05);
  for (int cells = 5; cells < 300; cells += 9) {
    const Mesh other = mesh_of("soup?faces=30&seed=" + std::to_string(cells));
    const Verdict verdict = verify_certificate(prove(other, {.gap = 0.01, .cells = cells}).dump(), other);
    INFO(cells << " cells: " << verdict.reason);
    REQUIRE(verdict.accepted);
  }
  for (const std::uint64_t evaluations : {2u, 7u, 100u}) {
    const Verdict verdict = verify_certificate(prove(mesh, {}, {.evaluations = evaluations}).dump(), mesh);
    INFO(evaluations << " evaluations: " << verdict.reason);
    REQUIRE(verdict.accepted);
    REQUIRE(verdict.upper >= best - 1e-6);
  }
}

TEST_CASE("verify refuses a proof that was tampered with", "[verify]") {
  const Mesh mesh = mesh_of("soup?faces=100");
  const Json proof = prove(mesh);
  REQUIRE(verify_certificate(proof.dump(), mesh).accepted);
  const auto changed = [&proof](auto change) {
    Json copy = proof;
    change(copy);
    return copy;
  };
  require_refused(proof, mesh_of("soup?faces=100&seed=2"), "another mesh");
  require_refused(changed([](Json& p) { p["lower"] = 0.5 * (p["lower"].get<double>() + p["value"].get<double>()); }),
                  mesh, "bound does not hold");
  require_refused(changed([](Json& p) { p["lower"] = p["value"].get<double>() + 1e-9; }), mesh, "exceeds the value");
  require_refused(changed([](Json& p) { p["value"] = p["value"].get<double>() - 1e-6; }), mesh, "value stated");
  require_refused(changed([](Json& p) { p["leaves"].erase(5); }), mesh, "leaf");
  require_refused(changed([](Json& p) { p["tree"] = p["tree"].get<std::string>() + "l"; }), mesh, "after its end");
  require_refused(changed([](Json& p) { p["tree"].get_ref<std::string&>().pop_back(); }), mesh, "not covered");
  require_refused(changed([](Json& p) { p["tree"].get_ref<std::string&>().back() = 'o'; }), mesh, "outside the zone");
  require_refused(changed([](Json& p) { p["tree"] = "f"; }), mesh, "general one");
  require_refused(changed([](Json& p) { p["tree"] = std::string(1000000, 'x'); }), mesh, "not covered");
  require_refused(changed([](Json& p) { p["leaves"][3][1][1] = -1.0; }), mesh, "negative");
  require_refused(changed([](Json& p) {
                    p["leaves"][3][1][1] = 0.5;
                    p["leaves"][3][1][0] = 1u << 30;
                  }),
                  mesh, "direction");
  require_refused(changed([](Json& p) { p["leaves"][3][1][0] = -1; }), mesh, "direction");
  require_refused(changed([](Json& p) { p["rotation"][0][0] = 2.0; }), mesh, "rotation");
  require_refused(changed([](Json& p) { p["version"] = 2; }), mesh, "version");
  require_refused(changed([](Json& p) { p["format"] = 7; }), mesh, "");
  require_refused(changed([](Json& p) { p["directions"][0] = Json::array({1, 2}); }), mesh, "three numbers");
  require_refused(changed([](Json& p) { p.erase("leaves"); }), mesh, "missing");
}

TEST_CASE("proofs of nearly round meshes rest on floors of h, and on true ones only", "[verify]") {
  const Mesh mesh = mesh_of("ellipsoid?a=1&b=1.02&c=1.05&faces=2000&rotate=random");
  const Json proof = prove(mesh, {.gap = 1e-5});
  const std::string tree = proof["tree"];
  REQUIRE(static_cast<std::size_t>(std::ranges::count(tree, 'h')) == proof["floors"].size());
  REQUIRE(proof["floors"].size() > 100);
  const Verdict verdict = verify_certificate(proof.dump(), mesh);
  INFO(verdict.reason);
  REQUIRE(verdict.accepted);
  REQUIRE(verdict.upper - verdict.lower <= 1.001e-5);

  const auto refused = [&](const std::string& reason, auto change) {
    Json copy = proof;
    change(copy);
    require_refused(copy, mesh, reason);
  };
  // Of what floors must add up to.
  const auto third_of = [](const Json& p) {
    double trace = 0;
    for (int k = 0; k < 3; ++k) trace += p["form"][k][k].get<double>();
    return (p["lower"].get<double>() - trace) / 3 + 1e-12;
  };
  // One axis gives what another is said to have: their sum is as before.
  refused("floors do not hold", [](Json& p) {
    p["floors"][7][0] = p["floors"][7][0].get<double>() + 0.01;
    p["floors"][7][1] = p["floors"][7][1].get<double>() - 0.01;
  });
  refused("do not add up", [](Json& p) { p["floors"][7][2] = p["floors"][7][2].get<double>() - 0.001; });
  refused("floor", [](Json& p) { p["floors"].erase(p["floors"].size() - 1); });
  refused("more floors", [](Json& p) { p["floors"].push_back(p["floors"][0]); });
  refused("three numbers", [](Json& p) { p["floors"][3] = Json::array({0.5, 0.5}); });
  refused("number", [](Json& p) { p["floors"][3][1] = "0.5"; });
  refused("malformed", [](Json& p) { p["floors"] = 1; });
  refused("form", [](Json& p) { p["form"] = nullptr; });
  refused("symmetric", [](Json& p) { p["form"][0][1] = p["form"][0][1].get<double>() + 1e-9; });
  refused("small", [](Json& p) { p["form"][2][2] = 1e9; });
  refused("floors do not", [](Json& p) { p["form"][0][0] = p["form"][0][0].get<double>() - 1e-4; });
  refused("floors do not", [](Json& p) { p["form"][0][0] = p["form"][0][0].get<double>() + 1e-4; });
  refused("floor", [](Json& p) { p.erase("floors"); });
  refused("floor", [](Json& p) { p.erase("form"); });
  // A box that needed cuts, said to need none: the incumbent's own, where there is nothing to spare.
  refused("floor", [&](Json& p) {
    std::string& text = p["tree"].get_ref<std::string&>();
    const double third = third_of(p);
    Json floors = Json::array();
    std::size_t at = 0;
    for (char& node : text) {
      if (node == 'h') floors.push_back(p["floors"][at++]);
      if (node == 'l') floors.push_back({third, third, third}), node = 'h';
    }
    p["floors"] = floors;
    p["leaves"] = Json::array();
  });
  // The whole zone as one box.
  refused("floors do not hold", [&](Json& p) {
    const double third = third_of(p);
    p["tree"] = "h";
    p["leaves"] = Json::array();
    p["floors"] = Json::array({Json::array({third, third, third})});
  });
}

TEST_CASE("verify refuses sums made to round upwards", "[verify]") {
  // A weight of less than half a unit in the last place of 1 leaves their sum at 1, but may raise the mixture.
  const Mesh mesh = mesh_of("soup?faces=100");
  Json proof = prove(mesh);
  Json& axis = proof["leaves"][0][0];
  for (int i = 0; i < 1000; ++i) axis.insert(axis.end(), {axis[0], 1.11e-16});
  require_refused(proof, mesh, "mixes more than");
}

TEST_CASE("verify refuses a certificate of many keys before it reads them", "[verify]") {
  std::string text = R"({"format":"rectilin certificate")";
  for (int i = 0; i < 10'000; ++i) text += ",\"" + std::to_string(i) + "\":0";
  const Verdict verdict = verify_certificate(text + "}", mesh_of("box"));
  CHECK_FALSE(verdict.accepted);
  CHECK(verdict.reason == "this is not a certificate");
}

TEST_CASE("verify refuses every truncation without a crash", "[verify]") {
  const Mesh mesh = mesh_of("pyramid");
  const std::string text = prove(mesh).dump();
  REQUIRE(verify_certificate(text, mesh).accepted);
  for (std::size_t length = 0; length < text.size(); length += 1 + length / 50)
    REQUIRE_FALSE(verify_certificate(text.substr(0, length), mesh).accepted);
  for (const char* nonsense :
       {"", "[]", "null", "{}", "[[[[[[", "\"l\"", "{\"format\":\"rectilin certificate\",\"version\":1}"})
    REQUIRE_FALSE(verify_certificate(nonsense, mesh).accepted);
}
