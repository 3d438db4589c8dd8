// All jobs of a store.
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

#include <fmt/core.h>

#include "core/printable.h"
#include "core/text.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/farm/farm_state.h"
#include "pipeline/cli/helper_program.h"
#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kColumns = 80;

struct ListedJob {
    std::string folder;
    std::string owner;
    std::string film;
    std::string state;  // as of JobState, or "unreadable"
    std::string message;
    std::int64_t frames = 0;
    std::int64_t finished = 0;
    std::optional<double> left;  // seconds
};

/// What is known of a job before its frames are looked at.
struct FoundJob {
    ListedJob listed;
    std::optional<farm::FarmJob> job{};  // empty: no more is to be found out
    bool has_ended = false;
};

/// Calls a function that fills what it finds out, and notes why if it cannot.
template <class Fill>
void fill(ListedJob& listed, const Fill& function) {
    try {
        return function();
    } catch (const Stopped&) {
        throw;
    } catch (const std::exception& error) {
        listed.message = error.what();
    } catch (const NeedsProgram& needed) {
        listed.message = "its frames are rendered by " + needed.name();
    }
    listed.state = "unreadable";
}

FoundJob found_job(const std::string& folder) {
    FoundJob found;
    ListedJob& listed = found.listed;
    listed.folder = folder;
    listed.owner = pipeline::name_of_owner(folder);
    fill(listed, [&] {
        farm::FarmJob job = farm::read_job(folder);
        listed.film = job.film;
        const auto end = farm::read_end(job);
        if (end && end->state == "complete" && end->frames > 0) {
            listed.state = end->state;
            listed.message = end->message;
            listed.frames = end->frames;
            listed.finished = end->frames - end->skipped;
            return;
        }
        (void)farm::read_round(job);  // one that is damaged must not keep the engine from answering
        found.has_ended = end.has_value();
        found.job = std::move(job);
    });
    return found;
}

void look_at_frames(FoundJob& found, const farm::Answer& answer, CommandContext& context) {
    ListedJob& listed = found.listed;
    fill(listed, [&] {
        const FarmFilm film = read_film(*found.job, JobUse::look, context);
        const JobState state = state_of(*found.job, FarmFrames(film, context.stop), answer);
        listed.state = state.state;
        listed.message = state.message;
        listed.frames = state.frames;
        listed.finished = std::ssize(state.finished);
        listed.left = state.left;
    });
}

/// What the engines say of these jobs, by their folders.
std::map<std::string, farm::Answer> answers_for(const std::vector<farm::FarmJob>& jobs) {
    try {
        return farm::ask_engines(jobs);
    } catch (const Error& error) {  // the jobs are listed all the same
        std::map<std::string, farm::Answer> unknown;
        for (const farm::FarmJob& job : jobs) {
            unknown[job.folder].problem = error.what();
        }
        return unknown;
    }
}

std::vector<ListedJob> jobs_of(const std::string& store, CommandContext& context) {
    std::vector<FoundJob> all;
    std::vector<farm::FarmJob> in_queue;
    for (const std::string& folder : farm::job_folders(store)) {
        all.push_back(found_job(folder));
        if (all.back().job && !all.back().has_ended) {
            in_queue.push_back(*all.back().job);
        }
    }
    const std::map<std::string, farm::Answer> answers = answers_for(in_queue);
    std::vector<ListedJob> listed;
    for (FoundJob& found : all) {
        if (found.job) {
            const auto answer = answers.find(found.job->folder);
            look_at_frames(found, answer == answers.end() ? farm::Answer{} : answer->second,
                           context);
        }
        listed.push_back(std::move(found.listed));
    }
    return listed;
}

std::string json_of(const ListedJob& job) {
    JsonMembers members;
    members.add("id", farm::job_id(job.folder))
        .add("folder", job.folder)
        .add("owner", job.owner)
        .add("film", job.film)
        .add("state", job.state)
        .add("message", job.message)
        .add("frames", job.frames)
        .add("finished", job.finished);
    if (job.left) {
        members.add("seconds_left", *job.left);
    }
    return members.object();
}

/// The text in at most so many columns. Bytes that continue a character of UTF-8 take none.
std::string shortened(const std::string& text, std::size_t columns) {
    const auto begins = [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
    };
    if (static_cast<std::size_t>(std::ranges::count_if(text, begins)) <= columns) {
        return text;
    }
    std::string result;
    std::size_t count = 0;
    for (const char byte : text) {
        count += begins(byte) ? 1 : 0;
        if (count >= columns) {
            break;
        }
        result += byte;
    }
    return result + "…";
}

/// The words in lines of at most kColumns with two blanks before each.
std::string indented(const std::string& text) {
    std::istringstream words(printable(text));
    std::string result;
    std::string line;
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 3 + word.size() > kColumns) {
            result += " " + line + "\n";
            line.clear();
        }
        line += " " + word;
    }
    return result + " " + line + "\n";
}

std::string row(const std::string& id, const std::string& owner, const std::string& film,
                const std::string& frames, const std::string& left, const std::string& state) {
    return fmt::format("{:10} {:9} {:25} {:>11} {:>10} {}\n", id, shortened(printable(owner), 9),
                       shortened(printable(film), 25), frames, left, state);
}

std::string text_of(const ListedJob& job) {
    constexpr std::size_t kIdColumns = 10;
    const std::string id = printable(farm::job_id(job.folder));
    const bool is_long = id.size() > kIdColumns;  // one that is cut could not be typed
    return (is_long ? id + "\n" : "") +
           row(is_long ? "" : id, job.owner, fs::path(job.film).filename().string(),
               job.frames > 0 ? fmt::format("{}/{}", job.finished, job.frames) : "",
               job.left ? duration_text(*job.left) : "", job.state) +
           (job.message.empty() ? "" : indented(job.message));
}

/// Nobody asked for the warnings of other people's shots.
ConsoleSettings silent_console() {
    ConsoleSettings settings;
    settings.write = [](std::string_view) {};
    return settings;
}

}  // namespace

void farm_list(const FarmCommand& command, CommandContext& context) {
    Console silent(silent_console());
    CommandContext quiet{silent,        context.stop,          context.structures,
                         context.music, context.text_problems, context.view};
    const std::string store = store_of(command);
    std::vector<std::string> jobs;
    for (const ListedJob& job : jobs_of(store, quiet)) {
        if (command.is_running && job.state != "running" && job.state != "waiting") {
            continue;
        }
        jobs.push_back(command.json ? json_of(job) : text_of(job));
    }
    if (command.json) {
        return print_text(
            fmt::format("{{\"store\":{},\"jobs\":[{}]}}\n", json_string(store), join(jobs, ",")));
    }
    if (jobs.empty()) {
        context.console.info(fmt::format("the store '{}' has no {}job", store,
                                         command.is_running ? "running " : ""));
        return;
    }
    print_text(row("JOB", "OWNER", "FILM", "FRAMES", "LEFT", "STATE") + join(jobs, ""));
}

}  // namespace carom::cli
