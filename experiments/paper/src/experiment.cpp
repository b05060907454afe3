#include "rectilin/paper/experiment.h"

#include "figures/experiments.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/laboratory/provenance.h"
#include "rectilin/mesh/source.h"

namespace rectilin::paper {

Mesh ExperimentContext::load(const std::string& source) const {
  std::error_code ignored;
  const bool is_pipe = !is_shape_source(source) && std::filesystem::is_fifo(source, ignored);
  const auto read = [&] {
    LoadedMesh loaded = load_mesh(source);
    losses->add(source, loaded.report);
    return std::move(loaded.mesh);
  };
  if (!is_pipe) return read();
  const std::lock_guard lock(from_pipes->mutex);
  const auto known = from_pipes->meshes.find(source);
  return known != from_pipes->meshes.end() ? known->second : from_pipes->meshes[source] = read();
}

const std::vector<Experiment>& experiments() {
  using namespace figures;
  static const std::vector<Experiment> all{
      fig1(),   fig2(),  fig5(),   fig6(),   fig7(),   fig8(),   fig9(),   fig10(), fig11(),         fig12(),
      fig13(),  fig14(), fig15(),  fig16(),  fig17(),  fig18(),  fig19(),  fig20(), pose_accuracy(), gallery(),
      table1(), fig21(), table2(), table3(), table4(), table5(), table6(), fig22(), gap(),           shortfall(),
  };
  return all;
}

const Experiment& find_experiment(const std::string& name) {
  std::vector<std::string> known;
  for (const Experiment& experiment : experiments()) {
    if (experiment.name == name) return experiment;
    known.push_back(experiment.name);
  }
  throw_unknown_name("experiment", name, known);
}

ExperimentOutcome run_experiment(const Experiment& experiment, const Json& settings, const ExperimentContext& given,
                                 const std::filesystem::path& folder, const std::string& command_line) {
  ExperimentContext context = given;
  context.losses = std::make_shared<LossLog>();  // of this experiment alone
  if (!context.meshes.empty() && experiment.takes.empty())
    throw ParameterError(experiment.name + " makes its own meshes and takes no others");
  const ExperimentResult result = experiment.make(settings, context);

  std::filesystem::create_directories(folder);
  Json pictures = Json::array();
  std::vector<std::string> names;
  for (const Sheet& sheet : result.sheets) {
    sheet.data.write(folder / (sheet.name + ".csv"));
    write_whole_file(folder / (sheet.name + ".svg"), sheet.svg);
    pictures.push_back({{"name", sheet.name}, {"caption", sheet.caption}, {"width", sheet.width}});
  }
  for (const report::NamedPlot& plot : result.plots) {
    plot.plot.write(folder, plot.name);
    names.push_back(plot.name);
    pictures.push_back({{"name", plot.name}, {"caption", plot.caption}, {"width", plot.plot.width()}});
  }
  Json all = {{"experiment", experiment.name}, {"title", experiment.help},
              {"says", result.says},           {"settings", settings},
              {"seed", context.seed},          {"gap", context.gap},
              {"meshes", context.meshes},      {"data", result.data},
              {"errors", result.errors},       {"left_out", context.losses->lines()},
              {"pictures", pictures},          {"provenance", laboratory::provenance(command_line)}};
  if (!result.table.empty()) {
    all["table"] = result.table;
    all["table_says"] = result.table_says;
  }
  // File names may be in any encoding: what is not UTF-8 is replaced.
  write_whole_file(folder / (experiment.name + ".json"), to_text(all, 1) + '\n');
  return {result.says, result.errors, context.losses->lines(), report::draw_all(folder, names)};
}

}  // namespace rectilin::paper
