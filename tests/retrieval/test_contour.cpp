// Outlines of small pictures drawn by hand.
#include <set>

#include "features/contour.h"
#include "features/ntu_contour.h"
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

TEST_CASE("The light field program's outline begins below, and ends where it began") {
  // Pavlidis's walk, to the right hand first where there is a choice, as seen with rows from below.
  const auto outline = pairs(ntu_contour(mask_of({".....", ".###.", ".###.", ".###.", "....."})));
  CHECK(outline ==
        std::vector<std::pair<int, int>>{{1, 3}, {1, 2}, {1, 1}, {2, 1}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {1, 3}});
  CHECK(ntu_contour(Mask(3)).empty());
  CHECK(ntu_contour(mask_of({"...", ".#.", "..."})).empty());  // fewer than eight pixels
}

TEST_CASE("Parts are joined for the light field program's outline, however far apart") {
  for (const int apart : {1, 2, 3, 4, 7, 20}) {
    INFO(apart);
    Mask mask(64);
    for (int y = 20; y < 30; ++y)
      for (int x = 10; x < 20; ++x) mask.pixels[mask.at(x, y)] = mask.pixels[mask.at(x + 10 + apart, y + 5)] = 1;
    const auto outline = pairs(ntu_contour(mask));
    REQUIRE_FALSE(outline.empty());
    CHECK(outline.front() == outline.back());
    const std::set<std::pair<int, int>> seen(outline.begin(), outline.end());
    CHECK(seen.contains({10, 20}));  // corners of both squares
    CHECK(seen.contains({29 + apart, 34}));
    for (const auto& [x, y] : seen) CHECK((x >= 10 && x <= 29 + apart && y >= 20 && y <= 34));
  }
}

TEST_CASE("Thinning keeps what it must, and what hung together by sides still does") {
  const auto parts = [](const Mask& mask) {
    Mask left = mask;
    int count = 0;
    for (int y = 0; y < mask.size; ++y)
      for (int x = 0; x < mask.size; ++x) {
        if (!left.covered(x, y)) continue;
        ++count;
        std::vector<Pixel> stack{{x, y}};
        while (!stack.empty()) {
          const Pixel p = stack.back();
          stack.pop_back();
          if (!left.covered(p.x, p.y)) continue;
          left.pixels[left.at(p.x, p.y)] = 0;
          for (const Pixel d : {Pixel{1, 0}, Pixel{-1, 0}, Pixel{0, 1}, Pixel{0, -1}})
            stack.push_back({p.x + d.x, p.y + d.y});
        }
      }
    return count;
  };
  Mask grown(30), kept(30);
  for (int y = 5; y < 25; ++y)
    for (int x = 5; x < 25; ++x) grown.pixels[grown.at(x, y)] = 1;
  for (const Pixel p : {Pixel{6, 6}, Pixel{20, 7}, Pixel{12, 22}}) kept.pixels[kept.at(p.x, p.y)] = 1;
  const Mask thin = thinned_to(grown, kept);
  for (std::size_t i = 0; i < thin.pixels.size(); ++i) {
    CHECK(thin.pixels[i] >= kept.pixels[i]);
    CHECK(thin.pixels[i] <= grown.pixels[i]);
  }
  CHECK(parts(thin) == 1);
  CHECK(std::ranges::count(thin.pixels, 1) < 80);  // of 400: lines between three points
}
