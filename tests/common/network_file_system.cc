// Preloaded before a test program, answers as network file systems do: renameat2 knows no flags
// and fsync no directories (NFS, 9p, sshfs: EINVAL), and there are no locks (Lustre: ENOSYS).

#include <dlfcn.h>
#include <sys/stat.h>

#include <cerrno>

extern "C" {

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  if (flags != 0) {
    errno = EINVAL;
    return -1;
  }
  using Call = int (*)(int, const char*, int, const char*, unsigned);
  static const auto next = reinterpret_cast<Call>(dlsym(RTLD_NEXT, "renameat2"));
  return next(from_folder, from, to_folder, to, flags);
}

int fsync(int file) {
  struct stat info;
  if (fstat(file, &info) == 0 && S_ISDIR(info.st_mode)) {
    errno = EINVAL;
    return -1;
  }
  using Call = int (*)(int);
  static const auto next = reinterpret_cast<Call>(dlsym(RTLD_NEXT, "fsync"));
  return next(file);
}

int flock(int /*file*/, int /*operation*/) {
  errno = ENOSYS;
  return -1;
}

}  // extern "C"
