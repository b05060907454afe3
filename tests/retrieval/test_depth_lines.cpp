// Depth lines of small pictures, and their distance by hand and against a plain recursion.
#include <functional>
#include <map>
#include <string>

#include "features/depth_lines.h"
#include "rectilin/base/random.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::retrieval;

namespace {

/// o outside, g gap, - level, / nearer, \ farther.
std::vector<LineState> line(const std::string& text) {
  std::vector<LineState> states;
  for (const char c : text) states.push_back(static_cast<LineState>(std::string("og-/\\").find(c)));
  return states;
}

std::string text_of(std::span<const LineState> states) {
  std::string text;
  for (const LineState s : states) text += "og-/\\"[static_cast<int>(s)];
  return text;
}

int changed(LineState a, LineState b) {
  if (a == b) return 0;
  const auto background = [](LineState s) { return s == LineState::kOutside || s == LineState::kGap; };
  if (background(a) != background(b)) return 2;
  return background(a) || a == LineState::kLevel || b == LineState::kLevel ? 1 : 2;
}

/// The definition, without tables.
int plain(const std::vector<LineState>& a, const std::vector<LineState>& b, int gap, int band) {
  std::map<std::pair<std::size_t, std::size_t>, int> known;
  const std::function<int(std::size_t, std::size_t)> cost = [&](std::size_t i, std::size_t j) -> int {
    if (std::abs(static_cast<int>(i) - static_cast<int>(j)) > band) return 1'000'000;
    if (i == 0 && j == 0) return 0;
    if (const auto found = known.find({i, j}); found != known.end()) return found->second;
    int least = 1'000'000;
    if (i > 0) least = std::min(least, cost(i - 1, j) + gap);
    if (j > 0) least = std::min(least, cost(i, j - 1) + gap);
    if (i > 0 && j > 0) least = std::min(least, cost(i - 1, j - 1) + changed(a[i - 1], b[j - 1]));
    return known[{i, j}] = least;
  };
  return cost(a.size(), b.size());
}

}  // namespace

TEST_CASE("Rows and columns of a picture as states") {
  render::DepthImage image;
  image.size = 8;
  image.depth.assign(64, 0);
  // One row: a level piece, a gap, a slope towards the viewer and a lone pixel. A step of level surface is at most
  // 2047.
  const std::vector<int> row{0, 30'000, 32'000, 0, 10'000, 20'000, 0, 5};
  for (std::size_t x = 0; x < 8; ++x) image.depth[3 * 8 + x] = static_cast<std::uint16_t>(row[x]);
  const std::vector<LineState> states = depth_lines(image);
  REQUIRE(states.size() == 128);
  CHECK(text_of(std::span(states).subspan(3 * 8, 8)) == "o--g//g-");
  CHECK(text_of(std::span(states).subspan(0, 8)) == "oooooooo");
  CHECK(text_of(std::span(states).subspan(64 + 4 * 8, 8)) == "ooo-oooo");  // column 4
}

TEST_CASE("Distances of lines by hand") {
  const auto distance = [](const char* a, const char* b, int gap, int band) {
    return line_distance(line(a), line(b), gap, band);
  };
  CHECK(distance("oo--oo", "oo--oo", 1, 3) == 0);
  CHECK(distance("oo--oo", "o--ooo", 1, 3) == 2);  // moved by one place: a state out, a state in
  CHECK(distance("oo--oo", "o--ooo", 2, 3) == 4);
  CHECK(distance("oo--oo", "o--ooo", 1, 0) == 4);  // nothing may move: two changes
  CHECK(distance("o/\\o", "o--o", 2, 1) == 2);
  CHECK(distance("//", "\\\\", 2, 1) == 4);
  CHECK(distance("ogo", "ooo", 1, 1) == 1);
}

TEST_CASE("Distances of random lines are the definition's, and symmetric") {
  Random random(5);
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t n = 1 + random.below(12);
    std::vector<LineState> a(n), b(n);
    for (auto& s : a) s = static_cast<LineState>(random.below(5));
    for (auto& s : b) s = random.chance(0.5) ? a[static_cast<std::size_t>(&s - b.data())] : LineState::kLevel;
    for (const int gap : {1, 2, 3})
      for (const int band : {0, 1, 3, 20}) {
        const int d = line_distance(a, b, gap, band);
        CHECK(d == plain(a, b, gap, band));
        CHECK(d == line_distance(b, a, gap, band));
        CHECK(d <= 2 * static_cast<int>(n));
      }
  }
}
