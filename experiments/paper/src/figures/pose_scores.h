// How right poses are, judged on models whose own axes are known to be right.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/base/rotation.h"
#include "rectilin/retrieval/classification.h"

namespace rectilin::paper::figures {

/// A pose that a method found for a model, in the coordinates in which the model's axes are right.
struct ScoredPose {
  std::size_t model = 0;  ///< index of the model
  std::string group;      ///< the model's class
  double angle = 0;       ///< degrees to the nearest of the 24 right frames
  /// The same, except for bodies of revolution, which have only one axis with a right place: degrees from this axis to
  /// the nearest axis of the frame.
  double revolved_angle = 0;
  double confidence = 1;
  bool unique = true;  ///< does the method call its pose unique?
  Rotation frame;      ///< the frame found; its rows are the axes
};

/// A share with its 95 % interval (Wilson 1927).
struct Share {
  std::size_t hits = 0, of = 0;

  double value() const { return of == 0 ? 0 : static_cast<double>(hits) / static_cast<double>(of); }
  double lower() const;
  double upper() const;
};

enum class Rule { kPlain, kRevolved };

/// The share of poses within that many degrees.
Share share_within(const std::vector<ScoredPose>& poses, double degrees, Rule rule);

/// The same for the half of the poses with the greater confidence; ties are broken by order.
Share surer_half(std::vector<ScoredPose> poses, double degrees, Rule rule);

/// The share of pairs of different models of one class whose frames, relative to the models' own axes, are within that
/// many degrees of each other: a method may be consistent and wrong. The first pose of one model is compared with the
/// first of the other, the second with the second, and so on.
Share consistency(const std::vector<ScoredPose>& poses, double degrees);

/// Does a pose turn together with its model? `same` counts the pairs of turns of one model, both called unique, whose
/// frames differ by less than a millionth of a radian, as seen from the model's own axes; `widest` is the largest
/// such angle.
struct Steadiness {
  Share same;
  double widest = 0;  ///< radians
};
Steadiness steadiness(const std::vector<ScoredPose>& poses);

/// The class of each model in a classification, by model name.
std::map<std::string, std::string> classes_by_model(const retrieval::Classification& classification);

/// The class of a mesh file, by its name without extension, or by that without a leading m; nothing if no class has it.
std::optional<std::string> class_of(const std::string& source, const std::map<std::string, std::string>& classes);

}  // namespace rectilin::paper::figures
