#include "walk_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "motion/bvh_writer.h"
#include "motion/glb_writer.h"
#include "notes.h"
#include "program/shown_text.h"

namespace stridegraph::tools {

std::string WalkFiles::faultIn(const std::string& path) {
  if (path.ends_with(".bvh") || path.ends_with(".glb")) return {};
  return fmt::format("found {}, expected a name ending in .bvh or .glb", quotedText(path));
}

std::string WalkFiles::pathOf(std::size_t walker) const {
  if (walker == 0 || holdsAll()) return path_;
  const std::size_t ending = path_.rfind('.');
  return fmt::format("{}_{}{}", path_.substr(0, ending), walker + 1, path_.substr(ending));
}

std::vector<NamedPath> WalkFiles::outputs(std::size_t walkers) const {
  std::vector<NamedPath> outputs = {{"-o", path_}};
  if (holdsAll()) return outputs;
  for (std::size_t walker = 1; walker < walkers; ++walker)
    outputs.push_back({fmt::format("-o of walker {}", walker + 1), pathOf(walker)});
  return outputs;
}

Result<void> WalkFiles::addTo(OutputFiles& files, const MotionLibrary& library,
                              const std::vector<const Plan*>& plans) const {
  std::vector<WalkerClip> together;
  for (std::size_t walker = 0; walker < plans.size(); ++walker) {
    if (!hasArrived(*plans[walker])) continue;
    together.push_back({&plans[walker]->walk, walker});
    if (holdsAll()) continue;
    const std::string text = writeBvh(library.skeleton, library.layout, plans[walker]->walk);
    if (Result<void> added = files.add(pathOf(walker), text); !added) return added;
  }
  if (!holdsAll() || together.empty()) return {};
  const RoundBody body = roundBody(library.skeleton, library.frames);
  return files.add(path_, writeGlb(library.skeleton, body, together));
}

void WalkFiles::noteOld(const std::vector<const Plan*>& plans, Warnings& notes) const {
  if (holdsAll()) {
    const bool isWritten =
        std::any_of(plans.begin(), plans.end(), [](const Plan* plan) { return hasArrived(*plan); });
    if (!isWritten) noteFileOfBefore(path_, "a walk of this plan", notes);
    return;
  }
  for (std::size_t walker = 0; walker < plans.size(); ++walker)
    if (!hasArrived(*plans[walker])) noteFileOfBefore(pathOf(walker), "a walk of this plan", notes);
  for (std::size_t walker = plans.size(); isFileThere(pathOf(walker)); ++walker)
    noteFileOfBefore(pathOf(walker), "a walk of this plan", notes);
}

std::vector<const Plan*> allOf(const Plan& plan) {
  std::vector<const Plan*> all = {&plan};
  for (const Plan& other : plan.others) all.push_back(&other);
  return all;
}

bool hasArrived(const Plan& plan) {
  return plan.report.status == PlanStatus::kArrived;
}

}  // namespace stridegraph::tools
