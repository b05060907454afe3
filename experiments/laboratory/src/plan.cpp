#include "rectilin/laboratory/plan.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "rectilin/base/fnv1a.h"

namespace rectilin::laboratory {
namespace {

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> items(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool blank = std::isspace(static_cast<unsigned char>(text[i])) != 0;
    const bool in_number =
        i + 1 < text.size() && std::string_view("+-.0123456789").find(text[i + 1]) != std::string_view::npos;
    if (blank || (text[i] == ',' && !in_number)) items.emplace_back();
    else items.back() += text[i];
  }
  std::erase(items, "");
  return items;
}

/// Is it UTF-8, so that it can be stored and read back?
bool is_utf8(const std::string& text) { return parse_json(to_text(Json(text))).get<std::string>() == text; }

}  // namespace

LabelledSpec split_label(std::string_view text) {
  const std::size_t equals = text.substr(0, text.find('?')).find('=');
  if (equals == std::string_view::npos) return {text, text};
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<Entry> parse_entries(const std::vector<std::string>& lists, const std::vector<std::string>& domains,
                                 const Registry& registry) {
  for (const std::string& domain : domains) domain_by_name(domain);
  std::vector<Entry> entries;
  for (const std::string& list : lists) {
    for (const std::string& item : split_list(list)) {
      const LabelledSpec parts = split_label(item);
      const std::string label(parts.label);
      const std::size_t at = parts.spec.rfind('@');
      const std::string spec(parts.spec.substr(0, at));
      const bool uses_domain = registry.make(spec)->capabilities().uses_domain;
      if (at != std::string::npos) {
        const std::string domain(parts.spec.substr(at + 1));
        domain_by_name(domain);
        entries.push_back({label, spec, domain});
      } else if (uses_domain && domains.size() > 1) {
        for (const std::string& domain : domains) entries.push_back({label + "@" + domain, spec, domain});
      } else {
        entries.push_back({label, spec, domains.front()});
      }
    }
  }
  return entries;
}

void check(const Plan& plan, const Registry& registry) {
  if (plan.meshes.empty()) throw ParameterError("there is no mesh to compare on");
  if (plan.entries.empty()) throw ParameterError("there is no optimizer to compare");
  if (plan.runs < 1) throw ParameterError("a comparison needs at least one run");
  std::set<std::string> seen;
  for (const std::string& mesh : plan.meshes)
    if (!seen.insert(mesh).second) throw ParameterError("the mesh '" + mesh + "' is given twice");
    else if (!is_utf8(mesh)) throw ParameterError("the name of the mesh '" + mesh + "' is not UTF-8");
  seen.clear();
  for (const Entry& entry : plan.entries)
    if (!seen.insert(entry.label).second) throw ParameterError("the optimizer '" + entry.label + "' is given twice");
    else if (!is_utf8(entry.label))
      throw ParameterError("the name of the optimizer '" + entry.label + "' is not UTF-8");
  if (plan.proves() && !registry.make(plan.certificate)->capabilities().certifies)
    throw ParameterError("'" + plan.certificate + "' proves nothing, so it cannot bound R");
}

Json to_json(const Plan& plan) {
  Json entries = Json::array();
  for (const Entry& e : plan.entries) entries.push_back({{"label", e.label}, {"spec", e.spec}, {"domain", e.domain}});
  Json json = {{"meshes", plan.meshes}, {"optimizers", entries}, {"runs", plan.runs},
               {"budget", plan.budget}, {"seed", plan.seed},     {"certificate", plan.certificate}};
  if (plan.objective != kRectilinearity) json["objective"] = plan.objective;
  return json;
}

Plan plan_from_json(const Json& json) {
  Plan plan;
  plan.meshes = json.at("meshes").get<std::vector<std::string>>();
  for (const Json& e : json.at("optimizers"))
    plan.entries.push_back(
        {e.at("label").get<std::string>(), e.at("spec").get<std::string>(), e.at("domain").get<std::string>()});
  json.at("runs").get_to(plan.runs);
  json.at("budget").get_to(plan.budget);
  json.at("seed").get_to(plan.seed);
  json.at("certificate").get_to(plan.certificate);
  plan.objective = json.value("objective", kRectilinearity);
  return plan;
}

std::string difference(const Plan& stored, const Plan& asked) {
  const Json a = to_json(stored), b = to_json(asked);
  if (stored.objective != asked.objective) return "objective " + stored.objective + ", not " + asked.objective;
  for (const auto& [key, value] : a.items())
    if (value != b[key])
      return value.is_array() ? "other " + key : key + " " + to_text(value) + ", not " + to_text(b[key]);
  return "no difference";
}

Instance instance(std::uint64_t seed, std::string_view mesh, int run) {
  Random random = Random(seed).fork(Fnv1a().add(mesh).value()).fork(static_cast<std::uint64_t>(run));
  Instance result;
  result.rotation = random_rotation(random);
  result.run_seed = random.bits() >> 11;  // 53 bits, so that it survives JSON readers that only have doubles
  return result;
}

}  // namespace rectilin::laboratory
