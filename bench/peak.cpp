#include "peak.h"

#include <cstring>

namespace rectilin::bench {
namespace {

// The flat kernel adds min(a x + b y + z, 0) to one sum for each direction. Compilers, given the
// same operations on registers in C++, move sums to the stack and back; hence assembly. All values
// are zero: on the processors at hand no instruction here takes longer for one number than for
// another.
#if defined(__x86_64__)

// clang-format off
#define RECTILIN_CLOBBERS "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", \
    "xmm9", "xmm10", "xmm11", "xmm12", "xmm13", "xmm14", "xmm15"
#define RECTILIN_EIGHT(F, R, P) F(R, P, 0) F(R, P, 1) F(R, P, 2) F(R, P, 3) \
    F(R, P, 4) F(R, P, 5) F(R, P, 6) F(R, P, 7)

// Sums in registers 0-7; 12 is the scratch register, 13 to 15 stand for slopes and faces.
#define RECTILIN_FUSED(R, P, i) \
    "vmovap" P " %%" R "13, %%" R "12\n" \
    "vfmadd132p" P " %%" R "14, %%" R "15, %%" R "12\n" \
    "vfmadd231p" P " %%" R "14, %%" R "15, %%" R "12\n" \
    "vminp" P " %%" R "15, %%" R "12, %%" R "12\n" \
    "vaddp" P " %%" R "12, %%" R #i ", %%" R #i "\n"
#define RECTILIN_PLAIN(R, P, i) \
    "movaps %%" R "13, %%" R "12\n" \
    "mulp" P " %%" R "14, %%" R "12\n" \
    "addp" P " %%" R "15, %%" R "12\n" \
    "movaps %%" R "13, %%" R "11\n" \
    "mulp" P " %%" R "14, %%" R "11\n" \
    "addp" P " %%" R "11, %%" R "12\n" \
    "minp" P " %%" R "15, %%" R "12\n" \
    "addp" P " %%" R "12, %%" R #i "\n"
#define RECTILIN_CLEAR_V(R, P, i) "vxorps %%xmm" #i ", %%xmm" #i ", %%xmm" #i "\n"
#define RECTILIN_CLEAR(R, P, i) "xorps %%xmm" #i ", %%xmm" #i "\n"
#define RECTILIN_SCRATCH_V "vxorps %%xmm13, %%xmm13, %%xmm13\n vxorps %%xmm14, %%xmm14, %%xmm14\n" \
    "vxorps %%xmm15, %%xmm15, %%xmm15\n"
#define RECTILIN_SCRATCH "xorps %%xmm13, %%xmm13\n xorps %%xmm14, %%xmm14\n xorps %%xmm15, %%xmm15\n"

#define RECTILIN_LOOP(NAME, STEP, CLEAR, SCRATCH, END, R, P, LANES) \
    double NAME(std::size_t rounds) { \
      std::size_t left = rounds; \
      asm volatile(RECTILIN_EIGHT(CLEAR, R, P) SCRATCH \
                   "1:\n" RECTILIN_EIGHT(STEP, R, P) RECTILIN_EIGHT(STEP, R, P) \
                   "sub $1, %0\n jnz 1b\n" END : "+r"(left) : : RECTILIN_CLOBBERS, "cc"); \
      return 16.0 * LANES * static_cast<double>(rounds); \
    }

RECTILIN_LOOP(single512, RECTILIN_FUSED, RECTILIN_CLEAR_V, RECTILIN_SCRATCH_V, "vzeroupper\n", "zmm", "s", 16)
RECTILIN_LOOP(double512, RECTILIN_FUSED, RECTILIN_CLEAR_V, RECTILIN_SCRATCH_V, "vzeroupper\n", "zmm", "d", 8)
RECTILIN_LOOP(single256, RECTILIN_FUSED, RECTILIN_CLEAR_V, RECTILIN_SCRATCH_V, "vzeroupper\n", "ymm", "s", 8)
RECTILIN_LOOP(double256, RECTILIN_FUSED, RECTILIN_CLEAR_V, RECTILIN_SCRATCH_V, "vzeroupper\n", "ymm", "d", 4)
RECTILIN_LOOP(single128, RECTILIN_PLAIN, RECTILIN_CLEAR, RECTILIN_SCRATCH, "", "xmm", "s", 4)
RECTILIN_LOOP(double128, RECTILIN_PLAIN, RECTILIN_CLEAR, RECTILIN_SCRATCH, "", "xmm", "d", 2)
// clang-format on

#endif

/// Sixty-four bytes: one load, or as many as the instruction set needs.
using Line = double __attribute__((vector_size(64)));

}  // namespace

RegisterLoop register_loop([[maybe_unused]] const std::string& target, [[maybe_unused]] Precision precision) {
#if defined(__x86_64__)
  const bool single = precision == Precision::kSingle;
  if (target.starts_with("AVX3")) return single ? single512 : double512;
  if (target == "AVX2") return single ? single256 : double256;
  if (target.starts_with("SS")) return single ? single128 : double128;
#endif
  return nullptr;
}

#if defined(__x86_64__)
__attribute__((target_clones("avx512f", "avx2", "default")))
#endif
double
read_arrays(const double* x, const double* y, const double* z, std::size_t size) {
  constexpr std::size_t kStep = sizeof(Line) / sizeof(double);
  constexpr std::size_t kAhead = 256;  // found by trial (Zen 5)
  Line sums[6] = {};
  for (std::size_t i = 0; i + 2 * kStep <= size; i += 2 * kStep) {
    const double* places[6] = {x + i, y + i, z + i, x + i + kStep, y + i + kStep, z + i + kStep};
    for (int k = 0; k < 6; ++k) {
      Line line;
      __builtin_prefetch(places[k] + kAhead);
      std::memcpy(&line, places[k], sizeof line);
      sums[k] += line;
    }
  }
  double total = 0;
  for (const Line& sum : sums)
    for (std::size_t lane = 0; lane < kStep; ++lane) total += sum[lane];
  return total;
}

}  // namespace rectilin::bench
