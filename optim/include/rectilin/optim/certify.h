// A proof of the global minimum: branch and bound on the cubic fundamental zone.
//
// A search that returns a rotation says "nothing better was met". certify() says "nothing better exists, but for a
// gap". The idea in three steps, for objectives of the form value(Q) = h(q1) + h(q2) + h(q3) (objective.h):
//
// *One box.* The 24 frames that differ by a symmetry of the cube have one value, and each set of 24 has a member in the
// cubic fundamental zone, a small polyhedron of Rodrigues vectors. On a box of such vectors a cut
//
//     value(Q) >= g1 . q1 + g2 . q2 + g3 . q3
//
// is a quadratic over another, and its least value on the box is nearly always at a corner: eight products bound the
// value of every rotation in the box from below. Several cuts may be mixed, and the best mixture is a small game
// between cuts and corners.
//
// *All boxes.* The zone is halved, and halved again. A box whose bound is not below the best value met (less the gap)
// cannot hold anything better and is done; the least bound of all boxes bounds the minimum. Minima are sharp (faces
// become parallel to axes), so few boxes are needed near them: some hundred for an ordinary mesh.
//
// *Flat landscapes.* On nearly round meshes every rotation is nearly as good as any other, and cuts, which are
// tangents, lose to the curvature. There h itself is bounded on what each axis sweeps: three numbers that add up to
// enough.
//
//     const ProjectedArea objective(area_vectors(load_mesh("shape:pyramid").mesh));
//     Evaluator evaluator(objective);
//     const CertifyResult result = certify(evaluator, {.gap = 1e-6});
//     // result.lower <= min P/S <= result.incumbent.value, and rectilinearity() of the two differ by 1e-6 at most.
//
// The same search can write its proof down (certificate.h), for a program that shares no code with it to check.
// papers/certificate.md has the lemmas and their proofs.
#pragma once

#include <memory>

#include "rectilin/optim/certificate.h"
#include "rectilin/optim/method.h"

namespace rectilin {

/// Best first, over boxes of Rodrigues vectors (papers/certificate.md has the mathematics). A box is bounded by the
/// best mixture of cuts known to it; where the cuts are still too weak a new one is taken at the minimum of their
/// upper envelope (Kelley 1960), and where the box is too large it is halved. Whatever ends the run, the evaluator's
/// lower bound is a proved one.
struct CertifyOptions {
  double gap = 1e-6;  ///< stop when merit(lower bound) - merit(incumbent) is this small, or as small as rounding allows
  int cells = 20'000'000;  ///< stop after so many boxes; 0: no limit
  double seconds = 0;      ///< stop after so much time; 0: no limit
  int batch = 32;  ///< boxes a round at least, sixteen times as many at most; the result depends on it, but not on the
                   ///< number of threads
  int bundle = 6;  ///< cuts kept on each axis of a box
  int descent = 15;     ///< steps of the local search from every better rotation that turns up
  bool balls = true;    ///< use certified balls round the incumbent (needs generators)
  bool floors = true;   ///< bound h itself where axes point to when boxes get too many (needs generators)
  bool polish = true;   ///< in the end solve for the frame at which faces are parallel to axes (needs generators)
  bool optima = false;  ///< after closing the gap, find all frames within it

  void bind(Parameters& table);
};

/// A set of frames within the gap of the best value. Distinct optima closer than the resolution are merged.
struct Optimum {
  enum class Kind {
    kPoint,      ///< a minimum; other frames within the gap are near it (0.02 radians) or in a ball where none is lower
    kContinuum,  ///< frames within the gap that stretch further: a curve of them, or closer than can be told
    kPossible,   ///< cells that could not be excluded: no frame within the gap was found there, or the budget ended
  };
  Kind kind = Kind::kPoint;
  Rotation rotation;  ///< the best frame met, as reduce_to_zone() turns it
  double value = 0;
};

struct CertifyResult {
  /// The state after a number of boxes.
  struct Step {
    std::uint64_t cells;
    std::uint64_t evaluations;
    double seconds;
    double value;  ///< of the incumbent
    double lower;  ///< proved
  };

  Incumbent incumbent;
  double lower = 0;                 ///< no rotation has a smaller value
  bool closed = false;              ///< the gap asked for was reached, or the narrowest that rounding allows
  std::uint64_t cells = 0;          ///< boxes bounded
  std::uint64_t leaves = 0;         ///< boxes that needed no halving
  double ball_angle = 0;            ///< radians round the incumbent that needed no boxes
  std::size_t floor_triangles = 0;  ///< of the sphere, over which h was bounded
  std::vector<Step> trajectory;     ///< one step for each change of value or lower
  std::vector<Optimum> optima;      ///< if asked for, best first
};

/// Throws ParameterError if the objective has no cuts. With `certificate` the run records a proof that others can
/// check; it then does without balls, which costs a few per cent. A run that is stopped before the gap is closed proves
/// what it got to.
CertifyResult certify(Evaluator& evaluator, const CertifyOptions& options, Certificate* certificate = nullptr);

/// The optimizer `certify` for the registry and for make_optimizer(): it has the evaluator's lower bound as its proof,
/// but gives no CertifyResult.
GlobalMethod<CertifyOptions> certify_method();

}  // namespace rectilin
