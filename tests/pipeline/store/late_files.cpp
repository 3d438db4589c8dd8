// A library to preload that makes the local file system behave like a network file system at its
// worst, for one of several "machines" that share a folder:
//   - link() makes the link and then, every second time, reports a failure: the reply was lost; who
//     opens it to read it finds it missing once;
//   - stat() and its relatives repeat for a minute what they said of a path of the store before;
//   - a frame that another process has renamed into its place appears a second later.
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <ctime>
#include <map>
#include <mutex>
#include <set>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

constexpr int kCachedFor = 60;  // s
constexpr double kLate = 1;     // s

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

struct Kept {
    int result = 0;
    int failure = 0;
    struct stat status {};
    std::time_t until = 0;
};

struct State {
    std::mutex mutex;
    std::map<std::string, Kept> kept;
    std::set<std::string> own;     // that this process has renamed
    std::set<std::string> unseen;  // links
    int links = 0;
};

State& state() {
    static State& only = *new State();  // outlives all other objects
    return only;
}

bool is_frame(const char* path) {
    const std::size_t length = std::strlen(path);
    return length > 4 && std::strcmp(path + length - 4, ".exr") == 0;
}

/// When a file was made, as far as the file system knows. Other times change when it is used.
bool find_birth(const char* path, timespec& birth) {
    struct statx status {};
    if (::statx(AT_FDCWD, path, 0, STATX_BTIME | STATX_CTIME, &status) != 0) {
        return false;
    }
    const bool is_known = (status.stx_mask & STATX_BTIME) != 0;
    const struct statx_timestamp& time = is_known ? status.stx_btime : status.stx_ctime;
    birth.tv_sec = time.tv_sec;
    birth.tv_nsec = time.tv_nsec;
    return true;
}

/// Whether another process has put a frame in its place only just now.
bool is_late(const char* path) {
    if (!is_frame(path)) {
        return false;
    }
    {
        const std::lock_guard lock(state().mutex);
        if (state().own.count(path) > 0) {
            return false;
        }
    }
    timespec birth{};
    if (!find_birth(path, birth)) {
        return false;
    }
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    const double age = static_cast<double>(now.tv_sec - birth.tv_sec) +
                       1e-9 * static_cast<double>(now.tv_nsec - birth.tv_nsec);
    return age < kLate;
}

/// Whether it is a link that this process is told to be missing, for the first time.
bool is_unseen(const char* path) {
    const std::lock_guard lock(state().mutex);
    return state().unseen.erase(path) > 0;
}

}  // namespace

extern "C" {

int link(const char* from, const char* to) {
    const int result = next<int(const char*, const char*)>("link")(from, to);
    const std::lock_guard lock(state().mutex);
    if (result == 0 && ++state().links % 2 == 0) {
        state().unseen.insert(to);
        errno = EIO;
        return -1;
    }
    return result;
}

int rename(const char* from, const char* to) {
    {
        const std::lock_guard lock(state().mutex);
        state().own.insert(to);
    }
    return next<int(const char*, const char*)>("rename")(from, to);
}

int stat(const char* path, struct stat* status) {
    const std::time_t now = std::time(nullptr);
    const std::lock_guard lock(state().mutex);
    if (std::strstr(path, "/frames/") == nullptr) {
        return next<int(const char*, struct stat*)>("stat")(path, status);
    }
    Kept& kept = state().kept[path];
    if (kept.until <= now) {
        kept.result = next<int(const char*, struct stat*)>("stat")(path, &kept.status);
        kept.failure = errno;
        kept.until = now + kCachedFor;
    }
    *status = kept.status;
    errno = kept.failure;
    return kept.result;
}

int access(const char* path, int mode) {
    if (is_late(path)) {
        errno = ENOENT;
        return -1;
    }
    return next<int(const char*, int)>("access")(path, mode);
}

int open(const char* path, int flags, ...) {
    if (is_late(path) || ((flags & O_CREAT) == 0 && is_unseen(path))) {
        errno = ENOENT;
        return -1;
    }
    va_list arguments;
    va_start(arguments, flags);
    const int mode = (flags & O_CREAT) != 0 ? va_arg(arguments, int) : 0;
    va_end(arguments);
    return next<int(const char*, int, ...)>("open")(path, flags, mode);
}

}  // extern "C"
