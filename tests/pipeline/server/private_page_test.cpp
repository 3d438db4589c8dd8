#include "pipeline/server/private_page.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <sys/stat.h>

namespace {

using carom::server::PrivatePage;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Sets a variable of the environment, and gives it its old value back at the end.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* before = std::getenv(name)) {
            before_ = before;
        }
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() {
        if (before_) {
            ::setenv(name_, before_->c_str(), 1);
        } else {
            ::unsetenv(name_);
        }
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> before_;
};

int mode_of(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 ? static_cast<int>(status.st_mode & 07777) : -1;
}

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

class PrivatePageFolder : public ::testing::Test {
  protected:
    PrivatePageFolder() {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directory(folder_);
        std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
    }
    ~PrivatePageFolder() override { std::filesystem::remove_all(folder_); }

    std::string folder_ = ::testing::TempDir() + "/private_page_test";
};

TEST_F(PrivatePageFolder, RuntimeFolder_HoldsTheFileWhileItIsNeeded) {
    const Variable runtime("XDG_RUNTIME_DIR", folder_);
    const ::mode_t before = ::umask(0);  // the mode must not depend on it
    std::string path;
    {
        const PrivatePage page("http://127.0.0.1:1/?key=abc");
        ::umask(before);
        path = page.path();
        EXPECT_THAT(path, StartsWith(folder_ + "/carom_studio_"));
        EXPECT_EQ(mode_of(path), 0600);
        EXPECT_THAT(text_of(path), HasSubstr("content=\"0;url=http://127.0.0.1:1/?key=abc\""));
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    EXPECT_TRUE(std::filesystem::exists(folder_));
}

TEST_F(PrivatePageFolder, OpenOrMissingRuntimeFolder_IsNotUsed) {
    std::filesystem::permissions(folder_, std::filesystem::perms(0755));
    const Variable temporary("TMPDIR", folder_);
    for (const std::string& unsafe : {folder_, folder_ + "/none", std::string("relative")}) {
        const Variable runtime("XDG_RUNTIME_DIR", unsafe);
        std::string inner;
        {
            const PrivatePage page("http://127.0.0.1:1/?key=abc");
            inner = std::filesystem::path(page.path()).parent_path().string();
            EXPECT_THAT(inner, StartsWith(folder_ + "/carom_studio_"));
            EXPECT_EQ(mode_of(inner), 0700);
            EXPECT_EQ(mode_of(page.path()), 0600);
        }
        EXPECT_FALSE(std::filesystem::exists(inner));
    }
}

}  // namespace
