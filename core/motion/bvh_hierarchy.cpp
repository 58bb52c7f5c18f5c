#include "motion/bvh_hierarchy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "motion/bvh_limits.h"

namespace stridegraph {
namespace {

constexpr std::array<std::pair<std::string_view, BvhChannel>, kMostBvhChannels> kChannelWords = {{
    {"XPOSITION", BvhChannel::kXPosition},
    {"YPOSITION", BvhChannel::kYPosition},
    {"ZPOSITION", BvhChannel::kZPosition},
    {"XROTATION", BvhChannel::kXRotation},
    {"YROTATION", BvhChannel::kYRotation},
    {"ZROTATION", BvhChannel::kZRotation},
}};

/// A joint whose closing brace has not come yet.
struct OpenJoint {
  std::size_t index = 0;
  std::size_t offset = 0;  ///< Of its name in the text, or of the word End.
  std::size_t endSites = 0;
  bool hasOffset = false;
  bool hasChannels = false;
  bool hasChildren = false;
};

/// Keeps its own stack of open joints: the depth of a text must not become the depth of the call stack.
class HierarchyParser {
 public:
  explicit HierarchyParser(BvhScanner& scanner) : scanner_(scanner) {}

  Result<BvhHierarchy> parse() {
    if (!scanner_.takeWord("HIERARCHY")) return scanner_.expected("HIERARCHY");
    if (!scanner_.takeWord("ROOT")) return scanner_.expected("ROOT");
    if (const Result<void> opened = openJoint(); !opened) return tl::unexpected(opened.error());
    while (!open_.empty()) {
      if (const Result<void> taken = takeStatement(); !taken) return tl::unexpected(taken.error());
    }
    if (hierarchy_.columns == 0)
      return scanner_.expected("a joint with CHANNELS before the end of HIERARCHY");
    return std::move(hierarchy_);
  }

 private:
  Result<void> takeStatement() {
    if (scanner_.takeSymbol('}')) return closeJoint();
    const BvhJoint& joint = hierarchy_.joints[open_.back().index];
    const std::size_t offset = scanner_.offset();
    if (scanner_.takeWord("OFFSET")) return takeOffset();
    if (!joint.isEndSite) {
      if (scanner_.takeWord("CHANNELS")) return takeChannels();
      if (scanner_.takeWord("JOINT")) return openJoint();
      if (takeEnd()) return openEndSite(offset);
    }
    if (scanner_.atEnd()) {
      return scanner_.expected(
          fmt::format("}} to close \"{}\" of line {}", joint.name, lineOf(open_.back())));
    }
    return scanner_.expected(joint.isEndSite ? "OFFSET or }" : "OFFSET, CHANNELS, JOINT, End Site or }");
  }

  /// Takes the words of an end site in front of its own name, if it has one.
  bool takeEnd() {
    if (scanner_.takeWord("ENDSITE") || scanner_.takeWord("END_SITE")) return true;
    if (!scanner_.takeWord("END")) return false;
    scanner_.takeWord("SITE");
    return true;
  }

  Result<std::string> takeName() {
    const std::size_t offset = scanner_.offset();
    std::string name = scanner_.takeName();
    if (name.size() <= kMostBvhNameBytes) return name;
    return fail(ErrorCode::kBvhValue,
                fmt::format("found a name of {} bytes, expected at most {}", name.size(), kMostBvhNameBytes),
                scanner_.placeOf(offset));
  }

  Result<void> openJoint() {
    const std::size_t offset = scanner_.offset();
    Result<std::string> name = takeName();
    if (!name) return tl::unexpected(name.error());
    if (name->empty()) return scanner_.expected("a joint's name");
    BvhJoint joint;
    joint.name = *std::move(name);
    return open(std::move(joint), offset);
  }

  Result<void> openEndSite(std::size_t offset) {
    Result<std::string> name = takeName();
    if (!name) return tl::unexpected(name.error());
    OpenJoint& parent = open_.back();
    ++parent.endSites;
    BvhJoint joint;
    joint.isEndSite = true;
    joint.endSiteName = *std::move(name);
    joint.name = hierarchy_.joints[parent.index].name + "#end";
    if (parent.endSites > 1) joint.name += fmt::format("{}", parent.endSites);
    return open(std::move(joint), offset);
  }

