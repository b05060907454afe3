// The global minimum with a proof: branch and bound on the cubic fundamental zone.
//
// A search that returns a rotation says "I met nothing better". certify() says "nothing better exists, except
// by less than the gap". The idea in three steps, for objectives of the form value(Q) = h(q1) + h(q2) + h(q3)
// (see objective.h):
//
// *One box.* The 24 frames that differ by a symmetry of the cube have the same value, and one of each 24 lies in the
// cubic fundamental zone, a small polyhedron of Rodrigues vectors. On a box of such vectors a cut
//
//     value(Q) >= g1 . q1 + g2 . q2 + g3 . q3
//
// is one quadratic polynomial divided by another, and its least value on the box is nearly always at a corner: eight
// products bound the value of every rotation in the box from below. Several cuts can be mixed, and the best mixture is
// the solution of a small game between cuts and corners.
//
// *All boxes.* The zone is halved, and its halves are halved again. A box whose bound is not below the best value found
// so far (less the gap) cannot hold anything better and is done; the least bound of all boxes bounds the minimum.
// Before a box is halved, those of its small parts are sifted out that single cuts settle without a game: most of
// them. Minima are sharp, because faces become parallel to axes there, so few boxes are left near them: some dozens
// for an ordinary mesh.
//
// *Flat landscapes.* On nearly round meshes every rotation is nearly as good as any other. Cuts are tangents there to
// something that curves away from them, and bounds from them would need very small boxes. So h itself is bounded from
// below on the part of the sphere that each axis sweeps: three numbers whose sum bounds the value.
//
//     const ProjectedArea objective(area_vectors(load_mesh("shape:pyramid").mesh));
//     Evaluator evaluator(objective);
//     const CertifyResult result = certify(evaluator, {.gap = 1e-6});
//     // result.lower <= min P/S <= result.incumbent.value, and rectilinearity() of the two differ by 1e-6 at most.
//
// The same search can write its proof down (certificate.h) for an independent program to check. papers/certificate.md
// has the lemmas and their proofs.
#pragma once

#include <memory>

#include "rectilin/optim/certificate.h"
#include "rectilin/optim/method.h"

namespace rectilin {

/// Settings of the search. It takes the box with the least bound first. A box is bounded by the best mixture of the
/// cuts known to it. Where these cuts are too weak, a new one is taken at the minimum of their upper envelope (Kelley
/// 1960); where the box is too large, it is halved. However the run ends, the evaluator's lower bound is a proved one.
struct CertifyOptions {
  double gap = 1e-6;       ///< stop when the merit is known to within this, or as closely as rounding allows
  int cells = 20'000'000;  ///< stop after this many boxes; 0: no limit
  double seconds = 0;      ///< stop after this time; 0: no limit
  int batch = 32;      ///< least number of boxes in a round, which has up to 16 times as many; the course of the search
                       ///< depends on it, but not on the number of threads
  int bundle = 3;      ///< cuts kept for each axis of a box
  int descent = 15;    ///< steps of the local search from each better rotation that is found
  bool balls = true;   ///< use balls around the incumbent in which nothing is better (needs generators)
  bool floors = true;  ///< where boxes get too many, bound h where their axes point to (needs generators)
  bool polish = true;  ///< at the end solve for the exact frame in which faces are parallel to axes (needs generators)
  bool optima = false;  ///< when the gap is closed, find all frames within it

  void bind(Parameters& table);
};

/// A set of frames within the gap of the best value. Distinct optima closer than the resolution are merged.
struct Optimum {
  enum class Kind {
    kPoint,      ///< a minimum; all other frames of the set are within 0.02 radians or in a ball in which none is lower
    kContinuum,  ///< a set of frames that extends further: a curve, or minima too close to tell apart
    kPossible,   ///< boxes that could not be excluded: no such frame was found there, or the budget ended
  };
  Kind kind = Kind::kPoint;
  Rotation rotation;  ///< the best frame found, as reduce_to_zone() returns it
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
  bool closed = false;              ///< the gap that was asked for was reached, or the narrowest that rounding allows
  std::uint64_t cells = 0;          ///< boxes that sifting left, bounded by mixtures of cuts or halved again
  std::uint64_t leaves = 0;         ///< boxes that were bounded without halving them
  double ball_angle = 0;            ///< radius (radians) of the ball around the incumbent that needed no boxes
  std::size_t floor_triangles = 0;  ///< triangles of the sphere on which h was bounded
  std::vector<Step> trajectory;     ///< one step for each change of value or lower
  std::vector<Optimum> optima;      ///< if they were asked for; best first
};

/// Throws ParameterError if the objective has no cuts. With `certificate` the run writes a proof that others can check;
/// it then does without balls and without sifting, because proofs of few large boxes are shorter, and takes about twice
/// as long. A run that is stopped before the gap is closed proves the bound that it has reached.
CertifyResult certify(Evaluator& evaluator, const CertifyOptions& options, Certificate* certificate = nullptr);

/// The optimizer `certify` for the registry and for make_optimizer(). What it proves is the evaluator's lower bound; it
/// gives no CertifyResult.
GlobalMethod<CertifyOptions> certify_method();

}  // namespace rectilin
