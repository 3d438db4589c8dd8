// Runs run_logged_job with its arguments: cache folder, video, log. With a fourth argument
// "without flock" flock fails with ENOLCK, as on a file system without locks; with "shared" the
// store is that of several machines. The exit code is 1 if the job fails.
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <string_view>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include "tests/pipeline/job/logged_job.h"

namespace {

bool forbid_flock() {
    sock_filter program[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_flock, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOLCK),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog filter{4, program};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

}  // namespace

int main(int count, char** arguments) {
    const std::string_view how = count > 4 ? arguments[4] : "";
    if (how == "without flock" && !forbid_flock()) {
        return 77;
    }
    try {
        carom::testing::run_logged_job(arguments[1], arguments[2], arguments[3], how == "shared");
    } catch (const std::exception& error) {
        std::puts(error.what());
        return 1;
    }
    return 0;
}
