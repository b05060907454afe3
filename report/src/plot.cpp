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
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>

#include "rectilin/base/printable.h"
#include "rectilin/base/system_reason.h"
#include "rectilin/base/whole_file.h"

extern char** environ;

namespace rectilin::report {
namespace {

constexpr std::array<const char*, LineStyle::kColours> kPalette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                                   "#e69f00", "#56b4e9", "#000000", "#b5a900"};
constexpr std::array<const char*, LineStyle::kDashes> kDashes = {"", "9,4", "2,3", "9,3,2,3", "16,4", "5,3,5,3,1,3"};

constexpr std::size_t kLegend = 26, kPanelTitle = 30, kRowName = 30,
                      kTitle = 64;  // columns of text that a title has room for

/// A placeholder for the plot's name in its commands, until the name is known. Text that is shown cannot contain it,
/// because all of it is made printable.
constexpr char kName = '\x01';
const std::string kData = std::string("'") + kName + ".csv'";

/// A gnuplot string. Between single quotes only these characters of printable text are special.
std::string gnuplot_string(const std::string& text) {
  std::string result = "'";
  for (const char c : printable(text)) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

/// The same for a label of a tic, which gnuplot would read as a format for the number of the tic.
std::string tic_string(const std::string& text) {
  std::string format;
  for (const char c : text) format += c == '%' ? std::string("%%") : std::string(1, c);
  return gnuplot_string(format);
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
  text << "# Draws " << kName << ".svg from " << kName << ".csv: gnuplot " << kName << ".gp\n"
       << "reset session\nset encoding utf8\n"
       << "set terminal svg size " << size.width << ',' << size.height << " dynamic font 'sans-serif," << font
       << "' background rgb 'white' name 'figure'\n"
       << "set output '" << kName << ".svg'\n"
       << "set datafile separator comma\nset datafile missing ''\n";
  return text.str();
}

std::string axis(const char* name, const Axis& a, bool small) {
  std::ostringstream text;
  if (!a.label.empty())
    // An empty line below the label keeps it away from the legend.
    text << "set " << name << "label " << gnuplot_string(a.label)
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
    text << kData << " skip 1 using " << band.x << ':' << band.low << ':' << band.high << " with filledcurves fc rgb '"
         << hex_colour(band.style.colour) << "' fs transparent solid 0.2 noborder notitle";
  }
  for (const auto& curve : panel.curves) {
    next();
    text << kData << " skip 1 using " << curve.x << ':' << curve.y << " with "
         << (curve.steps    ? "steps "
             : curve.points ? "linespoints pt 7 ps 0.6 "
                            : "lines ")
         << (curve.faint ? "lc rgb '#c8c8c8' lw 1 dt solid" : line(curve.style, width));
    if (curve.label.empty()) text << " notitle";
    else text << " title " << gnuplot_string(shortened(curve.label, kLegend)) << " noenhanced";
  }
  text << '\n';
  return text.str();
}

/// Columns of the legend: three or, if the names are long, two.
int legend_columns(const Panel& panel) {
  return std::ranges::any_of(panel.curves, [](const auto& curve) { return width(curve.label) > 14; }) ? 2 : 3;
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
  text << terminal(size, 13) << "set title " << gnuplot_string(shortened(title, kTitle)) << " noenhanced\n"
       << "set key bmargin center horizontal Left reverse samplen 2.5 font ',11' maxcols " << columns << " noenhanced\n"
       << "set grid lc rgb '#e0e0e0' lw 1\nset border 3\nset tics nomirror\n"
       << axis("x", panel.x, false) << axis("y", panel.y, false) << plot(panel, 2.2);
  return text.str();
}

std::string grid(const std::string& title, const std::vector<Panel>& panels, int columns, Plot::Size size) {
  std::ostringstream text;
  text << terminal(size, 12) << "set multiplot layout " << rows_of(panels.size(), columns) << ',' << columns
       << " title " << gnuplot_string(shortened(title, kTitle))
       << " noenhanced\nunset key\nset tmargin 2.6\nset bmargin 3.3\nset rmargin 2\n"
       << "set grid lc rgb '#e8e8e8' lw 1\nset border 3\nset tics nomirror\n";
  for (const Panel& panel : panels)
    text << "set title " << gnuplot_string(shortened(panel.title, kPanelTitle)) << " noenhanced offset 0,-0.5\n"
         << axis("x", panel.x, true) << axis("y", panel.y, true) << plot(panel, 2);
  text << "unset multiplot\n";
  return text.str();
}

/// Margins of a heat map, for its names and its scale.
struct Margins {
  int left, bottom, right = 95, top = 42;
};

/// If a map has more rows, its top and bottom are not visible at once, so the names of columns are at both.
constexpr std::size_t kTallMap = 30;

Margins margins(const HeatMap& map) {
  const auto longest = [](const std::vector<std::string>& names) {
    std::size_t length = 1;
    for (const std::string& name : names) length = std::max(length, std::min(width(printable(name)), kRowName));
    return static_cast<int>(length);
  };
  // The names of rows are left of the map; those of columns are below it, slanted to the left.
  const int leaning = 5 * longest(map.columns) + 30;
  Margins margin{std::max(8 * longest(map.rows) + 20, 6 * longest(map.columns) - 20), leaning};
  if (map.rows.size() > kTallMap) margin.top += leaning;
  return margin;
}

Plot::Size size_of(const HeatMap& map) {
  const Margins margin = margins(map);
  return {margin.left + margin.right + 15 + 56 * static_cast<int>(map.columns.size()),
          margin.bottom + margin.top + 18 + 30 * static_cast<int>(map.rows.size())};
}

/// Each cell is a coloured box with its number: black on light colours, white on dark ones.
std::string heat_map(const HeatMap& map, Plot::Size size) {
  const Margins margin = margins(map);
  std::ostringstream text;
  text << terminal(size, 13) << "set title " << gnuplot_string(map.title) << " noenhanced\nunset key\n"
       << "set lmargin at screen " << static_cast<double>(margin.left) / size.width << "\nset rmargin at screen "
       << 1 - static_cast<double>(margin.right) / size.width << "\nset bmargin at screen "
       << static_cast<double>(margin.bottom) / size.height << "\nset tmargin at screen "
       << 1 - static_cast<double>(margin.top) / size.height << "\n"
       << "set palette defined (0 '#fff7d6', 1 '#f5c767', 2 '#d98b4a', 3 '#8f4a63', 4 '#2e1f54')\n"
       << "set colorbox user origin screen " << 1 - (margin.right - 12.0) / size.width << ','
       << static_cast<double>(margin.bottom) / size.height << " size screen " << 14.0 / size.width << ','
       << 1 - static_cast<double>(margin.bottom + margin.top) / size.height << "\n"
       << "set cblabel " << gnuplot_string(map.scale) << " noenhanced\nset border lc rgb '#808080'\n"
       << "set xrange [-0.5:" << static_cast<double>(map.columns.size()) - 0.5 << "]\nset yrange ["
       << static_cast<double>(map.rows.size()) - 0.5 << ":-0.5]\nset tics scale 0 textcolor rgb 'black' noenhanced\n";
  std::string names;
  for (std::size_t i = 0; i < map.columns.size(); ++i)
    names += (i > 0 ? ", " : "") + tic_string(shortened(map.columns[i], kRowName)) + ' ' + std::to_string(i);
  text << "set xtics rotate by 40 right (" << names << ")\n";
  if (map.rows.size() > kTallMap)
    text << "set x2range [-0.5:" << static_cast<double>(map.columns.size()) - 0.5 << "]\nset x2tics rotate by 40 left ("
         << names << ")\n";
  text << "set ytics (";
  for (std::size_t i = 0; i < map.rows.size(); ++i)
    text << (i > 0 ? ", " : "") << tic_string(shortened(map.rows[i], kRowName)) << ' ' << i;
  text << ")\n";
  double least = INFINITY, largest = -INFINITY;
  for (const auto& row : map.values)
    for (const double v : row)
      if (std::isfinite(v)) least = std::min(least, v), largest = std::max(largest, v);
  if (!(largest > least)) largest = least + 1;
  if (std::isfinite(least)) text << "set cbrange [" << least << ':' << largest << "]\n";
  const std::size_t n = map.columns.size();
  const double middle = least + 0.6 * (largest - least);
  const char* const format = largest - least < 2 ? "'%.2f'" : "'%.1f'";
  text << "cell(c) = valid(c) ? column(c) : NaN\n"
       << "plot for [c=2:" << n + 1 << "] " << kData << " skip 1 using (c-2):0:(0.49):(0.49):(cell(c)) with boxxyerror "
       << "fs solid noborder lc palette, \\\n"
       << "     for [c=2:" << n + 1 << "] '' skip 1 using (c-2):0:(cell(c) < " << middle << " ? sprintf(" << format
       << ", cell(c)) : '') with labels tc rgb 'black', \\\n"
       << "     for [c=2:" << n + 1 << "] '' skip 1 using (c-2):0:(cell(c) >= " << middle << " ? sprintf(" << format
       << ", cell(c)) : '') with labels tc rgb 'white'\n";
  return text.str();
}

std::string with_name(const std::string& text, const std::string& name) {
  std::string result;
  for (const char c : text) result += c == kName ? name : std::string(1, c);
  return result;
}

/// The one line in gnuplot's output that says what is wrong; it follows the offending line and a caret.
std::string message_in(const std::string& said) {
  std::istringstream in(said);
  std::string last;
  for (std::string text; std::getline(in, text);) {
    if (text.find(" line ") != std::string::npos) return text;
    if (text.find_first_not_of(" \t\r^") != std::string::npos) last = text;
  }
  return last;
}

/// How a program ended that was run.
struct Ended {
  int status = 0;    ///< status as waitpid() gives it
  std::string said;  ///< what it wrote to standard error
};

/// Runs gnuplot on a file in a folder, without the user's settings (-d), which could change the plot. Throws PlotError
/// if gnuplot cannot be run.
Ended run_gnuplot(const std::filesystem::path& folder, const std::string& script) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw PlotError("gnuplot: " + system_reason(errno));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  std::string program = "gnuplot", option = "-d", file = script;
  char* arguments[] = {program.data(), option.data(), file.data(), nullptr};
  pid_t child = 0;
  const int problem = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  Ended ended;
  char buffer[4096];
  for (ssize_t got = 0;
       problem == 0 && ((got = read(ends[0], buffer, sizeof buffer)) > 0 || (got < 0 && errno == EINTR));)
    if (got > 0 && ended.said.size() < 100'000) ended.said.append(buffer, static_cast<std::size_t>(got));
  close(ends[0]);
  if (problem == ENOENT) throw NoGnuplot();
  if (problem != 0) throw PlotError("gnuplot: " + system_reason(problem));
  while (waitpid(child, &ended.status, 0) < 0 && errno == EINTR) {
  }
  return ended;
}

/// Is the file a complete SVG picture?
bool is_picture(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return false;
  const std::streamoff size = in.tellg(), tail = std::min<std::streamoff>(size, 64);
  std::string end(static_cast<std::size_t>(tail), '\0');
  in.seekg(size - tail);
  in.read(end.data(), tail);
  return end.find("</svg>") != std::string::npos;
}

}  // namespace

