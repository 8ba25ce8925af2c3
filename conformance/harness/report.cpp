#include "conformance/harness/report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace gouraud::conformance {
namespace {

constexpr std::string_view style = R"(
body { font: 14px/1.4 system-ui, sans-serif; margin: 2em; color: #222; max-width: 1500px }
table { border-collapse: collapse; font-size: 13px } td, th { padding: 1px 10px; text-align: left }
td.n { text-align: right; font-variant-numeric: tabular-nums } tr:nth-child(even) { background: #f4f4f4 }
.pass { color: #17692f } .fail { color: #b00020; font-weight: bold } .complaint { color: #b00020; margin: 0 }
figure { display: inline-block; margin: 6px } figcaption { font-size: 12px; color: #555 }
img { image-rendering: pixelated; border: 1px solid #ccc; display: block }
h2 { margin-top: 2em; border-top: 1px solid #ccc; padding-top: .6em } pre { white-space: pre-wrap }
)";

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string formatted(const char* format, double value) {
  std::array<char, 48> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

/// A measure for the terminal, "-" if it was not taken.
std::string shown(const Verdict& verdict, std::string_view key, const char* format) {
  const std::optional<double> value = verdict.value(key);
  return value ? formatted(format, *value) : "-";
}

std::string padded(std::string text, std::size_t width) {
  // Count characters, not bytes: "§" has two.
  const auto continuation = std::ranges::count_if(text, [](char c) { return (c & 0xC0) == 0x80; });
  const std::size_t length = text.size() - static_cast<std::size_t>(continuation);
  if (length < width) text.append(width - length, ' ');
  return text;
}

std::string identical_percent(const Verdict& verdict) {
  const std::optional<double> different = verdict.value("different_llvmpipe");
  return different ? formatted("%.3f", 100.0 - *different) : "-";
}

RgbImage without_alpha(const Picture& picture) {
  RgbImage image{picture.width_px, picture.height_px, {}};
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    if (i % 4 != 3) image.rgb.push_back(picture.rgba[i]);
  }
  return image;
}

void write_figure(std::ostream& out, std::string_view caption, const RgbImage& image) {
  out << "<figure><img src=\"data:image/png;base64," << base64(encode_png(image)) << "\" alt=\"" << caption
      << "\"><figcaption>" << caption << "</figcaption></figure>\n";
}

bool same_size(const Picture& first, const Picture& second) { return first.covered.size() == second.covered.size(); }

void write_pictures(std::ostream& out, std::string_view candidate, const SceneRenderings& renderings) {
  const Picture* const ours = picture_of(renderings.ours);
  const Picture* const llvmpipe = picture_of(renderings.llvmpipe);
  const Picture* const oracle = picture_of(renderings.oracle);
  const auto show = [&](std::string_view caption, const Picture* picture) {
    if (picture != nullptr) write_figure(out, caption, without_alpha(*picture));
  };
  show(candidate, ours);
  show("llvmpipe", llvmpipe);
  show("softpipe", picture_of(renderings.softpipe));
  show("oracle", oracle);
  if (ours == nullptr) return;
  if (llvmpipe != nullptr && same_size(*ours, *llvmpipe)) {
    write_figure(out, "difference from llvmpipe, times 64", difference_map(*ours, *llvmpipe));
  }
  if (oracle != nullptr && same_size(*ours, *oracle)) {
    write_figure(out, "error against the oracle: black is best, 1/255 mid grey", error_map(*ours, *oracle));
  }
}

void write_measures(std::ostream& out, const Verdict& verdict) {
  out << "<table><tr><th>measure<th>value<th>bound<th>accepted</tr>\n";
  for (const Measure& measure : verdict.measures) {
    out << "<tr><td title=\"" << measure.key << "\">" << escaped(measure.says) << "<td class=\"n"
        << (measure.holds() ? "" : " fail") << "\">" << formatted("%.6g", measure.value) << "<td class=n>"
        << (measure.bound ? formatted("%.6g", *measure.bound) : "") << "<td class=n>"
        << (measure.accepted ? formatted("%.6g", *measure.accepted) : "") << "</tr>\n";
  }
  out << "</table>\n";
}

void write_overview_row(std::ostream& out, const SceneResult& result) {
  const Verdict& verdict = result.verdict;
  out << "<tr><td><a href=\"#" << result.scene->name << "\">" << result.scene->name << "</a><td>" << result.scene->section
      << "<td class=" << (verdict.passed() ? "pass>pass" : "fail>FAIL") << "<td class=n>"
      << shown(verdict, "coverage_oracle", "%.0f") << " / " << shown(verdict, "coverage_llvmpipe", "%.0f")
      << "<td class=n>" << identical_percent(verdict) << "<td class=n>" << shown(verdict, "color_max_oracle", "%.2f")
      << " / " << shown(verdict, "color_max_llvmpipe", "%.0f") << "<td class=n>"
      << shown(verdict, "color_mean_oracle", "%.3f") << "<td class=n>" << shown(verdict, "depth_max_oracle", "%.2f")
      << " / " << shown(verdict, "llvmpipe_depth_max", "%.2f") << "</tr>\n";
}

void write_scene(std::ostream& out, std::string_view candidate, const SceneResult& result) {
  const Scene& scene = *result.scene;
  out << "<h2 id=\"" << scene.name << "\">" << scene.name << " <small>" << scene.section << "</small> <span class="
      << (result.verdict.passed() ? "pass>pass" : "fail>FAIL") << "</span></h2>\n<p>" << escaped(scene.shows) << "</p>\n";
  for (const std::string& complaint : result.verdict.complaints) {
    out << "<p class=complaint>" << escaped(complaint) << "</p>\n";
  }
  write_pictures(out, candidate, result.renderings);
  if (!result.accepted_reason.empty()) out << "<p>Accepted:</p><pre>" << escaped(result.accepted_reason) << "</pre>\n";
  write_measures(out, result.verdict);
}

}  // namespace

std::string summary_header() {
  return "coverage: pixels that differ from the oracle's/llvmpipe's; same: % of the pixels equal to llvmpipe's; max, mean:\n"
         "colour error against the oracle/llvmpipe in 1/255; depth: largest error against the oracle in units, ours (llvmpipe)\n" +
         padded("", 5) + padded("scene", 34) + " " + padded("section", 9) + " coverage  same %    max      mean  depth\n";
}

std::string summary_line(const SceneResult& result) {
  const Verdict& verdict = result.verdict;
  const auto pair = [&](std::string_view oracle, std::string_view llvmpipe, const char* format) {
    return shown(verdict, oracle, format) + "/" + shown(verdict, llvmpipe, "%.0f");
  };
  return (verdict.passed() ? "pass " : "FAIL ") + padded(std::string(result.scene->name), 34) + " " +
         padded(std::string(result.scene->section), 9) + " " +
         padded(pair("coverage_oracle", "coverage_llvmpipe", "%.0f"), 9) + " " + padded(identical_percent(verdict), 8) +
         "  " + padded(pair("color_max_oracle", "color_max_llvmpipe", "%.2f"), 8) + " " +
         padded(shown(verdict, "color_mean_oracle", "%.3f"), 5) + " " + shown(verdict, "depth_max_oracle", "%.2f") + " (" +
         shown(verdict, "llvmpipe_depth_max", "%.1f") + ")";
}

void Report::add(const SceneResult& result) {
  write_overview_row(overview_, result);
  write_scene(scenes_, candidate_, result);
  ++(result.verdict.passed() ? passed_ : failed_);
}

void Report::write(const std::string& folder) const {
  std::filesystem::create_directories(folder);
  const std::filesystem::path path = std::filesystem::path(folder) / "report.html";
  std::ofstream out(path);
  out << "<!doctype html><html lang=en><meta charset=utf-8><title>Gouraud: conformance</title><style>" << style
      << "</style>\n<h1>Conformance</h1>\n<p>" << passed_ << " passed, " << failed_ << " failed. Pictures by "
      << candidate_ << ", llvmpipe, softpipe and the oracle.</p>\n"
      << "<table><tr><th>scene<th>section<th>verdict<th>coverage oracle / llvmpipe<th>identical %"
      << "<th>max oracle / llvmpipe<th>mean<th>depth ours / llvmpipe</tr>\n"
      << overview_.str() << "</table>\n" << scenes_.str() << "</html>\n";
  if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace gouraud::conformance
