#include <flatbuffers/flatbuffers.h>

#include <cstring>

#include "base/utf8.h"
#include "graph/library_notes.h"
#include "graph/sgraph_file.h"
#include "graph/sgraph_hash.h"
#include "sgraph_generated.h"

namespace stridegraph {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

Offset<flatbuffers::String> writeText(FlatBufferBuilder& builder, const std::string& text) {
  return builder.CreateString(toUtf8(text));
}

Offset<sgraph::Joint> writeJoint(FlatBufferBuilder& builder, const Joint& joint,
                                 const std::vector<BvhChannel>& channels, const std::string& endSiteName) {
  std::vector<std::uint8_t> numbers;
  for (const BvhChannel channel : channels) numbers.push_back(static_cast<std::uint8_t>(channel));
  const sgraph::Offset offset(joint.offset.x(), joint.offset.y(), joint.offset.z());
  const auto name = writeText(builder, joint.name);
  const auto channelBytes = builder.CreateVector(numbers);
  const auto endSite = writeText(builder, endSiteName);
  return sgraph::CreateJoint(builder, name,
                             joint.parent ? static_cast<std::int32_t>(joint.parent->value) : -1, &offset,
                             joint.isEndSite, channelBytes, endSite);
}

std::vector<Offset<sgraph::Joint>> writeJoints(FlatBufferBuilder& builder, const MotionLibrary& library) {
  const BvhLayout& layout = library.layout;
  std::vector<Offset<sgraph::Joint>> joints;
  for (std::size_t j = 0; j < library.skeleton.size(); ++j) {
    joints.push_back(writeJoint(builder, library.skeleton.joints[j],
                                j < layout.channels.size() ? layout.channels[j] : std::vector<BvhChannel>(),
                                j < layout.endSiteNames.size() ? layout.endSiteNames[j] : std::string()));
  }
  return joints;
}

Offset<sgraph::StillPart> writeStillPart(FlatBufferBuilder& builder, const BvhStillPart& still) {
  std::vector<Offset<sgraph::StillJoint>> joints;
  for (const BvhStillJoint& entry : still.joints) {
    const auto joint = writeJoint(builder, entry.joint, entry.channels, entry.endSiteName);
    const Quat& q = entry.rotation;
    const sgraph::Turn turn(q.w(), q.x(), q.y(), q.z());
    joints.push_back(sgraph::CreateStillJoint(builder, joint, &turn));
  }
  const auto all = builder.CreateVector(joints);
  const sgraph::Offset offset(still.rootOffset.x(), still.rootOffset.y(), still.rootOffset.z());
  return sgraph::CreateStillPart(builder, all, static_cast<std::uint32_t>(still.before),
                                 static_cast<std::uint32_t>(still.holder), &offset);
}

std::vector<Offset<sgraph::ClipRange>> writeClips(FlatBufferBuilder& builder, const MotionLibrary& library) {
  std::vector<Offset<sgraph::ClipRange>> clips;
  for (const LibraryClip& clip : library.clips)
    clips.push_back(
        sgraph::CreateClipRange(builder, writeText(builder, clip.name), clip.frameCount, clip.mirrored));
  return clips;
}

std::vector<float> positionNumbers(const Clip& frames) {
  std::vector<float> numbers;
  numbers.reserve(3 * frames.frameCount());
  for (const Vec3& position : frames.rootPositions) {
    for (const int axis : {0, 1, 2}) numbers.push_back(static_cast<float>(position[axis]));
  }
  return numbers;
}

std::vector<float> rotationNumbers(const MotionLibrary& library) {
  std::vector<float> numbers;
  numbers.reserve(4 * library.frames.rotations.size());
  for (std::size_t f = 0; f < library.frames.frameCount(); ++f) {
    const PoseView pose = library.frames.pose(f);
    for (std::size_t j = 0; j < pose.rotations.size(); ++j) {
      if (library.skeleton.joints[j].isEndSite) continue;
      const Quat& q = pose.rotations[j];
      for (const double part : {q.w(), q.x(), q.y(), q.z()}) numbers.push_back(static_cast<float>(part));
    }
  }
  return numbers;
}

std::vector<sgraph::Edge> edgeRecords(const MotionGraph& graph) {
  std::vector<sgraph::Edge> edges;
  for (const MotionEdge& edge : graph.edges) {
    edges.emplace_back(edge.from.value, edge.to.value, static_cast<std::uint32_t>(edge.kind), edge.frames,
                       edge.sourceSpan, edge.targetSpan, edge.distanceMetres);
  }
  return edges;
}

std::vector<sgraph::Region> regionRecords(const std::vector<AlikeRegion>& regions) {
  std::vector<sgraph::Region> records;
  records.reserve(regions.size());
  for (const AlikeRegion& region : regions) {
    records.emplace_back(region.row.value, region.column.value, region.rowSpan, region.columnSpan,
                         region.distanceMetres);
  }
  return records;
}

std::vector<std::uint32_t> nodeNumbers(const MotionGraph& graph) {
  std::vector<std::uint32_t> nodes;
  for (const FrameIndex node : graph.nodes) nodes.push_back(node.value);
  return nodes;
}

std::vector<std::uint32_t> contactJointNumbers(const MotionLibrary& library) {
  std::vector<std::uint32_t> joints;
  for (const JointIndex joint : library.contactJoints) joints.push_back(joint.value);
  return joints;
}

std::vector<Offset<sgraph::Note>> writeNotes(FlatBufferBuilder& builder, const Warnings& notes) {
  std::vector<Offset<sgraph::Note>> records;
  for (const Warning& note : notes) {
    const auto message = builder.CreateString(note.message);
    const auto file = builder.CreateString(note.place.file);
    records.push_back(sgraph::CreateNote(builder, message, file, note.place.line, note.place.column,
                                         static_cast<std::uint8_t>(note.topic)));
  }
  return records;
}

/// Notes, and the hash of the library without them.
struct NotesPart {
  Warnings notes;
  std::uint64_t libraryHash = 0;
};

void writeLibrary(FlatBufferBuilder& builder, const MotionLibrary& library, const NotesPart& part) {
  const auto joints = builder.CreateVector(writeJoints(builder, library));
  const auto name = writeText(builder, library.frames.name);
  const auto positions = builder.CreateVector(positionNumbers(library.frames));
  const auto rotations = builder.CreateVector(rotationNumbers(library));
  const auto clips = builder.CreateVector(writeClips(builder, library));
  const auto nodes = builder.CreateVector(nodeNumbers(library.graph));
  const auto edges = builder.CreateVectorOfStructs(edgeRecords(library.graph));
  const auto regions = builder.CreateVectorOfStructs(regionRecords(library.regions));
  const auto contactJoints = builder.CreateVector(contactJointNumbers(library));
  const auto contacts = builder.CreateVector(library.contacts);
  const auto license = writeText(builder, library.license);
  Offset<flatbuffers::Vector<Offset<sgraph::Note>>> notes;
  if (!part.notes.empty()) notes = builder.CreateVector(writeNotes(builder, part.notes));
  // Absent where nothing stands still: libraries from before it keep their bytes, and hashes.
  Offset<sgraph::StillPart> still;
  if (!library.layout.still.joints.empty()) still = writeStillPart(builder, library.layout.still);
  sgraph::LibraryBuilder table(builder);
  table.add_version(kSgraphVersion);
  table.add_hash(part.libraryHash);
  table.add_joints(joints);
  table.add_units_per_metre(library.layout.unitsPerMetre);
  table.add_up(static_cast<std::uint8_t>(library.layout.up));
  table.add_frames_name(name);
  table.add_frames_per_second(library.frames.framesPerSecond);
  table.add_root_positions(positions);
  table.add_rotations(rotations);
  table.add_clips(clips);
  table.add_nodes(nodes);
  table.add_edges(edges);
  table.add_facing_sin(library.facingOffset.sin);
  table.add_facing_cos(library.facingOffset.cos);
  table.add_contact_joints(contactJoints);
  table.add_contacts(contacts);
  table.add_floor_height_metres(library.floorHeightMetres);
  table.add_threshold_metres(library.params.thresholdMetres);
  table.add_transition_frames(library.params.transitionFrames);
  table.add_mirror(library.params.mirror);
  table.add_license(license);
  table.add_neighbour_frames(library.params.neighbourFrames);
  table.add_largest_span_ratio(library.params.largestSpanRatio);
  // Left out where it is what readers take it to be: libraries from before it keep their bytes, and hashes.
  if (library.params.mostTransitions != LibraryParams{}.mostTransitions)
    table.add_most_transitions(library.params.mostTransitions);
  table.add_regions(regions);
  if (!part.notes.empty()) {
    table.add_notes(notes);
    table.add_file_hash(0);
  }
  if (!still.IsNull()) table.add_still(still);
  sgraph::FinishLibraryBuffer(builder, table.Finish());
}

/// The bytes, and the hash that they hold.
struct Written {
  std::vector<std::uint8_t> bytes;
  std::uint64_t hash = 0;
};

/// The bytes, with their hash in the field that is given.
Written write(const MotionLibrary& library, const NotesPart& part, flatbuffers::voffset_t hashField) {
  FlatBufferBuilder builder;
  // Zeros are stored, too, so that the hash has its place.
  builder.ForceDefaults(true);
  writeLibrary(builder, library, part);
  Written written;
  written.bytes.assign(builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize());
  const auto* table = flatbuffers::GetRoot<flatbuffers::Table>(written.bytes.data());
  const auto place = static_cast<std::size_t>(table->GetAddressOf(hashField) - written.bytes.data());
  written.hash = hashAround(written.bytes, place);
  flatbuffers::WriteScalar(written.bytes.data() + place, written.hash);
  return written;
}

Written writeWithoutNotes(const MotionLibrary& library) {
  return write(library, {}, sgraph::Library::VT_HASH);
}

}  // namespace

std::vector<std::uint8_t> writeSgraph(const MotionLibrary& library) {
  const Warnings notes = keepableNotes(library.notes);
  Written written = writeWithoutNotes(library);
  if (notes.empty()) return std::move(written.bytes);
  return write(library, {notes, written.hash}, sgraph::Library::VT_FILE_HASH).bytes;
}

std::uint64_t sgraphHash(const MotionLibrary& library) {
  return writeWithoutNotes(library).hash;
}

}  // namespace stridegraph
