// papers/claims.json as text.
#pragma once

namespace rectilin::claims_detail {

extern const char* const kLedger;

}  // namespace rectilin::claims_detail
