#include "pipeline/cli/terminal/standard_descriptors.h"

#include <cerrno>
#include <initializer_list>

#include <fcntl.h>
#include <unistd.h>

namespace carom::cli {

void hold_standard_descriptors() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) {
            continue;
        }
        // The lowest free number is this one, since those before it are taken. The direction is
        // the wrong one, so that what is tried with it fails as with a closed one.
        const int wrong = descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY;
        static_cast<void>(::open("/dev/null", wrong));
    }
}

}  // namespace carom::cli
