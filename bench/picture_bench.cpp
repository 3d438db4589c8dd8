// How quickly the studio's traced picture answers, without a browser: picture_bench SHOT. Prints
// the median and the 95th percentile, in milliseconds, of the times from a question to its first
// picture and to the first at the film's size, and from a new question to the end of the old work.
#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

#include "pipeline/config/load_shot.h"
#include "pipeline/studio/picture_view.h"
#include "sim/bake.h"

namespace {

using carom::studio::PageId;
using carom::studio::Picture;
using carom::studio::PictureView;
using Clock = std::chrono::steady_clock;

constexpr PageId kPage = 1;
constexpr int kTries = 40;

double milliseconds(Clock::duration time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

void print(const char* what, std::vector<double> times) {
    std::ranges::sort(times);
    const auto at = [&](double part) {
        return times[std::min(times.size() - 1,
                              static_cast<std::size_t>(part * static_cast<double>(times.size())))];
    };
    std::printf("| %s | %.1f ms | %.1f ms | %zu |\n", what, at(0.5), at(0.95), times.size());
}

/// The arrival of the pictures of one question.
class Arrivals {
  public:
    void take(const Picture& picture, int film_width) {
        const std::lock_guard lock(mutex_);
        if (picture.head.q != q_) {
            return;
        }
        const Clock::time_point now = Clock::now();
        first_ = first_ == Clock::time_point{} ? now : first_;
        if (full_ == Clock::time_point{} && picture.head.width == film_width) {
            full_ = now;
        }
        changed_.notify_all();
    }

    void expect(std::int64_t q) {
        const std::lock_guard lock(mutex_);
        q_ = q;
        first_ = full_ = {};
    }

    /// When the first picture came, and the first at the film's size.
    std::array<Clock::time_point, 2> wait() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return full_ != Clock::time_point{}; });
        return {first_, full_};
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::int64_t q_ = 0;
    Clock::time_point first_;
    Clock::time_point full_;
};

}  // namespace

int main(int count, char** words) {
    if (count != 2) {
        std::fputs("usage: picture_bench SHOT\n", stderr);
        return 2;
    }
    carom::pipeline::LoadResult loaded = carom::pipeline::load_shot(words[1]);
    if (!loaded.shot) {
        std::fputs("picture_bench: the shot has errors; see carom check\n", stderr);
        return 1;
    }
    loaded.shot->render.samples = 4096;  // more than there is time for
    const auto shot = std::make_shared<const carom::pipeline::Shot>(std::move(*loaded.shot));
    const auto timeline =
        std::make_shared<const carom::sim::Timeline>(carom::sim::bake(shot->world));
    const std::string cache = std::filesystem::temp_directory_path() / "carom_picture_bench";
    Arrivals arrivals;
    PictureView view([&](PageId /*page*/,
                         const Picture& picture) { arrivals.take(picture, shot->render.width); },
                     {.cache_folder = cache, .threads = 0});
    view.set_shot(shot, timeline, 1);

    std::vector<double> first;
    std::vector<double> full;
    std::vector<double> stop;
    for (int i = 0; i < kTries; ++i) {
        carom::studio::See question;
        question.q = i + 1;
        question.frame = 3 * i;
        arrivals.expect(question.q);
        const Clock::time_point begin = Clock::now();
        view.ask(kPage, question);
        const auto times = arrivals.wait();
        first.push_back(milliseconds(times[0] - begin));
        full.push_back(milliseconds(times[1] - begin));
        std::this_thread::sleep_for(std::chrono::milliseconds(50 + 7 * (i % 11)));
        const Clock::time_point end = Clock::now();
        view.cancel(kPage);
        view.wait_until_idle();
        stop.push_back(milliseconds(Clock::now() - end));
    }
    std::puts("| from, to | median | 95 % | tries |\n|---|---|---|---|");
    print("question to the first picture", first);
    print("question to the film's size, 1 sample", full);
    print("end of the question to the end of the work", stop);
    std::filesystem::remove_all(cache);
    return 0;
}
