// The ledger of claims: reads it from JSON and prints it as a table.
#include "rectilin/paper/claims.h"

#include <sstream>

#include "claims/ledger.h"
#include "rectilin/base/parameters.h"

namespace rectilin::paper {
namespace {

Claim claim_from_json(const Json& entry) {
  Claim claim;
  claim.id = entry.at("claim");
  claim.source = entry.at("source");
  claim.statement = entry.at("statement");
  claim.test = entry.at("test");
  claim.tolerance = entry.at("tolerance");
  claim.why = entry.at("why");
  claim.code = entry.at("code");
  claim.should_hold = entry.value("should_hold", true);
  claim.remark = entry.value("remark", "");
  return claim;
}

/// The text as a cell of a Markdown table, which must not contain a bar.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace

const std::vector<Claim>& all_claims() {
  static const std::vector<Claim> all = [] {
    std::vector<Claim> list;
    for (const Json& entry : parse_json(claims::kLedger)) list.push_back(claim_from_json(entry));
    return list;
  }();
  return all;
}

std::string claims_markdown() {
  std::ostringstream out;
  out << "| claim | source | what is claimed | how it is tested | tolerance of the margin | "
         "expected | code |\n"
         "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Claim& claim : all_claims()) {
    out << "| `" << claim.id << "` | " << cell(claim.source) << " | " << cell(claim.statement) << " | "
        << cell(claim.test) << " | " << to_text(claim.tolerance) << ": " << cell(claim.why) << " | "
        << (claim.should_hold ? "holds" : "fails") << (claim.remark.empty() ? "" : ". ") << cell(claim.remark) << " | `"
        << claim.code << "` |\n";
  }
  return out.str();
}

std::string_view to_string(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::kFails:
      return "fails";
    case ClaimVerdict::kHolds:
      return "holds";
    case ClaimVerdict::kHoldsWithMargin:
      return "holds with margin";
    case ClaimVerdict::kUntested:
      return "untested";
  }
  return "";
}

}  // namespace rectilin::paper
