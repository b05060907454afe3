// A C++ wrapper of SQLite: objects own what they open, and errors are exceptions.
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

/// A prepared statement. Text that is bound must stay valid until step() or run(). Not thread safe.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);

  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, double x);  ///< NaN becomes NULL
  Statement& bind(int parameter, std::int64_t x);
  Statement& bind(int parameter, std::span<const std::uint8_t> bytes);  ///< must stay valid, like text
  template <class Value>
  Statement& bind(int parameter, const std::optional<Value>& value) {
    return value ? bind(parameter, *value) : *this;  // a parameter that is not bound is NULL
  }

  /// Goes to the next row; returns false if there is none, and then the statement can be bound anew.
  bool step();
  /// Runs a statement and ignores its rows, if any; then it can be bound anew.
  void run();
  void reset();

  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string_view text(int column) const;                ///< valid until the next step()
  std::span<const std::uint8_t> bytes(int column) const;  ///< likewise

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
    kRead,   ///< reads, and never writes to the file
    kWrite,  ///< reads and writes; makes the file if it does not exist
    kHeal,   ///< reads; first undoes what a killed program left unfinished, if the file is writable
  };

  /// Throws std::runtime_error, "FILE: reason", as everything here does.
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

/// Undoes everything done during its lifetime, unless commit() is called.
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
