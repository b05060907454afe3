// Plots: a CSV file, a gnuplot file that draws it, and the SVG picture, in one folder and with one name. The gnuplot
// file can be edited and drawn again: gnuplot NAME.gp
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "rectilin/report/csv.h"

namespace rectilin::report {

/// How curves are told apart: by colours that people with any colour vision can tell apart (Okabe and Ito 2008), and
/// from the ninth curve on also by dashes.
struct LineStyle {
  int colour = 0;  ///< modulo the palette's size
  int dash = 0;    ///< modulo the number of patterns; 0 is solid
  static constexpr int kColours = 8, kDashes = 6;
};

/// The palette's colour as #rrggbb.
std::string hex_colour(int colour);
/// Lengths of dashes and gaps, separated by commas; empty for a solid line.
std::string dash_pattern(int dash);

struct Axis {
  std::string label;
  bool logarithmic = false;
  double lower = 0, upper = 0;  ///< chosen by gnuplot if they are equal
  double step = 0;              ///< distance of the tics on a linear axis; chosen by gnuplot if 0
};

/// A coordinate system with its curves. Columns are counted from 1, as in the CSV file's header.
struct Panel {
  std::string title;
  Axis x, y;

  struct Curve {
    int x = 1, y = 2;
    std::string label;  ///< its text in the legend; not in the legend if empty
    LineStyle style;
    bool steps = false;   ///< draws steps: constant up to the next point
    bool points = false;  ///< marks every row with a point
    bool faint = false;   ///< thin and grey, for comparison
  };
  struct Band {
    int x = 1, low = 2, high = 3;
    LineStyle style;
  };
  std::vector<Band> bands;  ///< drawn first
  std::vector<Curve> curves;
};

/// A table of coloured cells, rows from top to bottom. The CSV file has the name of the row and then a number for each
/// column. Larger numbers are darker; cells without a number stay white.
struct HeatMap {
  std::string title, scale;  ///< `scale` says what the numbers are
  std::vector<std::string> rows, columns;
  std::vector<std::vector<double>> values;  ///< [row][column], what the CSV file holds; NaN for none
};

/// A plot could not be drawn.
class PlotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// gnuplot is not installed.
class NoGnuplot : public PlotError {
 public:
  NoGnuplot();
};

class Plot {
 public:
  /// A plot of panels, `columns` in a row; a single panel has its legend below.
  Plot(std::string title, Csv data, std::vector<Panel> panels, int columns = 1);
  Plot(Csv data, const HeatMap& map);

  /// Writes NAME.csv and NAME.gp.
  void write(const std::filesystem::path& folder, const std::string& name) const;

  int width() const { return size_.width; }  ///< width in pixels at which the text has its normal size

  struct Size {
    int width, height;
  };

 private:
  Csv data_;
  Size size_;
  std::string commands_;  ///< gnuplot commands, with a placeholder for the name
};

/// A plot with its name and caption; its files are NAME.csv, NAME.gp and NAME.svg.
struct NamedPlot {
  std::string name, caption;
  Plot plot;
};

/// Runs gnuplot on NAME.gp in its folder, ignoring the settings in ~/.gnuplot. Thread safe. Throws NoGnuplot, or a
/// PlotError of one line with the plot's name and gnuplot's reason; then there is no NAME.svg, not even an older one.
void draw(const std::filesystem::path& folder, const std::string& name);

/// What went wrong while drawing plots.
struct PictureTroubles {
  std::vector<std::string> lines;  ///< one line for each plot that failed; a single one if there is no gnuplot
  bool failed = false;             ///< a plot failed although there is gnuplot
};

/// Draws many plots at once; does not throw if some fail.
PictureTroubles draw_all(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace rectilin::report
