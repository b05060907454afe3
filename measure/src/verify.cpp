// Written for readers who trust nothing: no merging of faces, no tree, no vector instructions, no code of the search.
#include "rectilin/measure/verify.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "rectilin/base/parameters.h"
#include "verify/floors.h"
#include "verify/part.h"

namespace rectilin {
namespace {

using verification::Face;
using verification::Floors;
using verification::least_on;
using verification::Part;

using Matrix3 = Eigen::Matrix3d;
using Extended3 = Eigen::Matrix<long double, 3, 1>;

/// All rounding errors in a bound, relative to S = 1. Three cuts: a block of kSummedBlock faces is summed in double
/// precision, with an error of kSummedBlock 2^-53 for each cut; everything between blocks is summed in extended
/// precision. A mixture adds kMostTerms of these cuts, and their weights likewise; everything else is a few roundoffs.
/// Then come the 27 coefficients of the polynomial.
constexpr std::size_t kSummedBlock = 1024, kMostTerms = 64;
constexpr double kAllowance = 1e-12;
static_assert(3 * (kSummedBlock + 2 * kMostTerms + 64) * 0x1p-53 < kAllowance / 2);
static_assert(std::numeric_limits<long double>::digits >= 64, "sums over blocks need more than double precision");

/// A certificate has two dozen words. A key is looked for among all earlier ones of its object when it is read:
/// 100,000 of them take 8 seconds, and the time grows with the square.
constexpr std::ptrdiff_t kMostQuotes = 1000;

constexpr double kHalfEdge = 0.41421356237309510;  // of the zone's cube, at least sqrt(2) - 1
constexpr int kMostHalvings = 12;                  // how often a leaf may be halved until its bound shows

/// Thrown to refuse the certificate, with the reason.
struct Refusal {
  std::string reason;
};

[[noreturn]] void refuse(std::string reason) { throw Refusal{std::move(reason)}; }

/// The area vectors of all triangles (half the cross product of two edges), divided by their total length.
std::vector<Face> area_vectors_of(const MeshView& mesh) {
  std::vector<Extended3> vectors;
  long double total = 0;
  for (const Triangle& t : mesh.triangles) {
    const Extended3 a = mesh.vertices[t[0]].cast<long double>(), b = mesh.vertices[t[1]].cast<long double>(),
                    c = mesh.vertices[t[2]].cast<long double>();
    const Extended3 e = b - a, f = c - a;
    vectors.emplace_back(e.y() * f.z() - e.z() * f.y(), e.z() * f.x() - e.x() * f.z(), e.x() * f.y() - e.y() * f.x());
    const Extended3& v = vectors.back();
    total += std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
  }
  if (!(total > 0) || !std::isfinite(total)) refuse("the mesh has no finite, positive area");
  std::vector<Face> faces;
  for (const Extended3& v : vectors)
    faces.push_back(
        {static_cast<double>(v.x() / total), static_cast<double>(v.y() / total), static_cast<double>(v.z() / total)});
  return faces;
}

/// sum s_i v_i, where s_i = +-1 says on which side of u the face is: |x . v_i| >= s_i x . v_i for every x, even where
/// rounding chose the side. So sum |x . v_i| is at least x . (the result).
Eigen::Vector3d cut(const std::vector<Face>& faces, const Eigen::Vector3d& u) {
  Extended3 total = Extended3::Zero();
  for (std::size_t begin = 0; begin < faces.size(); begin += kSummedBlock) {
    Eigen::Vector3d block = Eigen::Vector3d::Zero();
    for (std::size_t i = begin; i < std::min(begin + kSummedBlock, faces.size()); ++i) {
      const Face& v = faces[i];
      const double side = u.x() * v.x + u.y() * v.y + u.z() * v.z < 0 ? -1 : 1;
      block += side * Eigen::Vector3d(v.x, v.y, v.z);
    }
    total += block.cast<long double>();
  }
  return total.cast<double>();
}

/// Is sum_k g_k . r_k(rho) >= bound on the box, where g_k are the rows of g?
bool holds(const Matrix3& g, double bound, const Part& part, int halvings) {
  if (least_on(g, part) >= bound) return true;
  if (halvings == 0) return false;
  const int axis = part.longest();
  return holds(g, bound, part.half(axis, false), halvings - 1) && holds(g, bound, part.half(axis, true), halvings - 1);
}

double number(const Json& json) {
  if (!json.is_number()) refuse("a number is missing");
  const double x = json.get<double>();
  if (!std::isfinite(x)) refuse("a number is not finite");
  return x;
}

Eigen::Vector3d vector(const Json& json) {
  if (!json.is_array() || json.size() != 3) refuse("three numbers are missing");
  return {number(json[0]), number(json[1]), number(json[2])};
}

Matrix3 matrix(const Json& json, const std::string& name) {
  if (!json.is_array() || json.size() != 3) refuse(name + " is not three rows");
  Matrix3 rows;
  for (int k = 0; k < 3; ++k) rows.row(k) = vector(json[k]).transpose();
  return rows;
}

/// The mixture of cuts that a leaf states for one axis.
Eigen::Vector3d mixture(const Json& terms, const std::vector<Eigen::Vector3d>& cuts, const std::string& where) {
  if (!terms.is_array() || terms.size() % 2 != 0 || terms.empty()) refuse(where + ": an axis is not a list of pairs");
  if (terms.size() > 2 * kMostTerms)
    refuse(where + ": an axis mixes more than " + std::to_string(kMostTerms) + " cuts");
  double sum = 0;
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < terms.size(); i += 2) {
    if (!terms[i].is_number_unsigned() || terms[i].get<std::uint64_t>() >= cuts.size())
      refuse(where + ": no such direction");
    const double weight = number(terms[i + 1]);
    if (!(weight >= 0)) refuse(where + ": a weight is negative");
    sum += weight;
    result += weight * cuts[terms[i].get<std::size_t>()];
  }
  if (!(std::abs(sum - 1) < 1e-9)) refuse(where + ": the weights do not add up to 1");
  return result / sum;
}

/// Checks a leaf with floors: three numbers that add up to `enough`, each a lower bound on what its axis sweeps.
void check_floors(const Json& json, const Part& part, double enough, Floors& floors, const std::string& where) {
  const Eigen::Vector3d stated = vector(json);
  if (!(stated.sum() >= enough)) refuse(where + ": its floors do not add up to the bound");
  switch (floors.check({stated[0], stated[1], stated[2]}, part, kMostHalvings)) {
    case Floors::Answer::kHolds:
      return;
    case Floors::Answer::kFails:
      refuse(where + ": its floors do not hold");
    case Floors::Answer::kTooMany:
      refuse(where + ": its floors would need too many triangles");
  }
}

/// Walks through the tree with an explicit stack instead of recursion. Every box is halved, checked or outside the
/// zone, so when the stack is empty the leaves cover the zone.
std::size_t check_leaves(const std::string& tree, const Json& leaves, const Json& stated_floors,
                         const std::vector<Eigen::Vector3d>& cuts, Floors& floors, double trace, double lower) {
  std::vector<Part> open = {{Eigen::Vector3d::Constant(-kHalfEdge), Eigen::Vector3d::Constant(kHalfEdge)}};
  std::size_t leaf = 0, floor = 0;
  for (const char node : tree) {
    if (open.empty()) refuse("the tree goes on after its end");
    const Part part = open.back();
    open.pop_back();
    if (node == 'x' || node == 'y' || node == 'z') {
      open.push_back(part.half(node - 'x', true));
      open.push_back(part.half(node - 'x', false));
    } else if (node == 'o') {
      if (!part.outside_zone()) refuse("a box said to be outside the zone is not");
    } else if (node == 'l') {
      const std::string where = "leaf " + std::to_string(leaf);
      if (leaf >= leaves.size()) refuse(where + " is missing");
      const Json& axes = leaves[leaf++];
      if (!axes.is_array() || axes.size() != 3) refuse(where + ": three axes are missing");
      Matrix3 g;
      for (int k = 0; k < 3; ++k) g.row(k) = mixture(axes[k], cuts, where).transpose();
      if (!holds(g, lower + kAllowance, part, kMostHalvings)) refuse(where + ": its bound does not hold");
    } else if (node == 'h') {
      const std::string where = "floor " + std::to_string(floor);
      if (floor >= stated_floors.size()) refuse(where + " is missing");
      check_floors(stated_floors[floor++], part, lower - trace + kAllowance, floors, where);
    } else {
      refuse("the tree has an unknown node");
    }
  }
  if (!open.empty()) refuse("the tree ends too early: a part of the zone is not covered");
  if (leaf != leaves.size()) refuse("there are more leaves than the tree has");
  if (floor != stated_floors.size()) refuse("there are more floors than the tree has");
  return leaf + floor;
}

/// P/S at the rotation, rounded up.
double value_at(const std::vector<Face>& faces, const Matrix3& r) {
  if (!((r * r.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff() < 1e-12) || !(r.determinant() > 0))
    refuse("the rotation is not one");
  long double sum = 0;
  for (const Face& v : faces)
    for (int k = 0; k < 3; ++k) sum += std::abs(r(k, 0) * v.x + r(k, 1) * v.y + r(k, 2) * v.z);
  return static_cast<double>(sum) + 1e-11;  // the nearest true rotation may differ by the tolerance above
}

Verdict check(const Json& json, const MeshView& mesh) {
  if (!json.is_object() || json.value("format", "") != "rectilin certificate") refuse("this is not a certificate");
  if (json.value("version", 0) != 1) refuse("the certificate's version is not 1");
  for (const char* key : {"mesh", "rotation", "value", "lower", "tree", "directions", "leaves"})
    if (!json.contains(key)) refuse(std::string("'") + key + "' is missing");
  if (json["mesh"] != mesh_digest(mesh)) refuse("the certificate is about another mesh");
  const std::vector<Face> faces = area_vectors_of(mesh);

  const Matrix3 rotation = matrix(json["rotation"], "the rotation");
  // A proof with cuts alone has neither of these.
  const Json stated_floors = json.value("floors", Json::array());
  const Matrix3 form = json.contains("form") ? matrix(json["form"], "the form") : Matrix3::Zero();
  if (form != form.transpose() || form.cwiseAbs().maxCoeff() > 1) refuse("the form is not symmetric and small");
  const double value = value_at(faces, rotation), lower = number(json["lower"]);
  if (!(std::abs(value - number(json["value"])) < 1e-10)) refuse("the rotation does not have the value stated");
  if (!(lower > 0)) refuse("the bound is not positive");
  if (lower > value) refuse("the bound exceeds the value");

  Verdict verdict;
  if (!json["tree"].is_string() || !json["leaves"].is_array() || !json["directions"].is_array() ||
      !stated_floors.is_array())
    refuse("the tree, the leaves, the floors or the directions are malformed");
  const std::string tree = json["tree"];
  if (tree == "f") {  // |R v|_1 >= |v|, summed over the faces: P >= S
    if (lower > 1) refuse("the bound exceeds the general one, which is all that is claimed");
  } else {
    std::vector<Eigen::Vector3d> cuts;
    for (const Json& direction : json["directions"]) cuts.push_back(cut(faces, vector(direction)));
    verdict.cuts = cuts.size();
    Floors floors(faces, form);
    verdict.leaves = check_leaves(tree, json["leaves"], stated_floors, cuts, floors, form.trace(), lower);
  }
  verdict.accepted = true;
  constexpr double kRounding = 0x1p-50;  // rounding of the next two lines
  verdict.lower = 3 / value - 2 - kRounding;
  verdict.upper = 3 / lower - 2 + 3 / lower * kRounding;
  return verdict;
}

}  // namespace

std::string mesh_digest(const MeshView& mesh) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      for (const double coordinate : mesh.vertices[corner]) {
        auto bits = std::bit_cast<std::uint64_t>(coordinate);
        for (int byte = 0; byte < 8; ++byte, bits >>= 8) hash = (hash ^ (bits & 0xff)) * 0x100000001b3u;
      }
  char text[32];
  std::snprintf(text, sizeof text, "fnv1a64:%016llx", static_cast<unsigned long long>(hash));
  return text;
}

Verdict verify_certificate(std::string_view text, const MeshView& mesh) {
  Verdict verdict;
  try {
    if (std::ranges::count(text, '"') > kMostQuotes) refuse("this is not a certificate");
    return check(parse_json(text), mesh);
  } catch (const Refusal& refusal) {
    verdict.reason = refusal.reason;
  } catch (const Json::exception&) {
    verdict.reason = "the certificate is truncated or not JSON of the right shape";
  }
  return verdict;
}

}  // namespace rectilin
