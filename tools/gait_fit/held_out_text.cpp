#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gait_fit/held_out.h"
#include "gait_fit/joint_names.h"
#include "program/json_document.h"

namespace stridegraph::gait_fit {
namespace {

std::string pair(double heldOut, double trained) {
  return fmt::format(" {:.1f} / {:.1f} |", heldOut, trained);
}

template <typename Cell>
std::string row(const std::string& name, const std::vector<NamedFigures>& gaits, Cell cell) {
  std::string text = "| " + name + " |";
  for (const NamedFigures& gait : gaits) text += cell(gait.figures);
  return text + "\n";
}

}  // namespace

std::string toMarkdown(const std::vector<NamedFigures>& gaits) {
  std::string text = "Held out / trained, degrees rms.\n\n| joint |";
  std::string line = "|---|";
  for (const NamedFigures& gait : gaits) {
    text += " " + gait.gait + " |";
    line += "---|";
  }
  text += "\n" + line + "\n";
  for (std::size_t j = 0; j < kStoredJointCount; ++j)
    text += row(kJointNames[j], gaits,
                [j](const HeldOutFigures& f) { return pair(f.heldOut.joints[j], f.trained.joints[j]); });
  text += row("all joints", gaits, [](const HeldOutFigures& f) {
    return fmt::format(" **{:.2f}** / {:.2f} |", f.heldOut.allJoints, f.trained.allJoints);
  });
  text += row("all but the pelvis", gaits, [](const HeldOutFigures& f) {
    return fmt::format(" {:.2f} / {:.2f} |", f.heldOut.withoutPelvis, f.trained.withoutPelvis);
  });
  text += row("root lateral, height, forward, cm", gaits, [](const HeldOutFigures& f) {
    const Vec3& root = f.heldOut.rootCentimetres;
    return fmt::format(" {:.1f}, {:.1f}, {:.1f} |", root.x(), root.y(), root.z());
  });
  text += row("straight, to a capture of the same speed, cm", gaits, [](const HeldOutFigures& f) {
    return fmt::format(" {:.2f} (worst {:.2f}) |", f.straightMeanCentimetres, f.straightWorstCentimetres);
  });
  text +=
      row("lean captured, held out / trained, degrees for each m/s^2", gaits, [](const HeldOutFigures& f) {
        return fmt::format(" {:.2f}, {:.2f} / {:.2f} |", f.lean.captured, f.lean.heldOut, f.lean.trained);
      });
  text += "\n| clip | speed, m/s | held out, degrees | straight, cm |\n|---|---|---|---|\n";
  for (const NamedFigures& gait : gaits)
    for (const ClipErrors& clip : gait.figures.clips)
      text += fmt::format(
          "| {} | {:.2f} | {:.2f} | {} |\n", clip.name, clip.speed, clip.degrees,
          clip.straightCentimetres ? fmt::format("{:.2f}", *clip.straightCentimetres) : std::string());
  return text;
}

std::string toJson(const std::vector<NamedFigures>& gaits) {
  nlohmann::ordered_json json;
  for (const NamedFigures& gait : gaits) {
    const HeldOutFigures& figures = gait.figures;
    nlohmann::ordered_json& out = json[gait.gait];
    for (std::size_t j = 0; j < kStoredJointCount; ++j)
      out["joints"][kJointNames[j]] = {{"held_out_deg", figures.heldOut.joints[j]},
                                       {"trained_deg", figures.trained.joints[j]}};
    out["all_joints_deg"] = figures.heldOut.allJoints;
    out["without_pelvis_deg"] = figures.heldOut.withoutPelvis;
    out["trained_all_joints_deg"] = figures.trained.allJoints;
    out["root_cm"] = {figures.heldOut.rootCentimetres.x(), figures.heldOut.rootCentimetres.y(),
                      figures.heldOut.rootCentimetres.z()};
    out["straight_mean_cm"] = figures.straightMeanCentimetres;
    out["straight_worst_cm"] = figures.straightWorstCentimetres;
    out["lean_deg_per_m_s2"] = {{"captured", figures.lean.captured},
                                {"held_out", figures.lean.heldOut},
                                {"trained", figures.lean.trained}};
    for (const ClipErrors& clip : figures.clips) {
      nlohmann::ordered_json ofClip = {
          {"name", clip.name}, {"speed_m_s", clip.speed}, {"degrees", clip.degrees}};
      if (clip.straightCentimetres) ofClip["straight_cm"] = *clip.straightCentimetres;
      out["clips"].push_back(std::move(ofClip));
    }
  }
  return tools::documentText(json);
}

}  // namespace stridegraph::gait_fit
