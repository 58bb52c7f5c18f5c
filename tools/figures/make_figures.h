#pragma once

#include <functional>
#include <vector>

#include "figures/figure.h"

namespace stridegraph::figures {

/// All figures, as makeFigures(inputs) draws them; `progress` is told the share that is drawn, 0..1.
std::vector<FigureSection> makeFigures(const FigureInputs& inputs,
                                       const std::function<void(double)>& progress);

}  // namespace stridegraph::figures
