#include "program/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "program/name_list.h"
#include "program/shown_text.h"

namespace stridegraph::tools {

double numberOrThrow(const std::string& name, const std::string& text, const NumberRange& range) {
  const Result<double> value = parseNumber(text, range);
  if (!value) throw CLI::ValidationError(name, value.error().message);
  return *value;
}

std::uint64_t wholeOrThrow(const std::string& name, const std::string& text, const WholeRange& range) {
  const Result<std::uint64_t> value = parseWhole(text, range);
  if (!value) throw CLI::ValidationError(name, value.error().message);
  return *value;
}

std::string choiceOrThrow(const std::string& name, const std::string& text,
                          const std::vector<std::string>& choices) {
  if (std::find(choices.begin(), choices.end(), text) != choices.end()) return text;
  throw CLI::ValidationError(name, fmt::format("found {}, expected {}{}", quotedText(text), listOf(choices),
                                               suggestionFor(text, choices)));
}

CLI::Option* addText(CLI::App& command, const std::string& name,
                     const std::function<void(const std::string&)>& take, const std::string& meaning) {
  return command.add_option_function<std::string>(name, take, meaning);
}

CLI::Option* addNumber(CLI::App& command, const std::string& name, double& value, const NumberRange& range,
                       const std::string& meaning) {
  const auto take = [&value, name, range](const std::string& text) {
    value = numberOrThrow(name, text, range);
  };
  return addText(command, name, take, meaning + ": " + describe(range))
      ->type_name("X")
      ->default_str(plainNumber(value));
}

CLI::Option* addWholeList(CLI::App& command, const std::string& name, std::vector<std::size_t>& values,
                          const WholeRange& range, const std::string& meaning) {
  const auto take = [&values, name, range](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      std::istringstream parts(text + ",");
      for (std::string part; std::getline(parts, part, ',');)
        values.push_back(static_cast<std::size_t>(wholeOrThrow(name, part, range)));
    }
  };
  return command.add_option_function<std::vector<std::string>>(name, take, meaning + ": " + describe(range))
      ->type_name("N,N")
      ->allow_extra_args(false);
}

CLI::Option* addChoice(CLI::App& command, const std::string& name, std::string& value,
                       const std::vector<std::string>& choices, const std::string& meaning) {
  const auto take = [&value, name, choices](const std::string& text) {
    value = choiceOrThrow(name, text, choices);
  };
  return addText(command, name, take, meaning + ": " + listOf(choices))
      ->type_name("WORD")
      ->default_str(value);
}

CLI::Option* addPath(CLI::App& command, const std::string& name, std::string& path, const std::string& word,
                     const std::string& meaning) {
  return command.add_option(name, path, meaning)->type_name(word);
}

void addQuiet(CLI::App& command, bool& isQuiet) {
  command.add_flag("-q,--quiet", isQuiet, "Print errors and results alone: no progress, notes or summary");
}

}  // namespace stridegraph::tools
