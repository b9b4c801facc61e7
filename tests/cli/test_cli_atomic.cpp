// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// Whatever happens, the old file or the new one is there, whole.

namespace deburr::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::vector<std::string> formats{"ply", "las", "pcd", "csv", "obj", "off"};

class CliAtomic : public CliTest {
 protected:
  static std::ptrdiff_t files_in(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), {});
  }
};

/// A run that writes a megabyte or more.
std::vector<std::string> big_run(const std::string& out) {
  return {"synth", "cube", out, "--points", "60000", "--quiet"};
}

TEST_F(CliAtomic, KilledAtAnyMoment) {
  // Text takes longest to write, so that most of the moments lie there.
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run_program(big_run("whole.csv")).exit_code, 0);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const std::string whole = read_text("whole.csv");
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const int nameless = open(".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  for (unsigned i = 0; i < 32; ++i) {
    write_text("out.csv", "precious");
    const pid_t process = start_program(big_run("out.csv"), nothing, nothing);
    // Spread over a run, however fast the machine is.
    std::this_thread::sleep_for(took * i / 28);
    (void)kill(process, SIGKILL);
    (void)wait_for_exit(process);
    const std::string left = read_text("out.csv");
    EXPECT_TRUE(left == "precious" || left == whole) << i << ": " << left.size();
  }
  // A file gets a name when it is whole, and is left over only if the run ends just then.
  for (const fs::directory_entry& entry : fs::directory_iterator(".")) {
    const std::string name = entry.path().filename();
    if (nameless < 0 || name == "out.csv") continue;
    EXPECT_TRUE(read_text(name) == whole) << name << ": " << entry.file_size();
  }
  close(nameless);
  close(nothing);
}

/// Runs with a limit on the size of files, which is told as a full disk is.
Outcome run_with_limit(const std::vector<std::string>& args, rlim_t bytes) {
  rlimit before{};
  (void)getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit{bytes, before.rlim_max};
  (void)setrlimit(RLIMIT_FSIZE, &limit);
  Outcome outcome = run_program(args);
  (void)setrlimit(RLIMIT_FSIZE, &before);
  return outcome;
}

TEST_F(CliAtomic, NoRoomForTheFile) {
  for (const std::string& format : formats) {
    const std::string name = "out." + format;
    write_text(name, "precious");
    const Outcome outcome = run_with_limit(big_run(name), 100000);
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.err, "deburr: " + name + ": cannot write: File too large\n");
    EXPECT_EQ(read_text(name), "precious");
    fs::remove(name);
    EXPECT_EQ(files_in("."), 0);
  }
}

/// A run of which the second output is larger than the first.
std::vector<std::string> two_files(const std::string& first, const std::string& second) {
  return {"synth", "part", first, "--points", "9", "--truth", second, "--quiet"};
}

TEST_F(CliAtomic, NoOutputChangesIfAnotherOneCannotBeWritten) {
  for (const std::string out : {"out.ply", "new.ply"}) {
    write_text("out.ply", "precious");
    write_text("truth.ply", "precious too");
    const Outcome outcome = run_with_limit(two_files(out, "truth.ply"), 20000);
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.err, "deburr: truth.ply: cannot write: File too large\n");
    EXPECT_EQ(read_text("out.ply"), "precious");
    EXPECT_EQ(read_text("truth.ply"), "precious too");
    EXPECT_EQ(files_in("."), 2);
  }
  EXPECT_EQ(run_program(two_files("out.ply", "truth.ply")).exit_code, 0);
  EXPECT_EQ(read_cloud("out.ply").size(), 9U);
  EXPECT_GT(read_mesh("truth.ply").triangles.size(), 1000U);
  EXPECT_EQ(files_in("."), 2);
}

TEST_F(CliAtomic, NoOutputChangesIfAStreamTakesNoMore) {
  const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
  if (full < 0) GTEST_SKIP() << "NOT TESTED: /dev/full, a full disk, is of Linux";
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const PointCloud scan = synthesize_part({.points = 100}).cloud;
  write_cloud("scan.ply", scan);
  write_cloud("truth.ply", scan);
  for (const std::vector<std::string>& args : std::vector<std::vector<std::string>>{
           {"denoise", "scan.ply", "out.ply", "--report", "/dev/full"},
           {"denoise", "scan.ply", "out.ply", "--report", "-"},
           {"denoise", "scan.ply", "out.ply", "--json"},
           {"denoise", "scan.ply", "-", "--report", "out.ply"},
           {"synth", "cube", "out.ply", "--json"},
           {"synth", "cube", "-", "--clean", "out.ply"},
           {"compare", "scan.ply", "--truth", "truth.ply", "--distances", "out.ply"},
           {"render", "scan.ply", "out.png", "--json"}}) {
    write_text("out.ply", "precious");
    EXPECT_EQ(wait_for_exit(start_program(args, full, nothing)), 3) << args[0];
    EXPECT_EQ(read_text("out.ply"), "precious") << args[0];
    EXPECT_EQ(files_in("."), 3) << args[0];
  }
  close(nothing);
  close(full);
}

