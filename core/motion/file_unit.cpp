#include "motion/file_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "motion/bvh_reader.h"

namespace stridegraph {
namespace {

constexpr double kLowestHeightMetres = 0.9;
constexpr double kGreatestHeightMetres = 2.4;
constexpr double kCentimetresPerMetre = 100.0;
constexpr double kInchesPerMetre = 1.0 / 0.0254;

struct Unit {
  std::string_view name;
  std::string_view option;  ///< What `--units` takes for it.
  double perMetre;
  double prior;  ///< Share of files that have it.
};
constexpr std::array<Unit, 7> kUnits = {{{"metres", "m", 1.0, 0.2},
                                         {"CMU units of 5.6444 cm", "0.056444", 0.45 * kInchesPerMetre, 0.1},
                                         {"inches", "in", kInchesPerMetre, 0.12},
                                         {"centimetres", "cm", kCentimetresPerMetre, 0.5},
                                         {"millimetres", "0.001", 1000.0, 0.06},
                                         {"decimetres", "0.1", 10.0, 0.015},
                                         {"feet", "0.3048", 1.0 / 0.3048, 0.01}}};
/// Share of files in any other unit, over each factor of e that a height may be away from another.
constexpr double kOtherUnits = 0.004;

double normalDensity(double value, double mean, double deviation) {
  constexpr double kRootOfTwoPi = 2.5066282746310002;
  const double z = (value - mean) / deviation;
  return std::exp(-0.5 * z * z) / (deviation * kRootOfTwoPi);
}

/// How many bodies are so tall between their lowest and highest joints, over the logarithm of the height:
/// adults or, where the names of joints tell of feet or of a head alone, as many times half of an adult; and
/// children, animals and giants.
double heightDensity(double metres, const BodyEvidence& evidence) {
  constexpr double kOthers = 0.2;
  constexpr double kAdultMetres = 1.58;
  constexpr double kHipMetres = 0.87;
  constexpr double kUpperBodyMetres = 0.75;
  const double height = std::log(metres);
  double usual = normalDensity(height, std::log(kAdultMetres), 0.1);
  if (evidence.hasHead != evidence.hasFeet) {
    const double half =
        normalDensity(height, std::log(evidence.hasFeet ? kHipMetres : kUpperBodyMetres), 0.12);
    usual = 0.5 * usual + 0.5 * half;
  }
  return (1.0 - kOthers) * usual + kOthers * normalDensity(height, std::log(1.4), 0.42);
}

double along(UpAxis up, const Vec3& extent) {
  return up == UpAxis::kY ? extent.y() : extent.z();
}

std::string messageFor(const std::array<double, kUnits.size()>& weights, const Unit& unit, double confidence,
                       double height) {
  const double metres = height / unit.perMetre;
  const bool isOdd = metres < kLowestHeightMetres || metres > kGreatestHeightMetres;
  const std::string_view odd = isOdd ? ", odd for a human" : "";
  if (confidence < kDoubtfulConfidence) {
    const Unit* other = nullptr;
    for (std::size_t u = 0; u < kUnits.size(); ++u) {
      if (&kUnits[u] == &unit) continue;
      if (other == nullptr || weights[u] > weights[static_cast<std::size_t>(other - kUnits.data())])
        other = &kUnits[u];
    }
    return fmt::format(
        "{} are taken as the unit, which is doubtful: the body is {:.4g} units tall, which is "
        "{:.3g} m{}; in {} it would be {:.3g} m. Choose the unit if that is wrong (--units {})",
        unit.name, height, metres, odd, other->name, height / other->perMetre, other->option);
  }
  if (!isOdd && unit.perMetre == kCentimetresPerMetre) return {};
  return fmt::format("{} are understood as the unit: the body is {:.4g} units tall, which is {:.3g} m{}",
                     unit.name, height, metres, odd);
}

}  // namespace

UnitGuess inferUnit(const BodyEvidence& evidence, UpAxis up, Warnings& warnings) {
  const double height = std::max(along(up, evidence.extents.posed), along(up, evidence.extents.rest));
  if (height < 1e-6) {
    warnings.push_back({"centimetres are taken as the unit: the body has no height to tell it from",
                        {},
                        WarningTopic::kUnit});
    return {kCentimetresPerMetre, 0.0};
  }
  std::array<double, kUnits.size()> weights;
  double sum = kOtherUnits;
  for (std::size_t u = 0; u < kUnits.size(); ++u)
    sum += weights[u] = kUnits[u].prior * heightDensity(height / kUnits[u].perMetre, evidence);
  const auto best =
      static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
  const UnitGuess guess{kUnits[best].perMetre, weights[best] / sum};
  std::string message = messageFor(weights, kUnits[best], guess.confidence, height);
  if (!message.empty()) warnings.push_back({std::move(message), {}, WarningTopic::kUnit});
  return guess;
}

}  // namespace stridegraph
