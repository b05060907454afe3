// Figures: a CSV file, a gnuplot file that draws it, and the SVG picture, side by side and of one name. The
// gnuplot file can be edited and drawn again: gnuplot NAME.gp
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "rectilin/report/csv.h"

namespace rectilin::report {

/// How curves are told apart: colours that people with any colour vision tell apart (Okabe and Ito 2008), and
/// beyond the eighth the dashes as well.
struct LineStyle {
  int colour = 0;  ///< modulo the palette's size
  int dash = 0;    ///< modulo the number of patterns; 0 is solid
  static constexpr int kColours = 8, kDashes = 6;
};

/// The palette's colour as #rrggbb.
std::string hex_colour(int colour);
/// Lengths of strokes and spaces, separated by commas; empty for a solid line.
std::string dash_pattern(int dash);

struct Axis {
  std::string label;
  bool logarithmic = false;
  double lower = 0, upper = 0;  ///< gnuplot's own choice if they are equal
  double step = 0;              ///< from tic to tic, on a linear axis; gnuplot's own choice if 0
};

/// A coordinate system with its curves. Columns are counted from 1, as in the CSV file's header.
struct Panel {
  std::string title;
  Axis x, y;

  struct Curve {
    int x = 1, y = 2;
    std::string label;  ///< in the legend; none if empty
    LineStyle style;
    bool steps = false;   ///< constant up to the next point
    bool points = false;  ///< every row is marked
    bool faint = false;   ///< thin and grey, to be compared with
  };
  struct Band {
    int x = 1, low = 2, high = 3;
    LineStyle style;
  };
  std::vector<Band> bands;  ///< drawn first
  std::vector<Curve> curves;
};

/// A table of colours, rows from the top: the CSV file has the row's name and then a number a column. Larger is
/// darker; cells without a number stay white.
struct HeatMap {
  std::string title, scale;  ///< what the numbers are
  std::vector<std::string> rows, columns;
  std::vector<std::vector<double>> values;  ///< [row][column], what the CSV file holds; NaN for none
};

/// A figure that could not be drawn.
class PlotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// There is no gnuplot.
class NoGnuplot : public PlotError {
 public:
  NoGnuplot();
};

class Plot {
 public:
  /// Panels in rows of `columns`; a single one has a legend below.
  Plot(std::string title, Csv data, std::vector<Panel> panels, int columns = 1);
  Plot(Csv data, const HeatMap& map);

  /// Writes NAME.csv and NAME.gp.
  void write(const std::filesystem::path& folder, const std::string& name) const;

  int width() const { return size_.width; }  ///< pixels at which the text has its usual size

  struct Size {
    int width, height;
  };

 private:
  Csv data_;
  Size size_;
  std::string commands_;  ///< with a character for the name
};

/// A figure with what is said of it; its files are NAME.csv, NAME.gp and NAME.svg.
struct NamedPlot {
  std::string name, caption;
  Plot plot;
};

/// Runs gnuplot on NAME.gp in its folder, without the settings in ~/.gnuplot. Thread safe. Throws NoGnuplot, or
/// PlotError in one line with the picture's name and gnuplot's reason; then there is no NAME.svg, not even an older
/// one.
void draw(const std::filesystem::path& folder, const std::string& name);

/// What went wrong with pictures.
struct PictureTroubles {
  std::vector<std::string> lines;  ///< one for each picture that failed; one if there is no gnuplot
  bool failed = false;             ///< a picture failed, though there is gnuplot
};

/// The same for many at once.
PictureTroubles draw_all(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace rectilin::report
