// Series, which most figures of the paper are: meshes that differ in one number, and R of each.
#pragma once

#include <string>
#include <vector>

#include "figures/sample.h"

namespace rectilin::paper::figures {

struct Series {
  std::string name;          ///< name of the files
  std::string title;         ///< title of the picture
  std::string caption;       ///< says what the picture shows
  report::Axis axis;         ///< axis of the number
  bool logarithmic = false;  ///< is the scale of R logarithmic?

  struct Member {
    double number;
    Sample sample;
  };
  std::vector<Member> members = {};   ///< by increasing number
  std::vector<Sample> compared = {};  ///< meshes without the number; each becomes a horizontal line
};

struct MeasuredSeries {
  std::vector<Measured> members, compared;
  ExperimentResult result;  ///< complete except for ExperimentResult::says
};

/// "falls from 1.0000 to 0.4000", "rises from ... to ..." or, if R does neither all the way, "goes from ... to ...".
std::string course_text(const std::vector<Measured>& members);

/// Measures all members and plots R against the number.
MeasuredSeries measure(const Series& series, const ExperimentContext& context);

}  // namespace rectilin::paper::figures
