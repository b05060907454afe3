#include "rectilin/report/plot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <tbb/parallel_for_each.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>

#include "rectilin/base/whole_file.h"

extern char** environ;

namespace rectilin {
namespace {

constexpr std::array<const char*, LineStyle::kColours> kPalette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                                   "#e69f00", "#56b4e9", "#000000", "#b5a900"};
constexpr std::array<const char*, LineStyle::kDashes> kDashes = {"", "9,4", "2,3", "9,3,2,3", "16,4", "5,3,5,3,1,3"};

constexpr std::size_t kLegend = 26, kPanelTitle = 30, kRowName = 30;  // characters that there is room for

/// A gnuplot string; nothing in it is special between single quotes but these.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
  return result + "'";
}

/// Long names keep their ends, where they differ.
std::string shortened(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return text;
  const std::size_t head = longest * 3 / 5, tail = longest - head - 2;
  return text.substr(0, head) + ".." + text.substr(text.size() - tail);
}

std::string line(const LineStyle& style, double width) {
  std::ostringstream text;
  const std::string dashes = dash_pattern(style.dash);
  text << "lc rgb '" << hex_colour(style.colour) << "' lw " << width << " dt "
       << (dashes.empty() ? "solid" : "(" + dashes + ")");
  return text.str();
}

std::string terminal(Plot::Size size, int font) {
  std::ostringstream text;
  text << "# Draws @NAME@.svg from @NAME@.csv: gnuplot @NAME@.gp\n"
       << "reset session\nset encoding utf8\n"
       << "set terminal svg size " << size.width << ',' << size.height << " dynamic font 'sans-serif," << font
       << "' background rgb 'white' name 'figure'\n"
       << "set output '@NAME@.svg'\n"
       << "set datafile separator comma\nset datafile missing ''\n";
  return text.str();
}

std::string axis(const char* name, const Axis& a, bool small) {
  std::ostringstream text;
  if (!a.label.empty())
    // The empty line below the label keeps the legend away from it.
    text << "set " << name << "label " << quoted(a.label)
         << (*name == 'x' ? ".\"\\n\" noenhanced offset 0,0.5\n" : " noenhanced\n");
  else text << "unset " << name << "label\n";
  text << (a.logarithmic ? "set" : "unset") << " logscale " << name << "\n";
  if (a.logarithmic) text << "set format " << name << " '10^{%T}'\n";
  else text << "set format " << name << " '%g'\n";
  const double decades = a.logarithmic && a.upper > a.lower ? std::log10(a.upper / a.lower) : 0;
  if (small && decades > 4.5)
    text << "set " << name << "tics 1e" << (decades > 9 ? 4 : 2) << "\nunset m" << name << "tics\n";
  else if (a.step > 0) text << "set " << name << "tics " << a.step << "\nset m" << name << "tics default\n";
  else if (decades > 7) text << "set " << name << "tics 100\nset m" << name << "tics 2\n";
  else text << "set " << name << "tics autofreq\nset m" << name << "tics default\n";
  if (a.upper > a.lower) text << "set " << name << "range [" << a.lower << ':' << a.upper << "]\n";
  else text << "set " << name << "range [*:*]\n";
  return text.str();
}

std::string plot(const Panel& panel, double width) {
  std::ostringstream text;
  const char* separator = "plot ";
  const auto next = [&] { text << separator, separator = ", \\\n     "; };
  for (const auto& band : panel.bands) {
    next();
    text << "'@NAME@.csv' skip 1 using " << band.x << ':' << band.low << ':' << band.high
         << " with filledcurves fc rgb '" << hex_colour(band.style.colour)
         << "' fs transparent solid 0.2 noborder notitle";
  }
  for (const auto& curve : panel.curves) {
    next();
    text << "'@NAME@.csv' skip 1 using " << curve.x << ':' << curve.y << " with "
         << (curve.steps    ? "steps "
             : curve.points ? "linespoints pt 7 ps 0.6 "
                            : "lines ")
         << (curve.faint ? "lc rgb '#c8c8c8' lw 1 dt solid" : line(curve.style, width));
    if (curve.label.empty()) text << " notitle";
    else text << " title " << quoted(shortened(curve.label, kLegend)) << " noenhanced";
  }
  text << '\n';
  return text.str();
}

