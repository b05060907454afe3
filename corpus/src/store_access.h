// The database behind a store, for what goes through all of it at once.
#pragma once

#include "rectilin/corpus/store.h"
#include "rectilin/corpus/sqlite.h"

namespace rectilin::corpus {

class StoreAccess {
 public:
  static Database& database(Store& store);
};

/// The columns of a row in the table, in the order in which read_row() expects them.
inline constexpr const char* kRowColumns =
    "name, source, class, status, digest, result, report, error, version, finished, seconds";
Row read_row(const Statement& statement);

}  // namespace rectilin::corpus
