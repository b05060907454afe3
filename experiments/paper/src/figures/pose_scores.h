// How right poses are: models whose own axes are right, and the frames that a method found for them.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/base/rotation.h"
#include "rectilin/retrieval/classification.h"

namespace rectilin::paper::figures {

/// A pose of a model, in the coordinates in which its axes are the right ones.
struct ScoredPose {
  std::size_t model = 0;  ///< which
  std::string group;      ///< the model's class
  double angle = 0;       ///< degrees to the nearest of the 24 right frames
  /// The same but for bodies of revolution, of whose axes only one has a right place: degrees from this axis to the
  /// nearest axis of the frame.
  double revolved_angle = 0;
  double confidence = 1;
  Rotation frame;  ///< what was found, as rows
};

/// A share with the interval that Wilson (1927) gives it at 95 %.
struct Share {
  std::size_t hits = 0, of = 0;

  double value() const { return of == 0 ? 0 : static_cast<double>(hits) / static_cast<double>(of); }
  double lower() const;
  double upper() const;
};

enum class Rule { kPlain, kRevolved };

/// Poses within so many degrees.
Share share_within(const std::vector<ScoredPose>& poses, double degrees, Rule rule);

/// Of the half with the greater confidence; ties by the order given.
Share surer_half(std::vector<ScoredPose> poses, double degrees, Rule rule);

/// Pairs of different models of one class whose frames are within so many degrees of each other, as seen from the
/// models' own axes: a method may be consistent and wrong. Poses of equal rank among those of their model are compared.
Share consistency(const std::vector<ScoredPose>& poses, double degrees);

/// The class of each model in a classification, by the model's name.
std::map<std::string, std::string> classes_by_model(const retrieval::Classification& classification);

/// The class of a mesh file by its name: the stem, or the stem less a leading m; nothing if it is in none.
std::optional<std::string> class_of(const std::string& source, const std::map<std::string, std::string>& classes);

}  // namespace rectilin::paper::figures
