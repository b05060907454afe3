// SQLite's C interface with owners and exceptions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace rectilin::corpus {

class Database;

/// A prepared statement. Text that is bound must live until step() or run(). Not thread safe.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);

  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, double x);  ///< NaN becomes NULL
  Statement& bind(int parameter, std::int64_t x);
  Statement& bind(int parameter, std::span<const std::uint8_t> bytes);  ///< must live as text must
  template <class Value>
  Statement& bind(int parameter, const std::optional<Value>& value) {
    return value ? bind(parameter, *value) : *this;  // a parameter not bound is NULL
  }

  /// Whether there is a row; without one the statement is ready to be bound anew.
  bool step();
  /// Runs a statement without rows, or skips them, and makes it ready to be bound anew.
  void run();
  void reset();

  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string_view text(int column) const;                ///< until the next step
  std::span<const std::uint8_t> bytes(int column) const;  ///< the same

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

class Database {
 public:
  enum class Mode {
    kRead,   ///< without ever writing to the file
    kWrite,  ///< made if it does not exist
    kHeal,   ///< for reading; what a program that was killed left unfinished is undone first, where the file allows it
  };

  /// Throws std::runtime_error, "FILE: reason", like everything here.
  Database(const std::filesystem::path& file, Mode mode);

  void execute(const std::string& sql);
  [[noreturn]] void fail() const;
  sqlite3* handle() const { return database_.get(); }
  const std::string& name() const { return name_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::string name_;
  std::unique_ptr<sqlite3, Close> database_;
};

/// Undoes what was done since it was made, unless commit() is called.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace rectilin::corpus
