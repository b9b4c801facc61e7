// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "io/atomic_file.hpp"
#include "support/temp_dir.hpp"

namespace deburr {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

std::string error_of_opening(const fs::path& path) {
  try {
    const AtomicFile file(path);
  } catch (const IoError& e) {
    return e.what();
  }
  return "";
}

/// Whether files without a name can be made in a folder.
bool has_nameless_files(const fs::path& folder) {
  const int fd = ::open(folder.c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (fd >= 0) ::close(fd);
  return fd >= 0;
}

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const TempDir dir;
  put(dir / "a", "old");
  {
    AtomicFile file(dir / "a");
    file.write("ne");
    file.write("w");
    EXPECT_EQ(get(dir / "a"), "old");
    EXPECT_EQ(dir.count(), has_nameless_files(dir.path()) ? 1 : 2);
    file.commit();
  }
  EXPECT_EQ(get(dir / "a"), "new");
  EXPECT_EQ(dir.count(), 1);
}

TEST(AtomicFile, LeavesNothingBehindWithoutCommit) {
  const TempDir dir;
  put(dir / "a", "old");
  for (const char* name : {"a", "b"}) {
    EXPECT_THROW(
        {
          AtomicFile file(dir / name);
          file.write("new");
          throw std::runtime_error("in the middle");
        },
        std::runtime_error);
  }
  EXPECT_EQ(get(dir / "a"), "old");
  EXPECT_EQ(dir.count(), 1);
}

TEST(AtomicFile, WritesTwoFilesOfOneFolderAtOnce) {
  const TempDir dir;
  AtomicFile a(dir / "a");
  AtomicFile b(dir / "b");
  a.write("1");
  b.write("2");
  b.commit();
  a.commit();
  EXPECT_EQ(get(dir / "a") + get(dir / "b"), "12");
}

TEST(AtomicFile, ChangesNothingUntilAllOfSeveralAreWhole) {
  const TempDir dir;
  put(dir / "a", "old");
  {
    AtomicFile a(dir / "a");
    AtomicFile b(dir / "b");
    a.write("new");
    a.sync();
    b.write("new");
    a.finish();
    b.finish();
    EXPECT_EQ(get(dir / "a"), "old");
    EXPECT_FALSE(fs::exists(dir / "b"));
    b.finish();  // nothing is left to do
    b.commit();
  }
  EXPECT_EQ(get(dir / "a"), "old");
  EXPECT_EQ(get(dir / "b"), "new");
  EXPECT_EQ(dir.count(), 2);
}

// Between the two steps of a replacement, the file has a name that may be taken.
TEST(AtomicFile, TakesAnotherNameWhereItsOwnIsTaken) {
  const TempDir dir;
  put(dir / "a", "old");
  const std::string taken = ".deburr-" + std::to_string(::getpid()) + "-0.tmp";
  put(dir / taken, "of someone else");
  AtomicFile file(dir / "a");
  file.write("new");
  file.commit();
  EXPECT_EQ(get(dir / "a"), "new");
  EXPECT_EQ(get(dir / taken), "of someone else");
  EXPECT_EQ(dir.count(), 2);
}

// A file that another program made in the meantime is replaced, as one from before would be.
TEST(AtomicFile, ReplacesWhatAppearedMeanwhile) {
  const TempDir dir;
  AtomicFile file(dir / "a");
  file.write("new");
  put(dir / "a", "between");
  file.commit();
  EXPECT_EQ(get(dir / "a"), "new");
  EXPECT_EQ(dir.count(), 1);
}

TEST(AtomicFile, ReplacesFilesInMemoryToo) {
  const fs::path memory = "/dev/shm";
  if (::access(memory.c_str(), W_OK) != 0) GTEST_SKIP() << "there is no folder in memory here";
  const fs::path path = memory / ("deburr-" + std::to_string(::getpid()));
  put(path, "a longer one");
  {
    AtomicFile file(path);
    file.write("new");
    EXPECT_EQ(get(path), "a longer one");
    file.commit();
  }
  EXPECT_EQ(get(path), "new");
  fs::remove(path);
}

TEST(AtomicFile, KeepsPermissionsOrTakesThoseOfNewFiles) {
  const TempDir dir;
  put(dir / "a", "old");
  put(dir / "plain", "");
  fs::permissions(dir / "a", fs::perms{0640});
  for (const char* name : {"a", "b"}) {
    AtomicFile file(dir / name);
    file.commit();
  }
  EXPECT_EQ(fs::status(dir / "a").permissions(), fs::perms{0640});
  EXPECT_EQ(fs::status(dir / "b").permissions(), fs::status(dir / "plain").permissions());
}

TEST(AtomicFile, KeepsTheOwner) {
  if (::geteuid() != 0) GTEST_SKIP() << "NOT TESTED: only root can write files of others as theirs";
  const TempDir dir;
  put(dir / "a", "old");
  ASSERT_EQ(::chown((dir / "a").c_str(), 12345, 54321), 0);
  fs::permissions(dir / "a", fs::perms{0640});
  AtomicFile file(dir / "a");
  file.commit();
  struct stat status {};
  ASSERT_EQ(::stat((dir / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 12345U);
  EXPECT_EQ(status.st_gid, 54321U);
  EXPECT_EQ(fs::status(dir / "a").permissions(), fs::perms{0640});
}

TEST(AtomicFile, SaysWhyItCannotWrite) {
  const TempDir dir;
  fs::create_symlink("loop", dir / "loop");
  put(dir / "file", "");
  EXPECT_THAT(error_of_opening(dir.path()), HasSubstr("Is a directory"));
  EXPECT_THAT(error_of_opening(dir / "none/a"), HasSubstr("No such file or directory"));
  EXPECT_THAT(error_of_opening(dir / "file/a"), HasSubstr("Not a directory"));
  EXPECT_THAT(error_of_opening(dir / "loop"), HasSubstr("symbolic links"));
  EXPECT_THAT(error_of_opening(dir / "none/a"), HasSubstr((dir / "none/a").string()));
}

/// Root may write everywhere: then the test goes on as somebody else.
class NotRoot {
 public:
  NotRoot() : was_root_(::geteuid() == 0) {
    EXPECT_TRUE(!was_root_ || ::setresuid(nobody, nobody, 0) == 0);
  }
  ~NotRoot() { EXPECT_TRUE(!was_root_ || ::setresuid(0, 0, 0) == 0); }
  NotRoot(const NotRoot&) = delete;
  NotRoot& operator=(const NotRoot&) = delete;

  static constexpr uid_t nobody = 65534;

 private:
  bool was_root_;
};

TEST(AtomicFile, RespectsProtection) {
  const TempDir dir;
  put(dir / "a", "old");
  fs::permissions(dir / "a", fs::perms{0444});
  if (::geteuid() == 0) {
    ASSERT_EQ(::chown((dir / "a").c_str(), NotRoot::nobody, NotRoot::nobody), 0);
    ASSERT_EQ(::chown(dir.path().c_str(), NotRoot::nobody, NotRoot::nobody), 0);
  }
  const NotRoot not_root;
  EXPECT_THAT(error_of_opening(dir / "a"), HasSubstr("Permission denied"));
  fs::permissions(dir.path(), fs::perms{0555});
  EXPECT_THAT(error_of_opening(dir / "b"), HasSubstr("Permission denied"));
  fs::permissions(dir.path(), fs::perms{0755});
  EXPECT_EQ(get(dir / "a"), "old");
  EXPECT_EQ(dir.count(), 1);
}

TEST(WriteCloud, LeavesTheOldFileWhenCancelled) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points.resize(20000);
  for (const char* name : {"a.ply", "a.xyz"}) {
    put(dir / name, "old");
    // Each look at the callback is one more place to stop at.
    int looks = 0;
    const auto other = dir / (std::string("other-") + name);
    (void)write_cloud(other, cloud, [&] { return ++looks < 0; });
    fs::remove(other);
    ASSERT_GT(looks, 5);
    for (int stop = 1; stop <= looks; ++stop) {
      int left = stop;
      EXPECT_THROW((void)write_cloud(dir / name, cloud, [&] { return --left == 0; }), Cancelled);
      EXPECT_EQ(get(dir / name), "old");
    }
    fs::remove(dir / name);
    EXPECT_EQ(dir.count(), 0);
  }
}

TEST(WriteCloud, NamesThePathOfAFullDisk) {
  const TempDir dir;
  fs::create_symlink("/dev/full", dir / "full.ply");
  PointCloud cloud;
  cloud.points.resize(10);
  EXPECT_THROW((void)write_cloud(dir / "full.ply", cloud), IoError);
  EXPECT_TRUE(fs::is_symlink(dir / "full.ply"));
}

}  // namespace
}  // namespace deburr
