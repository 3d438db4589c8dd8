#include "pipeline/store/claim_note.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include "core/error.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::pipeline {
namespace {

constexpr std::size_t kLongest = 1024;  // bytes of a note
constexpr int kAttempts = 3;            // to read a file
constexpr std::chrono::milliseconds kPause{20};

std::string host_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// The first digits of the number that Linux gives each start of the machine.
std::string start_of_machine() {
    std::string id;
    std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), id);
    return id.substr(0, 8);
}

std::string describe_host() {
    std::string host = host_name() + "/" + start_of_machine();
    if (const char* node = std::getenv("SLURMD_NODENAME")) {
        host += std::string("/") + node;
    }
    for (char& c : host) {
        c = c > ' ' && c < 127 ? c : '_';
    }
    return host;
}

}  // namespace

std::string text_of(const ClaimNote& note) {
    return fmt::format("carom claim 1\nhost {}\nprocess {}\nbeat {:020}\nstate {:8}\n{}", note.host,
                       note.process, note.beat,
                       note.state == ClaimNote::State::finished ? "finished" : "working",
                       note.since.empty() ? "" : "since " + note.since + "\n");
}

std::optional<ClaimNote> parse_claim_note(const std::string& text) {
    ClaimNote note;
    std::istringstream in(text);
    std::string carom;
    std::string claim;
    std::string version;
    std::string host;
    std::string process;
    std::string beat;
    std::string state_key;
    std::string state;
    in >> carom >> claim >> version >> host >> note.host >> process >> note.process >> beat >>
        note.beat >> state_key >> state;
    if (!in || carom != "carom" || claim != "claim" || version != "1") {
        return std::nullopt;
    }
    note.state = state == "finished" ? ClaimNote::State::finished : ClaimNote::State::working;
    std::string since;
    in >> since >> note.since;  // other versions of carom do not write it
    return note;
}

namespace {

/// What is in a file. Empty, with errno, if it cannot be read.
std::optional<std::string> read_text(const std::string& path) {
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    std::string text(kLongest, '\0');
    const ssize_t size =
        file.is_open() ? ::pread(file.get(), text.data(), text.size(), 0) : ssize_t{-1};
    if (size < 0) {
        return std::nullopt;
    }
    text.resize(static_cast<std::size_t>(size));
    return text;
}

}  // namespace

std::optional<ClaimNote> read_claim_note(const std::string& path) {
    for (int attempt = 1;; ++attempt) {
        if (const std::optional<std::string> text = read_text(path)) {
            return parse_claim_note(*text).value_or(ClaimNote{});
        }
        if (errno == ENOENT || errno == ENOTDIR) {
            return std::nullopt;
        }
        if (errno == ESTALE) {  // another machine has just removed it
            return ClaimNote{};
        }
        const bool stays = errno == EACCES || errno == EISDIR || errno == ELOOP;
        if (stays || attempt == kAttempts) {
            throw Error(system_problem(path, "the claim cannot be read"));
        }
        std::this_thread::sleep_for(kPause);
    }
}

const std::string& this_host() {
    static const std::string host = describe_host();
    return host;
}

std::string host_prefix() {
    return fmt::format("{:016x}-", std::hash<std::string>()(this_host()));
}

std::string new_claim_process() {
    static std::atomic<std::uint64_t> count{0};
    static const std::uint32_t start = std::random_device()();
    return fmt::format("{}-{:08x}-{}", ::getpid(), start, ++count);
}

std::string time_now() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text.data();
}

std::string owner_of(const ClaimNote& note) {
    return fmt::format("process {} on {}", note.process.substr(0, note.process.find('-')),
                       note.host.substr(0, note.host.find('/')));
}

}  // namespace carom::pipeline
