// Outlines of small pictures drawn by hand.
#include <set>

#include "features/contour.h"
#include "rectilin/base/random.h"
#include "support/catch.h"

using namespace rectilin::retrieval;

namespace {

Mask mask_of(const std::vector<std::string>& rows) {
  Mask mask(static_cast<int>(rows.size()));
  for (int y = 0; y < mask.size; ++y)
    for (int x = 0; x < mask.size; ++x)
      mask.pixels[mask.at(x, y)] = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#';
  return mask;
}

std::vector<std::pair<int, int>> pairs(const std::vector<Pixel>& pixels) {
  std::vector<std::pair<int, int>> list;
  for (const Pixel& p : pixels) list.emplace_back(p.x, p.y);
  return list;
}

}  // namespace

TEST_CASE("The outline of a square goes once around, without its inside and its hole") {
  const auto outline = outer_contour(mask_of({".....", ".###.", ".#.#.", ".###.", "....."}));
  CHECK(pairs(outline) ==
        std::vector<std::pair<int, int>>{{1, 1}, {2, 1}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {1, 3}, {1, 2}});
}

TEST_CASE("A line is walked there and back, a point is itself, and nothing is nothing") {
  CHECK(pairs(outer_contour(mask_of({"...", "###", "..."}))) ==
        std::vector<std::pair<int, int>>{{0, 1}, {1, 1}, {2, 1}, {1, 1}});
  CHECK(pairs(outer_contour(mask_of({"...", ".#.", "..."}))) == std::vector<std::pair<int, int>>{{1, 1}});
  CHECK(outer_contour(Mask(3)).empty());
}

TEST_CASE("The largest part is taken, corners connect, and the picture's border is no obstacle") {
  const auto outline = pairs(outer_contour(mask_of({"##..#", "....#", "...#.", "..#..", "....."})));
  CHECK(outline.front() == std::pair(4, 0));
  CHECK(outline.size() == 6);  // four pixels, the two in the middle twice
}

TEST_CASE("Outlines of random pictures are closed walks over boundary pixels") {
  rectilin::Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    Mask mask(12);
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x) mask.pixels[mask.at(x, y)] = random.chance(0.55);
    const std::vector<Pixel> outline = outer_contour(mask);
    REQUIRE_FALSE(outline.empty());
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Pixel p = outline[i], q = outline[(i + 1) % outline.size()];
      CHECK(mask.covered(p.x, p.y));
      if (outline.size() > 1) CHECK(std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) == 1);
    }
  }
}

TEST_CASE("Boundary pixels are those with an uncovered neighbour") {
  CHECK(boundary_pixels(mask_of({"#####", "#####", "#####", "#####", "#####"})) == 16);
  CHECK(boundary_pixels(mask_of({".....", ".###.", ".###.", ".###.", "....."})) == 8);
  CHECK(boundary_pixels(Mask(4)) == 0);
}
