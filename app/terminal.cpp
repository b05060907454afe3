#include "terminal.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <string_view>

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

}  // namespace

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
  std::cerr << "\r\033[K[" << done_ << '/' << total_ << "] " << text.substr(0, 100) << std::flush;
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
    const std::string padding(columns_[i].width - std::min(columns_[i].width, cells[i].size()), ' ');
    text += i == 0 ? cells[i] + padding : "  " + padding + cells[i];
  }
  return text;
}

std::string fixed(double x, int digits) { return printed("%.*f", digits, x); }
std::string general(double x, int digits) { return printed("%.*g", digits, x); }

std::string quoted_command_line(int argc, const char* const* argv) {
  std::string line;
  for (int i = 0; i < argc; ++i) {
    const std::string word = argv[i];
    const bool plain = word.find_first_of(" \t'\"?&*;()$`\\|<>#!") == std::string::npos;
    line += (i > 0 ? " " : "") + (plain ? word : "'" + word + "'");
  }
  return line;
}

std::string settings_table(const std::vector<Parameters::Description>& settings) {
  const Table table({{"", 14}, {"", 12}});
  std::string text;
  for (const auto& s : settings)
    text.append("      ")
        .append(table.row({s.name, s.value.is_string() ? s.value.get<std::string>() : s.value.dump()}))
        .append("   " + s.help + " (" + s.accepts + ")\n");
  return text;
}

void complain(const std::string& message) { std::cerr << "rectilin: " << message << '\n'; }

void check_output() {
  if (!std::cout.flush()) throw std::runtime_error("standard output: cannot be written (is the disk full?)");
}

std::stop_token stop_on_interrupt() {
  interrupt_source();  // made before the handler can ask for it
  std::signal(SIGINT, [](int) {
    std::signal(SIGINT, SIG_DFL);
    interrupt_source().request_stop();  // no callbacks are registered: an atomic store
  });
  return interrupt_source().get_token();
}

}  // namespace rectilin::app
