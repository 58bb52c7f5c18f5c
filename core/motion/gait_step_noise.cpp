#include "motion/gait_step_noise.h"

#include <algorithm>
#include <cmath>

#include "motion/gait_curves.h"

namespace stridegraph {
namespace {

/// Near enough to normal (Irwin and Hall: twelve uniform numbers), and never beyond 6.
double normal(Random& random) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += random.uniform();
  return sum;
}

}  // namespace

StepNoise::StepNoise(Random& random, std::size_t steps) {
  const double fresh = std::sqrt(1.0 - kMemory * kMemory);
  values_.push_back(normal(random));
  for (std::size_t s = 0; s < steps; ++s)
    values_.push_back(kMemory * values_.back() + fresh * normal(random));
}

double StepNoise::at(double steps) const {
  const double last = static_cast<double>(values_.size() - 1);
  const double place = std::clamp(steps, 0.0, last);
  const auto before = static_cast<std::size_t>(place);
  const std::size_t after = std::min(before + 1, values_.size() - 1);
  return std::lerp(values_[before], values_[after], smoothStep(place - static_cast<double>(before)));
}

}  // namespace stridegraph
