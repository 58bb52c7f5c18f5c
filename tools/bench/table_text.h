#pragma once

#include <string>
#include <vector>

#include "bench/summary.h"

namespace stridegraph::bench {

using Cells = std::vector<std::string>;

/// A Markdown table.
class Table {
 public:
  explicit Table(const Cells& heading);

  void add(const Cells& cells);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// A table under its heading and what is said of it.
std::string section(const std::string& title, const std::string& about, const Table& table);

/// Three digits, without needless ones behind the point.
std::string figure(double value);
/// "7.10 / 8.74"
std::string medianAndWorst(const Spread& spread);
/// "1.073 / 1.100", or "-" where nothing arrived.
std::string ratio(const Summary& summary);
std::string percent(double share);
/// As readers know it: "native", "Node.js".
std::string placeTitle(const std::string& place);

}  // namespace stridegraph::bench
