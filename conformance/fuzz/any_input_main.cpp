// any_input LIBRARY SEED CALLS
//
// Every command of the GL with whatever arguments: enums of its group and others, numbers at their limits, offsets beyond
// buffer objects, inside and outside Begin/End and display lists. Nothing is compared; the library has to live. What a program
// owes the GL it gets here, too: client memory that is as large as the sizes say. Each context runs in a process of its own;
// where one dies, its seed and last calls are written, and the exit status is 1.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "conformance/harness/offscreen.h"
#include "conformance/scenes/shapes.h"
#include "gl_commands.h"

namespace gouraud::conformance {
namespace {

constexpr int calls_a_context = 600, calls_remembered = 12;
constexpr rlim_t longest_s = 20;  // of processor time
constexpr std::size_t client_bytes = std::size_t{1} << 32;

/// What the child did last, for the parent to tell.
struct Memoirs {
  int calls;
  std::array<std::array<char, 400>, calls_remembered> line;
};

/// Client memory, most of it zeros that take no room.
struct ClientMemory {
  std::byte* numbers;   ///< integers below 300, pointers to itself behind them
  std::byte* anything;  ///< bytes and floats of all kinds
  std::byte* answers;   ///< what commands may write to
};

std::byte* map(std::size_t bytes, int flags) {
  void* const memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_ANONYMOUS | MAP_NORESERVE | flags, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no memory");
  return static_cast<std::byte*>(memory);
}

ClientMemory make_client_memory() {
  const ClientMemory memory{map(client_bytes, MAP_PRIVATE), map(client_bytes, MAP_PRIVATE), map(client_bytes, MAP_PRIVATE)};
  Random random(1);
  constexpr std::size_t count = 1024;
  std::array<std::uint32_t, count> numbers;
  for (std::uint32_t& number : numbers) number = static_cast<std::uint32_t>(random.below(300));
  std::memcpy(memory.numbers, numbers.data(), sizeof numbers);
  const float odd[] = {0.0f, -0.0f, 1.0f, -1.0f, 0.5f, 1e-40f, 1e38f, -1e38f, std::numeric_limits<float>::infinity(),
                       -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()};
  for (std::size_t i = 0; i < count; ++i) {
    float value = random.range(-2, 2);
    if (i % 4 == 0) value = odd[static_cast<std::size_t>(random.below(static_cast<int>(std::size(odd))))];
    std::uint32_t word;
    std::memcpy(&word, &value, sizeof word);
    if (i % 64 > 48) word = random.next();
    std::memcpy(memory.anything + i * sizeof word, &word, sizeof word);
  }
  return memory;
}

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }
bool begins(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

std::vector<std::string_view> words(const char* text) {
  std::vector<std::string_view> result;
  for (std::string_view rest(text); !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    result.push_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return result;
}

class Caller {
 public:
  Caller(const GlTable& gl, const ClientMemory& memory, Random& random, Memoirs& memoirs)
      : gl_(gl), memory_(memory), random_(random), memoirs_(memoirs) {}

  void call_one() {
    const CommandRow& row = command_rows()[static_cast<std::size_t>(random_.below(static_cast<int>(command_rows().size())))];
    if (std::string_view(row.name) == "Begin" && random_.below(3) != 0) return;  // or all the rest is an error
    const std::string_view parameters(row.parameters);
    const std::vector<std::string_view> groups = words(row.groups), names = words(row.names);
    std::array<CommandArgument, 16> arguments;
    for (std::size_t i = 0; i < parameters.size(); ++i) arguments[i] = argument(row, parameters[i], groups[i], names[i]);
    remember(row, std::span(arguments).first(parameters.size()));
    row.call(gl_, arguments.data());
    if (contains(row.name, "Begin") && random_.below(2) == 0) gl_.End();
    if (std::string_view(row.name) == "NewList" && random_.below(2) == 0) gl_.EndList();
  }

 private:
  bool chance(int one_of) { return random_.below(one_of) == 0; }

  CommandArgument argument(const CommandRow& row, char kind, std::string_view group, std::string_view name) {
    switch (kind) {
      case 'e': return static_cast<double>(enumerant(group));
      case 'm': return static_cast<double>(chance(3) ? random_.next() : enumerant(group) | enumerant(group));
      case 'b': return static_cast<double>(chance(10) ? random_.below(256) : random_.below(2));
      case 'f':
      case 'd': return begins(row.name, "PixelStore") ? integer(row, 'i') : real();
      case 'p': return pointer(row, name);
      default: return integer(row, kind);
    }
  }

  std::uint32_t enumerant(std::string_view group) {
    if (chance(16)) return random_.next() % 0x9000;
    const std::span<const EnumRow> rows = enum_rows();
    const bool any = group == "none" || chance(8);
    for (int tries = 0; tries < 4000; ++tries) {
      const EnumRow& row = rows[static_cast<std::size_t>(random_.below(static_cast<int>(rows.size())))];
      if (any) return row.value;
      for (const std::string_view word : words(row.groups)) {
        if (word == group) return row.value;
      }
    }
    return 0;
  }

  double real() {
    const double odd[] = {0, -0.0, 1, -1, 0.5, 1e-45, 1e30, -1e30, 3e38, 1e300, std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
    if (chance(4)) return odd[random_.below(static_cast<int>(std::size(odd)))];
    return static_cast<double>(chance(4) ? random_.range(-100, 100) : random_.range(-1, 1));
  }

  /// Where the size of what client memory has to hold depends on it, it is small or wrong.
  double integer(const CommandRow& row, char kind) {
    const std::string_view name(row.name);
    const bool about_memory = contains(row.parameters, "p") || begins(name, "PixelStore") || begins(name, "Draw") || begins(name, "Multi") ||
                              contains(name, "ArrayElement") || begins(name, "EvalMesh") || begins(name, "MapGrid") || contains(name, "Buffer");
    if (chance(8)) return begins(name, "EvalMesh") || random_.below(2) == 0 ? -1 : std::numeric_limits<std::int32_t>::min();
    if (!about_memory && chance(8)) {
      const double large[] = {2147483647, 65536, 16384, 16385, 4294967295.0, 32767, 2048};
      return large[random_.below(static_cast<int>(std::size(large)))];
    }
    if (kind == 'n') return random_.below(2000);
    return chance(3) ? random_.below(70) : random_.below(6);
  }

  CommandArgument pointer(const CommandRow& row, std::string_view name) {
    const std::string_view command(row.name);
    if (chance(20) && (contains(command, "TexImage") || contains(command, "BufferData"))) return static_cast<void*>(nullptr);
    const bool answers = begins(command, "Get") || begins(command, "Gen") || begins(command, "Read") || contains(command, "FeedbackBuffer") ||
                         contains(command, "SelectBuffer") || name == "residences";
    if (answers) return memory_.answers + 16 * random_.below(8);
    if (is_offset(command) && chance(2)) return reinterpret_cast<void*>(static_cast<std::uintptr_t>(random_.below(3000)));
    if (begins(command, "MultiDrawElements") && name == "indices") return pointers();
    const bool numbers = contains(command, "Draw") || name == "count" || name == "first" || begins(command, "Delete") || begins(command, "CallLists");
    const bool images = contains(command, "Image") || contains(command, "DrawPixels") || contains(command, "Bitmap");
    if (numbers && !images) return memory_.numbers + 4 * random_.below(64);
    const bool untyped = images || contains(command, "Pointer") || contains(command, "BufferData") || contains(command, "BufferSubData") || command == "CallLists";
    return memory_.anything + (untyped && chance(3) ? random_.below(64) : 8 * random_.below(64));
  }

  /// The buffer object that is bound there makes an offset of it.
  bool is_offset(std::string_view command) {
    const auto bound = [this](GLenum binding) {
      GLint name = 0;
      gl_.GetIntegerv(binding, &name);
      return name != 0;
    };
    if (begins(command, "Multi")) return false;
    if (contains(command, "Elements")) return bound(GL_ELEMENT_ARRAY_BUFFER_BINDING);
    if (contains(command, "Pointer") || begins(command, "InterleavedArrays")) return bound(GL_ARRAY_BUFFER_BINDING);
    return false;
  }

  /// Pointers into the numbers.
  void* pointers() {
    std::byte* const place = memory_.numbers + (1 << 16);
    for (std::size_t i = 0; i < 512; ++i) {
      void* const to = memory_.numbers + 4 * random_.below(64);
      std::memcpy(place + i * sizeof to, &to, sizeof to);
    }
    return place;
  }

  void remember(const CommandRow& row, std::span<const CommandArgument> arguments) {
    auto& line = memoirs_.line[static_cast<std::size_t>(memoirs_.calls++ % calls_remembered)];
    auto length = static_cast<std::size_t>(std::snprintf(line.data(), line.size(), "%s", row.name));
    for (std::size_t i = 0; i < arguments.size() && length < line.size(); ++i) {
      const bool is_pointer = row.parameters[i] == 'p', is_enum = row.parameters[i] == 'e';
      char* const end = line.data() + length;
      const std::size_t room = line.size() - length;
      if (is_pointer) length += static_cast<std::size_t>(std::snprintf(end, room, " %p", arguments[i].pointer));
      else if (is_enum) length += static_cast<std::size_t>(std::snprintf(end, room, " 0x%x", arguments[i].as<std::uint32_t>()));
      else length += static_cast<std::size_t>(std::snprintf(end, room, " %.9g", arguments[i].number));
    }
  }

  const GlTable& gl_;
  const ClientMemory& memory_;
  Random& random_;
  Memoirs& memoirs_;
};

void run_context(const OsmesaFunctions& osmesa, const ClientMemory& memory, std::uint32_t seed, Memoirs& memoirs) {
  Random random(seed * 2654435761u + 1);
  const int sizes[] = {1, 7, 64, 130};
  const int depths[] = {0, 16, 24};
  const int width_px = sizes[random.below(4)], height_px = sizes[random.below(4)];
  OffscreenContext context(osmesa, width_px, height_px, depths[random.below(3)]);
  Caller caller(context.gl(), memory, random, memoirs);
  for (int i = 0; i < calls_a_context; ++i) caller.call_one();
}

int run(const OsmesaFunctions& osmesa, std::uint32_t seed, int calls) {
  const ClientMemory memory = make_client_memory();
  auto& memoirs = *new (map(sizeof(Memoirs), MAP_SHARED)) Memoirs{};
  int deaths = 0;
  for (int done = 0; done < calls; done += calls_a_context, ++seed) {
    memoirs.calls = 0;
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) {
      const rlimit longest{longest_s, longest_s}, no_core{0, 0};
      ::setrlimit(RLIMIT_CPU, &longest);
      ::setrlimit(RLIMIT_CORE, &no_core);
      run_context(osmesa, memory, seed, memoirs);
      std::_Exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (status == 0) continue;
    ++deaths;
    std::printf("seed %u: ended with %d after %d calls; the last ones:\n", seed, WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status), memoirs.calls);
    for (int i = std::max(0, memoirs.calls - calls_remembered); i < memoirs.calls; ++i) std::printf("  %s\n", memoirs.line[static_cast<std::size_t>(i % calls_remembered)].data());
  }
  std::printf("%d calls, %d of the contexts died\n", calls, deaths);
  return deaths == 0 ? 0 : 1;
}

}  // namespace
}  // namespace gouraud::conformance

int main(int argc, char** argv) {
  using namespace gouraud::conformance;
  try {
    if (argc != 4) throw std::runtime_error("usage: any_input LIBRARY SEED CALLS");
    return run(load_osmesa(argv[1]), static_cast<std::uint32_t>(std::atoi(argv[2])), std::atoi(argv[3]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "any_input: %s\n", error.what());
    return 2;
  }
}