NoGnuplot::NoGnuplot() : PlotError("gnuplot is not installed: there are no pictures (Debian: gnuplot-nox)") {}

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
  const std::filesystem::path picture = folder / (name + ".svg");
  std::error_code ignored;
  std::filesystem::remove(picture, ignored);  // otherwise an old picture would pass for the new one
  const Ended ended = run_gnuplot(folder, name + ".gp");
  const std::string message = message_in(ended.said);
  std::string reason;
  if (WIFSIGNALED(ended.status)) reason = "it was ended by signal " + std::to_string(WTERMSIG(ended.status));
  else if (WEXITSTATUS(ended.status) != 0) reason = message.empty() ? "it failed" : message;
  else if (!is_picture(picture)) reason = message.empty() ? "it made no picture" : message;
  if (reason.empty()) return;
  std::filesystem::remove(picture, ignored);
  throw PlotError(picture.string() + ": gnuplot: " + reason);
}

PictureTroubles draw_all(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  std::mutex mutex;
  std::set<std::string> lines;
  bool failed = false;
  tbb::parallel_for_each(names, [&](const std::string& name) {
    std::string trouble;
    bool missing = false;
    try {
      draw(folder, name);
      return;
    } catch (const NoGnuplot& e) {
      missing = true;
      trouble = e.what();
    } catch (const PlotError& e) {
      trouble = e.what();
    }
    const std::lock_guard lock(mutex);
    lines.insert(trouble);
    failed = failed || !missing;
  });
  return {{lines.begin(), lines.end()}, failed};
}

}  // namespace rectilin::report
