#include "conformance/harness/accepted.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "conformance/harness/judge.h"

namespace gouraud::conformance {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

double number(std::string_view text) {
  std::size_t used = 0;
  double value = 0.0;
  try {
    value = std::stod(std::string(text), &used);
  } catch (const std::exception&) {
  }
  if (used == 0 || used != text.size()) throw std::runtime_error("no number: " + std::string(text));
  return value;
}

}  // namespace

AcceptedExceptions parse_accepted(std::string_view text) {
  AcceptedExceptions result;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    const auto relation = line.find("<=");
    if (result.reason.empty() && relation != std::string::npos) {
      const std::string key(trimmed(std::string_view(line).substr(0, relation)));
      if (!is_measure(key)) throw std::runtime_error("no measure is called " + key);
      result.bounds[key] = number(trimmed(std::string_view(line).substr(relation + 2)));
    } else if (!result.reason.empty() || !trimmed(line).empty()) {
      result.reason += line + "\n";
    }
  }
  if (result.bounds.empty()) throw std::runtime_error("no line `measure <= number`");
  if (result.reason.find("§") == std::string::npos) throw std::runtime_error("the reason cites no section (§)");
  return result;
}

std::map<std::string, AcceptedExceptions, std::less<>> read_accepted(const std::string& folder) {
  std::map<std::string, AcceptedExceptions, std::less<>> result;
  if (!std::filesystem::is_directory(folder)) throw std::runtime_error("no folder " + folder);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() != ".md" || path.filename() == "README.md") continue;
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    try {
      result[path.stem()] = parse_accepted(text.str());
    } catch (const std::exception& error) {
      throw std::runtime_error(path.string() + ": " + error.what());
    }
  }
  return result;
}

}  // namespace gouraud::conformance
