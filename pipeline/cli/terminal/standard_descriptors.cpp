#include "pipeline/cli/terminal/standard_descriptors.h"

#include <cerrno>
#include <initializer_list>

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

namespace carom::cli {

void reserve_standard_descriptors() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) {
            continue;
        }
        // open() returns this descriptor, since all lower ones are in use. The access mode is the
        // wrong one, so that reading or writing fails as with a closed descriptor.
        const int wrong_mode = descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY;
        static_cast<void>(::open("/dev/null", wrong_mode));
    }
}

void let_too_large_files_fail() {
    ::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace carom::cli
