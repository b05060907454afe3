#include "terminal.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <string_view>

#include "rectilin/base/printable.h"
#include "rectilin/base/system_reason.h"
#include "rectilin/base/unfinished_files.h"
#include "rectilin/mesh/mesh_report.h"

namespace rectilin::app {
namespace {

std::string printed(const char* format, int digits, double x) {
  char text[400];  // the longest double in fixed notation has 309 digits before the point
  const std::string_view shown(text, static_cast<std::size_t>(std::snprintf(text, sizeof text, format, digits, x)));
  const bool minus_zero = shown.starts_with('-') && shown.find_first_not_of("-0.") == std::string_view::npos;
  return std::string(minus_zero ? shown.substr(1) : shown);
}

std::stop_source& interrupt_source() {
  static std::stop_source source;
  return source;
}

std::atomic<bool> can_stop = false;  ///< somebody has asked for the token
static_assert(std::atomic<bool>::is_always_lock_free);

/// Ends the program as the signal would, but removes unfinished files first.
void end(int number) {
  remove_unfinished_files();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

void stop_or_end(int number) {
  if (!can_stop.exchange(false)) return end(number);
  interrupt_source().request_stop();  // safe in a handler: without callbacks this only sets an atomic flag
}

/// A word, quoted so that a shell reads it back.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_@%+=:,./-";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  const bool shown = is_printable(word);
  std::string quoted = shown ? "'" : "$'";
  for (const char c : word) {
    const auto byte = static_cast<unsigned char>(c);
    if (shown) {
      if (c == '\'') quoted += "'\\''";
      else quoted += c;
    } else if (c == '\'' || c == '\\') {
      quoted.append("\\").append(1, c);
    } else if (byte >= 0x20 && byte < 0x7F) {
      quoted += c;
    } else {  // always three octal digits, so that a digit that follows is not taken for one of them
      char code[8];
      std::snprintf(code, sizeof code, "\\%03o", static_cast<unsigned>(byte));
      quoted += code;
    }
  }
  return quoted + "'";
}

}  // namespace

std::string time_left(double seconds) {
  if (!std::isfinite(seconds)) return "";
  const long whole = std::lround(seconds);
  return whole < 100 ? std::to_string(whole) + " s left: " : std::to_string((whole + 30) / 60) + " min left: ";
}

Progress::Progress(std::size_t total) : total_(total), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { clear(); }

void Progress::show(std::size_t done, const std::string& text) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  draw(text);
}

void Progress::note(const std::string& text) {
  const std::lock_guard lock(mutex_);
  draw(text);
}

void Progress::draw(const std::string& text) {
  if (!terminal_) return;
  std::cerr << "\r\033[K[" << done_ << '/' << total_ << "] " << shortened(text, 100) << std::flush;
  shown_ = true;
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  if (shown_) std::cerr << "\r\033[K" << std::flush;
  shown_ = false;
}

Table::Table(std::vector<Column> columns) : columns_(std::move(columns)) {
  for (Column& column : columns_) column.width = std::max(column.width, column.title.size());
}

std::string Table::header() const {
  std::vector<std::string> titles;
  for (const Column& column : columns_) titles.push_back(column.title);
  return row(titles);
}

std::string Table::row(const std::vector<std::string>& cells) const {
  std::string text;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::string cell = printable(cells[i]);
    const std::string padding(columns_[i].width - std::min(columns_[i].width, width(cell)), ' ');
    text += i == 0 ? cell + padding : "  " + padding + cell;
  }
  return text;
}

std::string fixed(double x, int digits) { return printed("%.*f", digits, x); }
std::string general(double x, int digits) { return printed("%.*g", digits, x); }

std::string quoted_command_line(int argc, const char* const* argv) {
  std::string line;
  for (int i = 0; i < argc; ++i) line += (i > 0 ? " " : "") + shell_word(argv[i]);
  return line;
}

std::size_t widest(const std::vector<std::string>& texts) {
  std::size_t columns = 0;
  for (const std::string& text : texts) columns = std::max(columns, width(printable(text)));
  return columns;
}

std::string settings_table(const std::vector<Parameters::Description>& settings) {
  const Table table({{"", 14}, {"", 12}});
  std::string text;
  for (const auto& s : settings)
    text.append("      ")
        .append(table.row({s.name, s.value.is_string() ? s.value.get<std::string>() : to_text(s.value)}))
        .append("   " + s.help + " (" + s.accepts + ")\n");
  return text;
}

void complain(const std::string& message) { std::cerr << "rectilin: " << printable(message) << '\n'; }

void complain_of_loss(const std::string& name, const MeshReport& report) {
  if (const std::string loss = summary(report); !loss.empty()) complain(name + ": " + loss);
}

void check_output() {
  errno = 0;
  if (std::cout.flush()) return;
  // Writing failed before, and the reason was not kept: trying once more makes the system say it again.
  if (errno == 0 && write(STDOUT_FILENO, "\n", 1) == 1) errno = 0;
  throw std::runtime_error("standard output: cannot be written" + (errno != 0 ? ": " + system_reason(errno) : ""));
}

void clean_up_on_signals() {
  interrupt_source();  // must exist before the handler can use it
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU, SIGXFSZ}) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    const bool may_stop = number == SIGINT || number == SIGTERM || number == SIGHUP;
    struct sigaction action {};
    action.sa_handler = may_stop ? stop_or_end : end;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, nullptr);
  }
}

std::stop_token stop_on_interrupt() {
  can_stop = true;
  return interrupt_source().get_token();
}

}  // namespace rectilin::app
