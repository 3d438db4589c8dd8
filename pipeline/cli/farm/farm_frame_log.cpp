// What workers printed while they rendered one frame.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fmt/core.h>

#include "core/printable.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/frame_table.h"
#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/farm/worker_file.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;
using farm::FrameRecord;

constexpr std::int64_t kMost = 1 << 20;  // bytes of the log of an attempt, its last ones

/// The lines of a log between two bytes; `to` -1: its end.
std::string part_of_log(const std::string& path, std::int64_t from, std::int64_t to) {
    std::error_code failure;
    if (path.empty() || !fs::is_regular_file(fs::symlink_status(path, failure))) {
        return "";
    }
    const auto size = static_cast<std::int64_t>(fs::file_size(path, failure));
    const std::int64_t end = to < 0 ? size : std::min(to, size);
    const std::int64_t begin = std::clamp(std::max(from, end - kMost), std::int64_t{0}, end);
    std::ifstream file(path, std::ios::binary);
    file.seekg(begin);
    std::string bytes(static_cast<std::size_t>(end - begin), '\0');
    file.read(bytes.data(), std::ssize(bytes));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
    std::string text;
    std::string_view rest = bytes;
    while (!rest.empty()) {
        const std::size_t line = rest.find('\n');
        text += "  " + printable(rest.substr(0, line)) + "\n";
        rest.remove_prefix(line == std::string_view::npos ? rest.size() : line + 1);
    }
    return text;
}

std::string text_of(const farm::FarmJob& job, const FrameRecord& record) {
    const std::string path = log_path(job, record);
    std::string text =
        fmt::format("{} by worker {} on {} after {}{}\n", record.end, record.worker, record.host,
                    duration_text(record.seconds), path.empty() ? "" : ", " + path);
    text = printable(text.substr(0, text.size() - 1)) + "\n";
    return text + part_of_log(path, record.log_from, record.log_to);
}

/// Of a worker that is in the frame, or was when it was cut off: what it printed since its last
/// frame.
std::string text_of(const farm::FarmJob& job, const farm::WorkerNote& note,
                    const std::vector<FrameRecord>& records) {
    const auto last = std::find_if(records.rbegin(), records.rend(),
                                   [&](const FrameRecord& one) { return one.worker == note.name; });
    const std::string path = last == records.rend() ? "" : log_path(job, *last);
    return printable(fmt::format("{:.0f} % by worker {} on {}{}", 100 * note.fraction, note.name,
                                 note.host, path.empty() ? "" : ", " + path)) +
           "\n" + (path.empty() ? "" : part_of_log(path, last->log_to, -1));
}

}  // namespace

void print_frame_log(const farm::FarmJob& job, std::int64_t frame) {
    const std::vector<FrameRecord> records = farm::read_frame_records(job);
    std::string text;
    for (const FrameRecord& record : records) {
        text += record.frame == frame ? text_of(job, record) : "";
    }
    for (const farm::WorkerNote& note : farm::read_workers(job)) {
        text += note.frame == frame && note.fraction < 1 ? text_of(job, note, records) : "";
    }
    if (text.empty()) {
        throw InputError(fmt::format("no worker has noted anything of frame {}", frame));
    }
    print_text(text);
}

}  // namespace carom::cli
