// Access to the file behind a database, for code that goes through all rows at once.
#pragma once

#include "rectilin/corpus/file_kind.h"
#include "rectilin/search/database.h"

namespace rectilin::search {

class DatabaseAccess {
 public:
  static corpus::Database& file(Database& database);
};

}  // namespace rectilin::search
