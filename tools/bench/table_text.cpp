#include "bench/table_text.h"

#include <fmt/format.h>

namespace stridegraph::bench {
namespace {

std::string line(const Cells& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

}  // namespace

Table::Table(const Cells& heading) : text_(line(heading) + line(Cells(heading.size(), "---"))) {}

void Table::add(const Cells& cells) {
  text_ += line(cells);
}

std::string section(const std::string& title, const std::string& about, const Table& table) {
  return fmt::format("## {}\n\n{}\n\n{}\n", title, about, table.text());
}

std::string figure(double value) {
  if (value >= 99.95) return fmt::format("{:.0f}", value);
  if (value >= 9.995) return fmt::format("{:.1f}", value);
  return fmt::format("{:.2f}", value);
}

std::string medianAndWorst(const Spread& spread) {
  return fmt::format("{} / {}", figure(spread.median), figure(spread.worst));
}

std::string ratio(const Summary& summary) {
  if (summary.arrived == 0) return "-";
  return fmt::format("{:.3f} / {:.3f}", summary.lengthRatio.median, summary.lengthRatio.worst);
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100.0 * share);
}

std::string placeTitle(const std::string& place) {
  return place == "node" ? "Node.js" : place;
}

}  // namespace stridegraph::bench
