#include "rectilin/corpus/export_store.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "npy.h"
#include "rectilin/base/printable.h"
#include "rectilin/base/whole_file.h"
#include "store_access.h"

namespace rectilin::corpus {
namespace {

namespace fs = std::filesystem;
static_assert(std::endian::native == std::endian::little, "the numbers in the files are little-endian");

/// The columns of the query that all formats use.
enum Column {
  kName,
  kSource,
  kClass,
  kStatus,
  kDigest,
  kFaces,
  kArea,
  kR,
  kLower,
  kUpper,
  kSeconds,
  kVersion,
  kError,
  kResult,
  kReport
};
constexpr const char* kSelect =
    "SELECT name, source, class, status, digest, faces, area, rectilinearity, lower, upper, seconds, version, error,"
    " result, report FROM meshes WHERE status > 0 ORDER BY name";

const char* status_of(const Statement& row) { return to_string(static_cast<RowStatus>(row.integer(kStatus))); }

void append_number(std::string& out, double x) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
  out.append(digits.data(), end);
}

/// Text that other programs can read: see printable(). In JSON lines names stay as they are.
void append_cell(std::string& out, std::string_view given) {
  const std::string text = printable(given);
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) out.append(c == '"' ? 2 : 1, c);
  out += '"';
}

void append_csv(std::string& out, const Statement& row) {
  for (const int column :
       {kName, kClass, kStatus, kDigest, kFaces, kArea, kR, kLower, kUpper, kSeconds, kVersion, kError}) {
    if (column != kName) out += ',';
    if (column == kStatus) out += status_of(row);
    else if (column == kFaces) out += row.text(column);  // a whole number, or empty
    else if (column < kArea || column > kSeconds) append_cell(out, row.text(column));
    else if (!row.is_null(column)) append_number(out, row.real(column));
  }
  out += '\n';
}

void append_json(std::string& out, const Statement& row) {
  Json line = {{"name", row.text(kName)},
               {"source", row.text(kSource)},
               {"class", row.text(kClass)},
               {"status", status_of(row)}};
  if (!row.is_null(kDigest)) line["digest"] = row.text(kDigest);
  Json end = {{"seconds", row.real(kSeconds)}, {"version", row.text(kVersion)}};
  if (!row.is_null(kError)) end["error"] = row.text(kError);
  // Cuts the braces off stored JSON objects, so that their text is passed on byte for byte.
  const auto inside = [](std::string_view object) {
    return object.size() < 2 ? object : object.substr(1, object.size() - 2);
  };
  out += '{';
  out += inside(to_text(line));
  if (const std::string_view result = inside(row.text(kResult)); !result.empty()) out.append(",").append(result);
  if (!row.is_null(kReport)) out.append(",\"report\":").append(row.text(kReport));
  out.append(",").append(inside(to_text(end))).append("}\n");
}

template <class Number>
void append_raw(std::string& out, Number x) {
  std::array<char, sizeof x> bytes;
  std::memcpy(bytes.data(), &x, sizeof x);
  out.append(bytes.data(), bytes.size());
}

/// The nine numbers of a stored result's rotation; NaN if it has none.
std::array<double, 9> rotation_in(std::string_view result) {
  std::array<double, 9> numbers;
  numbers.fill(std::nan(""));
  constexpr std::string_view kKey = "\"rotation\":[[";
  const std::size_t found = result.find(kKey);
  if (found == std::string_view::npos) return numbers;
  const char* at = result.data() + found + kKey.size();
  const char* const end = result.data() + result.size();
  for (double& x : numbers) {
    const auto [next, error] = std::from_chars(at, end, x);
    if (error != std::errc()) break;
    at = next;
    while (at != end && (*at == ',' || *at == '[' || *at == ']')) ++at;
  }
  return numbers;
}

struct Widths {
  std::size_t name = 1, group = 1, rows = 0;
};

Widths widths_of(Database& database) {
  Statement most(database,
                 "SELECT max(length(CAST(name AS BLOB))), max(length(CAST(class AS BLOB))), count(*) FROM meshes"
                 " WHERE status > 0");
  most.step();
  const auto at_least_1 = [&](int column) {
    return static_cast<std::size_t>(std::max<std::int64_t>(1, most.integer(column)));
  };
  return {at_least_1(0), at_least_1(1), static_cast<std::size_t>(most.integer(2))};
}

std::string table_header(const Widths& widths) {
  std::vector<std::string> fields = {"('name', '|S" + std::to_string(widths.name) + "')",
                                     "('class', '|S" + std::to_string(widths.group) + "')", "('status', '|u1')",
                                     "('faces', '<i8')"};
  for (const char* name : {"area", "rectilinearity", "lower", "upper", "seconds"})
    fields.push_back("('" + std::string(name) + "', '<f8')");
  fields.push_back("('rotation', '<f8', (3, 3))");
  return npy_header(fields, widths.rows);
}

void append_record(std::string& out, const Statement& row, const Widths& widths) {
  append_bytes(out, row.text(kName), widths.name);
  append_bytes(out, row.text(kClass), widths.group);
  append_raw(out, static_cast<std::uint8_t>(row.integer(kStatus)));
  append_raw(out, row.is_null(kFaces) ? std::int64_t{-1} : row.integer(kFaces));
  for (const int column : {kArea, kR, kLower, kUpper, kSeconds}) append_raw(out, row.real(column));
  for (const double x : rotation_in(row.text(kResult))) append_raw(out, x);
}

}  // namespace

void export_store(Store& store, const fs::path& file) {
  const std::string format = file.extension().string();
  if (format != ".csv" && format != ".jsonl" && format != ".npy")
    throw ParameterError(file.string() + ": the extension is none of .csv, .jsonl, .npy");
  Database& database = StoreAccess::database(store);
  database.execute("BEGIN");  // a consistent view of the store, even while it is being written
  GrowingFile out(file);
  const Widths widths = widths_of(database);
  std::string text =
      format == ".csv" ? "name,class,status,digest,faces,area,rectilinearity,lower,upper,seconds,version,error\n" : "";
  if (format == ".npy") text = table_header(widths);
  Statement row(database, kSelect);
  while (row.step()) {
    if (format == ".csv") append_csv(text, row);
    else if (format == ".jsonl") append_json(text, row);
    else append_record(text, row, widths);
    constexpr std::size_t kPiece = 1 << 20;
    if (text.size() <= kPiece) continue;
    out.write(text);
    text.clear();
  }
  out.write(text);
  out.finish();
  database.execute("COMMIT");
}

}  // namespace rectilin::corpus
