// The experiments, each in a file of its own, and what turns an options struct into one.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "rectilin/paper/experiment.h"

namespace rectilin::paper::figures {

Experiment fig1();
Experiment fig2();
Experiment fig5();
Experiment fig6();
Experiment fig7();
Experiment fig8();
Experiment fig9();
Experiment fig10();
Experiment fig11();
Experiment fig12();
Experiment fig13();
Experiment fig14();
Experiment fig15();
Experiment fig16();
Experiment fig17();
Experiment fig18();
Experiment fig19();
Experiment fig20();
Experiment gallery();
Experiment table1();
Experiment fig21();
Experiment table2();
Experiment table3();
Experiment table4();
Experiment table5();
Experiment table6();
Experiment fig22();
Experiment gap();
Experiment pose_accuracy();
Experiment shortfall();

/// An experiment from a struct of settings with `bind(Parameters&)` and `run(const
/// ExperimentContext&) const`. `quick` are settings as after the '?' of a Spec: with them it takes
/// about a second.
template <class Settings>
Experiment make_experiment(const std::string& name, std::string title, std::string takes, const std::string& quick) {
  auto entry = Factory<ExperimentResult, const ExperimentContext&>::entry(
      name, std::move(title), Settings(),
      [](const Settings& settings, const ExperimentContext& context) { return settings.run(context); });
  std::string spec = name;
  if (!quick.empty()) spec.append("?").append(quick);
  return {std::move(entry), std::move(takes), Spec::parse(spec).settings};
}

}  // namespace rectilin::paper::figures
