#include "bench/document_json.h"

#include <map>

#include "program/json_document.h"
#include "scene/json_text.h"

namespace stridegraph::bench {
namespace {

/// Every member of a run but its seed and its shortest path, by its name in JSON.
template <typename Run, typename Visit>
void forEachMember(Run& run, const Visit& visit) {
  visit("place", run.place);
  visit("library", run.library);
  visit("set", run.set);
  visit("room", run.room);
  visit("method", run.method);
  visit("status", run.status);
  visit("explanation", run.explanation);
  visit("goal_radius_m", run.goalRadiusMetres);
  visit("path_ms", run.pathMilliseconds);
  visit("motion_ms", run.motionMilliseconds);
  visit("synthesis_ms", run.synthesisMilliseconds);
  visit("total_ms", run.totalMilliseconds);
  visit("expansions", run.expansions);
  visit("length_m", run.lengthMetres);
  visit("duration_s", run.durationSeconds);
  visit("transitions", run.transitions);
  visit("blended_share", run.blendedShare);
  visit("clearance_m", run.clearanceMetres);
  visit("arrival_error_m", run.arrivalErrorMetres);
  visit("edges", run.edges);
}

Json toJson(const BenchRun& run) {
  Json json;
  forEachMember(run, [&](const char* name, const auto& value) { json[name] = value; });
  json["seed"] = run.seed;
  json["shortest_m"] = run.shortestMetres ? Json(*run.shortestMetres) : Json();
  return json;
}

Json toJson(const GrowthRow& row) {
  Json json = {{"place", row.place}, {"what", row.what}, {"size", row.size}, {"figures", Json::object()}};
  for (const auto& [name, value] : row.figures) json["figures"][name] = value;
  return json;
}

/// A member where it is there and of the right type.
void take(const Json& json, const char* name, std::string& value) {
  if (json.contains(name) && json[name].is_string()) value = json[name].get<std::string>();
}

void take(const Json& json, const char* name, double& value) {
  if (json.contains(name) && json[name].is_number()) value = json[name].get<double>();
}

BenchRun runFrom(const Json& json) {
  BenchRun run;
  forEachMember(run, [&](const char* name, auto& value) { take(json, name, value); });
  if (json.contains("seed") && json["seed"].is_number_unsigned())
    run.seed = json["seed"].get<std::uint64_t>();
  double shortest = 0.0;
  take(json, "shortest_m", shortest);
  if (shortest > 0.0) run.shortestMetres = shortest;
  return run;
}

GrowthRow growthFrom(const Json& json) {
  GrowthRow row;
  take(json, "place", row.place);
  take(json, "what", row.what);
  take(json, "size", row.size);
  if (!json.contains("figures")) return row;
  for (const auto& [name, value] : json["figures"].items())
    if (value.is_number()) row.figures.emplace_back(name, value.get<double>());
  return row;
}

void fillInShortest(BenchDocument& document) {
  std::map<std::pair<std::string, std::string>, double> shortest;
  for (const BenchRun& run : document.runs)
    if (run.shortestMetres) shortest.emplace(std::pair(run.set, run.room), *run.shortestMetres);
  for (BenchRun& run : document.runs) {
    const auto known = shortest.find({run.set, run.room});
    if (!run.shortestMetres && known != shortest.end()) run.shortestMetres = known->second;
  }
}

}  // namespace

std::string writeBenchJson(const BenchDocument& document) {
  Json json = {{"runs", Json::array()}, {"growth", Json::array()}};
  for (const BenchRun& run : document.runs) json["runs"].push_back(toJson(run));
  for (const GrowthRow& row : document.growth) json["growth"].push_back(toJson(row));
  return tools::documentText(json);
}

Result<void> joinBenchJson(std::string_view text, const std::string& name, BenchDocument& document) {
  const Json json = parseJson(text, name).value_or(Json());
  if (!json.is_object() || !json.contains("runs") || !json["runs"].is_array())
    return fail(ErrorCode::kInvalidArgument, "found no list of runs, expected what bench --json writes",
                {name});
  for (const Json& run : json["runs"])
    if (run.is_object()) document.runs.push_back(runFrom(run));
  if (json.contains("growth"))
    for (const Json& row : json["growth"])
      if (row.is_object()) document.growth.push_back(growthFrom(row));
  fillInShortest(document);
  return {};
}

}  // namespace stridegraph::bench
