#include "demos/shell/options.h"

#include <charconv>
#include <cstdio>
#include <sstream>
#include <tuple>
#include <utility>

namespace shell {
namespace {

constexpr int max_size_px = 16384;
constexpr int max_frames = 1000000;

// The whole text as a number from `low` to `high`, or nothing.
template <typename Number>
std::optional<Number> parse_number(const std::string& text, Number low, Number high) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, value);
  if (status != std::errc{} || stop != end || !(value >= low && value <= high)) return std::nullopt;
  return value;
}

// Two numbers with a separator between them.
std::optional<std::pair<int, int>> parse_pair(const std::string& text, char separator, int low, int high) {
  const size_t at = text.find(separator);
  if (at == std::string::npos) return std::nullopt;
  const auto first = parse_number<int>(text.substr(0, at), low, high);
  const auto second = parse_number<int>(text.substr(at + 1), low, high);
  if (!first || !second) return std::nullopt;
  return std::pair(*first, *second);
}

bool parse_size(const std::string& text, Options& options) {
  const auto size = parse_pair(text, 'x', 1, max_size_px);
  if (size) std::tie(options.width_px, options.height_px) = *size;
  return size.has_value();
}

bool parse_click(const std::string& text, Options& options) {
  const auto position = parse_pair(text, ',', 0, max_size_px - 1);
  if (position) options.click = Click{position->first, position->second};
  return position.has_value();
}

std::optional<int> parse_key(const std::string& name) {
  if (name == "left") return key_left;
  if (name == "right") return key_right;
  if (name == "up") return key_up;
  if (name == "down") return key_down;
  if (name == "space") return ' ';
  if (name.size() == 1 && name[0] > ' ' && name[0] <= '~') return name[0];
  return std::nullopt;
}

bool parse_keys(const std::string& text, Options& options) {
  std::istringstream names(text);
  for (std::string name; std::getline(names, name, ',');) {
    const auto key = parse_key(name);
    if (!key) return false;
    options.keys.push_back(*key);
  }
  return !options.keys.empty();
}

// Where the number of a numbered file name stands: its place, its length, and how it is padded.
struct Placeholder {
  size_t begin = 0;
  size_t size = 0;
  int width = 0;
  bool zeros = false;
};

std::optional<Placeholder> find_placeholder(const std::string& out) {
  const size_t percent = out.find('%');
  if (percent == std::string::npos) return std::nullopt;
  Placeholder place{.begin = percent};
  size_t i = percent + 1;
  if (i < out.size() && out[i] == '0') place.zeros = true, ++i;
  if (i < out.size() && out[i] >= '1' && out[i] <= '9') place.width = out[i++] - '0';
  if (i >= out.size() || out[i] != 'd') return std::nullopt;
  place.size = i + 1 - percent;
  return place;
}

bool is_valid_out(const std::string& out) {
  const auto place = find_placeholder(out);
  const size_t after = place ? place->begin + place->size : 0;
  return !out.empty() && out.find('%', after) == std::string::npos;
}

// Takes one option with its value; false where the value is no good.
bool take_value(const std::string& option, const std::string& value, Options& options) {
  if (option == "--size") return parse_size(value, options);
  if (option == "--keys") return parse_keys(value, options);
  if (option == "--click") return parse_click(value, options);
  if (option == "--time") {
    options.time_s = parse_number<double>(value, 0.0, 1e6);
    return options.time_s.has_value();
  }
  options.headless = true;
  if (option == "--out") {
    options.out = value;
    return is_valid_out(value);
  }
  const auto frames = parse_number<int>(value, 1, max_frames);
  if (frames) options.frames = *frames;
  return frames.has_value();
}

// What each option wants, in the words of its error message; null for an unknown option.
const char* wanted_value(const std::string& option) {
  if (option == "--size") return "WIDTHxHEIGHT, each 1 to 16384";
  if (option == "--keys") return "a list such as left,right,up,down,space,z";
  if (option == "--click") return "X,Y, each 0 to 16383";
  if (option == "--time") return "seconds, 0 to 1000000";
  if (option == "--out") return "a file name, with at most one %d, %4d or %04d";
  if (option == "--frames") return "a number, 1 to 1000000";
  return nullptr;
}

}  // namespace

std::string help_text(const Demo& demo) {
  std::ostringstream text;
  text << "usage: " << demo.name << " [options]\n"
       << "In the window: " << demo.keys_help << "; ESC ends.\n"
       << "  --size WxH     picture size (default " << demo.width_px << 'x' << demo.height_px << ")\n"
       << "  --keys LIST    press these keys before the first frame: left,right,up,down,space or a character\n"
       << "  --click X,Y    then press the mouse at this pixel, y from the top\n"
       << "  --time S       hold the clock at S seconds\n"
       << "without a window:\n"
       << "  --out FILE     write the last frame as a PNG (default " << demo.name << ".png);\n"
       << "                 with a number in the name, as in frame%04d.png, write every frame, counted from 0\n"
       << "  --frames N     draw N frames (default 1); frame i shows the time i/60 s, however long drawing takes\n"
       << "Either of the last two asks for no window; so does a missing display.\n";
  return text.str();
}

std::optional<Options> parse_options(const std::vector<std::string>& arguments, const Demo& demo, std::string& error) {
  Options options;
  options.width_px = demo.width_px;
  options.height_px = demo.height_px;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& option = arguments[i];
    if (option == "--help" || option == "-h") {
      options.help = true;
      continue;
    }
    const char* wanted = wanted_value(option);
    if (wanted == nullptr) {
      error = "unknown argument '" + option + "' (--help lists the known ones)";
      return std::nullopt;
    }
    if (i + 1 == arguments.size() || !take_value(option, arguments[i + 1], options)) {
      error = option + " needs " + wanted;
      return std::nullopt;
    }
    ++i;
  }
  if (options.out.empty()) options.out = std::string(demo.name) + ".png";
  return options;
}

bool is_numbered(const std::string& out) {
  return find_placeholder(out).has_value();
}

std::string frame_file(const std::string& out, int frame) {
  const auto place = find_placeholder(out);
  if (!place) return out;
  std::string number = std::to_string(frame);
  const size_t width = static_cast<size_t>(place->width);
  if (number.size() < width) number.insert(0, width - number.size(), place->zeros ? '0' : ' ');
  return std::string(out).replace(place->begin, place->size, number);
}

}  // namespace shell
