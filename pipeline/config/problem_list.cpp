#include "pipeline/config/problem_list.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/core.h>

namespace carom::pipeline::config {

namespace {

constexpr std::size_t kMaxProblems = 100;
constexpr std::size_t kMaxStored = 10000;

}  // namespace

void ProblemList::error(const Place& place, Message message, std::string key_path) {
    ++error_count_;
    add({place, Severity::error, std::move(message), std::move(key_path)});
}

void ProblemList::warning(const Place& place, Message message, std::string key_path) {
    add({place, Severity::warning, std::move(message), std::move(key_path)});
}

void ProblemList::add(Entry entry) {
    if (entries_.size() >= kMaxStored) {
        ++hidden_count_;
        return;
    }
    entries_.push_back(std::move(entry));
}

std::vector<Problem> ProblemList::take() {
    const auto order = [](const Entry& e) {
        return std::tie(e.place.source, e.place.line, e.place.column, e.severity, e.message.text);
    };
    std::stable_sort(entries_.begin(), entries_.end(),
                     [&](const Entry& a, const Entry& b) { return order(a) < order(b); });
    const auto same = [&](const Entry& a, const Entry& b) { return order(a) == order(b); };
    entries_.erase(std::unique(entries_.begin(), entries_.end(), same), entries_.end());
    std::vector<Problem> problems;
    for (Entry& entry : entries_) {
        if (problems.size() == kMaxProblems) {
            const std::size_t rest = entries_.size() - kMaxProblems + hidden_count_;
            problems.push_back({has_error() ? Severity::error : Severity::warning,
                                {},
                                {},
                                fmt::format("and {} more problems", rest),
                                {},
                                {}});
            break;
        }
        problems.push_back({entry.severity, sources_->describe(entry.place),
                            std::move(entry.key_path), std::move(entry.message.text),
                            sources_->line_of(entry.place), sources_->include_chain(entry.place),
                            std::move(entry.message.suggestion)});
    }
    entries_.clear();
    return problems;
}

}  // namespace carom::pipeline::config
