#include <flatbuffers/flatbuffers.h>
#include <fmt/format.h>

#include <optional>

#include "base/utf8.h"
#include "graph/graph_building.h"
#include "graph/library_checks.h"
#include "graph/sgraph_file.h"
#include "graph/sgraph_hash.h"
#include "sgraph_generated.h"

namespace stridegraph {
namespace {

using Fault = std::optional<std::string>;

/// Smaller than any library: identifier, root and the fields of an empty one.
constexpr std::size_t kLeastBytes = 64;

/// Programs before notes were kept wrote texts in any encoding.
std::string text(const flatbuffers::String* string) {
  return toUtf8({string->data(), string->size()});
}

Vec3 vectorOf(const sgraph::Offset& offset) {
  return {offset.x(), offset.y(), offset.z()};
}

Joint jointOf(const sgraph::Joint& record) {
  Joint joint{text(record.name()), {}, vectorOf(*record.offset()), record.is_end_site()};
  if (record.parent() >= 0) joint.parent = JointIndex(static_cast<std::size_t>(record.parent()));
  return joint;
}

Fault readChannels(const sgraph::Joint& record, std::vector<BvhChannel>& channels) {
  constexpr auto kLastChannel = static_cast<std::uint8_t>(BvhChannel::kZRotation);
  for (const std::uint8_t channel : *record.channels()) {
    if (channel > kLastChannel) return fmt::format("channel {} is unknown", channel);
    channels.push_back(static_cast<BvhChannel>(channel));
  }
  return {};
}

Fault readStillPart(const sgraph::StillPart* part, BvhStillPart& still) {
  if (part == nullptr) return {};
  for (const sgraph::StillJoint* record : *part->joints()) {
    const sgraph::Turn& turn = *record->rotation();
    BvhStillJoint& entry = still.joints.emplace_back(BvhStillJoint{jointOf(*record->joint()),
                                                                   {turn.w(), turn.x(), turn.y(), turn.z()},
                                                                   {},
                                                                   text(record->joint()->end_site_name())});
    if (Fault fault = readChannels(*record->joint(), entry.channels)) return fault;
  }
  still.before = part->before();
  still.holder = part->holder();
  still.rootOffset = vectorOf(*part->root_offset());
  return {};
}

Fault readJoints(const sgraph::Library& file, MotionLibrary& library) {
  for (const sgraph::Joint* record : *file.joints()) {
    library.skeleton.joints.push_back(jointOf(*record));
    if (Fault fault = readChannels(*record, library.layout.channels.emplace_back())) return fault;
    library.layout.endSiteNames.push_back(text(record->end_site_name()));
  }
  if (Fault fault = readStillPart(file.still(), library.layout.still)) return fault;
  if (file.up() > static_cast<std::uint8_t>(UpAxis::kZ))
    return fmt::format("up axis {} is unknown", file.up());
  library.layout.unitsPerMetre = file.units_per_metre();
  library.layout.up = static_cast<UpAxis>(file.up());
  return faultIn(library.skeleton);
}

Fault readFrames(const sgraph::Library& file, MotionLibrary& library) {
  const auto& positions = *file.root_positions();
  const auto& rotations = *file.rotations();
  std::size_t moving = 0;
  for (const Joint& joint : library.skeleton.joints) moving += joint.isEndSite ? 0 : 1;
  const std::size_t frameCount = positions.size() / 3;
  if (positions.size() % 3 != 0 || rotations.size() != 4 * moving * frameCount)
    return fmt::format("{} numbers of positions, {} of rotations for {} joints", positions.size(),
                       rotations.size(), moving);
  Clip& frames = library.frames;
  frames.name = text(file.frames_name());
  frames.framesPerSecond = file.frames_per_second();
  frames.jointCount = library.skeleton.size();
  flatbuffers::uoffset_t next = 0;
  const auto number = [&] { return static_cast<double>(rotations.Get(next++)); };
  for (flatbuffers::uoffset_t p = 0; p < positions.size(); p += 3) {
    frames.rootPositions.emplace_back(static_cast<double>(positions.Get(p)),
                                      static_cast<double>(positions.Get(p + 1)),
                                      static_cast<double>(positions.Get(p + 2)));
    for (const Joint& joint : library.skeleton.joints) {
      Quat rotation = Quat::Identity();
      if (!joint.isEndSite) {
        rotation.w() = number();
        for (double* part : {&rotation.x(), &rotation.y(), &rotation.z()}) *part = number();
      }
      frames.rotations.push_back(rotation);
    }
  }
  return {};
}

Fault readClips(const sgraph::Library& file, MotionLibrary& library) {
  std::uint64_t next = 0;
  for (const sgraph::ClipRange* record : *file.clips()) {
    if (next > library.frames.frameCount()) return std::string("more frames in clips than in the library");
    library.clips.push_back(
        {text(record->name()), static_cast<std::uint32_t>(next), record->frame_count(), record->mirrored()});
    next += record->frame_count();
  }
  return {};
}

Fault readGraph(const sgraph::Library& file, MotionLibrary& library) {
  MotionGraph& graph = library.graph;
  for (const std::uint32_t node : *file.nodes()) graph.nodes.emplace_back(std::size_t{node});
  graph.firstEdge.assign(graph.nodes.size() + 1, 0);
  for (const sgraph::Edge* record : *file.edges()) {
    if (record->kind() > static_cast<std::uint32_t>(EdgeKind::kTransition) ||
        record->from() >= graph.nodes.size())
      return fmt::format("an edge of kind {} from node {}", record->kind(), record->from());
    graph.edges.push_back({NodeIndex(std::size_t{record->from()}), NodeIndex(std::size_t{record->to()}),
                           static_cast<EdgeKind>(record->kind()), record->frames(), record->source_span(),
                           record->target_span(), record->distance_metres()});
    ++graph.firstEdge[record->from() + 1];
  }
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) graph.firstEdge[n + 1] += graph.firstEdge[n];
  return {};
}

void readRegions(const sgraph::Library& file, MotionLibrary& library) {
  library.regions.reserve(file.regions()->size());
  for (const sgraph::Region* record : *file.regions())
    library.regions.push_back({FrameIndex(std::size_t{record->row()}),
                               FrameIndex(std::size_t{record->column()}), record->row_span(),
                               record->column_span(), record->distance_metres()});
}

void readRest(const sgraph::Library& file, MotionLibrary& library) {
  library.facingOffset = {file.facing_sin(), file.facing_cos()};
  for (const std::uint32_t joint : *file.contact_joints())
    library.contactJoints.emplace_back(std::size_t{joint});
  library.contacts.assign(file.contacts()->begin(), file.contacts()->end());
  library.floorHeightMetres = file.floor_height_metres();
  library.params = {.thresholdMetres = file.threshold_metres(),
                    .transitionFrames = file.transition_frames(),
                    .framesPerSecond = file.frames_per_second(),
                    .mirror = file.mirror(),
                    .neighbourFrames = file.neighbour_frames(),
                    .largestSpanRatio = file.largest_span_ratio(),
                    .mostTransitions = file.most_transitions()};
  library.license = text(file.license());
  library.hash = file.hash();
}

void readNotes(const sgraph::Library& file, MotionLibrary& library) {
  if (file.notes() == nullptr) return;
  for (const sgraph::Note* record : *file.notes()) {
    // A newer program may know more topics.
    const bool known = record->topic() < kAllWarningTopics.size();
    library.notes.push_back({text(record->message()),
                             {text(record->file()), static_cast<std::size_t>(record->line()),
                              static_cast<std::size_t>(record->column())},
                             known ? kAllWarningTopics[record->topic()] : WarningTopic::kOther});
  }
}

/// Whether the hash that a field of the file holds is that of all other bytes.
bool hashHolds(const std::vector<std::uint8_t>& bytes, flatbuffers::voffset_t field) {
  const auto* table = flatbuffers::GetRoot<flatbuffers::Table>(bytes.data());
  const std::uint8_t* place = table->GetAddressOf(field);
  if (place == nullptr) return false;
  const auto hash = flatbuffers::ReadScalar<std::uint64_t>(place);
  return hashAround(bytes, static_cast<std::size_t>(place - bytes.data())) == hash;
}

/// What is wrong with the bytes as a FlatBuffers file of ours.
std::optional<Error> faultInBytes(const std::vector<std::uint8_t>& bytes) {
  const auto damaged = [](std::string message) {
    return Error{ErrorCode::kAssetDamaged, std::move(message)};
  };
  if (bytes.size() < kLeastBytes)
    return damaged(fmt::format("{} bytes are too few for a motion library (.sgraph)", bytes.size()));
  if (!sgraph::LibraryBufferHasIdentifier(bytes.data()))
    return damaged("this is no motion library: the mark SGRF is missing");
  flatbuffers::Verifier verifier(bytes.data(), bytes.size(), 64, 100'000'000);
  if (!sgraph::VerifyLibraryBuffer(verifier)) return damaged("the motion library is truncated or altered");
  const sgraph::Library& file = *sgraph::GetLibrary(bytes.data());
  if (file.version() != kSgraphVersion) {
    return Error{ErrorCode::kAssetVersion,
                 fmt::format("the motion library is of version {}; this program reads version {}: "
                             "build it anew from its clips",
                             file.version(), kSgraphVersion)};
  }
  // With notes the library's own hash is that of other bytes; the file's covers it.
  if (!hashHolds(bytes, file.notes() == nullptr ? sgraph::Library::VT_HASH : sgraph::Library::VT_FILE_HASH))
    return damaged("the motion library is altered: its hash does not hold");
  return {};
}

}  // namespace

Result<MotionLibrary> readSgraph(std::span<const std::uint8_t> bytes) {
  // A copy of its own, so that numbers lie where the machine wants them whatever the caller's address.
  const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  if (std::optional<Error> error = faultInBytes(copy)) return tl::unexpected<Error>(std::move(*error));
  const sgraph::Library& file = *sgraph::GetLibrary(copy.data());
  MotionLibrary library;
  Fault fault = readJoints(file, library);
  if (!fault) fault = readFrames(file, library);
  if (!fault) fault = readClips(file, library);
  if (!fault) fault = readGraph(file, library);
  if (!fault) {
    readRegions(file, library);
    readRest(file, library);
    readNotes(file, library);
    fault = faultIn(library);
  }
  if (fault) return fail(ErrorCode::kAssetDamaged, "the motion library is not sound: " + *fault);
  return library;
}

}  // namespace stridegraph
