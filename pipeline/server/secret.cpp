#include "pipeline/server/secret.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>

#include <sys/random.h>

#include "core/error.h"

namespace carom::server {

std::string make_secret() {
    std::array<unsigned char, 16> bytes{};
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t count = ::getrandom(bytes.data() + filled, bytes.size() - filled, 0);
        if (count < 0 && errno != EINTR) {
            throw Error("the operating system gives no random numbers: " +
                        std::generic_category().message(errno));
        }
        filled += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : bytes) {
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

bool is_secret(std::string_view given, std::string_view secret) {
    if (given.size() != secret.size() || secret.empty()) {
        return false;
    }
    // volatile: the compiler must not end the loop at the first difference.
    volatile unsigned char difference = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
        difference = static_cast<unsigned char>(difference | (given[i] ^ secret[i]));
    }
    return difference == 0;
}

}  // namespace carom::server
