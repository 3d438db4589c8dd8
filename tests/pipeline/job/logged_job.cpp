#include "tests/pipeline/job/logged_job.h"

#include <chrono>
#include <fstream>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "tests/pipeline/job/tiny_shot.h"

namespace carom::testing {

void run_logged_job(const std::string& cache, const std::string& video, const std::string& log,
                    bool is_shared) {
    const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    const pipeline::Shot shot = tiny_shot();
    const sim::Timeline timeline = tiny_timeline();
    const pipeline::FilmSource source(shot, timeline);
    const auto render = [&](const pipeline::FrameInputs& inputs, const WorkContext&,
                            render::FrameSums*) {
        const std::string line = source.key(inputs).to_string() + "\n";
        if (::write(file, line.data(), line.size()) < 0) {
            ::_exit(2);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(8));
        return fake_picture(shot, inputs);
    };
    pipeline::FilmJobOptions options;
    options.cache_folder = cache;
    options.output = video;
    options.claim_times.keeps_finished = is_shared;
    pipeline::JobObserver observer;
    observer.on_warning = [&](const std::string& text) {
        std::ofstream(log + ".warnings", std::ios::app) << text << '\n';
    };
    (void)make_film_with(render, shot, timeline, options, observer, {});
    ::close(file);
}

}  // namespace carom::testing
