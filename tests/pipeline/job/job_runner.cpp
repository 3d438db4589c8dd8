// Makes the tiny shot's film: what a test kills. Arguments: cache folder, video, and a log that
// gets a line with the seed of every picture when its rendering begins.
#include <chrono>
#include <string>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

#include "pipeline/job/film_pipeline.h"
#include "tests/pipeline/job/tiny_shot.h"

int main(int, char** arguments) {
    using namespace carom;
    const int log = ::open(arguments[3], O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    const pipeline::Shot shot = testing::tiny_shot();
    const auto render = [&](const pipeline::FrameInputs& inputs, const WorkContext&) {
        const std::string line = std::to_string(inputs.frame.seed) + "\n";
        if (::write(log, line.data(), line.size()) < 0) {
            ::_exit(2);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(8));
        return testing::fake_picture(shot, inputs);
    };
    pipeline::FilmJobOptions options;
    options.cache_folder = arguments[1];
    options.output = arguments[2];
    (void)pipeline::make_film_with(render, shot, testing::tiny_timeline(), options, {}, {});
    ::close(log);
    return 0;
}
