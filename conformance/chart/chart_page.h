// The parts of chart.html that do not depend on figures: a page that draws itself from `chart` and `images`.
#pragma once

#include <string_view>

namespace gouraud::chart {

extern const std::string_view chart_page_head;
extern const std::string_view chart_page_script;

}  // namespace gouraud::chart
