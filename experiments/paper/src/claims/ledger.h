// papers/claims.json as text.
#pragma once

namespace rectilin::paper::claims {

extern const char* const kLedger;

}  // namespace rectilin::paper::claims
