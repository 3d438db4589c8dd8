// A shot in a folder of its own, a session and what it sent.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <unistd.h>

#include "pipeline/studio/message_json.h"
#include "pipeline/studio/session.h"
#include "tests/folders.h"
#include "tests/patience.h"

namespace carom::studio {

inline std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_file(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

class StudioSession : public ::testing::Test {
  protected:
    /// In a process that another test has started, in the folder of that test.
    StudioSession()
        : StudioSession(is_started_by_test()
                            ? std::filesystem::path(std::getenv(kFolderVariable))
                            : std::filesystem::canonical(std::filesystem::temp_directory_path()) /
                                  ("carom_session_" + std::to_string(getpid()))) {}
    explicit StudioSession(std::filesystem::path folder) : folder_(std::move(folder)) {
        if (is_started_by_test()) {
            return;
        }
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        std::filesystem::copy_file(CAROM_SOURCE_DIR "/examples/bank_shot.yaml", path("shot.yaml"));
    }
    ~StudioSession() override {
        session_.reset();
        std::filesystem::remove_all(folder_);
    }

    static constexpr const char* kFolderVariable = "CAROM_SESSION_FOLDER";
    [[nodiscard]] static bool is_started_by_test() {
        return std::getenv(kFolderVariable) != nullptr;
    }

    [[nodiscard]] std::string path(const std::string& name) const {
        return (folder_ / name).string();
    }

    [[nodiscard]] SessionOptions options() const {
        return {.shot = path("shot.yaml"),
                .root = folder_.string(),
                .cache_folder = path("cache"),
                .state_folder = path("state")};
    }

    void start() { start(options()); }

    void start(SessionOptions options) {
        session_ = std::make_unique<Session>(std::move(options), [this](Outgoing message) {
            const std::lock_guard lock(mutex_);
            sent_.push_back(std::move(message));
            wake_.notify_all();
        });
        session_->opened(1);
        say(Hello{kProtocol});
    }

    void say(const PageMessage& message) { session_->received(1, to_json(message)); }

    /// Forgets what was sent.
    void forget() {
        const std::lock_guard lock(mutex_);
        sent_.clear();
    }

    /// Waits for a text of that type for which `matches` holds, and returns it.
    template <class Message, class Matches>
    Message wait_for(Matches matches) {
        std::unique_lock lock(mutex_);
        std::optional<Message> found;
        std::size_t next = 0;
        const bool heard = wake_.wait_for(lock, kPatience, [&] {
            for (; next < sent_.size() && !found; ++next) {
                if (!sent_[next].binary) {
                    ServerMessage text = read_server_message(sent_[next].data);
                    if (auto* one = std::get_if<Message>(&text); one && matches(*one)) {
                        found = std::move(*one);
                    }
                }
            }
            return found.has_value();
        });
        if (!heard) {
            throw std::runtime_error("there is no such message; these came:" + heard_texts());
        }
        return std::move(*found);
    }

    /// The texts that were sent, with the mutex.
    std::string heard_texts() {
        std::string texts;
        for (const Outgoing& one : sent_) {
            if (!one.binary) {
                texts += "\n" + std::string(one.data).substr(0, 300);
            }
        }
        return texts;
    }

    template <class Message>
    Message wait_for() {
        return wait_for<Message>([](const Message&) { return true; });
    }

    std::filesystem::path folder_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<Outgoing> sent_;
    std::unique_ptr<Session> session_;
};

}  // namespace carom::studio
