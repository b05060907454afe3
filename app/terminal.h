// What the commands share when they talk to people: progress, tables, error messages, Ctrl-C.
#pragma once

#include <cstddef>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/base/parameters.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::app {

/// "12 s left: " or "3 min left: ", to put in front of a progress message; empty if the number is not finite.
std::string time_left(double seconds);

/// A progress line on standard error that is rewritten in place. It stays silent if standard error is not a terminal.
/// Thread safe.
class Progress {
 public:
  explicit Progress(std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows "[done/total] text"; the text is made printable and shortened.
  void show(std::size_t done, const std::string& text);
  /// Shows another text with the last count: how the current item is getting on.
  void note(const std::string& text);
  /// A function that calls show(), for loops over many items.
  OnProgress shown() {
    return [this](std::size_t done, std::size_t, const std::string& text) { show(done, text); };
  }
  /// Removes the line so that something else can be printed.
  void clear();

 private:
  void draw(const std::string& text);

  std::mutex mutex_;
  std::size_t total_, done_ = 0;
  bool terminal_;
  bool shown_ = false;
};

/// A table of text with columns of fixed width: the first column is left-aligned, the others right-aligned. Cells are
/// made printable.
class Table {
 public:
  struct Column {
    std::string title;
    std::size_t width;  ///< least width in columns of the terminal; a longer title makes it wider
  };
  explicit Table(std::vector<Column> columns);

  std::string header() const;
  std::string row(const std::vector<std::string>& cells) const;

 private:
  std::vector<Column> columns_;
};

/// x with `digits` digits after the decimal point.
std::string fixed(double x, int digits);
/// x with `digits` significant digits.
std::string general(double x, int digits);

/// A command line as text, quoted so that a shell reads the same words back: in single quotes where POSIX needs them,
/// in $'...' where a word has characters that cannot be shown.
std::string quoted_command_line(int argc, const char* const* argv);

/// A line for each setting with its name, default and help.
std::string settings_table(const std::vector<Parameters::Description>& settings);

/// The width of the widest text, as a table shows it.
std::size_t widest(const std::vector<std::string>& texts);

/// Prints an error message on standard error: one line that begins with the program's name. Control characters are
/// shown, not obeyed (see printable()).
void complain(const std::string& message);

/// Prints what a reader left out of a mesh, if anything: "NAME: " and summary() of the report.
void complain_of_loss(const std::string& name, const MeshReport& report);

/// A token that is stopped by Ctrl-C (SIGINT), SIGTERM and SIGHUP. A second signal ends the program; until somebody has
/// asked for the token, so does the first. Signals that were ignored when the program started stay ignored. A signal
/// that ends the program leaves no unfinished files behind.
std::stop_token stop_on_interrupt();

/// Makes sure that signals leave no unfinished files behind; must be called first in main().
void clean_up_on_signals();

/// Flushes standard output; throws std::runtime_error if that fails.
void check_output();

}  // namespace rectilin::app
