#include "rectilin/corpus/export_store.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <vector>

#include "json_member.h"
#include "npy.h"
#include "rectilin/base/printable.h"
#include "rectilin/base/whole_file.h"
#include "store_access.h"

namespace rectilin::corpus {
namespace {

namespace fs = std::filesystem;
static_assert(std::endian::native == std::endian::little, "the numbers in the files are little-endian");

/// The columns of the query that all formats use.
enum Column { kName, kSource, kClass, kStatus, kDigest, kFaces, kArea, kSeconds, kVersion, kError, kResult, kReport };
constexpr const char* kSelect =
    "SELECT name, source, class, status, digest, faces, area, seconds, version, error, result, report FROM meshes"
    " WHERE status > 0 ORDER BY name";

/// What tables show of the results of a task, besides faces and area: members of the JSON object.
struct Fields {
  std::vector<std::string_view> words, numbers;  ///< words are in CSV only
  std::vector<std::string_view> arrays;          ///< in NPY only: `rotation` (3 by 3) or `centre` (3)
};

Fields fields_of(const std::string& task) {
  if (task == "pose") return {{"chosen", "uniqueness"}, {"scale", "confidence"}, {"rotation", "centre"}};
  if (task == "compare") return {{"outcome"}, {"merit", "evaluations"}, {"rotation"}};
  return {{}, {"rectilinearity", "lower", "upper"}, {"rotation"}};
}

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

std::string csv_header(const Fields& fields) {
  std::string header = "name,class,status,digest,faces,area";
  for (const auto& names : {fields.words, fields.numbers})
    for (const std::string_view name : names) header.append(",").append(name);
  return header + ",seconds,version,error\n";
}

void append_csv(std::string& out, const Statement& row, const Fields& fields) {
  append_cell(out, row.text(kName));
  out += ',';
  append_cell(out, row.text(kClass));
  out.append(",").append(status_of(row)).append(",");
  append_cell(out, row.text(kDigest));
  out.append(",").append(row.text(kFaces)).append(",");  // a whole number, or empty
  if (!row.is_null(kArea)) append_number(out, row.real(kArea));
  const std::string_view result = row.text(kResult);
  for (const std::string_view name : fields.words) {
    out += ',';
    if (const std::string_view word = member_of(result, name); word.starts_with('"'))
      append_cell(out, parse_json(word).get<std::string>());
  }
  for (const std::string_view name : fields.numbers) {
    out += ',';
    if (const std::string_view number = member_of(result, name); number != "null") out += number;
  }
  out += ',';
  append_number(out, row.real(kSeconds));
  out += ',';
  append_cell(out, row.text(kVersion));
  out += ',';
  append_cell(out, row.text(kError));
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

/// Appends so many numbers of a JSON array, whatever its shape; NaN for those that it lacks.
void append_numbers(std::string& out, std::string_view array, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    array.remove_prefix(std::min(array.find_first_not_of(",[]"), array.size()));
    double x = std::nan("");
    const char* const end = std::from_chars(array.data(), array.data() + array.size(), x).ptr;
    array.remove_prefix(static_cast<std::size_t>(end - array.data()));
    append_raw(out, x);
  }
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

std::string table_header(const Widths& widths, const Fields& fields) {
  std::vector<std::string> columns = {"('name', '|S" + std::to_string(widths.name) + "')",
                                      "('class', '|S" + std::to_string(widths.group) + "')", "('status', '|u1')",
                                      "('faces', '<i8')"};
  const auto add = [&](std::string_view name) { columns.push_back("('" + std::string(name) + "', '<f8')"); };
  add("area");
  for (const std::string_view name : fields.numbers) add(name);
  add("seconds");
  for (const std::string_view name : fields.arrays)
    columns.push_back("('" + std::string(name) + "', '<f8', " + (name == "rotation" ? "(3, 3))" : "(3,))"));
  return npy_header(columns, widths.rows);
}

void append_record(std::string& out, const Statement& row, const Widths& widths, const Fields& fields) {
  append_bytes(out, row.text(kName), widths.name);
  append_bytes(out, row.text(kClass), widths.group);
  append_raw(out, static_cast<std::uint8_t>(row.integer(kStatus)));
  append_raw(out, row.is_null(kFaces) ? std::int64_t{-1} : row.integer(kFaces));
  append_raw(out, row.real(kArea));
  const std::string_view result = row.text(kResult);
  for (const std::string_view name : fields.numbers) append_numbers(out, member_of(result, name), 1);
  append_raw(out, row.real(kSeconds));
  for (const std::string_view name : fields.arrays)
    append_numbers(out, member_of(result, name), name == "rotation" ? 9 : 3);
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
  const Fields fields = fields_of(store.task().name);
  std::string text = format == ".csv" ? csv_header(fields) : format == ".npy" ? table_header(widths, fields) : "";
  Statement row(database, kSelect);
  while (row.step()) {
    if (format == ".csv") append_csv(text, row, fields);
    else if (format == ".jsonl") append_json(text, row);
    else append_record(text, row, widths, fields);
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
