// Preloaded before a program, lets a test make the system fail while the program runs: the first
// bytes of the file that LATTICEWORLD_FAULTS names are read as `Faults` at every call. What is
// written or read counts where it lies below LATTICEWORLD_FAULTS_BELOW.

#include <dlfcn.h>
#include <fcntl.h>
#include <netdb.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

namespace {

// As faults.py packs it.
struct Faults {
  std::int32_t refuse_threads;    // 1: pthread_create gives EAGAIN
  std::int32_t refuse_processes;  // 1: fork gives EAGAIN
  std::int32_t clock_shift_s;     // added to the wall clock
  std::int32_t write_delay_us;    // before each write and sync
  std::int32_t write_error;       // what each write and sync gives (errno); 0: nothing
  std::int32_t read_error;        // what each read gives (errno); 0: nothing
  std::int32_t names_hang;  // 1: names of hosts are looked up until this is 0; numbers are not
};

const volatile Faults& Now() {
  static const Faults none{};
  static const volatile Faults* const faults = [] {
    const char* path = std::getenv("LATTICEWORLD_FAULTS");
    const int file = path == nullptr ? -1 : open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) return &none;
    void* memory = mmap(nullptr, sizeof(Faults), PROT_READ, MAP_SHARED, file, 0);
    close(file);
    return memory == MAP_FAILED ? &none : static_cast<const Faults*>(memory);
  }();
  return *faults;
}

template <typename Call>
Call* Next(const char* name) {
  return reinterpret_cast<Call*>(dlsym(RTLD_NEXT, name));
}

// Whether this file is one whose calls are to fail.
bool IsBelow(int file) {
  const char* below = std::getenv("LATTICEWORLD_FAULTS_BELOW");
  char path[4096];
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  const ssize_t size = readlink(link.c_str(), path, sizeof(path));
  return below != nullptr && size >= static_cast<ssize_t>(std::strlen(below)) &&
         std::strncmp(path, below, std::strlen(below)) == 0;
}

bool FailsToWrite(int file) {
  const volatile Faults& faults = Now();
  if ((faults.write_delay_us == 0 && faults.write_error == 0) || !IsBelow(file)) return false;
  if (faults.write_delay_us > 0) usleep(static_cast<useconds_t>(faults.write_delay_us));
  if (faults.write_error != 0) errno = faults.write_error;
  return faults.write_error != 0;
}

bool FailsToRead(int file) {
  if (Now().read_error == 0 || !IsBelow(file)) return false;
  errno = Now().read_error;
  return true;
}

}  // namespace

extern "C" {

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                   void* argument) noexcept {
  static auto* const next =
      Next<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create");
  return Now().refuse_threads != 0 ? EAGAIN : next(thread, attributes, start, argument);
}

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static auto* const next = Next<int(clockid_t, timespec*)>("clock_gettime");
  const int result = next(clock, time);
  if (result == 0 && clock == CLOCK_REALTIME) time->tv_sec += Now().clock_shift_s;
  return result;
}

int gettimeofday(timeval* time, void* zone) noexcept {
  static auto* const next = Next<int(timeval*, void*)>("gettimeofday");
  const int result = next(time, zone);
  if (result == 0) time->tv_sec += Now().clock_shift_s;
  return result;
}

pid_t fork() noexcept {
  static auto* const next = Next<pid_t()>("fork");
  if (Now().refuse_processes == 0) return next();
  errno = EAGAIN;
  return -1;
}

int getaddrinfo(const char* name, const char* service, const addrinfo* hints, addrinfo** found) {
  static auto* const next =
      Next<int(const char*, const char*, const addrinfo*, addrinfo**)>("getaddrinfo");
  const bool is_name =
      name != nullptr && std::strspn(name, "0123456789abcdefABCDEF.:") < std::strlen(name);
  while (is_name && Now().names_hang != 0) usleep(10000);
  return next(name, service, hints, found);
}

ssize_t read(int file, void* data, size_t size) {
  static auto* const next = Next<ssize_t(int, void*, size_t)>("read");
  return FailsToRead(file) ? -1 : next(file, data, size);
}

size_t fread(void* data, size_t size, size_t count, FILE* file) {
  static auto* const next = Next<size_t(void*, size_t, size_t, FILE*)>("fread");
  return FailsToRead(fileno(file)) ? 0 : next(data, size, count, file);
}

ssize_t write(int file, const void* data, size_t size) {
  static auto* const next = Next<ssize_t(int, const void*, size_t)>("write");
  return FailsToWrite(file) ? -1 : next(file, data, size);
}

size_t fwrite(const void* data, size_t size, size_t count, FILE* file) {
  static auto* const next = Next<size_t(const void*, size_t, size_t, FILE*)>("fwrite");
  return FailsToWrite(fileno(file)) ? 0 : next(data, size, count, file);
}

int fsync(int file) {
  static auto* const next = Next<int(int)>("fsync");
  return FailsToWrite(file) ? -1 : next(file);
}

}  // extern "C"