/// Three entries a line of the legend or, if their names are long, two.
int legend_columns(const Panel& panel) {
  return std::ranges::any_of(panel.curves, [](const auto& curve) { return curve.label.size() > 14; }) ? 2 : 3;
}

int rows_of(std::size_t count, int columns) { return (static_cast<int>(count) + columns - 1) / columns; }

Plot::Size size_of(const std::vector<Panel>& panels, int columns) {
  if (panels.size() > 1) return {240 * columns, 40 + 180 * rows_of(panels.size(), columns)};
  const Panel& panel = panels.front();
  return {520, 380 + 18 * rows_of(panel.curves.size(), legend_columns(panel))};
}

std::string single(const std::string& title, const Panel& panel, Plot::Size size) {
  const int columns = legend_columns(panel);
  std::ostringstream text;
  text << terminal(size, 13) << "set title " << quoted(title) << " noenhanced\n"
       << "set key bmargin center horizontal Left reverse samplen 2.5 font ',11' maxcols " << columns << " noenhanced\n"
       << "set grid lc rgb '#e0e0e0' lw 1\nset border 3\nset tics nomirror\n"
       << axis("x", panel.x, false) << axis("y", panel.y, false) << plot(panel, 2.2);
  return text.str();
}

std::string grid(const std::string& title, const std::vector<Panel>& panels, int columns, Plot::Size size) {
  std::ostringstream text;
  text << terminal(size, 12) << "set multiplot layout " << rows_of(panels.size(), columns) << ',' << columns
       << " title " << quoted(title) << " noenhanced\nunset key\nset tmargin 2.6\nset bmargin 3.3\nset rmargin 2\n"
       << "set grid lc rgb '#e8e8e8' lw 1\nset border 3\nset tics nomirror\n";
  for (const Panel& panel : panels)
    text << "set title " << quoted(shortened(panel.title, kPanelTitle)) << " noenhanced offset 0,-0.5\n"
         << axis("x", panel.x, true) << axis("y", panel.y, true) << plot(panel, 2);
  text << "unset multiplot\n";
  return text.str();
}

/// Room round a heat map for names and scale.
struct Margins {
  int left, bottom, right = 95, top = 42;
};

Margins margins(const HeatMap& map) {
  const auto longest = [](const std::vector<std::string>& names) {
    std::size_t length = 1;
    for (const std::string& name : names) length = std::max(length, std::min(name.size(), kRowName));
    return static_cast<int>(length);
  };
  return {7 * longest(map.rows) + 20, 5 * longest(map.columns) + 30};
}

Plot::Size size_of(const HeatMap& map) {
  const Margins margin = margins(map);
  return {margin.left + margin.right + 15 + 56 * static_cast<int>(map.columns.size()),
          margin.bottom + margin.top + 18 + 30 * static_cast<int>(map.rows.size())};
}

