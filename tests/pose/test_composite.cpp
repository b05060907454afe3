// What the composite pose does where several frames are as good, or nearly the same.
#include <vector>

#include "pose_support.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::test;
using pose::Uniqueness;

namespace {

/// All frames that a pose calls as good as each other.
std::vector<Rotation> answers(const pose::Pose& pose) {
  std::vector<Rotation> frames = pose.alternatives;
  frames.push_back(pose.rotation);
  return frames;
}

/// A body whose projected area and mirror defects change little over a degree: frames found by mirror planes are as
/// good as the certified one, or better by what samples can tell.
Mesh pebble(double knob) {
  return together(shape("ellipsoid?a=4&b=2&c=1&faces=1000"),
                  moved(shape("pyramid"), rotation_from_euler(0.1, 0.2, 0.3), knob, {0.8, 0.7, 0.7}));
}

}  // namespace

TEST_CASE("a prism with five, six, eight or ten sides has so many poses, however it is turned", "[pose]") {
  // One of each pair of opposite sides lies flat, or one of each pair of edges for an odd number; quarter turns make
  // some of these one frame.
  Random random(21);
  for (const auto& [sides, count] : {std::pair(5, 5), std::pair(6, 3), std::pair(8, 2), std::pair(10, 5)}) {
    const Mesh mesh = shape("prism?sides=" + std::to_string(sides));
    const std::vector<Rotation> known = answers(pose_of("composite", mesh));
    for (int i = 0; i < 2; ++i) {
      const Rotation turn = random_rotation(random);
      const pose::Pose found = pose_of("composite", moved(mesh, turn));
      CAPTURE(sides, i);
      CHECK(found.uniqueness == Uniqueness::kSeveral);
      const std::vector<Rotation> frames = answers(found);
      CHECK(frames.size() == static_cast<std::size_t>(count));
      for (const Rotation& frame : known)
        CHECK(std::ranges::count_if(frames, [&](const Rotation& f) { return frame_angle(f * turn, frame) < 1e-6; }) ==
              1);
    }
  }
}

TEST_CASE("of frames a degree apart the certified one is the pose", "[pose]") {
  Random random(22);
  for (const double knob : {0.2, 0.4}) {
    const Rotation certified = pose_of("rectilinear", pebble(knob)).rotation, turn = random_rotation(random);
    const pose::Pose found = pose_of("composite", moved(pebble(knob), turn));
    CAPTURE(knob, found.reason);
    CHECK(frame_angle(found.rotation * turn, certified) < 1e-6);
    CHECK(found.uniqueness == Uniqueness::kUnique);
    // The test is of something: a frame less than a degree away has the better score.
    CHECK(std::ranges::any_of(found.candidates, [&](const pose::PoseCandidate& c) {
      return c.score < found.candidates.front().score && frame_angle(c.rotation, found.rotation) < kDegree;
    }));
  }
}
