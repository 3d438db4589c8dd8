#include "core/free_memory.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#ifdef __GLIBC__  // which the headers above define
#include <malloc.h>
#endif

namespace carom {

namespace {

using Bytes = std::optional<std::uint64_t>;

/// The smaller of the known values.
Bytes least(const Bytes& a, const Bytes& b) {
    return a && b ? std::min(*a, *b) : (a ? a : b);
}

/// The number in a file; empty if the file does not exist or contains a word ("max").
Bytes number_in(const std::string& path) {
    std::uint64_t number = 0;
    std::ifstream file(path);
    return file >> number ? Bytes(number) : std::nullopt;
}

Bytes free_in_system(const std::string& root) {
    std::ifstream file(root + "/proc/meminfo");
    std::string line;
    const std::string name = "MemAvailable:";
    while (std::getline(file, line)) {
        if (line.starts_with(name)) {
            return std::stoull(line.substr(name.size())) * 1024;
        }
    }
    return std::nullopt;
}

/// The path of this process's control group (version 2), from "0::/user.slice/..."; empty if it has
/// none.
std::string control_group(const std::string& root) {
    std::ifstream file(root + "/proc/self/cgroup");
    std::string line;
    while (std::getline(file, line)) {
        if (line.starts_with("0::")) {
            return line.substr(3);
        }
    }
    return "";
}

Bytes free_in_control_groups(const std::string& root) {
    std::string group = control_group(root);
    Bytes free;
    while (!group.empty()) {
        const std::string folder = fmt::format("{}/sys/fs/cgroup{}/", root, group);
        const Bytes limit = number_in(folder + "memory.max");
        const Bytes used = number_in(folder + "memory.current");
        if (limit && used) {
            free = least(free, *limit - std::min(*limit, *used));
        }
        group.resize(group.rfind('/'));
    }
    return free;
}

Bytes free_address_space(const std::string& root) {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
        return std::nullopt;
    }
    const Bytes pages = number_in(root + "/proc/self/statm");
    const auto page_size = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    const std::uint64_t used = pages.value_or(0) * page_size;
    return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, used);
}

}  // namespace

std::optional<std::uint64_t> free_memory(const std::string& root) {
    return least(least(free_in_system(root), free_in_control_groups(root)),
                 free_address_space(root));
}

void give_back_freed_memory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace carom
