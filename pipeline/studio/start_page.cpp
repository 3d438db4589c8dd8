#include "pipeline/studio/start_page.h"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

#include "core/error.h"
#include "pipeline/config/config_files.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/plan/plan_svg.h"
#include "pipeline/studio/text_hash.h"
#include "sim/bake.h"

namespace carom::studio {

namespace fs = std::filesystem;
namespace config = pipeline::config;

namespace {

constexpr std::uint64_t kMostSteps = 3'000'000;  // of a simulation for a picture
constexpr std::uintmax_t kMostAssetBytes = std::uintmax_t{16} << 20U;  // of a mesh or an image
constexpr std::string_view kStills = "/still/";

/// The name of a shot, and what its first comment says.
StartFile describe(const std::string& file) {
    StartFile entry;
    entry.file = file;
    entry.name = fs::path(file).stem().string();
    std::string text;
    if (config::read_text_file(file, config::YamlLimits{}.bytes, text)) {
        entry.about = first_sentence(text);
    }
    return entry;
}

std::vector<std::string> shots_in(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code code;
    for (fs::directory_iterator entry(folder, code), end; !code && entry != end;
         entry.increment(code)) {
        if (entry->path().extension() == ".yaml" && entry->is_regular_file(code)) {
            files.push_back(fs::weakly_canonical(entry->path(), code).string());
        }
    }
    std::ranges::sort(files);
    return files;
}

/// The templates and the examples, which stand beside the configurations, in the source tree as in
/// an installation.
struct Offered {
    std::vector<StartFile> templates;
    std::vector<StartFile> examples;
    std::map<std::string, std::string> stills;  // paths of pictures by those of their shots
};

Offered find_offered() {
    Offered offered;
    for (const fs::path folder : config::standard_config_folders().folders) {
        const fs::path share = folder.parent_path();
        if (offered.templates.empty()) {
            for (const std::string& file : shots_in(folder / "templates")) {
                offered.templates.push_back(describe(file));
            }
        }
        if (!offered.examples.empty()) {
            continue;
        }
        for (const std::string& file : shots_in(share / "examples")) {
            offered.examples.push_back(describe(file));
            const std::string name = "example_" + offered.examples.back().name + ".jpg";
            for (const fs::path& still :
                 {share / "examples/stills" / name, share / "docs/images/gallery" / name}) {
                std::error_code code;
                if (fs::is_regular_file(still, code)) {
                    offered.stills[file] = still.string();
                }
            }
        }
    }
    // The smallest template first.
    std::stable_partition(offered.templates.begin(), offered.templates.end(),
                          [](const StartFile& one) { return one.name == "empty"; });
    return offered;
}

/// The picture of a shot that simulates quickly; null for others.
std::shared_ptr<const std::string> draw(const std::string& file, const std::stop_token& end) {
    try {
        const pipeline::LoadResult loaded =
            pipeline::load_shot(file, {.most_asset_bytes = kMostAssetBytes});
        if (!loaded.shot) {
            return nullptr;
        }
        const std::optional<sim::Timeline> timeline =
            sim::bake_within(kMostSteps, loaded.shot->world, {.stop = end});
        return timeline ? std::make_shared<const std::string>(
                              pipeline::sketch_svg(*loaded.shot, *timeline))
                        : nullptr;
    } catch (const std::exception&) {
        return nullptr;  // stopped, or a shot that cannot be simulated
    }
}

}  // namespace

class StartPage::Artist {
  public:
    explicit Artist(std::function<void()> changed)
        : changed_(std::move(changed)), offered_(find_offered()) {
        for (const auto& [file, still] : offered_.stills) {
            addresses_[file] = std::string(kStills) + hash_of(still) + ".jpg";
            stills_[addresses_[file]] = {"image/jpeg", still, nullptr};
        }
        thread_ = std::jthread([this](const std::stop_token& end) { run(end); });
    }

