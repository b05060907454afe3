// What the commands share in talking to a person: progress, tables, Ctrl-C.
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

/// "12 s left: " or "3 min left: ", to begin a text of progress with; nothing if the number is not finite.
std::string time_left(double seconds);

/// A line that says how far things are, rewritten in place on standard error. Says nothing if standard error
/// is not a terminal. Thread safe.
class Progress {
 public:
  explicit Progress(std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows "[done/total] text", the text made printable and cut.
  void show(std::size_t done, const std::string& text);
  /// The same with what was last said to be done: how one item is getting on.
  void note(const std::string& text);
  /// Calls show() for a loop over many items.
  OnProgress shown() {
    return [this](std::size_t done, std::size_t, const std::string& text) { show(done, text); };
  }
  /// Removes the line, so that something else can be printed.
  void clear();

 private:
  void draw(const std::string& text);

  std::mutex mutex_;
  std::size_t total_, done_ = 0;
  bool terminal_;
  bool shown_ = false;
};

/// Rows of text in columns of fixed width; the first column is flush left, the others right. Cells are made printable.
class Table {
 public:
  struct Column {
    std::string title;
    std::size_t width;  ///< at least, in columns of the terminal; the title's length counts, too
  };
  explicit Table(std::vector<Column> columns);

  std::string header() const;
  std::string row(const std::vector<std::string>& cells) const;

 private:
  std::vector<Column> columns_;
};

/// x with `digits` digits behind the point.
std::string fixed(double x, int digits);
/// x with `digits` significant digits.
std::string general(double x, int digits);

/// The words of a command line, quoted so that a shell reads them as they were: in single quotes where POSIX needs
/// them, in $'...' where a word has characters that cannot be shown.
std::string quoted_command_line(int argc, const char* const* argv);

/// A line for each setting: name, default, help.
std::string settings_table(const std::vector<Parameters::Description>& settings);

/// The widest of texts as a table shows them.
std::size_t widest(const std::vector<std::string>& texts);

/// Complains on standard error, in one line that begins with the program's name; control characters are shown, not
/// obeyed (see printable()).
void complain(const std::string& message);

/// Complains of what a reader left out of a mesh, if there is something: "NAME: " and summary() of the report.
void complain_of_loss(const std::string& name, const MeshReport& report);

/// A token that Ctrl-C (SIGINT), SIGTERM and SIGHUP stop. The second of them ends the program, as the first does as
/// long as nobody has asked for the token. Signals that are ignored when the program starts stay ignored. What ends the
/// program leaves no unfinished files.
std::stop_token stop_on_interrupt();

/// Sees to it that a signal leaves no unfinished files; to be called first of all.
void clean_up_on_signals();

/// Sends out what was printed to standard output; throws std::runtime_error if that fails.
void check_output();

}  // namespace rectilin::app