TEST_F(CliAtomic, OutputsEqualToTheInputAndLinks) {
  for (const std::string& format : formats) {
    const std::string name = "scan." + format;
    write_cloud("real." + format, synthesize_part({.points = 300}).cloud);
    fs::create_symlink("real." + format, name);
    ASSERT_EQ(run_program({"denoise", "real." + format, "out." + format}).exit_code, 0);
    ASSERT_EQ(run_program({"denoise", name, name}).exit_code, 0);
    EXPECT_TRUE(fs::is_symlink(name));
    EXPECT_EQ(read_text("real." + format), read_text("out." + format)) << format;
  }
  EXPECT_EQ(files_in("."), std::ssize(formats) * 3);
}

/// The rights of a user without any, while this lives. Only root can give them up.
class Nobody {
 public:
  static constexpr unsigned id = 65534;
  Nobody() : is_nobody_(setegid(id) == 0 && seteuid(id) == 0) {}
  ~Nobody() {
    if (is_nobody_) (void)!(seteuid(0) == 0 && setegid(0) == 0);
  }
  Nobody(const Nobody&) = delete;
  Nobody& operator=(const Nobody&) = delete;

  [[nodiscard]] bool can_run_the_program() const {
    return is_nobody_ && eaccess(DEBURR_PROGRAM, X_OK) == 0 && eaccess(".", W_OK) == 0;
  }

 private:
  bool is_nobody_;
};

// In a folder like /tmp a file of somebody else can be written to, but nothing can take its place.
// Who reads exit code 3 runs again: the input must not have been denoised by then.
TEST_F(CliAtomic, TheInputIsReplacedLast) {
  if (geteuid() != 0) GTEST_SKIP() << "NOT TESTED: only root can make a folder like that";
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "NOT TESTED: the sanitizer finds no leaks in programs that gave up rights";
#endif
  write_cloud("scan.ply", synthesize_part({.points = 300}).cloud);
  const std::string before = read_text("scan.ply");
  fs::create_directory("shared");
  write_text("shared/r.json", "theirs");
  for (const char* path : {".", "shared"}) ASSERT_EQ(chmod(path, 01777), 0);
  ASSERT_EQ(chown("scan.ply", Nobody::id, Nobody::id), 0);
  ASSERT_EQ(chmod("shared/r.json", 0666), 0);
  ASSERT_EQ(chown("shared/r.json", 1000, 1000), 0);
  const int out = open("messages", O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  {
    const Nobody nobody;
    if (!nobody.can_run_the_program())
      GTEST_SKIP() << "NOT TESTED: others cannot run the program here";
    EXPECT_EQ(wait_for_exit(start_program(
                  {"denoise", "scan.ply", "scan.ply", "--report", "shared/r.json"}, out, out)),
              3);
  }
  close(out);
  EXPECT_THAT(read_text("messages"), HasSubstr("shared/r.json: cannot replace"));
  EXPECT_EQ(read_text("scan.ply"), before);
  EXPECT_EQ(read_text("shared/r.json"), "theirs");
}

/// A disk of 256 kB, where the test may have one.
class SmallDisk {
 public:
  explicit SmallDisk(const fs::path& folder) : folder_(folder) {
    fs::create_directory(folder);
    is_there_ = mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=256k") == 0;
  }
  ~SmallDisk() {
    if (is_there_) (void)umount(folder_.c_str());
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  [[nodiscard]] bool is_there() const { return is_there_; }
  [[nodiscard]] bool make_read_only() const {
    return mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=256k") == 0;
  }

 private:
  fs::path folder_;
  bool is_there_ = false;
};

TEST_F(CliAtomic, AFullAndAReadOnlyDisk) {
  const SmallDisk disk("disk");
  if (!disk.is_there()) GTEST_SKIP() << "NOT TESTED: no disk may be mounted here, which takes root";
  write_text("disk/out.ply", "precious");
  write_cloud("scan.ply", synthesize_part({.points = 100}).cloud);
  const Outcome full = run_program(big_run("disk/out.ply"));
  EXPECT_EQ(full.exit_code, 3);
  EXPECT_THAT(full.err, HasSubstr("disk/out.ply: cannot write: No space left on device"));
  EXPECT_EQ(read_text("disk/out.ply"), "precious");
  EXPECT_EQ(files_in("disk"), 1);
  write_text("disk/filler", std::string(1 << 18, 'x'));
  write_text("out.ply", "precious too");
  const Outcome second = run_program({"denoise", "scan.ply", "out.ply", "--report", "disk/report"});
  EXPECT_EQ(second.exit_code, 3);
  EXPECT_THAT(second.err, HasSubstr("disk/report: cannot write: No space left on device"));
  EXPECT_EQ(read_text("out.ply"), "precious too");
  fs::remove("disk/filler");
  ASSERT_TRUE(disk.make_read_only());
  const Outcome locked = run_program({"synth", "cube", "disk/out.ply", "--points", "10"});
  EXPECT_EQ(locked.exit_code, 3);
  EXPECT_THAT(locked.err, HasSubstr("Read-only file system"));
  EXPECT_EQ(read_text("disk/out.ply"), "precious");
}

}  // namespace
}  // namespace deburr::cli
