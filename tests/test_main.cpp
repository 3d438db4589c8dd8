// The main function of the test programs. If CAROM_CASE_TIMEOUT is set, a case that takes longer
// than this number of seconds ends the program, since CTest runs many cases in one process and
// cannot limit the time of each.
#include <csignal>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace {

std::string& timeout_message() {
    static std::string message;
    return message;
}

extern "C" void end_program(int) {
    const std::string& message = timeout_message();
    const ssize_t written = ::write(STDERR_FILENO, message.data(), message.size());
    ::_exit(written < 0 ? 2 : 1);
}

class CaseTimeout : public testing::EmptyTestEventListener {
  public:
    explicit CaseTimeout(unsigned seconds) : seconds_(seconds) {
        std::signal(SIGALRM, end_program);
    }

    void OnTestSuiteStart(const testing::TestSuite& suite) override { start(suite.name()); }

    void OnTestStart(const testing::TestInfo& info) override {
        start(std::string(info.test_suite_name()) + "." + info.name());
    }

    void OnTestProgramEnd(const testing::UnitTest&) override { ::alarm(0); }

  private:
    void start(const std::string& name) const {
        ::alarm(0);
        timeout_message() = "[  FAILED  ] " + name + " takes longer than " +
                            std::to_string(seconds_) + " s (CAROM_CASE_TIMEOUT)\n";
        ::alarm(seconds_);
    }

    unsigned seconds_;
};

}  // namespace

int main(int count, char** arguments) {
    testing::InitGoogleMock(&count, arguments);
    if (const char* seconds = std::getenv("CAROM_CASE_TIMEOUT")) {
        testing::UnitTest::GetInstance()->listeners().Append(
            new CaseTimeout(static_cast<unsigned>(std::atoi(seconds))));  // gtest owns it
    }
    return RUN_ALL_TESTS();
}
