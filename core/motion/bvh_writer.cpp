#include "motion/bvh_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/check.h"
#include "motion/bvh_channels.h"
#include "motion/bvh_conventions.h"
#include "motion/bvh_euler_track.h"
#include "motion/bvh_still_part.h"
#include "motion/export_names.h"

namespace stridegraph {
namespace {

constexpr std::size_t kDeepestIndent = 64;
constexpr int kAngleDecimals = 5;
constexpr int kLeastLengthDecimals = 6, kMostLengthDecimals = 15;
/// Readers need not take larger numbers.
constexpr double kLargestNumber = 1e9;

/// Decimals of lengths in file units that tell micrometres apart.
int lengthDecimals(double unitsPerMetre) {
  const double needed = std::ceil(kLeastLengthDecimals - std::log10(unitsPerMetre));
  return static_cast<int>(std::clamp<double>(needed, kLeastLengthDecimals, kMostLengthDecimals));
}

/// A name that stands on a line of its own and opens or closes nothing.
std::string bvhName(std::string_view name, std::string_view fallback) {
  std::string safe = exportName(name, fallback);
  for (char& c : safe)
    if (c == '{' || c == '}') c = '_';
  return safe;
}

constexpr std::array<std::string_view, 6> kChannelNames = {"Xposition", "Yposition", "Zposition",
                                                           "Xrotation", "Yrotation", "Zrotation"};

/// A joint's channels as they are written, and where its numbers come from.
struct JointColumns {
  std::vector<BvhChannel> channels;
  BvhEulerTrack track;
};

BvhChannel rotationChannel(Axis axis) {
  return static_cast<BvhChannel>(static_cast<int>(BvhChannel::kXRotation) + static_cast<int>(axis));
}

class BvhWriter {
 public:
  /// `travel` are the translations of the joint that has them anew in each frame; the others keep their
  /// offsets.
  BvhWriter(const Skeleton& skeleton, const BvhLayout& layout, const Clip& clip, JointIndex travelling,
            const std::vector<Vec3>& travel)
      : skeleton_(skeleton),
        layout_(layout),
        clip_(clip),
        lengthDecimals_(lengthDecimals(layout.unitsPerMetre)),
        travelling_(travelling),
        travel_(travel) {}

  std::string write() {
    for (std::size_t j = 0; j < skeleton_.size(); ++j) columns_.push_back(columnsOf(j));
    append("HIERARCHY\n");
    writeHierarchy();
    append("MOTION\nFrames: {}\nFrame Time: {:.10f}\n", clip_.frameCount(), 1.0 / clip_.framesPerSecond);
    for (std::size_t f = 0; f < clip_.frameCount(); ++f) writeRow(f);
    return fmt::to_string(text_);
  }

 private:
  template <typename... Args>
  void append(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  /// A fixed number of decimals, never "-0.0".
  void appendNumber(double value, int decimals) {
    const double number = std::isnan(value) ? 0.0 : std::clamp(value, -kLargestNumber, kLargestNumber);
    const std::size_t begin = text_.size();
    append("{:.{}f}", number, decimals);
    const std::string_view written(text_.data() + begin, text_.size() - begin);
    if (!written.starts_with('-') || written.find_first_not_of("-0.") != std::string_view::npos) return;
    text_.resize(begin);
    append("{:.{}f}", 0.0, decimals);
  }

  JointColumns columnsOf(std::size_t j) const {
    const Joint& joint = skeleton_.joints[j];
    if (joint.isEndSite) return {};
    JointColumns columns;
    std::vector<Axis> axes;
    for (const BvhChannel channel : layout_.channels[j]) {
      if (isPosition(channel)) continue;
      axes.push_back(static_cast<Axis>(static_cast<int>(channel) % 3));
    }
    if (travels(j)) axes = withAllAxes(std::move(axes));
    std::vector<Quat> rotations;
    rotations.reserve(clip_.frameCount());
    for (std::size_t f = 0; f < clip_.frameCount(); ++f) {
      rotations.push_back(fileFromCore(layout_.up, clip_.rotations[f * clip_.jointCount + j]));
    }
    columns.track = bvhEulerTrack(std::move(axes), rotations);
    columns.channels = channelsOf(j, columns.track.axes);
    return columns;
  }

  bool travels(std::size_t j) const { return travelling_.value == j; }

  /// The layout's channels with what is missing: at the joint that travels positions in front, anywhere axes
  /// at the end.
  std::vector<BvhChannel> channelsOf(std::size_t j, const std::vector<Axis>& axes) const {
    std::vector<BvhChannel> channels = layout_.channels[j];
    const auto isMissing = [&](BvhChannel channel) {
      return std::find(channels.begin(), channels.end(), channel) == channels.end();
    };
    if (travels(j)) {
      for (const BvhChannel channel :
           {BvhChannel::kZPosition, BvhChannel::kYPosition, BvhChannel::kXPosition}) {
        if (isMissing(channel)) channels.insert(channels.begin(), channel);
      }
    }
    for (const Axis axis : axes) {
      if (isMissing(rotationChannel(axis))) channels.push_back(rotationChannel(axis));
    }
    return channels;
  }

  void writeHierarchy() {
    std::vector<std::size_t> open;
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      const Joint& joint = skeleton_.joints[j];
      while (!open.empty() && JointIndex(open.back()) != joint.parent) close(open);
      STRIDEGRAPH_CHECK(open.empty() == (j == 0));
      writeJoint(j, open.size());
      open.push_back(j);
    }
    while (!open.empty()) close(open);
  }

