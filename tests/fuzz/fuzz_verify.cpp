// Fuzzes the checker of proofs (libFuzzer): whatever the text says, it must not be believed if it is wrong about the
// pyramid, whose R is known, and must not throw.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "rectilin/measure/verify.h"
#include "rectilin/mesh/shapes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const rectilin::Mesh mesh = rectilin::make_shape(rectilin::Spec::parse("pyramid"));
  static const double exact = 3 * (1 + std::sqrt(5.0)) / 4 - 2;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const rectilin::Verdict verdict = rectilin::verify_certificate(text, mesh);
  const bool right = verdict.accepted ? verdict.lower <= exact && verdict.upper >= exact
                                      : !verdict.reason.empty() && verdict.reason.find('\n') == verdict.reason.npos;
  if (!right) std::abort();
  return 0;
}
