#include "scene/scene_link.h"

#include <fmt/format.h>

#include <span>
#include <utility>
#include <vector>

#include "base/bits.h"
#include "base/hash.h"
#include "base/utf8.h"
#include "scene/base64_url.h"
#include "scene/degrees.h"
#include "scene/json_text.h"
#include "scene/packed_bytes.h"
#include "scene/scene_json.h"

namespace stridegraph {

// Bytes of a link: version, body, checksum of both. Every version begins with its number and ends with this
// checksum, so that an old program can tell a new link from a broken one. Version 2 adds walkers and
// constraints; scenes without them stay in version 1, so that every program can follow their links.

namespace {

constexpr std::string_view kPrefix = "s=";
constexpr std::uint8_t kPlainVersion = 1;
constexpr std::uint8_t kVersion = 2;
constexpr int kChecksumBytes = 4;
constexpr std::size_t kLeastNumberBytes = 1;

/// What the byte before the constraints says is there, and whether one asks for running.
enum ConstraintBits : std::uint8_t { kGait = 1, kRuns = 2, kMinSpeed = 4, kMaxSpeed = 8, kArrival = 16 };

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

void writeRectangle(PackedWriter& writer, const Rectangle& rectangle) {
  writePoint(writer, rectangle.centre);
  writePoint(writer, rectangle.size);
}

Rectangle readRectangle(PackedReader& reader) {
  const Vec2 centre = readPoint(reader);
  return {centre, readPoint(reader)};
}

void writeConstraints(PackedWriter& writer, const WalkConstraints& constraints) {
  const auto bit = [](bool set, ConstraintBits which) { return set ? static_cast<unsigned>(which) : 0U; };
  writer.byte(static_cast<std::uint8_t>(bit(constraints.gait.has_value(), kGait) |
                                        bit(constraints.gait == Gait::kRun, kRuns) |
                                        bit(constraints.minSpeedMetresPerSecond.has_value(), kMinSpeed) |
                                        bit(constraints.maxSpeedMetresPerSecond.has_value(), kMaxSpeed) |
                                        bit(constraints.latestArrivalSeconds.has_value(), kArrival)));
  for (const std::optional<double>& number :
       {constraints.minSpeedMetresPerSecond, constraints.maxSpeedMetresPerSecond,
        constraints.latestArrivalSeconds}) {
    if (number) writer.number(*number);
  }
  writer.varint(constraints.areas.size());
  for (const Area& area : constraints.areas) {
    writer.byte(static_cast<std::uint8_t>(area.kind));
    writeRectangle(writer, area.rectangle);
  }
}

WalkConstraints readConstraints(PackedReader& reader) {
  WalkConstraints constraints;
  const unsigned bits = reader.byte();
  const auto optionalNumber = [&](ConstraintBits which) {
    return (bits & which) != 0U ? std::optional<double>(reader.number()) : std::nullopt;
  };
  if ((bits & kGait) != 0U) constraints.gait = (bits & kRuns) != 0U ? Gait::kRun : Gait::kWalk;
  constraints.minSpeedMetresPerSecond = optionalNumber(kMinSpeed);
  constraints.maxSpeedMetresPerSecond = optionalNumber(kMaxSpeed);
  constraints.latestArrivalSeconds = optionalNumber(kArrival);
  constraints.areas.resize(reader.count(5 * kLeastNumberBytes));
  for (Area& area : constraints.areas) {
    area.kind = reader.byte() == 1 ? AreaKind::kPrefer : AreaKind::kAvoid;
    area.rectangle = readRectangle(reader);
  }
  return constraints;
}

void writeWalkers(PackedWriter& writer, const std::vector<Walker>& walkers) {
  writer.varint(walkers.size());
  for (const Walker& walker : walkers) {
    writePlacement(writer, walker.start);
    writePlacement(writer, walker.goal);
  }
}

std::vector<Walker> readWalkers(PackedReader& reader) {
  std::vector<Walker> walkers(reader.count(6 * kLeastNumberBytes));
  for (Walker& walker : walkers) {
    walker.start = readPlacement(reader);
    walker.goal = readPlacement(reader);
  }
  return walkers;
}

bool isPlain(const Scene& scene) {
  return scene.walkers.empty() && !scene.constraints.any();
}

void writeScene(PackedWriter& writer, const Scene& scene) {
  writer.text(scene.name);
  writePoint(writer, {scene.widthMetres, scene.depthMetres});
  writer.number(scene.radiusMetres);
  writer.varint(scene.seed);
  writePlacement(writer, scene.start);
  writePlacement(writer, scene.goal);
  writer.varint(scene.obstacles.size());
  for (const Rectangle& obstacle : scene.obstacles) writeRectangle(writer, obstacle);
  writer.varint(scene.moving.size());
  for (const MovingObstacle& moving : scene.moving) writeMoving(writer, moving);
  writer.text(scene.unknownMembers);
  if (isPlain(scene)) return;
  writeWalkers(writer, scene.walkers);
  writeConstraints(writer, scene.constraints);
}

Scene readScene(PackedReader& reader, std::uint8_t version) {
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
  for (Rectangle& obstacle : scene.obstacles) obstacle = readRectangle(reader);
  const std::size_t movingCount = reader.count(4 * kLeastNumberBytes);
  for (std::size_t i = 0; i < movingCount; ++i) scene.moving.push_back(readMoving(reader));
  scene.unknownMembers = reader.text();
  if (version == kPlainVersion) return scene;
  scene.walkers = readWalkers(reader);
  scene.constraints = readConstraints(reader);
  return scene;
}

tl::unexpected<Error> damaged(std::string_view found) {
  return fail(ErrorCode::kLinkDamaged,
              fmt::format("the link is damaged: found {}, expected the whole link as it was copied", found));
}

Result<void> checkShared(const SharedScene& shared) {
  if (Result<void> checked = checkScene(shared.scene); !checked) return damaged(checked.error().message);
  if (!isUtf8(shared.scene.name) || !isUtf8(shared.search)) return damaged("a name that is not UTF-8");
  if (shared.scene.unknownMembers.empty()) return {};
  const Result<Json> unknown = parseJson(shared.scene.unknownMembers, "link");
  if (!unknown || !unknown->is_object()) return damaged("members that are no JSON object");
  return {};
}

}  // namespace

std::string encodeLink(const SharedScene& shared) {
  PackedWriter writer;
  writer.byte(isPlain(shared.scene) ? kPlainVersion : kVersion);
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
  shared.scene = readScene(reader, version);
  if (reader.failed() || reader.bytesLeft() > 0) return damaged("a scene that does not fit its length");
  if (Result<void> checked = checkShared(shared); !checked) return fail(std::move(checked));
  return shared;
}

}  // namespace stridegraph