  Result<void> open(BvhJoint joint, std::size_t offset) {
    if (!scanner_.takeSymbol('{')) return scanner_.expected("{");
    if (hierarchy_.joints.size() == kMostBvhJoints)
      return failAtLimit("joints and end sites", kMostBvhJoints, offset);
    if (open_.size() == kMostBvhDepth)
      return failAtLimit("joints one below the other", kMostBvhDepth, offset);
    if (!open_.empty()) {
      open_.back().hasChildren = true;
      joint.parent = open_.back().index;
    }
    open_.push_back({hierarchy_.joints.size(), offset});
    hierarchy_.joints.push_back(std::move(joint));
    return {};
  }

  Result<void> failAtLimit(std::string_view what, std::size_t limit, std::size_t offset) const {
    return fail(ErrorCode::kBvhValue,
                fmt::format("found {} or more {}, expected at most {}", limit + 1, what, limit),
                scanner_.placeOf(offset));
  }

  Result<void> closeJoint() {
    const OpenJoint& joint = open_.back();
    if (!joint.hasOffset) {
      return fail(ErrorCode::kBvhSyntax,
                  fmt::format("found }} without an OFFSET for \"{}\" of line {}, expected OFFSET",
                              hierarchy_.joints[joint.index].name, lineOf(joint)),
                  scanner_.placeOf(scanner_.offset()));
    }
    open_.pop_back();
    return {};
  }

  /// OFFSET and CHANNELS stand once and before the children: a row's order follows from theirs.
  Result<void> checkOnce(std::string_view keyword, bool isThere) {
    const OpenJoint& joint = open_.back();
    if (!isThere && !joint.hasChildren) return {};
    return fail(ErrorCode::kBvhSyntax,
                fmt::format("found {} {} of \"{}\", expected one {} before the children", keyword,
                            isThere ? "for a second time in the block" : "behind the children",
                            hierarchy_.joints[joint.index].name, keyword),
                scanner_.placeOf(scanner_.offset()));
  }

  Result<void> takeOffset() {
    if (Result<void> once = checkOnce("OFFSET", open_.back().hasOffset); !once) return once;
    open_.back().hasOffset = true;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Result<double> value = scanner_.takeNumber("three numbers after OFFSET");
      if (!value) return tl::unexpected(value.error());
      hierarchy_.joints[open_.back().index].offset[axis] = *value;
    }
    return {};
  }

  Result<void> takeChannels() {
    if (Result<void> once = checkOnce("CHANNELS", open_.back().hasChannels); !once) return once;
    open_.back().hasChannels = true;
    const std::size_t offset = scanner_.offset();
    const Result<std::size_t> count = scanner_.takeCount("the number of channels");
    if (!count) return tl::unexpected(count.error());
    if (*count > kMostBvhChannels) {
      return fail(ErrorCode::kBvhValue,
                  fmt::format("found {} channels, expected 0 to {}", *count, kMostBvhChannels),
                  scanner_.placeOf(offset));
    }
    BvhJoint& joint = hierarchy_.joints[open_.back().index];
    joint.firstColumn = hierarchy_.columns;
    hierarchy_.columns += *count;
    for (std::size_t i = 0; i < *count; ++i) {
      if (Result<void> taken = takeChannel(joint, *count); !taken) return taken;
    }
    return {};
  }

  Result<void> takeChannel(BvhJoint& joint, std::size_t count) {
    const std::size_t offset = scanner_.offset();
    for (const auto& [word, channel] : kChannelWords) {
      if (!scanner_.takeWord(word)) continue;
      if (std::find(joint.channels.begin(), joint.channels.end(), channel) != joint.channels.end()) {
        return fail(
            ErrorCode::kBvhSyntax,
            fmt::format("found a channel of \"{}\" for the second time, expected each once", joint.name),
            scanner_.placeOf(offset));
      }
      joint.channels.push_back(channel);
      return {};
    }
    return scanner_.expected(fmt::format("{} channels such as Xposition or Zrotation", count));
  }

  std::size_t lineOf(const OpenJoint& joint) const { return scanner_.placeOf(joint.offset).line; }

  BvhScanner& scanner_;
  BvhHierarchy hierarchy_;
  std::vector<OpenJoint> open_;
};

}  // namespace

Result<BvhHierarchy> parseBvhHierarchy(BvhScanner& scanner) {
  return HierarchyParser(scanner).parse();
}

}  // namespace stridegraph
