// Preloaded before a program, keeps aside what the program has synced, so that a test can rebuild
// what a loss of power would have left: of a file its content at its last fsync, of a folder its
// names at its last fsync (durable.py). Files are known by a tag in an extended attribute, which
// follows them through renames and dies with them.
//
// LATTICEWORLD_DURABLE_ROOT: only what lies below it counts. LATTICEWORLD_DURABLE_KEPT: the folder
// where the synced state goes, outside of it.

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

namespace {

constexpr char kAttribute[] = "user.latticeworld_durable";

std::string Unique() {
  static std::atomic<unsigned> count{0};
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  char text[80];
  std::snprintf(text, sizeof(text), "%d-%ld-%09ld-%u", static_cast<int>(getpid()),
                static_cast<long>(now.tv_sec), now.tv_nsec, count++);
  return text;
}

// The tag of what lies at `path`, which gets one where it has none. Empty: it can have none.
std::string TagOf(const std::string& path) {
  const std::string fresh = Unique();
  lsetxattr(path.c_str(), kAttribute, fresh.data(), fresh.size(), XATTR_CREATE);
  char tag[128];
  const ssize_t size = lgetxattr(path.c_str(), kAttribute, tag, sizeof(tag));
  return size > 0 ? std::string(tag, static_cast<std::size_t>(size)) : std::string();
}

// Puts `content` where the test finds it, whole or not at all, for the program may be killed here.
void Keep(const std::string& kept, const std::string& name, const std::string& content) {
  const std::string temporary = kept + "/.new-" + Unique();
  const int file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return;
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t count = write(file, content.data() + done, content.size() - done);
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  close(file);
  std::rename(temporary.c_str(), (kept + "/" + name).c_str());
}

std::string ContentOf(const std::string& path) {
  std::string content;
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  char buffer[1 << 16];
  for (ssize_t count; file >= 0 && (count = read(file, buffer, sizeof(buffer))) > 0;)
    content.append(buffer, static_cast<std::size_t>(count));
  if (file >= 0) close(file);
  return content;
}

// A line for each name: its tag, a blank, the name.
std::string NamesIn(const std::string& path) {
  std::string names;
  DIR* folder = opendir(path.c_str());
  while (const dirent* entry = folder == nullptr ? nullptr : readdir(folder)) {
    const std::string name = entry->d_name;
    if (name == "." || name == "..") continue;
    names += TagOf(path + "/" + name) + " " + name + "\n";
  }
  if (folder != nullptr) closedir(folder);
  return names;
}

int Sync(int file) {
  const char* root = std::getenv("LATTICEWORLD_DURABLE_ROOT");
  const char* kept = std::getenv("LATTICEWORLD_DURABLE_KEPT");
  struct stat info {};
  if (fstat(file, &info) != 0) return -1;
  char path[4096];
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  const ssize_t size = readlink(link.c_str(), path, sizeof(path) - 1);
  if (root == nullptr || kept == nullptr || size <= 0) return 0;
  const std::string name(path, static_cast<std::size_t>(size));
  if (name.compare(0, std::strlen(root), root) != 0) return 0;
  const int before = errno;
  if (S_ISDIR(info.st_mode)) {
    Keep(kept, TagOf(name) + ".names", NamesIn(name));
  } else {
    Keep(kept, TagOf(name), ContentOf(link));
  }
  errno = before;
  return 0;
}

}  // namespace

extern "C" {

int fsync(int file) { return Sync(file); }
int fdatasync(int file) { return Sync(file); }

}  // extern "C"
