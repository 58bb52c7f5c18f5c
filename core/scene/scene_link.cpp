#include "scene/scene_link.h"

#include <fmt/format.h>

#include <span>
#include <utility>
#include <vector>

#include "base/bits.h"
#include "base/hash.h"
#include "scene/base64_url.h"
#include "scene/degrees.h"
#include "scene/json_text.h"
#include "scene/packed_bytes.h"
#include "scene/scene_json.h"

namespace stridegraph {

// Bytes of a link: version, body, checksum of both. Every version begins with its number and ends with this
// checksum, so that an old program can tell a new link from a broken one.

namespace {

constexpr std::string_view kPrefix = "s=";
constexpr std::uint8_t kVersion = 1;
constexpr int kChecksumBytes = 4;
constexpr std::size_t kLeastNumberBytes = 1;

enum HeadingForm : std::uint8_t { kNoHeading, kDegrees, kRadians };

std::uint64_t checksum(std::span<const std::uint8_t> bytes) {
  const std::uint64_t hash = stableHash(bytes);
  return (hash ^ (hash >> 32U)) & 0xffffffffU;
}

void writePoint(PackedWriter& writer, const Vec2& point) {
  writer.number(point.x());
  writer.number(point.y());
}

Vec2 readPoint(PackedReader& reader) {
  const double x = reader.number();
  return {x, reader.number()};
}

void writePlacement(PackedWriter& writer, const Placement& placement) {
  writePoint(writer, placement.position);
  if (!placement.heading) {
    writer.byte(kNoHeading);
    return;
  }
  const double degrees = degreesThatGive(*placement.heading);
  const bool exact = bitCast<std::uint64_t>(Angle::degrees(degrees).radians()) ==
                     bitCast<std::uint64_t>(placement.heading->radians());
  writer.byte(exact ? kDegrees : kRadians);
  writer.number(exact ? degrees : placement.heading->radians());
}

Placement readPlacement(PackedReader& reader) {
  Placement placement{readPoint(reader), std::nullopt};
  const std::uint8_t form = reader.byte();
  if (form == kDegrees) placement.heading = Angle::degrees(reader.number());
  if (form == kRadians) placement.heading = Angle::radians(reader.number());
  return placement;
}

void writeMoving(PackedWriter& writer, const MovingObstacle& moving) {
  writePoint(writer, moving.size);
  writer.byte(static_cast<std::uint8_t>(moving.repeat));
  writer.varint(moving.track.size());
  for (const TrackPoint& point : moving.track) {
    writer.number(point.seconds);
    writePoint(writer, point.position);
  }
}

MovingObstacle readMoving(PackedReader& reader) {
  MovingObstacle moving;
  moving.size = readPoint(reader);
  const std::uint8_t repeat = reader.byte();
  moving.repeat = repeat == 1   ? TrackRepeat::kPingPong
                  : repeat == 2 ? TrackRepeat::kOnce
                                : TrackRepeat::kLoop;
  moving.track.resize(reader.count(3 * kLeastNumberBytes));
  for (TrackPoint& point : moving.track) {
    point.seconds = reader.number();
    point.position = readPoint(reader);
  }
  return moving;
}

void writeScene(PackedWriter& writer, const Scene& scene) {
  writer.text(scene.name);
  writePoint(writer, {scene.widthMetres, scene.depthMetres});
  writer.number(scene.radiusMetres);
  writer.varint(scene.seed);
  writePlacement(writer, scene.start);
  writePlacement(writer, scene.goal);
  writer.varint(scene.obstacles.size());
  for (const Rectangle& obstacle : scene.obstacles) {
    writePoint(writer, obstacle.centre);
    writePoint(writer, obstacle.size);
  }
  writer.varint(scene.moving.size());
  for (const MovingObstacle& moving : scene.moving) writeMoving(writer, moving);
  writer.text(scene.unknownMembers);
}

Scene readScene(PackedReader& reader) {
  Scene scene;
  scene.name = reader.text();
  const Vec2 size = readPoint(reader);
  scene.widthMetres = size.x();
  scene.depthMetres = size.y();
  scene.radiusMetres = reader.number();
  scene.seed = reader.varint();
  scene.start = readPlacement(reader);
  scene.goal = readPlacement(reader);
  scene.obstacles.resize(reader.count(4 * kLeastNumberBytes));
  for (Rectangle& obstacle : scene.obstacles) {
    obstacle.centre = readPoint(reader);
    obstacle.size = readPoint(reader);
  }
  const std::size_t movingCount = reader.count(4 * kLeastNumberBytes);
  for (std::size_t i = 0; i < movingCount; ++i) scene.moving.push_back(readMoving(reader));
  scene.unknownMembers = reader.text();
  return scene;
}

tl::unexpected<Error> damaged(std::string_view found) {
  return fail(ErrorCode::kLinkDamaged,
              fmt::format("the link is damaged: found {}, expected the whole link as it was copied", found));
}

Result<void> checkShared(const SharedScene& shared) {
  if (Result<void> checked = checkScene(shared.scene); !checked) return damaged(checked.error().message);
  if (shared.scene.unknownMembers.empty()) return {};
  const Result<Json> unknown = parseJson(shared.scene.unknownMembers, "link");
  if (!unknown || !unknown->is_object()) return damaged("members that are no JSON object");
  return {};
}

}  // namespace

std::string encodeLink(const SharedScene& shared) {
  PackedWriter writer;
  writer.byte(kVersion);
  writer.text(shared.search);
  writer.fixed(shared.libraryHash, 8);
  writeScene(writer, shared.scene);
  writer.fixed(checksum(writer.bytes()), kChecksumBytes);
  return std::string(kPrefix) + toBase64Url(writer.bytes());
}

Result<SharedScene> decodeLink(std::string_view fragment) {
  if (fragment.starts_with('#')) fragment.remove_prefix(1);
  if (!fragment.starts_with(kPrefix)) return damaged(fmt::format("no \"{}\" at its beginning", kPrefix));
  const std::optional<std::vector<std::uint8_t>> bytes = fromBase64Url(fragment.substr(kPrefix.size()));
  if (!bytes) return damaged("letters that no link has");
  if (bytes->size() <= kChecksumBytes) return damaged("only its beginning");
  const std::span<const std::uint8_t> all(*bytes);
  const std::span<const std::uint8_t> body = all.first(all.size() - kChecksumBytes);
  if (PackedReader(all.last(kChecksumBytes)).fixed(kChecksumBytes) != checksum(body)) {
    return damaged("a checksum that does not fit");
  }
  PackedReader reader(body);
  const std::uint8_t version = reader.byte();
  if (version > kVersion) {
    return fail(ErrorCode::kLinkVersion,
                fmt::format("the link was made by a newer program: found version {}, expected at most {}",
                            version, kVersion));
  }
  if (version == 0) return damaged("version 0");
  SharedScene shared;
  shared.search = reader.text();
  shared.libraryHash = reader.fixed(8);
  shared.scene = readScene(reader);
  if (reader.failed() || reader.bytesLeft() > 0) return damaged("a scene that does not fit its length");
  if (Result<void> checked = checkShared(shared); !checked) return fail(std::move(checked));
  return shared;
}

}  // namespace stridegraph
