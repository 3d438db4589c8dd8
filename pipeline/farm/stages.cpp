#include "pipeline/farm/stages.h"

#include "pipeline/farm/farm_job.h"

namespace carom::farm {

const std::vector<Stage>& stages() {
    static const std::vector<Stage> all{
        {"frames", "worker.sh", "work", "Renders frames until its time is over or all are there.",
         true, &FarmJob::time},
        {"film", "film.sh", "finish",
         "Writes the film if no worker has, else asks for missing frames.", false,
         &FarmJob::film_time}};
    return all;
}

}  // namespace carom::farm
