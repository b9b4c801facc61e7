// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>

#include "deburr/error.hpp"
#include "io/atomic_file.hpp"
#include "io/links.hpp"
#include "io/source.hpp"
#include "support/temp_dir.hpp"

// Where a path leads: along links, to what is open already, to devices and pipes.

namespace deburr {
namespace {

using testing::Optional;
namespace fs = std::filesystem;

/// A descriptor that is open for as long as the test wants.
class Open {
 public:
  explicit Open(int fd) : fd_(fd) { EXPECT_GE(fd, 0); }
  ~Open() { ::close(fd_); }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;

  [[nodiscard]] int number() const { return fd_; }
  [[nodiscard]] fs::path path() const { return "/dev/fd/" + std::to_string(fd_); }

 private:
  int fd_;
};

TEST(FollowLinks, GoesToTheEndThoughNothingIsThere) {
  const TempDir dir;
  fs::create_directory(dir / "sub");
  fs::create_symlink("sub/none", dir / "link");
  fs::create_symlink("link", dir / "chain");
  fs::create_symlink("loop", dir / "loop");
  EXPECT_EQ(follow_links(dir / "chain"), dir / "sub/none");
  EXPECT_EQ(follow_links(dir / "plain"), dir / "plain");
  EXPECT_EQ(follow_links("plain"), "plain");
  EXPECT_EQ(follow_links(dir / "loop"), dir / "loop");
}

TEST(OwnDescriptor, IsKnownByAllItsNames) {
  const TempDir dir;
  EXPECT_THAT(own_descriptor("/dev/stdin"), Optional(0));
  EXPECT_THAT(own_descriptor("/dev/stdout"), Optional(1));
  EXPECT_THAT(own_descriptor("/dev/fd/7"), Optional(7));
  EXPECT_THAT(own_descriptor("/proc/self/fd/999999"), Optional(999999));  // which is closed
  EXPECT_THAT(own_descriptor("/proc/thread-self/fd/2"), Optional(2));
  EXPECT_THAT(own_descriptor("/dev/../dev/fd/3"), Optional(3));
  EXPECT_THAT(own_descriptor("/proc/" + std::to_string(::getpid()) + "/fd/3"), Optional(3));
  fs::create_symlink("/dev/stderr", dir / "link");
  EXPECT_THAT(own_descriptor(dir / "link"), Optional(2));
}

TEST(OwnDescriptor, IsNoOtherFile) {
  const TempDir dir;
  fs::create_directory(dir / "fd");
  put(dir / "fd/1", "");
  fs::create_symlink("loop", dir / "loop");
  for (const fs::path& path :
       {dir / "fd/1", dir / "loop", dir / "none/1", fs::path("1"), fs::path("-"), fs::path(""),
        fs::path("/dev/fd"), fs::path("/dev/fd/"), fs::path("/dev/fd/1x"), fs::path("/dev/fd/-1"),
        fs::path("/dev/fd/99999999999"), fs::path("/dev/null"), fs::path("/proc/1/fd/1")}) {
    EXPECT_EQ(own_descriptor(path), std::nullopt) << path;
  }
}

// Two writers of one file, the shell and this one, are not to write over each other.
TEST(AtomicFile, WritesIntoWhatADescriptorHolds) {
  const TempDir dir;
  put(dir / "a", "");
  const int held = ::open((dir / "a").c_str(), O_WRONLY);
  AtomicFile file("/dev/fd/" + std::to_string(held));
  file.write("new");
  EXPECT_EQ(get(dir / "a"), "new");
  file.commit();
  EXPECT_EQ(::write(held, "er", 2), 2);  // still the same file, at the same place
  EXPECT_EQ(get(dir / "a"), "newer");
  ::close(held);
}

TEST(AtomicFile, GoesOnWhereADescriptorStands) {
  const TempDir dir;
  const Open held(::open((dir / "a").c_str(), O_WRONLY | O_CREAT, 0600));
  ASSERT_EQ(::write(held.number(), "head ", 5), 5);
  fs::create_symlink(held.path(), dir / "link");
  AtomicFile file(dir / "link");
  file.write("body");
  file.commit();
  EXPECT_EQ(get(dir / "a"), "head body");
  EXPECT_EQ(dir.count(), 2);
}

// These cannot be opened by their paths.
TEST(AtomicFile, WritesSockets) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  const Open ours(ends[0]);
  const Open theirs(ends[1]);
  AtomicFile file(ours.path());
  file.write("data");
  file.commit();
  std::array<char, 8> got{};
  EXPECT_EQ(::read(theirs.number(), got.data(), got.size()), 4);
  EXPECT_STREQ(got.data(), "data");
}

TEST(AtomicFile, SaysWhatIsWrongWithADescriptor) {
  const TempDir dir;
  put(dir / "a", "old");
  const Open held(::open((dir / "a").c_str(), O_RDONLY));
  AtomicFile file(held.path());
  EXPECT_THROW(file.write("new"), IoError);
  EXPECT_EQ(get(dir / "a"), "old");
  EXPECT_THROW(AtomicFile("/dev/fd/999"), IoError);
}

TEST(Load, ReadsADescriptorFromWhereItStands) {
  const TempDir dir;
  put(dir / "a", "head body");
  const Open held(::open((dir / "a").c_str(), O_RDONLY));
  ASSERT_EQ(::lseek(held.number(), 5, SEEK_SET), 5);
  EXPECT_EQ(load(held.path()).data, "body");
  EXPECT_EQ(load(held.path()).data, "");
  EXPECT_EQ(load(dir / "a").data, "head body");
  const Open writes(::open((dir / "a").c_str(), O_WRONLY));
  EXPECT_THROW((void)load(writes.path()), IoError);
}

TEST(AtomicFile, ReplacesWhatALinkPointsTo) {
  const TempDir dir;
  fs::create_directory(dir / "sub");
  put(dir / "sub/a", "old");
  fs::create_symlink("sub/a", dir / "link");
  fs::create_symlink("link", dir / "chain");
  fs::create_symlink("sub/new", dir / "dangling");
  for (const char* name : {"chain", "dangling"}) {
    AtomicFile file(dir / name);
    file.write("new");
    file.commit();
  }
  EXPECT_TRUE(fs::is_symlink(dir / "link") && fs::is_symlink(dir / "chain") &&
              fs::is_symlink(dir / "dangling"));
  EXPECT_EQ(get(dir / "sub/a"), "new");
  EXPECT_EQ(get(dir / "sub/new"), "new");
}

TEST(AtomicFile, WritesDevicesDirectly) {
  AtomicFile null("/dev/null");
  null.write("data");
  null.commit();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));

  AtomicFile full("/dev/full");
  try {
    full.write("data");
    FAIL() << "the device took data";
  } catch (const IoError& e) {
    EXPECT_STREQ(e.what(), "/dev/full: cannot write: No space left on device");
  }
}

TEST(AtomicFile, WritesPipesDirectly) {
  const TempDir dir;
  ASSERT_EQ(::mkfifo((dir / "pipe").c_str(), 0600), 0);
  // Open for both, so that neither end waits for the other.
  std::fstream reader(dir / "pipe", std::ios::in | std::ios::out);
  AtomicFile file(dir / "pipe");
  file.write("data\n");
  file.commit();
  std::string line;
  std::getline(reader, line);
  EXPECT_EQ(line, "data");
  EXPECT_TRUE(fs::is_fifo(dir / "pipe"));
}

}  // namespace
}  // namespace deburr
