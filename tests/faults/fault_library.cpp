// Preloaded into a program (LD_PRELOAD), it lets writes to files and other calls fail and the clock
// jump.
//   CAROM_FAULT=KIND:N      at the N-th write, counted from 1: `full`, from then on every one fails
//                           for want of space; `io`, this one fails; `short`, this one writes half
//                           of what it should
//   CAROM_FAILING=CALL:ERRNO:N  the N-th `link`, `read` or `flock` fails with this number of an
//                           error; each one if N is 0
//   CAROM_FAULT_COUNT=FILE  a line with the numbers of writes, links, reads and locks is appended
//   to
//                           FILE at the end
//   CAROM_CLOCK_JUMP=N      from the N-th look on, the clock of the day is an hour late
// Writes are those to regular files other than the three standard streams, what flushes, cuts and
// renames them included. What a stream of <cstdio> only puts into its buffer is none. Reads are
// those of regular files, except through <cstdio>.
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <stdio_ext.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>

namespace {

enum class Fault { none, full, io, half };

template <class Function>
Function* real(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

struct Plan {
    std::string kind;
    long at = 0;

    Plan() {
        const char* text = std::getenv("CAROM_FAULT");
        const char* colon = text != nullptr ? std::strchr(text, ':') : nullptr;
        if (colon != nullptr) {
            kind.assign(text, colon);
            at = std::atol(colon + 1);
        }
    }
};

enum class Call { link, read, flock };
constexpr std::array kCalls{"link", "read", "flock"};  // in the order of Call

/// Which call fails.
struct Failing {
    std::string call;
    int error = 0;
    long at = 0;  // 0: each

    Failing() {
        const char* text = std::getenv("CAROM_FAILING");
        const char* first = text != nullptr ? std::strchr(text, ':') : nullptr;
        const char* second = first != nullptr ? std::strchr(first + 1, ':') : nullptr;
        if (second != nullptr) {
            call.assign(text, first);
            error = std::atoi(first + 1);
            at = std::atol(second + 1);
        }
    }
};

struct Counter {
    std::atomic<long> count{0};
    std::array<std::atomic<long>, kCalls.size()> calls{};

    ~Counter() {
        const char* path = std::getenv("CAROM_FAULT_COUNT");
        if (path == nullptr) {
            return;
        }
        const int file = ::open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
        std::string line = std::to_string(count.load());
        for (const std::atomic<long>& of_call : calls) {
            line += " " + std::to_string(of_call.load());
        }
        line += "\n";
        if (real<ssize_t(int, const void*, size_t)>("write")(file, line.data(), line.size()) < 0) {
            std::abort();
        }
        ::close(file);
    }
};

const Plan& plan() {
    static const Plan instance;
    return instance;
}

Counter& counter() {
    static Counter instance;
    return instance;
}

/// Whether this call is to fail, with errno set.
bool fails(Call call) {
    static const Failing failing;
    const auto index = static_cast<std::size_t>(call);
    const long number = ++counter().calls[index];
    if (failing.call != kCalls[index] || (failing.at != 0 && failing.at != number)) {
        return false;
    }
    errno = failing.error;
    return true;
}

bool is_regular(int file) {
    struct stat status {};
    return ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

Fault next() {
    const long number = ++counter().count;
    if (plan().kind == "full" && number >= plan().at) {
        return Fault::full;
    }
    if (number != plan().at) {
        return Fault::none;
    }
    return plan().kind == "io" ? Fault::io : plan().kind == "short" ? Fault::half : Fault::none;
}

Fault fault_of(int file) {
    return file <= STDERR_FILENO || !is_regular(file) ? Fault::none : next();
}

/// Whether the call is to fail, with errno set.
bool fails(Fault fault) {
    if (fault == Fault::full) {
        errno = ENOSPC;
    }
    if (fault == Fault::io) {
        errno = EIO;
    }
    return fault == Fault::full || fault == Fault::io;
}

/// What a stream holds is to be written, and this fails.
bool fails_to_flush(FILE* stream) {
    return ::__fpending(stream) > 0 && fails(fault_of(::fileno(stream)));
}

size_t halved(Fault fault, size_t size) {
    return fault == Fault::half && size > 1 ? size / 2 : size;
}

}  // namespace

extern "C" {

ssize_t write(int file, const void* data, size_t size) {
    static const auto call = real<ssize_t(int, const void*, size_t)>("write");
    const Fault fault = fault_of(file);
    return fails(fault) ? -1 : call(file, data, halved(fault, size));
}

ssize_t pwrite64(int file, const void* data, size_t size, off64_t offset) {
    static const auto call = real<ssize_t(int, const void*, size_t, off64_t)>("pwrite64");
    const Fault fault = fault_of(file);
    return fails(fault) ? -1 : call(file, data, halved(fault, size), offset);
}

ssize_t pwrite(int file, const void* data, size_t size, off_t offset) {
    return pwrite64(file, data, size, offset);
}

ssize_t writev(int file, const iovec* parts, int count) {
    static const auto call = real<ssize_t(int, const iovec*, int)>("writev");
    const Fault fault = fault_of(file);
    if (fails(fault)) {
        return -1;
    }
    return call(file, parts, fault == Fault::half && count > 1 ? count / 2 : count);
}

size_t fwrite(const void* data, size_t size, size_t count, FILE* stream) {
    static const auto call = real<size_t(const void*, size_t, size_t, FILE*)>("fwrite");
    const size_t room = ::__fbufsize(stream) > 0 ? ::__fbufsize(stream) : BUFSIZ;
    const bool fits = ::__fpending(stream) + size * count < room;
    return !fits && fails(fault_of(::fileno(stream))) ? 0 : call(data, size, count, stream);
}

int fflush(FILE* stream) {
    static const auto call = real<int(FILE*)>("fflush");
    return stream != nullptr && fails_to_flush(stream) ? EOF : call(stream);
}

int fseeko64(FILE* stream, off64_t offset, int whence) {
    static const auto call = real<int(FILE*, off64_t, int)>("fseeko64");
    return fails_to_flush(stream) ? -1 : call(stream, offset, whence);
}

int fseeko(FILE* stream, off_t offset, int whence) {
    return fseeko64(stream, offset, whence);
}

int fseek(FILE* stream, long offset, int whence) {
    return fseeko64(stream, offset, whence);
}

int fclose(FILE* stream) {
    static const auto call = real<int(FILE*)>("fclose");
    const bool failed = fails_to_flush(stream);
    const int reason = errno;
    if (failed) {
        ::__fpurge(stream);
    }
    const int result = call(stream);
    if (!failed) {
        return result;
    }
    errno = reason;
    return EOF;
}

int fsync(int file) {
    static const auto call = real<int(int)>("fsync");
    return fails(fault_of(file)) ? -1 : call(file);
}

int ftruncate64(int file, off64_t length) {
    static const auto call = real<int(int, off64_t)>("ftruncate64");
    return fails(fault_of(file)) ? -1 : call(file, length);
}

int rename(const char* from, const char* to) {
    static const auto call = real<int(const char*, const char*)>("rename");
    return fails(next()) ? -1 : call(from, to);
}

int link(const char* from, const char* to) {
    static const auto call = real<int(const char*, const char*)>("link");
    return fails(Call::link) ? -1 : call(from, to);
}

ssize_t read(int file, void* data, size_t size) {
    static const auto call = real<ssize_t(int, void*, size_t)>("read");
    return is_regular(file) && fails(Call::read) ? -1 : call(file, data, size);
}

ssize_t pread64(int file, void* data, size_t size, off64_t offset) {
    static const auto call = real<ssize_t(int, void*, size_t, off64_t)>("pread64");
    return is_regular(file) && fails(Call::read) ? -1 : call(file, data, size, offset);
}

ssize_t pread(int file, void* data, size_t size, off_t offset) {
    return pread64(file, data, size, offset);
}

// The name flock is also that of a structure.
int lock_file(int file, int operation) __asm__("flock");
int lock_file(int file, int operation) {
    static const auto call = real<int(int, int)>("flock");
    return fails(Call::flock) ? -1 : call(file, operation);
}

int clock_gettime(clockid_t clock, timespec* time) {
    static const auto call = real<int(clockid_t, timespec*)>("clock_gettime");
    static const char* text = std::getenv("CAROM_CLOCK_JUMP");
    static const long jump = text != nullptr ? std::atol(text) : 0;
    static std::atomic<long> looks{0};
    const int result = call(clock, time);
    if (jump > 0 && clock == CLOCK_REALTIME && ++looks >= jump) {
        time->tv_sec -= 3600;
    }
    return result;
}

}  // extern "C"
