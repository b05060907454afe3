// What gnuplot draws, looked at as text.
#include "rectilin/base/whole_file.h"
#include "rectilin/report/plot.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

namespace rectilin::report {
namespace {

constexpr const char* kGrey = "rgb(200, 200, 200)";
constexpr const char* kMark = "<use xlink:href='#gpPt6' transform='translate(";  // a filled circle at its place

/// The SVG file of one curve through three points.
std::string picture(const Panel::Curve& curve, int panels = 1) {
  Csv data({"x", "y"});
  for (const int x : {1, 2, 3}) data.row({x, x * x});
  Panel panel;
  panel.title = "squares";
  panel.curves = {curve};
  const test::ScratchFolder folder;
  Plot("a figure", data, std::vector<Panel>(static_cast<std::size_t>(panels), panel), panels)
      .write(folder.path(), "curve");
  draw(folder.path(), "curve");
  return test::text_of(folder.path() / "curve.svg");
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("curves are drawn as they are described") {
  const int panels = GENERATE(1, 2);
  Panel::Curve curve;
  curve.style.colour = 2;
  const std::string line = picture(curve, panels);
  CHECK_FALSE(contains(line, kGrey));
  CHECK_FALSE(contains(line, kMark));
  curve.faint = true;
  const std::string faint = picture(curve, panels);
  CHECK(contains(faint, kGrey));
  CHECK_FALSE(contains(faint, kMark));
  curve.points = true;
  CHECK(contains(picture(curve, panels), kMark));
}

TEST_CASE("text in figures is taken as it is") {
  Panel::Curve curve;
  curve.label = "a_b & <c> 'd' {e}";
  CHECK(contains(picture(curve), "a_b &amp; &lt;c> 'd' {e}"));
}

TEST_CASE("a figure that cannot be drawn is an error of one line") {
  const test::ScratchFolder folder;
  write_whole_file(folder.path() / "bad.gp", "plot 'missing.csv'\n");
  try {
    draw(folder.path(), "bad");
    FAIL("drawn");
  } catch (const PlotError& error) {
    CHECK_FALSE(contains(error.what(), "\n"));
    CHECK(contains(error.what(), "bad"));
  }
}

}  // namespace
}  // namespace rectilin::report
