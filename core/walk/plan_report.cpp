#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "walk/plan.h"

namespace stridegraph {

namespace {

nlohmann::ordered_json placeOf(const JointRatio& worst) {
  return {{"frame", worst.frame}, {"joint", worst.joint}};
}

nlohmann::ordered_json listOf(const std::vector<WalkSeam>& seams) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const WalkSeam& seam : seams)
    list.push_back({{"frame", seam.frame},
                    {"from", seam.from.value},
                    {"to", seam.to.value},
                    {"distance_m", seam.distanceMetres}});
  return list;
}

/// How clean the motion is.
void addQuality(const PlanReport& report, nlohmann::ordered_json& json) {
  json["foot_skate_cm_s"] = report.footSkateCmPerSecond;
  json["foot_skate_source_cm_s"] = report.footSkateSourceCmPerSecond;
  json["penetration_cm"] = 100.0 * report.penetrationMetres;
  json["contacts"] = report.contacts;
  json["feet_corrected"] = {{"mean_cm", 100.0 * report.feetCorrectedMeanMetres},
                            {"worst_cm", 100.0 * report.feetCorrectedWorstMetres}};
  json["feet_left_alone"] = report.feetLeftAlone;
  json["joint_speed_ratio"] = report.jointSpeed.ratio;
  json["joint_speed_ratio_at"] = placeOf(report.jointSpeed);
  json["joint_accel_ratio"] = report.jointAcceleration.ratio;
  json["joint_accel_ratio_at"] = placeOf(report.jointAcceleration);
  json["seams"] = listOf(report.seams);
}

nlohmann::ordered_json objectOf(const PlanReport& report) {
  nlohmann::ordered_json json;
  json["status"] = planStatusName(report.status);
  json["explanation"] = report.explanation;
  json["seed"] = report.seed;
  json["planner"] = plannerName(report.planner);
  json["search"] = searchName(report.search);
  json["radius_m"] = report.radiusMetres;
  json["goal_radius_m"] = report.goalRadiusMetres;
  json["units_per_metre"] = report.unitsPerMetre;
  json["path_ms"] = report.pathMilliseconds;
  json["motion_ms"] = report.motionMilliseconds;
  json["synthesis_ms"] = report.synthesisMilliseconds;
  json["total_ms"] = report.totalMilliseconds;
  json["path_length_m"] = report.pathLengthMetres;
  json["motion_length_m"] = report.motionLengthMetres;
  json["duration_s"] = report.durationSeconds;
  json["frames"] = report.frames;
  json["expansions"] = report.expansions;
  json["transitions"] = report.transitions;
  if (report.smallSteps > 0) json["small_steps"] = report.smallSteps;
  nlohmann::ordered_json edges = nlohmann::ordered_json::array();
  for (const auto& [from, to] : report.edges) edges.push_back({from.value, to.value});
  json["edges"] = std::move(edges);
  json["clearance_m"] = report.clearanceMetres;
  if (report.movingClearanceMetres) json["moving_clearance_m"] = *report.movingClearanceMetres;
  if (report.goalFreeUntilSeconds) json["goal_free_until_s"] = *report.goalFreeUntilSeconds;
  if (report.constraintsKept) json["constraints_kept"] = *report.constraintsKept;
  addQuality(report, json);
  json["arrival_error_m"] = report.arrivalErrorMetres;
  if (report.arrivalHeadingError) json["arrival_heading_error_deg"] = report.arrivalHeadingError->degrees();
  json["arrival_warp"] = {{"last_m", report.arrivalWarp.metres},
                          {"stretch", report.arrivalWarp.stretch},
                          {"deg_per_m", report.arrivalWarp.turnPerMetre.degrees()}};
  json["bent_share"] = report.bentShare;
  json["starts_standing"] = report.startsStanding;
  json["ends_standing"] = report.endsStanding;
  json["library_hash"] = hexDigits(report.libraryHash);
  return json;
}

/// Texts that are not UTF-8 do not make it fail: their wrong bytes become U+FFFD.
std::string textOf(const nlohmann::ordered_json& json) {
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

std::string toJson(const PlanReport& report) {
  return textOf(objectOf(report));
}

std::string toJson(const Plan& plan) {
  nlohmann::ordered_json json = objectOf(plan.report);
  if (!plan.others.empty()) {
    json["walkers"] = nlohmann::ordered_json::array();
    for (const Plan& other : plan.others) json["walkers"].push_back(objectOf(other.report));
  }
  return textOf(json);
}

}  // namespace stridegraph
