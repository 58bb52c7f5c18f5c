#include "graph/clip_intake.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graph/clip_preparation.h"
#include "graph/glitches.h"
#include "motion/contacts.h"
#include "motion/mirror.h"

namespace stridegraph {
namespace {

Clip clipOf(const MotionLibrary& library, const LibraryClip& range) {
  const Clip& frames = library.frames;
  const auto first = static_cast<std::ptrdiff_t>(range.firstFrame);
  const auto end = first + static_cast<std::ptrdiff_t>(range.frameCount);
  const auto joints = static_cast<std::ptrdiff_t>(frames.jointCount);
  return {range.name,
          frames.framesPerSecond,
          frames.jointCount,
          {frames.rootPositions.begin() + first, frames.rootPositions.begin() + end},
          {frames.rotations.begin() + first * joints, frames.rotations.begin() + end * joints}};
}

}  // namespace

ClipIntake::ClipIntake(const Skeleton& skeleton, const LibraryParams& params)
    : skeleton_(skeleton), params_(params) {
  for (std::size_t j = 0; j < skeleton.size(); ++j) joints_.emplace_back(j);
}

ClipIntake::ClipIntake(MotionLibrary base) : ClipIntake(base.skeleton, base.params) {
  base_ = std::move(base);
  for (std::size_t b = 0; b < base_->clips.size(); ++b) {
    if (base_->clips[b].mirrored) continue;
    clips_.push_back(clipOf(*base_, base_->clips[b]));
    inBase_.emplace_back(b);
  }
  originals_ = baseOriginals_ = clips_.size();
}

void ClipIntake::add(const Clip& clip, Warnings& warnings) {
  const Clip atRate = atLibraryRate(clip, params_.framesPerSecond);
  const std::vector<Glitch> glitches = findGlitches(atRate);
  for (const Glitch& glitch : glitches) {
    warnings.push_back({fmt::format("joint {} turns {:.0f} degrees from frame {} to {}, far more than before "
                                    "and after: cut there",
                                    skeleton_.joints[glitch.joint.value].name, glitch.turn.degrees(),
                                    glitch.frame, glitch.frame + 1),
                        {clip.name}});
  }
  for (Clip& piece : cutAtGlitches(atRate, glitches)) {
    addRounded(std::move(piece));
    ++originals_;
  }
}

void ClipIntake::addRounded(Clip clip) {
  roundToFloats(skeleton_, clip);
  clips_.push_back(std::move(clip));
  inBase_.emplace_back();
}

double ClipIntake::floorOf(const Clip& clip) const {
  return floorLevelMetres(skeleton_, clip, joints_);
}

void ClipIntake::level(std::size_t c, Warnings& warnings) {
  if (!floorMetres_) floorMetres_ = floorOf(clips_.front());
  if (c == 0 || inBase_[c]) return;
  const double liftMetres = floorLiftMetres(*floorMetres_, floorOf(clips_[c]));
  if (liftMetres == 0.0) return;
  for (Vec3& root : clips_[c].rootPositions) root.y() += liftMetres;
  roundToFloats(skeleton_, clips_[c]);
  warnings.push_back(liftWarning(clips_[c].name, liftMetres));
}

Result<void> ClipIntake::findMirror() {
  std::vector<Clip> first;
  for (std::size_t c = 0, left = kPosesForMirror; c < originals_ && left > 0; ++c) {
    const std::size_t count = std::min(left, clips_[c].frameCount());
    Clip part{clips_[c].name, clips_[c].framesPerSecond, clips_[c].jointCount, {}, {}};
    for (std::size_t f = 0; f < count; ++f) part.append(clips_[c].pose(f));
    first.push_back(std::move(part));
    left -= count;
  }
  Result<MirrorMap> map = findMirrorMap(skeleton_, first);
  if (!map) return fail(std::move(map));
  mirrorMap_ = *std::move(map);
  return {};
}

void ClipIntake::addMirrorOf(std::size_t c) {
  Clip mirror = stridegraph::mirrored(skeleton_, *mirrorMap_, clips_[c]);
  mirror.name = clips_[c].name + " mirrored";
  addRounded(std::move(mirror));
  if (c < baseOriginals_ && isAsInBase(clips_.back(), baseOriginals_ + c))
    inBase_.back() = baseOriginals_ + c;
}

bool ClipIntake::isAsInBase(const Clip& clip, std::size_t baseClip) const {
  if (baseClip >= base_->clips.size() || base_->clips[baseClip].frameCount != clip.frameCount()) return false;
  const Clip known = clipOf(*base_, base_->clips[baseClip]);
  return known.rootPositions == clip.rootPositions &&
         std::equal(known.rotations.begin(), known.rotations.end(), clip.rotations.begin(),
                    [](const Quat& a, const Quat& b) { return a.coeffs() == b.coeffs(); });
}

KnownRegions ClipIntake::takeKnown() {
  KnownRegions known;
  known.clips.assign(clips_.size(), false);
  if (!base_) return known;
  std::vector<std::optional<std::size_t>> startOf(base_->clips.size());
  std::size_t start = 0;
  for (std::size_t c = 0; c < clips_.size(); ++c) {
    known.clips[c] = inBase_[c].has_value();
    if (inBase_[c]) startOf[*inBase_[c]] = start;
    start += clips_[c].frameCount();
  }
  const auto moved = [&](FrameIndex frame) -> std::optional<FrameIndex> {
    const LibraryClip& clip = base_->clipOf(frame);
    const auto& now = startOf[static_cast<std::size_t>(&clip - base_->clips.data())];
    if (!now) return {};
    return FrameIndex(*now + frame.value - clip.firstFrame);
  };
  for (AlikeRegion region : base_->regions) {
    const std::optional<FrameIndex> row = moved(region.row);
    const std::optional<FrameIndex> column = moved(region.column);
    if (!row || !column) continue;
    region.row = *row;
    region.column = *column;
    known.regions.push_back(region);
  }
  base_.reset();
  return known;
}

}  // namespace stridegraph
