#include "options.h"

#include <fmt/format.h>

#include "option_reader.h"

namespace stridegraph::bindings {
namespace {

using emscripten::val;

constexpr double kInchMetres = 0.0254;

/// Units as on the command line: auto, m, cm, in, or metres per unit.
std::optional<double> readUnits(OptionReader& reader, const std::string& what) {
  if (!reader.isText("units")) {
    const std::optional<double> metresPerUnit = reader.number("units");
    if (!metresPerUnit) return {};
    if (*metresPerUnit > 0) return 1.0 / *metresPerUnit;
    reader.refuse(fmt::format("{}: units is {}, expected metres per unit above 0", what, *metresPerUnit));
    return {};
  }
  const std::string units = reader.text("units").value_or("auto");
  if (units == "m") return 1.0;
  if (units == "cm") return 100.0;
  if (units == "in") return 1.0 / kInchMetres;
  if (units != "auto") {
    reader.refuse(fmt::format("{}: units is \"{}\", expected auto, m, cm, in or a number", what, units));
  }
  return {};
}

std::optional<UpAxis> readUp(OptionReader& reader, const std::string& what) {
  const std::string up = reader.text("up").value_or("auto");
  if (up == "y") return UpAxis::kY;
  if (up == "z") return UpAxis::kZ;
  if (up != "auto") reader.refuse(fmt::format("{}: up is \"{}\", expected auto, y or z", what, up));
  return {};
}

BvhReadParams readReading(OptionReader& reader, const std::string& what) {
  return {.unitsPerMetre = readUnits(reader, what), .up = readUp(reader, what)};
}

/// A name that must be one of core's: `find` is plannerFromName or searchFromName.
template <typename Kind>
void readKind(OptionReader& reader, const char* member, std::optional<Kind> (*find)(std::string_view),
              const char* expected, Kind& kind) {
  const std::optional<std::string> name = reader.text(member);
  if (!name) return;
  if (const std::optional<Kind> found = find(*name)) {
    kind = *found;
  } else {
    reader.refuse(fmt::format("plan options: {} is \"{}\", expected {}", member, *name, expected));
  }
}

/// A library that is appended to keeps its settings.
void refuseSettingsBesideAppend(OptionReader& reader) {
  if (!reader.isGiven("append")) return;
  for (const char* name :
       {"threshold", "transitionFrames", "fps", "mirror", "neighbours", "spanRatio", "mostTransitions"}) {
    if (reader.isGiven(name)) {
      reader.refuse(fmt::format(
          "build options: found {} beside append, expected none: the library keeps its own", name));
    }
  }
}

}  // namespace

Result<PlanOptions> readPlanOptions(const val& options) {
  OptionReader reader(options, "plan options");
  PlanOptions read;
  if (const auto seed = reader.wholeNumber("seed")) read.seed = static_cast<std::uint64_t>(*seed);
  read.radiusMetres = reader.number("radius");
  read.goalRadiusMetres = reader.number("goalRadius").value_or(read.goalRadiusMetres);
  read.standing = reader.flag("standing").value_or(read.standing);
  read.footCleanup = reader.flag("footCleanup").value_or(read.footCleanup);
  read.subgoalSpacingMetres = reader.number("subgoalSpacing").value_or(read.subgoalSpacingMetres);
  read.improvementExpansions = static_cast<std::uint64_t>(reader.wholeNumber("improve").value_or(0.0));
  read.enoughRatio = reader.number("until");
  read.budgetMilliseconds = reader.number("budgetMs").value_or(read.budgetMilliseconds);
  const std::string planners =
      fmt::format("{} or {}", plannerName(PlannerKind::kPrm), plannerName(PlannerKind::kRrtConnect));
  const std::string searches =
      fmt::format("{}, {} or {}", searchName(SearchKind::kGuided), searchName(SearchKind::kThesis),
                  searchName(SearchKind::kThesisChecked));
  readKind(reader, "planner", plannerFromName, planners.c_str(), read.planner);
  readKind(reader, "search", searchFromName, searches.c_str(), read.search);
  if (Result<void> checked = reader.check(); !checked) return fail(std::move(checked));
  return read;
}

Result<BvhReadParams> readReadingOptions(const val& options, const std::string& what) {
  OptionReader reader(options, what);
  const BvhReadParams read = readReading(reader, what);
  if (Result<void> checked = reader.check(); !checked) return fail(std::move(checked));
  return read;
}

Result<BuildOptions> readBuildOptions(const val& options) {
  const std::string what = "build options";
  OptionReader reader(options, what);
  BuildOptions read;
  read.library.thresholdMetres = reader.number("threshold").value_or(read.library.thresholdMetres);
  read.library.framesPerSecond = reader.number("fps").value_or(read.library.framesPerSecond);
  read.library.mirror = reader.flag("mirror").value_or(read.library.mirror);
  if (const auto frames = reader.wholeNumber("transitionFrames")) {
    read.library.transitionFrames = static_cast<std::uint32_t>(std::min(*frames, 4294967295.0));
  }
  if (const auto frames = reader.wholeNumber("neighbours")) {
    read.library.neighbourFrames = static_cast<std::uint32_t>(std::min(*frames, 4294967295.0));
  }
  if (const auto transitions = reader.wholeNumber("mostTransitions")) {
    read.library.mostTransitions = static_cast<std::uint32_t>(std::min(*transitions, 4294967295.0));
  }
  read.library.largestSpanRatio = reader.number("spanRatio").value_or(read.library.largestSpanRatio);
  refuseSettingsBesideAppend(reader);
  read.reading = readReading(reader, what);
  read.license = reader.text("license").value_or("");
  if (Result<void> checked = reader.check(); !checked) return fail(std::move(checked));
  return read;
}

}  // namespace stridegraph::bindings
