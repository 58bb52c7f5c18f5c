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

bool showSameFrames(const Clip& a, const Clip& b) {
  return a.rootPositions == b.rootPositions &&
         std::equal(a.rotations.begin(), a.rotations.end(), b.rotations.begin(), b.rotations.end(),
                    [](const Quat& p, const Quat& q) { return p.coeffs() == q.coeffs(); });
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
                        {clip.name},
                        WarningTopic::kMotion});
  }
  const bool nameTaken = isNameTaken(clip.name);
  const std::size_t before = originals_;
  for (Clip& piece : cutAtGlitches(atRate, glitches)) addOriginal(std::move(piece), warnings);
  if (nameTaken && originals_ > before)
    warnings.push_back({"another clip has this name, too; both are kept", {clip.name}, WarningTopic::kText});
}

void ClipIntake::addOriginal(Clip clip, Warnings& warnings) {
  roundToFloats(skeleton_, clip);
  if (!clips_.empty()) level(clip, warnings);
  if (const Clip* same = sameFramesAs(clip)) {
    warnings.push_back(
        {fmt::format("shows the same {} frames as {}: left out", clip.frameCount(), same->name),
         {clip.name},
         WarningTopic::kMotion});
    return;
  }
  clips_.push_back(std::move(clip));
  inBase_.emplace_back();
  ++originals_;
}

bool ClipIntake::isNameTaken(const std::string& name) const {
  return std::any_of(clips_.begin(), clips_.end(), [&](const Clip& clip) { return clip.name == name; });
}

const Clip* ClipIntake::sameFramesAs(const Clip& clip) const {
  const auto same = std::find_if(clips_.begin(), clips_.end(),
                                 [&](const Clip& other) { return showSameFrames(other, clip); });
  return same == clips_.end() ? nullptr : &*same;
}

void ClipIntake::addRounded(Clip clip) {
  roundToFloats(skeleton_, clip);
  clips_.push_back(std::move(clip));
  inBase_.emplace_back();
}

double ClipIntake::floorOf(const Clip& clip) const {
  return floorLevelMetres(skeleton_, clip, joints_);
}

void ClipIntake::level(Clip& clip, Warnings& warnings) {
  if (!floorMetres_) floorMetres_ = floorOf(clips_.front());
  const double liftMetres = floorLiftMetres(*floorMetres_, floorOf(clip));
  if (liftMetres == 0.0) return;
  for (Vec3& root : clip.rootPositions) root.y() += liftMetres;
  roundToFloats(skeleton_, clip);
  warnings.push_back(liftWarning(clip.name, liftMetres));
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

void ClipIntake::collect(MotionLibrary& library) const {
  library.frames.framesPerSecond = params_.framesPerSecond;
  library.frames.jointCount = skeleton_.size();
  for (std::size_t c = 0; c < clips_.size(); ++c) {
    const Clip& clip = clips_[c];
    library.clips.push_back({clip.name, static_cast<std::uint32_t>(library.frames.frameCount()),
                             static_cast<std::uint32_t>(clip.frameCount()), isMirrored(c)});
    for (std::size_t f = 0; f < clip.frameCount(); ++f) library.frames.append(clip.pose(f));
  }
}

bool ClipIntake::isAsInBase(const Clip& clip, std::size_t baseClip) const {
  if (baseClip >= base_->clips.size() || base_->clips[baseClip].frameCount != clip.frameCount()) return false;
  return showSameFrames(clipOf(*base_, base_->clips[baseClip]), clip);
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
