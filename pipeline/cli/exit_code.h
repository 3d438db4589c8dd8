// What carom's exit codes mean.
#pragma once

namespace carom::cli {

enum ExitCode : int {
    kDone = 0,
    kFailed = 1,      // while running: a full disk, a library
    kWrongUsage = 2,  // of the command line, or an input that is not right
    kInterrupted = 130,
};

}  // namespace carom::cli
