// Preloaded before a program, answers as network file systems do: renameat2 knows no flags and
// fsync no directories (NFS, 9p, sshfs: EINVAL), and there are no locks (Lustre: ENOSYS; with
// LOCKS=nfs in the environment as NFS without a lock service: ENOLCK). Who asks whether a process
// lives goes on late, so that what others do meanwhile matters.

#include <dlfcn.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

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
  const char* locks = std::getenv("LOCKS");
  errno = locks != nullptr && std::strcmp(locks, "nfs") == 0 ? ENOLCK : ENOSYS;
  return -1;
}

int kill(pid_t process, int signal) {
  using Call = int (*)(pid_t, int);
  static const auto next = reinterpret_cast<Call>(dlsym(RTLD_NEXT, "kill"));
  const int result = next(process, signal);
  const int error = errno;
  if (signal == 0) usleep(1000 * (getpid() % 4));
  errno = error;
  return result;
}

}  // extern "C"
