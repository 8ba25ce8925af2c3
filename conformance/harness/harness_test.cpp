// The small parts: pipes, processes, hashes, PNG.
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "conformance/harness/channel.h"
#include "conformance/harness/child_process.h"
#include "conformance/harness/hash_check.h"
#include "conformance/harness/png.h"
#include "conformance/harness/report.h"
#include "conformance/harness/testing.h"

namespace gouraud::conformance {
namespace {

Command shell(const std::string& script) { return {"/bin/sh", {"-c", script}, {}, {}, false}; }

TEST(Channel, APictureArrivesAsItLeft) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  Picture sent = exact_row({{10.25, 20, 30, 255}, {1, 2, 3, 4}});
  sent.gl_errors = {0x0501};
  sent.read_differences = 2;
  sent.exact->alternatives[1] = {sent.exact->pixels[0]};
  Writer(ends[1]).picture(sent);
  const Picture received = Reader(ends[0], 5).picture();
  EXPECT_EQ(received.rgba, sent.rgba);
  EXPECT_EQ(received.depth, sent.depth);
  EXPECT_EQ(received.covered, sent.covered);
  EXPECT_EQ(received.gl_errors, sent.gl_errors);
  EXPECT_EQ(received.read_differences, 2u);
  EXPECT_EQ(received.exact->pixels, sent.exact->pixels);
  EXPECT_EQ(received.exact->flags, sent.exact->flags);
  EXPECT_EQ(received.exact->fragments_written, sent.exact->fragments_written);
  EXPECT_EQ(received.exact->alternatives, sent.exact->alternatives);
  ::close(ends[1]);
  EXPECT_THROW(Reader(ends[0], 5).text(), ChannelClosed);
  ::close(ends[0]);
}

TEST(ChildProcess, SpeaksOverItsPipes) {
  ChildProcess child(shell("cat <&4 >&3"));
  Writer(child.write_fd()).text("hello");
  EXPECT_EQ(Reader(child.read_fd(), 5).text(), "hello");
}

TEST(ChildProcess, SaysHowItEnded) {
  EXPECT_EQ(ChildProcess(shell("exit 0")).wait(), "");
  EXPECT_EQ(ChildProcess(shell("exit 3")).wait(), "exit status 3");
  EXPECT_EQ(ChildProcess(shell("kill -SEGV $$")).wait().substr(0, 9), "signal 11");
  EXPECT_THROW(ChildProcess({"/no/such/program", {}, {}, {}, false}), std::runtime_error);
}

TEST(ChildProcess, GetsItsEnvironment) {
  ASSERT_EQ(::setenv("GOURAUD_TEST_DROPPED", "x", 1), 0);
  Command command = shell("test \"$GOURAUD_TEST_SET\" = 1 -a -z \"$GOURAUD_TEST_DROPPED\"");
  command.environment = {{"GOURAUD_TEST_SET", "1"}};
  command.dropped_environment = {"GOURAUD_TEST_D"};
  EXPECT_EQ(ChildProcess(command).wait(), "");
}

TEST(Drivers, ACrashCostsOneScene) {
  // A driver that answers each scene by throwing, and dies in the scene "b".
  const std::string script = R"(
    say() { printf "\\$(printf %o ${#1})\0\0\0\0\0\0\0%s" "$1" >&3; }
    for scene; do say $scene; test $scene = b && kill -KILL $$; printf '\0' >&3; say no; done)";
  const Driver driver{"test", {"/bin/sh", {"-c", script, "sh"}, {}, {}, false}};
  const Renderings renderings = render_all(driver, {"a", "b", "c"});
  EXPECT_EQ(renderings.at("a").failure, "no");
  EXPECT_EQ(renderings.at("b").failure, "the driver's process ended: signal 9 (Killed)");
  EXPECT_EQ(renderings.at("c").failure, "no");
}

TEST(Drivers, ADriverThatDoesNotRunFailsEveryScene) {
  const Renderings renderings = render_all({"test", shell("exit 2")}, {"a", "b"});
  EXPECT_EQ(renderings.at("a").failure, "the driver does not run: exit status 2");
  EXPECT_EQ(renderings.at("b").failure, "the driver does not run: exit status 2");
}

TEST(Hash, EveryBitCounts) {
  const Picture picture = covered_row({{1, 2, 3, 4}, {5, 6, 7, 8}});
  Picture other = picture;
  EXPECT_EQ(hash(other), hash(picture));
  other.rgba[7] ^= 1;
  EXPECT_NE(hash(other), hash(picture));
  other = picture;
  other.depth[1] ^= 0x800000;
  EXPECT_NE(hash(other), hash(picture));
  other = picture;
  std::swap(other.width_px, other.height_px);
  EXPECT_NE(hash(other), hash(picture));
}

TEST(Hash, FilesAreReadAsWritten) {
  const Hashes hashes{{"a", "0123456789abcdef"}, {"b", "fedcba9876543210"}};
  EXPECT_EQ(parse_hashes(to_text(hashes)), hashes);
}

TEST(Png, Base64) {
  EXPECT_EQ(base64({}), "");
  EXPECT_EQ(base64({'f'}), "Zg==");
  EXPECT_EQ(base64({'f', 'o'}), "Zm8=");
  EXPECT_EQ(base64({'f', 'o', 'o', 'b'}), "Zm9vYg==");
}

TEST(Png, IsAPng) {
  const std::vector<std::uint8_t> bytes = encode_png({2, 2, std::vector<std::uint8_t>(12, 200)});
  ASSERT_GT(bytes.size(), 8u);
  EXPECT_EQ(std::string(bytes.begin() + 1, bytes.begin() + 4), "PNG");
}

TEST(DifferenceMap, AmplifiesAndMarksCoverage) {
  Picture ours = covered_row({{10, 10, 10, 255}, {10, 10, 10, 255}, {10, 10, 10, 255}});
  Picture other = covered_row({{11, 10, 10, 255}, {10, 10, 10, 255}, {10, 10, 10, 255}});
  other.covered[1] = 0;
  ours.covered[2] = 0;
  const std::vector<std::uint8_t> expected{64, 0, 0, 255, 0, 255, 0, 255, 255};
  EXPECT_EQ(difference_map(ours, other).rgb, expected);
}

}  // namespace
}  // namespace gouraud::conformance
