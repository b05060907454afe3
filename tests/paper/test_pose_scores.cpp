// How right poses are: shares and intervals on cases that can be counted by hand.
#include <numbers>

#include "figures/pose_scores.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::paper::figures;

namespace {

ScoredPose scored(std::size_t model, const std::string& group, double degrees, double confidence = 1) {
  ScoredPose pose;
  pose.model = model;
  pose.group = group;
  pose.frame = rotation_from_vector(degrees * std::numbers::pi / 180 * Vector3(0, 0, 1));
  pose.angle = pose.revolved_angle = degrees;
  pose.confidence = confidence;
  return pose;
}

}  // namespace

TEST_CASE("shares within an angle, and Wilson's interval", "[paper]") {
  const std::vector<ScoredPose> poses = {scored(0, "a", 0, 0.9), scored(1, "a", 5, 0.8), scored(2, "b", 20, 0.1),
                                         scored(3, "b", 30, 0.2)};
  CHECK(share_within(poses, 10, Rule::kPlain).hits == 2);
  CHECK(share_within(poses, 5, Rule::kPlain).hits == 2);
  CHECK(share_within(poses, 2, Rule::kPlain).hits == 1);
  CHECK(surer_half(poses, 10, Rule::kPlain).hits == 2);
  CHECK(surer_half(poses, 10, Rule::kPlain).of == 2);
  // Wilson (1927) for 2 of 4: the middle is 1/2 by symmetry, half the width z / (2 sqrt(4 + z^2)).
  const Share half{2, 4};
  const double z = 1.959963984540054, width = z / (2 * std::sqrt(4 + z * z));
  CHECK(half.lower() == Approx(0.5 - width));
  CHECK(half.upper() == Approx(0.5 + width));
  CHECK(Share{0, 0}.lower() == 0);
  CHECK(Share{0, 0}.upper() == 1);
}

TEST_CASE("a body of revolution is judged by its axis", "[paper]") {
  ScoredPose pose = scored(0, "a", 30);
  pose.revolved_angle = 1;
  CHECK(share_within({pose}, 10, Rule::kPlain).hits == 0);
  CHECK(share_within({pose}, 10, Rule::kRevolved).hits == 1);
}

TEST_CASE("consistency counts pairs of a class, right or wrong", "[paper]") {
  // Two of class a alike though both are wrong; one of b beside none; quarter turns are no difference.
  const std::vector<ScoredPose> poses = {scored(0, "a", 20), scored(1, "a", 112), scored(2, "b", 0),
                                         scored(3, "a", 40)};
  const Share share = consistency(poses, 10);
  CHECK(share.of == 3);
  CHECK(share.hits == 1);
}

TEST_CASE("steadiness looks at turns of one model that are called unique", "[paper]") {
  ScoredPose open = scored(2, "a", 7);
  open.unique = false;
  const std::vector<ScoredPose> poses = {scored(0, "a", 3), scored(0, "a", 93), scored(0, "a", 4),
                                         scored(1, "a", 9), scored(2, "a", 3),  open};
  const Steadiness found = steadiness(poses);
  CHECK(found.same.of == 2);
  CHECK(found.same.hits == 1);
  CHECK(found.widest == Approx(std::numbers::pi / 180));
}