/// Each cell is a coloured box with its number, in black on light colours and white on dark ones.
std::string heat_map(const HeatMap& map, Plot::Size size) {
  const Margins margin = margins(map);
  std::ostringstream text;
  text << terminal(size, 13) << "set title " << quoted(map.title) << " noenhanced\nunset key\n"
       << "set lmargin at screen " << static_cast<double>(margin.left) / size.width << "\nset rmargin at screen "
       << 1 - static_cast<double>(margin.right) / size.width << "\nset bmargin at screen "
       << static_cast<double>(margin.bottom) / size.height << "\nset tmargin at screen "
       << 1 - static_cast<double>(margin.top) / size.height << "\n"
       << "set palette defined (0 '#fff7d6', 1 '#f5c767', 2 '#d98b4a', 3 '#8f4a63', 4 '#2e1f54')\n"
       << "set colorbox user origin screen " << 1 - (margin.right - 12.0) / size.width << ','
       << static_cast<double>(margin.bottom) / size.height << " size screen " << 14.0 / size.width << ','
       << 1 - static_cast<double>(margin.bottom + margin.top) / size.height << "\n"
       << "set cblabel " << quoted(map.scale) << " noenhanced\nset border lc rgb '#808080'\n"
       << "set xrange [-0.5:" << static_cast<double>(map.columns.size()) - 0.5 << "]\nset yrange ["
       << static_cast<double>(map.rows.size()) - 0.5
       << ":-0.5]\nset tics scale 0 textcolor rgb 'black' noenhanced\nset xtics rotate by 40 right (";
  for (std::size_t i = 0; i < map.columns.size(); ++i)
    text << (i > 0 ? ", " : "") << quoted(shortened(map.columns[i], kRowName)) << ' ' << i;
  text << ")\nset ytics (";
  for (std::size_t i = 0; i < map.rows.size(); ++i)
    text << (i > 0 ? ", " : "") << quoted(shortened(map.rows[i], kRowName)) << ' ' << i;
  text << ")\n";
  double least = INFINITY, largest = -INFINITY;
  for (const auto& row : map.values)
    for (const double v : row)
      if (std::isfinite(v)) least = std::min(least, v), largest = std::max(largest, v);
  if (!(largest > least)) largest = least + 1;
  if (std::isfinite(least)) text << "set cbrange [" << least << ':' << largest << "]\n";
  const std::size_t n = map.columns.size();
  const double middle = least + 0.6 * (largest - least);
  text << "cell(c) = valid(c) ? column(c) : NaN\n"
       << "plot for [c=2:" << n + 1 << "] '@NAME@.csv' skip 1 using (c-2):0:(0.49):(0.49):(cell(c)) with boxxyerror "
       << "fs solid noborder lc palette, \\\n"
       << "     for [c=2:" << n + 1 << "] '' skip 1 using (c-2):0:(cell(c) < " << middle
       << " ? sprintf('%.1f', cell(c)) : '') with labels tc rgb 'black', \\\n"
       << "     for [c=2:" << n + 1 << "] '' skip 1 using (c-2):0:(cell(c) >= " << middle
       << " ? sprintf('%.1f', cell(c)) : '') with labels tc rgb 'white'\n";
  return text.str();
}

std::string with_name(std::string text, const std::string& name) {
  constexpr std::string_view kPlace = "@NAME@";
  for (std::size_t at = 0; (at = text.find(kPlace, at)) != std::string::npos; at += name.size())
    text.replace(at, kPlace.size(), name);
  return text;
}

std::string first_message(const std::filesystem::path& file) {
  std::ifstream in(file);
  for (std::string text; std::getline(in, text);)  // the message stands below the offending line and a caret
    if (text.find(" line ") != std::string::npos) return text;
  return "it failed";
}

}  // namespace

std::string hex_colour(int colour) { return kPalette[static_cast<std::size_t>(colour) % kPalette.size()]; }

std::string dash_pattern(int dash) { return kDashes[static_cast<std::size_t>(dash) % kDashes.size()]; }

Plot::Plot(std::string title, Csv data, std::vector<Panel> panels, int columns)
    : data_(std::move(data)),
      size_(size_of(panels, columns)),
      commands_(panels.size() == 1 ? single(title, panels.front(), size_) : grid(title, panels, columns, size_)) {}

Plot::Plot(Csv data, const HeatMap& map)
    : data_(std::move(data)), size_(size_of(map)), commands_(heat_map(map, size_)) {}

void Plot::write(const std::filesystem::path& folder, const std::string& name) const {
  data_.write(folder / (name + ".csv"));
  write_whole_file(folder / (name + ".gp"), with_name(commands_, name));
}

void draw(const std::filesystem::path& folder, const std::string& name) {
  const std::string script = name + ".gp", log = name + ".log";
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  std::string program = "gnuplot", file = script;
  char* arguments[] = {program.data(), file.data(), nullptr};
  pid_t child = 0;
  const int problem = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0) {
    std::filesystem::remove(folder / log);
    throw PlotError(problem == ENOENT ? "gnuplot is not installed: there are no pictures (Debian: gnuplot-nox)"
                                      : std::string("gnuplot: ") + std::strerror(problem));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const std::string message = WIFEXITED(status) && WEXITSTATUS(status) == 0 ? "" : first_message(folder / log);
  std::filesystem::remove(folder / log);
  if (!message.empty()) throw PlotError("gnuplot: " + message);
}

std::vector<std::string> draw_all(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  std::mutex mutex;
  std::set<std::string> troubles;
  tbb::parallel_for_each(names, [&](const std::string& name) {
    try {
      draw(folder, name);
    } catch (const PlotError& e) {
      const std::lock_guard lock(mutex);
      troubles.insert(e.what());
    }
  });
  return {troubles.begin(), troubles.end()};
}

}  // namespace rectilin
