#include "conformance/harness/judge.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "conformance/harness/compare.h"

namespace gouraud::conformance {
namespace {

constexpr std::optional<double> reported{};

/// % of the pixels: filtering rounds elsewhere (ARCHITECTURE §5, textured colour).
constexpr double textured_different = 1.0;

/// One row a measure; the bounds of ARCHITECTURE §5 by judge: polygons, lines and points, oracle only.
struct Row {
  std::string_view key, says;
  std::optional<double> polygons, lines_and_points, oracle_only;
  std::optional<double> bound(Judge judge) const {
    switch (judge) {
      case Judge::polygons: return polygons;
      case Judge::textures: return key == "different_llvmpipe" ? textured_different : polygons;
      case Judge::lines_and_points: return lines_and_points;
      case Judge::oracle_only: return oracle_only;
    }
    return reported;
  }
};

// choice: the mean colour error is judged by what it exceeds the best rounding of the same values by. ARCHITECTURE
// says 0.26/255 where rounding gives 0.25; rounding gives that only where colours vary.
constexpr std::array rows{
    Row{"drawn", "pixels drawn", reported, reported, reported},
    Row{"coverage_oracle", "pixels drawn by ours or the oracle, not by both", 0.0, 0.0, 0.0},
    Row{"background_oracle", "undrawn pixels that differ from the oracle's", 0.0, 0.0, 0.0},
    Row{"color_max_oracle", "largest colour error, 1/255", 1.0, 1.0, 1.0},
    Row{"color_mean_oracle", "mean colour error, 1/255", reported, reported, reported},
    Row{"color_excess_oracle", "mean colour error beyond that of rounding, 1/255", 0.01, 0.01, 0.01},
    Row{"depth_max_oracle", "largest depth error, units", 1.0, 1.0, 1.0},
    Row{"depth_mean_oracle", "mean depth error, units", reported, reported, reported},
    Row{"ambiguous_oracle", "pixels whose depth test hangs on less than a unit", reported, reported, reported},
    Row{"extrapolated_oracle", "pixels that only snapping covers", reported, reported, reported},
    Row{"knife_edge_vertices", "vertices where 1e-6 switches a light", reported, reported, reported},
    Row{"coverage_llvmpipe", "pixels drawn by ours or llvmpipe, not by both", 0.0, reported, reported},
    Row{"background_llvmpipe", "undrawn pixels that differ from llvmpipe's", 0.0, 0.0, reported},
    Row{"color_max_llvmpipe", "largest colour difference from llvmpipe, 1/255", 1.0, reported, reported},
    Row{"color_mean_llvmpipe", "mean colour difference from llvmpipe, 1/255", reported, reported, reported},
    Row{"different_llvmpipe", "% of the drawn pixels whose colour differs from llvmpipe's", 0.1, reported, reported},
    Row{"beyond_one_llvmpipe", "% of the drawn pixels that differ from llvmpipe's in coverage or by more than 1/255",
        reported, 0.5, reported},
    Row{"coverage_softpipe", "pixels drawn by ours or softpipe, not by both", reported, reported, reported},
    Row{"color_max_softpipe", "largest colour difference from softpipe, 1/255", reported, reported, reported},
    Row{"different_softpipe", "% of the drawn pixels whose colour differs from softpipe's", reported, reported, reported},
    Row{"llvmpipe_coverage", "llvmpipe against the oracle: coverage, pixels", reported, reported, reported},
    Row{"llvmpipe_color_max", "llvmpipe against the oracle: largest colour error, 1/255", reported, reported, reported},
    Row{"llvmpipe_depth_max", "llvmpipe against the oracle: largest depth error, units", reported, reported, reported},
    Row{"llvmpipe_depth_mean", "llvmpipe against the oracle: mean depth error, units", reported, reported, reported},
    Row{"softpipe_depth_max", "softpipe against the oracle: largest depth error, units", reported, reported, reported},
};

const Row& row_of(std::string_view key) { return *std::ranges::find(rows, key, &Row::key); }

class Judgement {
 public:
  Judgement(const Scene& scene, const AcceptedExceptions* accepted) : scene_(scene), accepted_(accepted) {}