  void close(std::vector<std::size_t>& open) {
    open.pop_back();
    append("{}}}\n", indent(open.size()));
  }

  void writeJoint(std::size_t j, std::size_t depth) {
    const Joint& joint = skeleton_.joints[j];
    const std::string margin = indent(depth);
    if (joint.isEndSite) {
      const std::string name = bvhName(layout_.endSiteNames[j], "");
      append("{}End Site{}{}\n{}{{\n", margin, name.empty() ? "" : " ", name, margin);
    } else {
      append("{}{} {}\n{}{{\n", margin, joint.parent ? "JOINT" : "ROOT", bvhName(joint.name, "joint"),
             margin);
    }
    const Vec3 offset = fileFromCore(layout_.up, joint.offset) * layout_.unitsPerMetre;
    append("{}\tOFFSET", margin);
    for (const double coordinate : offset) {
      text_.push_back(' ');
      appendNumber(coordinate, lengthDecimals_);
    }
    text_.push_back('\n');
    if (joint.isEndSite) return;
    append("{}\tCHANNELS {}", margin, columns_[j].channels.size());
    for (const BvhChannel channel : columns_[j].channels) {
      append(" {}", kChannelNames[static_cast<std::size_t>(channel)]);
    }
    append("\n");
  }

  void writeRow(std::size_t f) {
    bool isFirst = true;
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      const Joint& joint = skeleton_.joints[j];
      const Vec3& translation = travels(j) ? travel_[f] : joint.offset;
      const Vec3 position = fileFromCore(layout_.up, translation) * layout_.unitsPerMetre;
      std::size_t angle = 0;
      for (const BvhChannel channel : columns_[j].channels) {
        if (!isFirst) text_.push_back(' ');
        isFirst = false;
        if (isPosition(channel)) {
          appendNumber(position[static_cast<Eigen::Index>(channel)], lengthDecimals_);
        } else {
          appendNumber(columns_[j].track.degrees[f][angle++], kAngleDecimals);
        }
      }
    }
    append("\n");
  }

  /// Tabs by depth, up to where the indent of a very deep hierarchy would outgrow everything else.
  static std::string indent(std::size_t depth) { return std::string(std::min(depth, kDeepestIndent), '\t'); }

  const Skeleton& skeleton_;
  const BvhLayout& layout_;
  const Clip& clip_;
  int lengthDecimals_;
  JointIndex travelling_;
  const std::vector<Vec3>& travel_;
  std::vector<JointColumns> columns_;
  fmt::memory_buffer text_;
};

}  // namespace

std::string writeBvh(const Skeleton& skeleton, const BvhLayout& layout, const Clip& clip) {
  STRIDEGRAPH_CHECK(layout.channels.size() == skeleton.size() &&
                    layout.endSiteNames.size() == skeleton.size());
  STRIDEGRAPH_CHECK(clip.jointCount == skeleton.size());
  if (layout.still.joints.empty())
    return BvhWriter(skeleton, layout, clip, JointIndex(std::size_t{0}), clip.rootPositions).write();
  const WholeBvh whole = withStillPart(skeleton, layout, clip);
  return BvhWriter(whole.skeleton, whole.layout, whole.clip, whole.travelling, whole.travel).write();
}

}  // namespace stridegraph