    Start offer(const std::vector<std::string>& recent) {
        Start start{offered_.templates, offered_.examples, {}};
        for (const std::string& file : recent) {
            start.recent.push_back(describe(file));
        }
        const std::lock_guard lock(mutex_);
        is_resting_ = false;
        wanted_.clear();
        for (std::vector<StartFile>* list : {&start.recent, &start.templates, &start.examples}) {
            for (StartFile& one : *list) {
                const auto known = addresses_.find(one.file);
                if (known != addresses_.end()) {
                    one.still = known->second;
                }
                if (list != &start.examples) {
                    wanted_.push_back(one.file);
                }
            }
        }
        wake_.notify_one();
        return start;
    }

    void rest() {
        const std::lock_guard lock(mutex_);
        is_resting_ = true;
        wanted_.clear();
    }

    [[nodiscard]] bool has(const std::string& file) const {
        const auto is_it = [&](const StartFile& one) { return one.file == file; };
        return std::ranges::any_of(offered_.templates, is_it) ||
               std::ranges::any_of(offered_.examples, is_it);
    }

    [[nodiscard]] std::optional<Still> find(std::string_view address) const {
        const std::lock_guard lock(mutex_);
        const auto found = stills_.find(std::string(address));
        return found == stills_.end() ? std::nullopt : std::optional(found->second);
    }

  private:
    void run(const std::stop_token& end) {
        bool has_new = false;
        for (;;) {
            std::string file;
            {
                std::unique_lock lock(mutex_);
                if (wanted_.empty() && has_new && !is_resting_) {
                    has_new = false;
                    lock.unlock();
                    changed_();
                    continue;
                }
                if (!wake_.wait(lock, end, [&] { return !wanted_.empty(); }) ||
                    end.stop_requested()) {
                    return;
                }
                file = wanted_.front();
                wanted_.pop_front();
            }
            has_new = draw_anew(file, end) || has_new;
        }
    }

    /// Draws the picture of a file that changed since it was drawn. Returns whether it is new.
    bool draw_anew(const std::string& file, const std::stop_token& end) {
        std::string text;
        if (!config::read_text_file(file, config::YamlLimits{}.bytes, text)) {
            return false;
        }
        const std::string key = hash_of(file + "\n" + text);
        if (!tried_.insert(key).second) {
            return false;
        }
        std::shared_ptr<const std::string> bytes = draw(file, end);
        if (bytes == nullptr || end.stop_requested()) {
            return false;
        }
        const std::string address = std::string(kStills) + key + ".svg";
        const std::lock_guard lock(mutex_);
        stills_.erase(addresses_[file]);
        addresses_[file] = address;
        stills_[address] = {"image/svg+xml", {}, std::move(bytes)};
        return true;
    }

    std::function<void()> changed_;
    const Offered offered_;

    mutable std::mutex mutex_;  // of the members up to stills_
    std::condition_variable_any wake_;
    std::deque<std::string> wanted_;                // files to draw
    bool is_resting_ = false;                       // until the next offer
    std::map<std::string, std::string> addresses_;  // of pictures, by their shots
    std::map<std::string, Still> stills_;           // by their addresses

    std::set<std::string> tried_;  // of the thread

    std::jthread thread_;  // ends first
};

StartPage::StartPage(std::function<void()> changed)
    : artist_(std::make_unique<Artist>(std::move(changed))) {}

StartPage::~StartPage() = default;

Start StartPage::offer(const std::vector<std::string>& recent) {
    return artist_->offer(recent);
}

void StartPage::rest() {
    artist_->rest();
}

bool StartPage::has(const std::string& file) const {
    return artist_->has(file);
}

std::optional<Still> StartPage::find(std::string_view address) const {
    return artist_->find(address);
}

std::string first_sentence(std::string_view text) {
    std::string comment;
    while (text.starts_with('#')) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(1, end - 1);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.find("yaml-language-server") != std::string_view::npos) {
            continue;
        }
        line.remove_prefix(std::min(line.find_first_not_of(" \r"), line.size()));
        comment += (comment.empty() ? "" : " ") + std::string(line);
    }
    const std::size_t end = comment.find(". ");
    return end == std::string::npos ? comment : comment.substr(0, end + 1);
}

}  // namespace carom::studio