  void complain(std::string sentence) { verdict_.complaints.push_back(std::move(sentence)); }

  void measure(std::string_view key, double value) {
    const Row& row = row_of(key);
    Measure measure{row.key, row.says, value, row.bound(scene_.judge), std::nullopt};
    if (accepted_ != nullptr) {
      if (const auto found = accepted_->bounds.find(key); found != accepted_->bounds.end()) {
        measure.accepted = found->second;
      }
    }
    verdict_.measures.push_back(measure);
    if (!measure.holds()) complain(text(measure) + ", must be at most " + number(limit(measure)));
    if (measure.accepted && !measure.bound) complain(text(measure) + " is accepted, but not judged here");
    if (measure.accepted && measure.bound && value <= *measure.bound) {
      complain(text(measure) + " is accepted up to " + number(*measure.accepted) + ", but needs no exception");
    }
  }

  Verdict finish() { return std::move(verdict_); }

 private:
  static std::string number(double value) {
    std::array<char, 32> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
    return buffer.data();
  }
  static double limit(const Measure& measure) { return measure.accepted ? *measure.accepted : *measure.bound; }
  static std::string text(const Measure& measure) {
    return std::string(measure.key) + " (" + std::string(measure.says) + ") is " + number(measure.value);
  }

  const Scene& scene_;
  const AcceptedExceptions* accepted_;
  Verdict verdict_;
};

double count(std::size_t value) { return static_cast<double>(value); }

void judge_by_oracle(Judgement& judgement, const Picture& ours, const Picture& oracle) {
  const ExactError error = compare_exact(ours, *oracle.exact);
  judgement.measure("coverage_oracle", count(compare_coverage(ours, *oracle.exact).total()));
  judgement.measure("background_oracle", count(compare_background(ours, oracle)));
  judgement.measure("color_max_oracle", error.color_max);
  judgement.measure("color_mean_oracle", error.color_mean);
  judgement.measure("color_excess_oracle", error.color_mean - error.color_mean_of_rounding);
  judgement.measure("depth_max_oracle", error.depth_max);
  judgement.measure("depth_mean_oracle", error.depth_mean);
  judgement.measure("ambiguous_oracle", count(oracle.exact->count(oracle::pixel_depth_ambiguous)));
  judgement.measure("extrapolated_oracle", count(oracle.exact->count(oracle::pixel_extrapolated)));
  judgement.measure("knife_edge_vertices", static_cast<double>(oracle.exact->knife_edge_vertices));
}

void judge_by_llvmpipe(Judgement& judgement, const Picture& ours, const Picture& llvmpipe) {
  const CoverageDifference coverage = compare_coverage(ours, llvmpipe);
  const ColorDifference color = compare_color(ours, llvmpipe);
  judgement.measure("coverage_llvmpipe", count(coverage.total()));
  judgement.measure("background_llvmpipe", count(compare_background(ours, llvmpipe)));
  judgement.measure("color_max_llvmpipe", color.max);
  judgement.measure("color_mean_llvmpipe", color.mean);
  judgement.measure("different_llvmpipe", color.different_percent());
  const double beyond_one = count(coverage.total() + color.beyond_one);
  judgement.measure("beyond_one_llvmpipe", coverage.drawn == 0 ? 0.0 : 100.0 * beyond_one / count(coverage.drawn));
}

void report_softpipe(Judgement& judgement, const Picture& ours, const Picture& softpipe) {
  const ColorDifference color = compare_color(ours, softpipe);
  judgement.measure("coverage_softpipe", count(compare_coverage(ours, softpipe).total()));
  judgement.measure("color_max_softpipe", color.max);
  judgement.measure("different_softpipe", color.different_percent());
}

void report_mesa_errors(Judgement& judgement, const Picture* llvmpipe, const Picture* softpipe, const Picture& oracle) {
  if (llvmpipe != nullptr) {
    const ExactError error = compare_exact(*llvmpipe, *oracle.exact);
    judgement.measure("llvmpipe_coverage", count(compare_coverage(*llvmpipe, *oracle.exact).total()));
    judgement.measure("llvmpipe_color_max", error.color_max);
    judgement.measure("llvmpipe_depth_max", error.depth_max);
    judgement.measure("llvmpipe_depth_mean", error.depth_mean);
  }
  if (softpipe != nullptr) judgement.measure("softpipe_depth_max", compare_exact(*softpipe, *oracle.exact).depth_max);
}

void check_renderings(Judgement& judgement, const SceneRenderings& renderings) {
  const auto check = [&](std::string_view name, const std::optional<Rendering>& rendering) {
    if (rendering && !rendering->picture) judgement.complain(std::string(name) + ": " + rendering->failure);
  };
  check("ours", renderings.ours);
  check("llvmpipe", renderings.llvmpipe);
  check("softpipe", renderings.softpipe);
  check("oracle", renderings.oracle);
}

std::string error_list(const Picture& picture) {
  std::string result;
  for (const std::uint32_t error : picture.gl_errors) {
    std::array<char, 16> buffer;
    std::snprintf(buffer.data(), buffer.size(), " 0x%04X", error);
    result += buffer.data();
  }
  return result.empty() ? " none" : result;
}

/// True if all pixels have the same colour.
bool is_uniform(const Picture& picture) {
  const std::vector<std::uint8_t>& rgba = picture.rgba;
  return rgba.size() < 8 || std::equal(rgba.begin() + 4, rgba.end(), rgba.begin());
}

bool same_format(const Picture& first, const Picture& second) {
  return first.width_px == second.width_px && first.height_px == second.height_px &&
         first.depth_bits == second.depth_bits;
}

}  // namespace

std::optional<double> Verdict::value(std::string_view key) const {
  const auto found = std::ranges::find(measures, key, &Measure::key);
  return found == measures.end() ? std::nullopt : std::optional(found->value);
}

bool is_measure(std::string_view key) { return std::ranges::find(rows, key, &Row::key) != rows.end(); }

Verdict judge(const Scene& scene, const SceneRenderings& renderings, const AcceptedExceptions* accepted) {
  Judgement judgement(scene, accepted);
  check_renderings(judgement, renderings);
  const Picture* const ours = picture_of(renderings.ours);
  if (ours == nullptr) return judgement.finish();

  const auto comparable = [&](std::string_view name, const std::optional<Rendering>& rendering) -> const Picture* {
    const Picture* const picture = picture_of(rendering);
    if (picture == nullptr || same_format(*ours, *picture)) return picture;
    judgement.complain(std::string(name) + "'s picture has another size or depth format");
    return nullptr;
  };
  const Picture* const oracle = comparable("oracle", renderings.oracle);
  const Picture* const llvmpipe = comparable("llvmpipe", renderings.llvmpipe);
  const Picture* const softpipe = comparable("softpipe", renderings.softpipe);

  const auto drawn = static_cast<std::size_t>(std::ranges::count(ours->covered, 1));
  judgement.measure("drawn", count(drawn));
  if (drawn == 0 && is_uniform(*ours)) judgement.complain("the picture is empty; a scene must show something");
  if (ours->read_differences > 0) {
    judgement.complain("glReadPixels differs from the memory given to OSMesa in " +
                       std::to_string(ours->read_differences) + " pixels");
  }
  if (oracle != nullptr) judge_by_oracle(judgement, *ours, *oracle);
  if (llvmpipe != nullptr) {
    judge_by_llvmpipe(judgement, *ours, *llvmpipe);
    if (ours->gl_errors != llvmpipe->gl_errors) {
      judgement.complain("glGetError gives" + error_list(*ours) + ", llvmpipe" + error_list(*llvmpipe));
    }
  }
  if (softpipe != nullptr) report_softpipe(judgement, *ours, *softpipe);
  if (oracle != nullptr) report_mesa_errors(judgement, llvmpipe, softpipe, *oracle);
  return judgement.finish();
}

}  // namespace gouraud::conformance
